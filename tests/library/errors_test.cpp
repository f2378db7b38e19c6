// SPDX-License-Identifier: GPL-3.0-or-later
// Every error says what it is about: a code, what is wrong, what would be right.
#include "tests/catch.hpp"
#include "tests/dem/temp_folder.hpp"
#include "tests/library/made_ground.hpp"

#include <cmath>
#include <fstream>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace orograph::errors_test {

namespace {

const std::string kData = std::string(OROGRAPH_SOURCE_DIR) + "/data_samples/";

void check_error(ErrorCode code, const std::string& wrong, const std::function<void()>& work) {
  INFO(wrong);
  try {
    work();
    FAIL("nothing was wrong");
  } catch (const Error& error) {
    INFO(error.what());
    CHECK(error.code() == code);
    CHECK(error.wrong().find(wrong) != std::string::npos);
    CHECK(error.right().size() > 3);
    CHECK(error.what() == error.wrong() + ": " + error.right());
    for (const std::string& phrase : {error.wrong(), error.right()})
      CHECK(phrase.find('\n') == std::string::npos);
  }
}

constexpr int kSide = 40;

Session small_session() {
  return Session(Terrain::of(borrowed(rough_heights(kSide), kSide)));
}

void check_draw(const std::string& wrong, const std::function<void(MapSpec&)>& spoil) {
  MapSpec spec;
  spoil(spec);
  const Session session = small_session();
  check_error(ErrorCode::request, wrong, [&] { session.draw(spec); });
  CHECK(session.draw({}).facts.counts.strokes > 100);
}

} // namespace

TEST_CASE("files that can't be used are of code input") {
  const TempFolder folder;
  const std::string text = folder.file("text.tif");
  std::ofstream(text) << "this is no raster\n";
  const std::string scene = folder.file("scene.toml");
  std::ofstream(scene) << "[part.box]\nshape = \"bottle\"\n";
  check_error(ErrorCode::input, "none.tif", [&] { Terrain::read({folder.file("none.tif")}); });
  check_error(ErrorCode::input, "text.tif", [&] { Terrain::read({text}); });
  check_error(ErrorCode::input, "none.toml", [&] { Solids::read(folder.file("none.toml")); });
  check_error(ErrorCode::input, "scene.toml, line 2", [&] { Solids::read(scene); });
  check_error(ErrorCode::input, "scene.toml", [&] { read_view_file(scene); });
}

TEST_CASE("numbers out of their range, and wishes that exclude each other, are told by field") {
  const double none = std::nan("");
  const std::vector<std::pair<const char*, std::function<void(MapSpec&)>>> cases{
      {"`plan` is 0 profiles", [](MapSpec& s) { s.style.plan = ProfileCount{0}; }},
      {"`plan` is -1 mm", [](MapSpec& s) { s.style.plan = PageSpacing{-1}; }},
      {"`plan` is nan m", [&](MapSpec& s) { s.style.plan = GroundSpacing{none}; }},
      {"`field_of_view` is 180", [](MapSpec& s) { s.view.field_of_view = Angle::degrees(180); }},
      {"`from_elevation` is 91", [](MapSpec& s) { s.view.from_elevation = Angle::degrees(91); }},
      {"`distance_m` is 0", [](MapSpec& s) { s.view.distance_m = 0; }},
      {"`exaggeration` is -2", [](MapSpec& s) { s.view.exaggeration = -2; }},
      {"`refraction` is nan", [&](MapSpec& s) { s.view.refraction = none; }},
      {"`eye_map` is nan,3", [&](MapSpec& s) { s.view.eye_map = GivenPlace(none, 3); }},
      {"`eye_map` has no meaning",
       [](MapSpec& s) {
         s.view.eye_map = GivenPlace(1, 2);
         s.view.projection = Projection::oblique;
       }},
      {"`simplify_mm` is -1", [](MapSpec& s) { s.style.simplify_mm = -1; }},
      {"`visibility_tolerance_mm` is 11", [](MapSpec& s) { s.style.visibility_tolerance_mm = 11; }},
      {"`pen_width_mm` is 0", [](MapSpec& s) { s.style.pen_width_mm = 0; }},
      {"no layer 'ridges'",
       [](MapSpec& s) {
         s.style.layers = {"profiles", "ridges"};
       }},
      {"'shores' is asked for twice",
       [](MapSpec& s) {
         s.style.layers = {"shores", "shores"};
       }},
      {"the layer 'hidden-mesh' has no meaning without 'mesh'",
       [](MapSpec& s) {
         s.style.layers = {"profiles", "hidden-mesh"};
       }},
      {"`grey` is 1.5", [](MapSpec& s) { s.style.layers.front().grey = 1.5; }},
      {"`width_mm` is nan", [&](MapSpec& s) { s.page.width_mm = none; }},
      {"margins of 105 mm leave no room", [](MapSpec& s) { s.page.margin_mm = 105; }}};
  for (const auto& [wrong, spoil] : cases) {
    CAPTURE(wrong);
    check_draw(wrong, spoil);
  }
}

