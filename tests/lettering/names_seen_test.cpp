// SPDX-License-Identifier: GPL-3.0-or-later
// Which names are printed: those of summits that are seen, past ground and solids; and the same
// whatever order, threads and locale they are asked in.
#include "orograph.hpp"
#include "tests/catch.hpp"
#include "tests/dem/temp_folder.hpp"
#include "tests/lettering/named_maps.hpp"
#include "tests/library/made_ground.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <clocale>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <iterator>
#include <memory>
#include <string>
#include <vector>

namespace orograph::names_seen_test {
namespace {

constexpr int kSide = 60;

// Cells of 30 m from the same place as `borrowed`.
Terrain terrain_of(int side, const std::function<double(int, int)>& height_m) {
  auto heights = std::make_shared<std::vector<float>>();
  for (int row = 0; row < side; ++row)
    for (int column = 0; column < side; ++column)
      heights->push_back(static_cast<float>(height_m(column, row)));
  return Terrain::of(borrowed(heights, side));
}
// Of a vertex, in map coordinates.
Vec2 place(int column, int row) {
  return {500000 + 30 * (column + 0.5), 5000000 - 30 * (row + 0.5)};
}

NameState state_of(const Map& map, const std::string& name) {
  const auto found = std::ranges::find(map.facts.names->names, name, &NameFacts::text);
  REQUIRE(found != map.facts.names->names.end());
  return found->state;
}

Solids solids_of(const std::string& scene) {
  const TempFolder folder;
  std::ofstream(folder.file("scene.toml")) << scene;
  return Solids::read(folder.file("scene.toml"));
}

// The same triangles as a TIN.
Terrain tin_of(int side, const std::function<double(int, int)>& height_m) {
  TinInput input;
  for (int row = 0; row < side; ++row)
    for (int column = 0; column < side; ++column) {
      const Vec2 at = place(column, row);
      input.points.push_back({at.x, at.y, height_m(column, row)});
    }
  const auto n = static_cast<std::uint32_t>(side);
  for (std::uint32_t row = 0; row + 1 < n; ++row)
    for (std::uint32_t column = 0; column + 1 < n; ++column) {
      const std::uint32_t at = row * n + column;
      input.triangles.push_back({at, at + n, at + n + 1});
      input.triangles.push_back({at, at + n + 1, at + 1});
    }
  return Terrain::of(input);
}

// A cone of 300 m, and a ridge of `ridge_m` between it and the south.
double cone_m(int column, int row, double ridge_m) {
  const double cone = 300 - 30 * std::hypot(column - 30, row - 15);
  return std::max({cone, row == 40 ? ridge_m : 0, 0.0});
}

MapSpec from_south(Projection projection) {
  MapSpec spec;
  spec.style.layers = {"skyline", "border", "silhouettes"};
  spec.view.projection = projection;
  spec.view.exaggeration = 1;
  return spec;
}

} // namespace

TEST_CASE("Names of an eye are hidden where it doesn't see their summits") {
  const Terrain terrain = Terrain::of(borrowed(rough_heights(kSide), kSide));
  int hidden = 0, seen = 0;
  for (std::uint64_t seed = 1; seed <= last_seed(24); ++seed) {
    Random random(seed);
    const Session session(terrain, {}, {}, names_of(random_names(random, kSide, 60), terrain));
    MapSpec spec = from_south(random.pick({Projection::cylindrical, Projection::perspective}));
    spec.view.eye_map = middle(kSide);
    spec.view.eye_height_m = random.between(5, 100);
    spec.view.curvature = Curvature::off; // which a picture may leave out where it moves nothing
    spec.style.detail.of_file = true;     // on which sights are, eye and all
    if (!is_panorama(spec.view.projection)) {
      spec.view.look_azimuth = Angle::degrees(random.whole(0, 359));
      spec.view.field_of_view = Angle::degrees(90);
    }
    const Map map = session.draw(spec);
    std::vector<Vec2> places;
    for (const NameFacts& name : map.facts.names->names) places.push_back(name.map);
    const std::vector<PlaceSight> sights = session.sights(spec.view, places);
    for (std::size_t i = 0; i < places.size(); ++i) {
      const NameFacts& name = map.facts.names->names[i];
      CAPTURE(seed, name.text, name.hidden_mm);
      CHECK((name.state == NameState::hidden) == (name.hidden_mm > 0.2));
      if (name.state == NameState::hidden) CHECK(sights[i].state == PlaceState::hidden);
      if (sights[i].state == PlaceState::seen) CHECK(name.hidden_mm == 0);
      REQUIRE(name.bearing);
      CHECK(name.bearing->azimuth_deg == Approx(sights[i].bearing.azimuth_deg).margin(1e-9));
      CHECK(name.bearing->altitude_deg == Approx(sights[i].bearing.altitude_deg).margin(1e-6));
      CHECK(name.bearing->distance_m == Approx(sights[i].bearing.distance_m));
      ++(name.state == NameState::hidden ? hidden : seen);
    }
  }
  CHECK(hidden >= enough(80));
  CHECK(seen >= enough(100));
}

TEST_CASE("In a parallel view a ridge hides what is behind it and not above it") {
  const auto draw = [](double ridge_m, double elevation_deg, bool is_tin) {
    const auto heights = [&](int column, int row) { return cone_m(column, row, ridge_m); };
    const Terrain terrain = is_tin ? tin_of(kSide, heights) : terrain_of(kSide, heights);
    const Session session(terrain, {}, {}, names_of({{place(30, 15), "Cone"}}, terrain));
    MapSpec spec = from_south(Projection::orthographic);
    spec.view.from_elevation = Angle::degrees(elevation_deg);
    return session.draw(spec);
  };
  for (const bool is_tin : {false, true}) {
    CHECK(state_of(draw(290, 10, is_tin), "Cone") == NameState::chosen);
    const Map map = draw(500, 10, is_tin);
    CHECK(state_of(map, "Cone") == NameState::hidden);
    // The ridge is 25 rows nearer: it stands so much higher in the picture.
    const double lift_m = 25 * 30 * std::tan(10 * M_PI / 180);
    CHECK(state_of(draw(290 + lift_m, 10, is_tin), "Cone") == NameState::chosen);
    CHECK(state_of(draw(310 + lift_m, 10, is_tin), "Cone") == NameState::hidden);
    CHECK(state_of(draw(500, 60, is_tin), "Cone") == NameState::chosen);
  }
}

TEST_CASE("A house in front of a summit hides its name; a cairn on it doesn't") {
  const Terrain terrain =
      terrain_of(kSide, [](int column, int row) { return cone_m(column, row, 0); });
  const Overlays names = names_of({{place(30, 15), "Cone"}}, terrain);
  const auto scene = [](Vec2 at, double high_m) {
    return solids_of(fmt::format("[part.house]\nshape = 'box'\nsize = [60, 20, {}]\n"
                                 "[[place]]\npart = 'house'\nat = [{}, {}]\n",
                                 high_m, at.x, at.y));
  };
  for (const Projection projection :
       {Projection::orthographic, Projection::perspective, Projection::cylindrical}) {
    MapSpec spec = from_south(projection);
    spec.view.from_elevation = Angle::degrees(5);
    if (projection != Projection::orthographic) {
      spec.view.eye_map = GivenPlace(place(30, 55).x, place(30, 55).y);
      spec.view.eye_height_m = 2;
      spec.view.look_azimuth = Angle();
    }
    CAPTURE(projection);
    const auto state = [&](const Solids& solids) {
      return state_of(Session(terrain, solids, {}, names).draw(spec), "Cone");
    };
    CHECK(state({}) == NameState::chosen);
    CHECK(state(scene(place(30, 45), 600)) == NameState::hidden);
    CHECK(state(scene(place(30, 45), 20)) == NameState::chosen);  // lower
    CHECK(state(scene(place(40, 45), 600)) == NameState::chosen); // beside it
    CHECK(state(scene(place(30, 5), 400)) == NameState::chosen);  // behind it
    CHECK(state(scene(place(30, 15), 20)) == NameState::chosen);  // on it
  }
}

TEST_CASE("A grid and the TIN of its triangles print the same names") {
  const auto heights = rough_heights(kSide);
  const auto height_m = [&](int column, int row) {
    return static_cast<double>((*heights)[static_cast<std::size_t>(row * kSide + column)]);
  };
  const Terrain grid = terrain_of(kSide, height_m), tin = tin_of(kSide, height_m);
  Random random(4);
  const auto points = random_names(random, kSide, 60);
  MapSpec spec = from_south(Projection::orthographic); // along columns: dominance along rows
  spec.style.detail.of_file = true;                    // a grid's cells would grow
  spec.labels.size_mm = 4;
  const Map of_grid = Session(grid, {}, {}, names_of(points, grid)).draw(spec),
            of_tin = Session(tin, {}, {}, names_of(points, tin)).draw(spec);
  CHECK(of_grid.facts.names->count(NameState::chosen) >= 5);
  CHECK(of_grid.facts.names->chosen() == of_tin.facts.names->chosen());
}

TEST_CASE("Names of any characters are in every format, and what they lack is told in a line") {
  const Terrain terrain = Terrain::of(borrowed(rough_heights(kSide), kSide));
  Random random(7);
  auto points = random_names(random, kSide, 7);
  const std::vector<std::string> odd{
      "\"Q\" & <b> 'x'", "\xF0\x9F\x8F\x94", "הר חרמון", std::string(300, 'm'),
      "a\x01\tb\x7F",    "富士山",           ""};
  for (std::size_t i = 0; i < odd.size(); ++i) {
    points[i].name = odd[i];
    points[i].map = place(8 + 15 * static_cast<int>(i % 4), 8 + 18 * static_cast<int>(i / 4));
  }
  const Session session(terrain, {}, {}, names_of(points, terrain));
  for (const LetterKind kind : {LetterKind::font, LetterKind::stroke}) {
    MapSpec spec = from_south(Projection::orthographic);
    spec.view.from_elevation = Angle::degrees(90);
    spec.page.width_mm = 400;
    spec.letters.kind = kind;
    const Map map = session.draw(spec);
    CHECK(find_fault(map.drawing).value_or("") == "");
    CHECK(map.facts.names->unnamed == 1);
    CHECK(map.facts.names->count(NameState::chosen) == 6);
    CHECK(state_of(map, "a  b") == NameState::chosen);
    for (const std::string& note : map.facts.lettering) {
      CHECK(note.find('\n') == std::string::npos);
      CHECK(note.size() < 400);
    }
    const bool tells_cut = std::ranges::any_of(map.facts.lettering, [](const std::string& note) {
      return note.find("there is no room for all of 'mmm") != std::string::npos;
    });
    CHECK(tells_cut);
    for (const Format format : {Format::svg, Format::pdf, Format::ps, Format::eps, Format::png,
                                Format::hpgl, Format::gcode, Format::dxf}) {
      if (kind == LetterKind::font && has_one_width(format)) continue;
      INFO(format_names()[static_cast<std::size_t>(format)]);
      const TempFolder folder;
      WriteOptions options;
      options.format = format;
      write_drawing(map.drawing, folder.file("map"), options);
      std::ifstream file(folder.file("map"), std::ios::binary);
      const std::string bytes{std::istreambuf_iterator<char>(file), {}};
      CHECK(bytes.size() > 1000);
      if (format != Format::svg || kind != LetterKind::font) continue;
      for (const char* text : {"&quot;Q&quot; &amp; &lt;b&gt;", "הר חרמון", "富士山", "…</text>"})
        CHECK(bytes.find(text) != std::string::npos);
      CHECK(bytes.find('\x01') == std::string::npos);
    }
  }
}

TEST_CASE("The file's order, threads and a locale with commas change nothing of names",
          "[unsanitized]") {
  const Terrain terrain = Terrain::of(borrowed(rough_heights(kSide), kSide));
  Random random(11);
  auto points = random_names(random, kSide, 60);
  std::vector<MapSpec> specs;
  for (int i = 0; i < 6; ++i) specs.push_back(random_named_spec(random, kSide));
  specs[0].letters.kind = LetterKind::stroke;
  const auto draw_all = [&](int jobs) {
    const Session session(terrain, {}, {}, names_of(points, terrain));
    Control control;
    control.jobs = jobs;
    std::string all;
    for (const MapSpec& spec : specs) all += drawn_bytes(session, spec, control);
    return all;
  };
  const std::string bytes = draw_all(1);
  CHECK((draw_all(4) == bytes));
  std::ranges::reverse(points);
  CHECK((draw_all(2) == bytes));

  const TempFolder folder; // where the machine has no such locale, one is made
  if (!std::setlocale(LC_ALL, "de_DE.UTF-8")) {
    const std::string make = "localedef -i de_DE -f UTF-8 " + folder.file("de_DE.UTF-8") + " 2>&1";
    if (std::system(make.c_str()) == 0) setenv("LOCPATH", folder.path().c_str(), 1);
  }
  if (!std::setlocale(LC_ALL, "de_DE.UTF-8")) {
    WARN("no locale with commas is here, nor localedef's sources");
    return;
  }
  REQUIRE(std::string(std::localeconv()->decimal_point) == ",");
  const std::string with_commas = draw_all(2);
  std::setlocale(LC_ALL, "C");
  unsetenv("LOCPATH");
  CHECK((with_commas == bytes));
}

} // namespace orograph::names_seen_test
