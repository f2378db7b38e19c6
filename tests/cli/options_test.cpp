// SPDX-License-Identifier: GPL-3.0-or-later
// The options of `render` and `info`: each one's effect, each refusal.
#include "cli/options/options.hpp"
#include "geometry/error.hpp"
#include "tests/catch.hpp"
#include "tests/cli/given_options.hpp"
#include "tests/cli/made_files.hpp"
#include "write/same_file.hpp"

#include <array>
#include <cmath>
#include <filesystem>

namespace orograph::options_test {
namespace {

using namespace given_options;

/// Whether the option stores this value, an exception (for --of) being a no.
bool takes(const Option& option, const std::string& text) {
  try {
    return option.take(text);
  } catch (const UsageError&) {
    return false;
  }
}

using Layers = std::vector<LayerSpec>;

} // namespace

TEST_CASE("two names alone give the defaults") {
  const auto s = given({});
  CHECK(s.inputs == std::vector<std::string>{"in.tif"});
  CHECK(s.output == "out.svg");
  CHECK(s.write.format == Format::svg);
  CHECK(s.map.view.from_azimuth == Angle::degrees(180));
  CHECK(s.map.view.from_elevation == Angle::degrees(25));
  CHECK(s.map.view.projection == Projection::perspective);
  CHECK_FALSE(s.map.style.plan);
  CHECK_FALSE(s.map.view.exaggeration);
  CHECK_FALSE(s.map.view.field_of_view);
  CHECK_FALSE(s.progress);
  CHECK(s.map.page.width_mm == 210);
  CHECK(s.map.page.orientation == Orientation::by_picture);
}

TEST_CASE("terrain options") {
  const auto s =
      given({"-b", "2", "--oo", "A=1", "--oo=B=x=y", "--bbox", "-10,-20,30,40", "--overview", "0"});
  CHECK(s.reading.band == 2);
  CHECK(s.reading.open_options == Arguments{"A=1", "B=x=y"});
  REQUIRE(s.reading.bbox);
  CHECK(s.reading.bbox->low == Vec2{-10, -20});
  CHECK(s.reading.overview == 0);
  check_refused({"--band", "0"}, "whole number, at least 1");
  check_refused({"--oo", "A"}, "NAME=VALUE");
  check_refused({"--oo", "=1"}, "NAME=VALUE");
  check_refused({"--bbox", "30,0,10,40"}, "XMIN below XMAX");
  check_refused({"--overview", "-1"}, "0 to 100");
}

TEST_CASE("view options") {
  const auto framed = given({"--view-from", "225/15", "--fov", "60", "--distance", "5000",
                             "--look-at=-1,2,3", "--roll", "-10", "--exaggeration", "2"});
  CHECK(framed.map.view.from_azimuth == Angle::degrees(225));
  CHECK(framed.map.view.from_elevation == Angle::degrees(15));
  CHECK(framed.map.view.field_of_view == Angle::degrees(60));
  CHECK(framed.map.view.distance_m == 5000.0);
  CHECK(framed.map.view.look_at_map == Vec3{-1, 2, 3});
  CHECK(framed.map.view.roll == Angle::degrees(-10));
  CHECK(framed.map.view.exaggeration == 2.0);
  CHECK_FALSE(given({"--exaggeration", "auto"}).map.view.exaggeration);
  CHECK(given({"--eye", "-120,5,3"}).map.view.eye_map == Vec3{-120, 5, 3});
  CHECK(given({"--roll", "-.5"}).map.view.roll == Angle::degrees(-0.5));
  CHECK(given({"--projection", "orthographic"}).map.view.projection == Projection::orthographic);

  check_refused({"--view-from", "180"}, "EL from 0 to 90");
  check_refused({"--view-from", "180/91"}, "EL from 0 to 90");
  check_refused({"--fov", "0"}, "above 0");
  check_refused({"--fov", "180"}, "less than 180");
  check_refused({"--distance", "-5"}, "metres, above 0");
  check_refused({"--eye", "1"}, "X,Y[,Z]");
  check_refused({"--exaggeration", "0"}, "or auto");
  check_refused({"--projection", "panorama"}, "cylindrical");
  check_refused({"--projection", "isometric"}, "perspective|orthographic|oblique");
}

TEST_CASE("oblique and axonometric views by name") {
  CHECK(given({"--projection", "oblique"}).map.view.projection == Projection::oblique);
  const auto length_and_rise = [](const Arguments& options) {
    const RenderSettings s = given(options);
    CHECK(s.map.view.projection == Projection::oblique);
    return std::pair(s.map.view.oblique.length, s.map.view.oblique.rise.in_degrees());
  };
  CHECK(length_and_rise({"--projection", "oblique"}) == std::pair(1.0, 45.0));
  CHECK(length_and_rise({"--oblique", "cavalier"}) == std::pair(1.0, 45.0));
  CHECK(length_and_rise({"--oblique", "cabinet"}) == std::pair(0.5, 45.0));
  CHECK(length_and_rise({"--oblique", "military"}) == std::pair(1.0, 90.0));
  CHECK(length_and_rise({"--oblique", "0.7,135"}) == std::pair(0.7, 135.0));
  const RenderSettings isometric = given({"--axonometric", "isometric"});
  CHECK(isometric.map.view.projection == Projection::orthographic);
  // Of the three axes of the map, shortened by the view.
  const auto shares = [](const RenderSettings& s) {
    const double a = s.map.view.from_azimuth.in_radians(),
                 e = s.map.view.from_elevation.in_radians();
    return std::array{std::hypot(std::cos(a), std::sin(a) * std::sin(e)),
                      std::hypot(std::sin(a), std::cos(a) * std::sin(e)), std::cos(e)};
  };
  for (const double share : shares(isometric)) CHECK(std::abs(share - std::sqrt(2. / 3)) <= 1e-15);
  const auto dimetric = shares(given({"--axonometric", "dimetric"}));
  CHECK(std::abs(dimetric[0] - dimetric[2]) <= 1e-15);
  CHECK(std::abs(dimetric[1] - dimetric[2] / 2) <= 1e-15);
  const auto trimetric = shares(given({"--axonometric", "trimetric"}));
  CHECK(std::abs(trimetric[0] - trimetric[1]) > 0.05);
  CHECK(std::abs(trimetric[0] - trimetric[2]) > 0.01);

  check_refused({"--oblique", "1"}, "ALPHA from 0 to 180");
  check_refused({"--oblique", "0,45"}, "L above 0");
  check_refused({"--oblique", "cavalier", "--projection", "perspective"}, "leave --projection out");
  check_refused({"--oblique", "cavalier", "--eye", "1,2,3"}, "no meaning in a parallel view");
  check_refused({"--axonometric", "isometric", "--view-from", "1/2"}, "exclude each other");
  check_refused({"--axonometric", "diametric"}, "isometric|dimetric|trimetric");
}

TEST_CASE("NaN and infinity are no values, for any option that takes a number") {
  RenderSettings settings;
  const Command command = render_command(settings);
  int numbers = 0;
  for (const auto& option : command.options) {
    if (option.is_positional() || option.is_switch() || takes(option, "word") ||
        takes(option, "one,two,three"))
      continue;
    ++numbers;
    for (const std::string text :
         {"nan", "-nan", "inf", "-inf", "1e999", "nan,nan,nan", "nan,nan,nan,nan", "nan/nan",
          "180/inf", "nanmm", "infm", "nanxinf", ""}) {
      INFO(option.name << " " << text);
      CHECK_FALSE(takes(option, text));
    }
    check_refused({option.name, "-inf"}, ": ");
  }
  CHECK(numbers > 15);
}

TEST_CASE("options of lines and page") {
  const auto s = given({"--profiles",
                        "150",
                        "--occluder",
                        "surface",
                        "--visibility-tolerance",
                        "0",
                        "--simplify",
                        "0",
                        "--flat",
                        "draw",
                        "--layers",
                        "border,profiles",
                        "--page",
                        "A3",
                        "--landscape",
                        "--margin",
                        "5",
                        "--pen-width",
                        "0.3",
                        "--title",
                        "Two words"});
  CHECK(std::get<ProfileCount>(s.map.style.plan.value()).count == 150);
  CHECK(s.map.style.occluder == Occluder::surface);
  CHECK(s.map.style.visibility_tolerance_mm == 0);
  CHECK(s.map.style.simplify_mm == 0);
  CHECK(s.map.style.flat == FlatGround::draw);
  CHECK(s.map.style.layers == Layers{"border", "profiles"});
  CHECK(given({"--flat", "waterlines"}).map.style.flat == FlatGround::waterlines);
  CHECK_FALSE(s.void_edges);
  CHECK(given({"--void-edges"}).void_edges);
  CHECK(given({"--void-edges"}).map.style.asks_for("voids"));
  CHECK_FALSE(given({}).map.style.asks_for("voids"));
  CHECK(given({"--void-edges", "--layers", "voids"}).map.style.layers == Layers{"voids"});
  CHECK(given({"--layers", "voids,border"}).map.style.layers == Layers{"voids", "border"});
  CHECK(s.map.page.width_mm == 297);
  CHECK(s.map.page.height_mm == 420);
  CHECK(s.map.page.orientation == Orientation::landscape);
  CHECK(s.map.page.margin_mm == 5);
  CHECK(s.map.style.pen_width_mm == 0.3);
  CHECK(s.map.title == "Two words");
  CHECK(std::get<PageSpacing>(given({"--spacing", "0.6mm"}).map.style.plan.value()).mm == 0.6);
  CHECK(given({"--page", "400x250"}).map.page.orientation == Orientation::as_given);
  CHECK(given({"--portrait", "--page", "400x250"}).map.page.orientation == Orientation::portrait);

  check_refused({"--profiles", "0"}, "1 to 100000");
  check_refused({"--profiles", "100001"}, "1 to 100000");
  check_refused({"--spacing", "0.6"}, "0.6mm on the page or 100m on the ground");
  check_refused({"--occluder", "all"}, "surface|profiles");
  check_refused({"--simplify", "-0.1"}, "mm, 0 to 10");
  check_refused({"--visibility-tolerance", "-1"}, "mm, 0 to 10");
  check_refused({"--flat", "no"}, "shore|draw");
  check_refused({"--layers", "profiles,profiles"},
                "each once of profiles, underside, mesh, hachures, walls, wall-contours, "
                "wall-index-contours, block, contours, index-contours, graticule, grid, edges, "
                "waterlines, shores, border, drape, voids");
  check_refused({"--layers", "hatching"}, "each once of");
  check_refused({"--layers", ""}, "each once of");
  check_refused({"--page", "a99"}, "a4");
  check_refused({"--page", "0x100"}, "1 to 10000");
  check_refused({"--margin", "-1"}, "mm, at least 0");
  check_refused({"--margin", "105"}, "--margin 104.5 or less");
  check_refused({"--page", "1x1"}, "larger --page");
  check_refused({"--pen-width", "0"}, "mm, 0.01 to 10");
}

TEST_CASE("output options") {
  const auto s = given({"--of", "PNG", "--dpi", "600", "--overwrite", "--report", "r.json", "-q"});
  CHECK(s.write.format == Format::png);
  CHECK(s.write.dpi == 600);
  CHECK(s.write.overwrite);
  CHECK(s.report == "r.json");
  CHECK(s.quiet);
  CHECK(given({"--progress"}).progress == true);
  CHECK(given({"--no-progress", "-q"}).progress == false);
  CHECK(parse_render({"in.tif", "-", "--of", "svg"})->output == "-");

  check_refused({"--of", "dwg"}, "geojson");
  check_refused({"--dpi", "300"}, "--of png");
  check_refused({"--of", "png", "--dpi", "5"}, "10 to 4800");
  check_refused({"--of", "png", "--dpi", "4800", "--page", "a0"}, "or less");
  check_refused({"--report", ""}, "a file name");
  CHECK(refusal_of({"in.tif", "out.dwg"}).find("svg") != std::string::npos);
  CHECK(refusal_of({"in.tif", "-"}).find("--of svg") != std::string::npos);
  CHECK(refusal_of({"in.tif", "-", "--of", "pdf"}).find("text format") != std::string::npos);
  CHECK(refusal_of({"in.tif", ""}).find("OUTPUT '' can't be used") != std::string::npos);
}

TEST_CASE("options that exclude each other") {
  check_refused({"--view-from", "180/25", "--eye", "1,2,3"}, "exclude each other");
  check_refused({"--distance", "10", "--eye", "1,2,3"}, "exclude each other");
  check_refused({"--profiles", "10", "--spacing", "1mm"}, "exclude each other");
  check_refused({"--portrait", "--landscape"}, "exclude each other");
  check_refused({"--progress", "--no-progress"}, "exclude each other");
  check_refused({"-q", "--progress"}, "exclude each other");
  for (const Arguments& option :
       {Arguments{"--distance", "10"}, {"--fov", "30"}, {"--eye", "1,2,3"}}) {
    Arguments options{"--projection", "orthographic"};
    options.insert(options.end(), option.begin(), option.end());
    check_refused(options, option.front() + " has no meaning in a parallel view");
  }
  check_refused({"--eye", "1,2,3", "--look-at", "1,2,3"}, "the same point");
}

TEST_CASE("eye and target on the ground, by longitude and latitude, in a direction") {
  const auto s = given({"--eye-lonlat", "-118.2,34.3", "--eye-height", "1.6", "--look-azimuth",
                        "-30", "--pitch", "-2.5"});
  CHECK(s.map.view.eye_lonlat == GivenPlace(-118.2, 34.3));
  CHECK_FALSE(s.map.view.eye_map);
  CHECK(s.map.view.has_eye());
  CHECK(s.map.view.eye_height_m == 1.6);
  CHECK(s.map.view.look_azimuth == Angle::degrees(-30));
  CHECK(s.map.view.pitch == Angle::degrees(-2.5));
  CHECK(given({"--eye", "4e5,5e6"}).map.view.eye_map == GivenPlace(4e5, 5e6));
  CHECK(given({"--look-at-lonlat", "235.5,-90,12"}).map.view.look_at_lonlat ==
        Vec3{235.5, -90, 12});
  CHECK_FALSE(given({"--look-at", "1,2"}).map.view.has_eye());
  CHECK(given({"--projection", "orthographic", "--look-at-lonlat", "1,2"}).map.view.look_at_lonlat);

  for (const std::string option : {"--eye-lonlat", "--look-at-lonlat"}) {
    check_refused({option, "34.3,-118.2"}, "-118.2 is no latitude: longitude comes first: "
                                           "-118.2,34.3");
    check_refused({option, "120,100"}, "100 is no latitude: latitudes are from -90 to 90");
    check_refused({option, "-181,3"}, "LON from -180 to 360");
    check_refused({option, "361,3,5"}, "LON from -180 to 360");
    check_refused({option, "9"}, "LON,LAT[,H]");
    check_refused({option, "9,nan"}, "LON,LAT[,H]");
  }
  check_refused({"--eye-height", "0"}, "metres, above 0");
  check_refused({"--pitch", "91"}, "-90 to 90");

  const Arguments eye{"--eye-lonlat", "1,2"};
  const auto with_eye = [&](Arguments options) {
    options.insert(options.begin(), eye.begin(), eye.end());
    return options;
  };
  for (const Arguments& option : {Arguments{"--eye", "1,2"},
                                  {"--view-from", "180/25"},
                                  {"--distance", "10"},
                                  {"--view", "a.toml"}})
    check_refused(with_eye(option), "exclude each other");
  for (const Arguments& option : {Arguments{"--look-azimuth", "10"}, {"--pitch", "3"}})
    for (const std::string target : {"--look-at", "--look-at-lonlat"}) {
      Arguments options = with_eye(option);
      options.insert(options.end(), {target, "3,4"});
      check_refused(options, "exclude each other");
    }
  check_refused({"--look-at", "1,2", "--look-at-lonlat", "3,4"}, "exclude each other");
  check_refused(with_eye({"--look-at-lonlat", "1,2"}), "the same point");
  CHECK(refusal(with_eye({"--look-at", "1,2"})) == "accepted"); // coordinates of something else
  for (const Arguments& option :
       {Arguments{"--eye-height", "3"}, {"--look-azimuth", "10"}, {"--pitch", "3"}}) {
    check_refused(option, option.front() + " has no meaning without an eye");
    Arguments parallel = with_eye(option);
    parallel.insert(parallel.end(), {"--oblique", "cabinet"});
    check_refused(parallel, " has no meaning in a parallel view");
    check_refused({option.front(), option.back(), "--view", "a.toml"}, "exclude each other");
  }
  check_refused(with_eye({"--pitch", "3"}), "give --look-azimuth DEG too");
  check_refused({"--eye", "1,2,3", "--eye-height", "4"}, "give --eye X,Y, or leave");
  check_refused({"--eye-lonlat", "1,2,3", "--eye-height", "4"}, "give --eye-lonlat LON,LAT, or");
}

TEST_CASE("a command line that isn't one") {
  check_refused({"--fow", "30"}, "unknown option --fow: did you mean --fov?");
  check_refused({"--fow=30"}, "did you mean --fov?");
  check_refused({"-of", "svg"}, "did you mean --of?");
  check_refused({"--exag", "2"}, "did you mean --exaggeration?");
  check_refused({"--zzzzzzzzzzzz"}, "unknown option --zzzzzzzzzzzz: orograph render --help");
  check_refused({"--fov", "--roll", "3"}, "--fov has no value");
  check_refused({"--fov="}, "--fov '' can't be used");
  check_refused({"--fov", "30", "--fov", "40"}, "--fov is given 2 times");
  check_refused({"--overwrite=false"}, "takes no value");
  CHECK(refusal_of({}).find("no INPUT") != std::string::npos);
  CHECK(refusal_of({"in.tif"}).find("no OUTPUT") != std::string::npos);
  CHECK(refusal_of({"in.tif", "out.svg", "--fov"}).find("--fov has no value") != std::string::npos);
}

TEST_CASE("forms of giving a value") {
  CHECK(given({"--title="}).map.title.empty());
  CHECK(given({"--title", ""}).map.title.empty());
  CHECK(given({"--title=--fov"}).map.title == "--fov");
  CHECK(given({"-b2"}).reading.band == 2);
  CHECK(given({"-qb", "2"}).reading.band == 2);
  CHECK(parse_render({"--", "-in.tif", "-out.svg"})->inputs == std::vector<std::string>{"-in.tif"});
  CHECK_FALSE(parse_render({"--help"}));
  CHECK_FALSE(parse_render({"--help-all"}));
  CHECK_FALSE(parse_render({"-h", "in.tif"}));
}

TEST_CASE("an output is never an input") {
  const MadeFolder folder;
  const std::string input = folder.write("in.svg", "heights");
  namespace fs = std::filesystem;
  fs::create_symlink(input, folder.path("link.svg"));
  fs::create_hard_link(input, folder.path("hard.svg"));
  fs::create_directory(folder.path("sub"));

  for (const std::string& output :
       {input, folder.path("link.svg"), folder.path("hard.svg"), folder.path("sub/../in.svg")}) {
    INFO(output);
    CHECK(refusal_of({input, output}).find("is the INPUT") != std::string::npos);
    CHECK(refusal_of({input, folder.path("out.svg"), "--report", output}).find("is the INPUT") !=
          std::string::npos);
  }
  CHECK(refusal_of({input, folder.path("out.svg"), "--report", folder.path("sub/../out.svg")})
            .find("is the OUTPUT too") != std::string::npos);
  CHECK(refusal_of({input, folder.path("out.svg")}) == "accepted");

  CHECK(replaces_input("/vsizip/" + input + "/a/b.tif", input));
  CHECK(replaces_input("/vsigzip//vsitar/" + input + "/b.tif", input));
  CHECK(replaces_input("NETCDF:\"" + input + "\":band", input));
  CHECK(replaces_input("GPKG:" + input + ":heights", input));
  CHECK_FALSE(replaces_input(input, folder.path("out.svg")));
  CHECK_FALSE(replaces_input(folder.path("sub/other.tif"), input));
}

TEST_CASE("options of info") {
  const auto s = parse_info({"in.tif", "-b", "3", "--bbox", "0,0,1,1", "--overview", "1"});
  REQUIRE(s);
  CHECK(s->inputs == std::vector<std::string>{"in.tif"});
  CHECK(s->reading.band == 3);
  CHECK(s->reading.overview == 1);
  CHECK_FALSE(parse_info({"--help"}));
  CHECK_THROWS_AS(parse_info({"in.tif", "--fov", "30"}), UsageError);
}

TEST_CASE("points to look at come from the network where the terrain may") {
  const std::vector<std::string> asked = {"dem.tif", "peaks.csv", "--eye",
                                          "1,2",     "--output",  "seen.csv"};
  const auto without = parse_visible(asked);
  REQUIRE(without);
  CHECK_FALSE(without->points.allow_network);
  std::vector<std::string> allowed = asked;
  allowed.push_back("--allow-network");
  const auto with = parse_visible(allowed);
  REQUIRE(with);
  CHECK(with->points.allow_network);
}

} // namespace orograph::options_test