TEST_CASE("what can't be drawn is of code request, and the session draws on") {
  check_draw("under the ground", [](MapSpec& spec) {
    spec.view.eye_map = middle(kSide);
    spec.view.eye_map->z = -100;
  });
  check_draw("outside of the terrain", [](MapSpec& spec) { spec.view.eye_map = GivenPlace(0, 0); });
  check_draw("no place in the terrain's CRS",
             [](MapSpec& spec) { spec.view.eye_lonlat = GivenPlace(9, 95); });
  check_draw("100000 profiles", [](MapSpec& spec) { spec.style.plan = GroundSpacing{1e-6}; });
  check_draw("margins", [](MapSpec& spec) { spec.page.margin_mm = 200; });
  check_draw("coincide", [](MapSpec& spec) {
    spec.view.eye_map = middle(kSide);
    spec.view.look_at_map = middle(kSide);
    spec.view.eye_map->z = spec.view.look_at_map->z = 5000;
  });
  check_error(ErrorCode::request, "no file is named", [] { Terrain::read({}); });
  check_error(ErrorCode::request, "-2 jobs", [] { small_session().draw({}, {.jobs = -2}); });
  check_error(ErrorCode::request, "-2 jobs",
              [] { Terrain::read({kData + "volcano.tif"}, {}, {.jobs = -2}); });
  check_error(ErrorCode::request, "unknown format", [] { format_of_name("doc"); });
  check_error(ErrorCode::request, "doesn't tell its format", [] { format_of_path("map.doc"); });
}

TEST_CASE("files that can't be written are of code output") {
  const TempFolder folder;
  const Drawing drawing = small_session().draw({}).drawing;
  const std::string there = folder.file("there.svg");
  std::ofstream(there) << "something\n";
  const auto check = [&](const std::string& path, const std::string& wrong) {
    const WriteOptions options{.format = format_of_path(path)};
    check_error(ErrorCode::output, wrong, [&] { write_drawing(drawing, path, options); });
    check_error(ErrorCode::output, wrong, [&] { check_writable(path, options); });
  };
  for (const std::string& name : format_names()) {
    if (is_tied_to_ground(format_of_name(name))) continue;
    check(folder.file("none/map." + name), "none/map." + name);
    check("/dev/full/map." + name, "/dev/full");
  }
  check(there, "exists already");
  const std::string in_the_way = folder.file("folder.svg");
  std::filesystem::create_directory(in_the_way);
  check(in_the_way, "not an ordinary file");
  check_error(ErrorCode::request, "no map points", [&] {
    write_drawing(drawing, folder.file("a.geojson"), {.format = Format::geojson});
  });
  check_error(ErrorCode::request, "dpi", [&] {
    write_drawing(drawing, folder.file("a.png"), {.format = Format::png, .dpi = 1e7});
  });
  check_error(ErrorCode::request, "standard output",
              [&] { write_drawing(drawing, "-", {.format = Format::png}); });
}

TEST_CASE("what the caller stopped is of code cancelled") {
  std::stop_source stop;
  stop.request_stop();
  const Control control{.stop = stop.get_token()};
  check_error(ErrorCode::cancelled, "stopped", [&] { small_session().draw({}, control); });
  check_error(ErrorCode::cancelled, "stopped",
              [&] { Terrain::read({kData + "volcano.tif"}, {}, control); });
}

} // namespace orograph::errors_test
