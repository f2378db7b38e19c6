// SPDX-License-Identifier: GPL-3.0-or-later
// Options from a file: drawn again from a report, beside a command line, and before other defaults.
#include "cli/options/options.hpp"
#include "cli/options/settings_file.hpp"
#include "geometry/error.hpp"
#include "tests/catch.hpp"
#include "tests/cli/made_files.hpp"
#include "tests/cli/made_scenes.hpp"
#include "tests/cli/run_program.hpp"

#include <nlohmann/json.hpp>

#include <filesystem>
#include <functional>
#include <set>
#include <sstream>

using namespace orograph;
using Words = std::vector<std::string>;

namespace {

constexpr int kSide = 40;

Words words_of(const std::string& text) {
  std::istringstream stream(text);
  return {std::istream_iterator<std::string>(stream), {}};
}

std::string hill() {
  return ascii_grid(kSide, kSide, [](int column, int row) {
    return column < 6 ? 60 : hill_m(column, row, kSide) + 3 * ((7 * column + 5 * row) % 11);
  });
}

RenderSettings given(const Words& options, const std::string& output = "out.svg") {
  Words arguments{"in.tif", output};
  arguments.insert(arguments.end(), options.begin(), options.end());
  return *parse_render(arguments);
}

std::string refusal(const Words& options) {
  try {
    given(options);
  } catch (const Error& error) {
    return error.what();
  }
  return "accepted";
}

std::string settings_line(const std::string& option, const std::string& value) {
  return option.substr(2) + " = '" + value + "'\n";
}

} // namespace

TEST_CASE("a drawing is made again from the settings in its report alone") {
  const MadeFolder folder;
  make_scenes(folder);
  folder.write("hill.asc", hill());
  folder.write("hill.prj", kUtm32);
  std::filesystem::create_directory(folder.path("reports"));
  int number = 0;
  for (const std::string options :
       {"",
        "--view-from 210/35 --exaggeration 3",
        "--view-from 300/5 --fov 60 --roll 7 --profiles 40",
        "--distance 900 --exaggeration auto",
        "--distance 900 --fov 20 --spacing 15m",
        "--projection orthographic --view-from 10/90 --light off",
        "--oblique cabinet --page 120x80 --portrait --title=",
        "--projection oblique --page a5 --landscape --margin 3 --pen-width 0.4 --title 'two words'",
        "--axonometric dimetric",
        "--eye 210,40 --eye-height 20 --haze 0 --pen-width 0.1:0.4",
        "--eye 210,40,400 --look-at 200,300 --light off --haze 0",
        "--eye 210,40 --look-azimuth 20 --pitch -4 --fov 80",
        "--eye-lonlat 4.5115,0.0001 --look-at-lonlat 4.5125,0.003 --refraction 0.2",
        "--curvature on --curvature-coefficient 0.8",
        "--spacing 2mm --spread planes --light off",
        "--light 120/30 --light-contrast 2 --light-smooth 3 --light-by density",
        "--occluder profiles --layers profiles,border",
        "--simplify 0.3 --visibility-tolerance 0 --silhouette-jump 0.1 --join 0 --min-stroke 0 "
        "--outline by-layer",
        "--min-stroke 3 --flat draw --void-edges",
        "--bbox 50,50,350,330 --height-unit ft --fill-voids 3",
        "--bbox-lonlat 4.5113,0,4.514,0.003",
        "--scene hut.toml --hidden dash --view-from 200/30",
        "--view flat.toml --profiles 30",
        "--of geojson --min-stroke 2 --view-from 100/10",
        "--of png --dpi 60",
        "--of ps --pen-order drawing",
        "--pen-order best --clip-to 100x90",
        "--of hpgl --device hp7475a --margin 14",
        "--pens pens.toml --pause-between-pens",
        "--of gcode --device grbl-z --page 100x80"}) {
    INFO(options);
    folder.write("pens.toml",
                 "[[pen]]\nnumber = 1\nwidth = 0.1\n[[pen]]\nnumber = 2\nwidth = 0.2\n");
    folder.write("flat.toml", "projection = 'parallel'\nvrp = [200, 200, 100]\nvpn = [0, -1, 1]\n"
                              "prp = [0, 0, 100]\nwindow = [-200, -200, 200, 200]\n");
    const std::string name = std::to_string(++number);
    const std::string report = (number % 2 == 0 ? "reports/" : "") + name + ".json";
    Words first{"render", "hill.asc", name + "-first.svg", "--report", report};
    for (std::string word : words_of(options)) {
      if (word == "'two") word = "two words";
      if (word != "words'") first.push_back(word);
    }
    const ProgramRun drawn = run_orograph(first, {.folder = folder.path()});
    INFO(drawn.err);
    REQUIRE(drawn.exit_code == 0);
    const ProgramRun again = run_orograph({"render", "hill.asc", name + "-again.svg", "--settings",
                                           report, "--report", name + "-again.json"},
                                          {.folder = folder.path()});
    INFO(again.err);
    REQUIRE(again.exit_code == 0);
    CHECK(folder.read(name + "-first.svg") == folder.read(name + "-again.svg"));
    // Nothing is lost on the way, and nothing more is found.
    const auto settings = [&](const std::string& path) {
      nlohmann::json all = nlohmann::json::parse(folder.read(path))["settings"];
      for (const char* file : {"scene", "view", "pens"})
        all.erase(file); // each from its report's folder
      return all;
    };
    CHECK(settings(report) == settings(name + "-again.json"));
  }
  CHECK(number >= 30);
}

TEST_CASE("defaults are written out as values, or in words that no option takes for one") {
  RenderSettings settings;
  const Command command = render_command(settings);
  int values = 0;
  for (const Option& option : command.options) {
    if (option.by_default.empty()) continue;
    INFO(option.name << " " << option.by_default);
    if (option.by_default.find(' ') != std::string::npos) continue;
    const bool is_value = option.take(option.by_default);
    values += is_value ? 1 : 0;
    CHECK((is_value || option.name == "--max-edge" || option.name == "--jobs"));
  }
  CHECK(values > 20);
  // What has no default in the table, and isn't given, can only be what depends on the terrain.
  std::set<std::string> written;
  for (const auto& [name, its_values] : given({}).options) written.insert("--" + name);
  for (const Option& option : command.options) {
    const bool is_chosen =
        option.by_default.empty() || option.by_default.find(' ') != std::string::npos ||
        std::set<std::string>{"--pitch",        "--eye-height",      "--hidden",        "--dpi",
                              "--max-edge",     "--overlap",         "--hidden-layers", "--strips",
                              "--horizon-step", "--hachure-spacing", "--hachure-slope"}
            .contains(option.name) ||
        option.group == "General" || option.name == "--check" ||
        option.name.starts_with("--label-"); // of names that there are
    INFO(option.name);
    CHECK(written.contains(option.name) != is_chosen);
  }
}

TEST_CASE("the command line goes before a settings file") {
  const MadeFolder folder;
  const std::string file = folder.write(
      "a.toml", "view-from = \"200/30\" # a comment\nfov = 40\nsimplify = 1e-1\nprofiles = \"77\"\n"
                "light = 'off'\nportrait = true\nvoid-edges = false\noo = ['A=1', 'B=2']\n"
                "layers = 'profiles,skyline'\nquiet = true\n");
  const RenderSettings s = given({"--settings", file});
  CHECK(s.map.view.from_azimuth == Angle::degrees(200));
  CHECK(s.map.view.field_of_view == Angle::degrees(40));
  CHECK(s.map.style.simplify_mm == 0.1);
  CHECK(std::get<ProfileCount>(s.map.style.plan.value()).count == 77);
  CHECK_FALSE(s.map.style.light);
  CHECK(s.map.page.orientation == Orientation::portrait);
  CHECK_FALSE(s.void_edges);
  CHECK(s.reading.open_options == Words{"A=1", "B=2"});
  CHECK(s.map.style.layers == std::vector<LayerSpec>{"profiles", "skyline"});
  CHECK(s.quiet);

  CHECK(given({"--settings", file, "--fov", "50"}).map.view.field_of_view == Angle::degrees(50));
  CHECK(given({"--fov", "50", "--settings", file}).map.view.field_of_view == Angle::degrees(50));
  CHECK(given({"--settings", file, "--oo", "C=3"}).reading.open_options == Words{"C=3"});
  // Of the file nothing is taken that is in conflict with the command line.
  const RenderSettings eye = given({"--settings", file, "--eye", "1,2,3"});
  CHECK(eye.map.view.eye_map == GivenPlace(Vec3{1, 2, 3}));
  CHECK(eye.map.view.from_azimuth == ViewSpec{}.from_azimuth);
  CHECK(eye.map.view.field_of_view == Angle::degrees(40));
  CHECK(
      std::get<PageSpacing>(given({"--settings", file, "--spacing", "2mm"}).map.style.plan.value())
          .mm == 2);
  CHECK(given({"--settings", file, "--landscape"}).map.page.orientation == Orientation::landscape);
  CHECK(given({"--settings", file, "--progress"}).quiet == false);
  // Two of the command line still exclude each other, and so do two of a file.
  CHECK(refusal({"--settings", file, "--eye", "1,2", "--look-at", "3,4", "--pitch", "1"}) ==
        "--look-at and --pitch exclude each other: the point tells how steeply to look");
  const std::string two = folder.write("two.toml", "fov = 30\nspacing = '1mm'\nprofiles = 3\n");
  CHECK(refusal({"--settings", two}) ==
        two + ", line 3: --profiles and --spacing exclude each other: give one of the two");
  CHECK(refusal({"--settings", two, "--profiles", "5"}) == "accepted");
}

TEST_CASE("what has no meaning in a drawing is passed over in a settings file") {
  const MadeFolder folder;
  const auto with = [&](const std::string& lines, Words options) {
    options.insert(options.end(), {"--settings", folder.write("a.toml", lines)});
    return options;
  };
  CHECK(refusal(with("dpi = 300\npitch = 0\neye-height = 3\nlook-azimuth = 9\nhidden = 'dash'\n",
                     {})) == "accepted");
  const RenderSettings parallel = given(with(
      "fov = 40\ndistance = 3\nrefraction = 0.2\npitch = 0\n", {"--projection", "orthographic"}));
  CHECK_FALSE(parallel.map.view.field_of_view);
  CHECK_FALSE(parallel.map.view.distance_m);
  CHECK(given(with("pitch = 0\n", {"--eye", "1,2", "--look-at", "3,4"})).map.view.look_at_map);
  CHECK(given(with("projection = 'perspective'\n", {"--oblique", "cabinet"})).map.view.projection ==
        Projection::oblique);
  CHECK(given(with("oblique = 'cabinet'\n", {"--projection", "perspective"})).map.view.projection ==
        Projection::perspective);
  CHECK(refusal(with("oblique = 'cabinet'\nprojection = 'perspective'\n", {}))
            .find("a projection of its own") != std::string::npos);
  CHECK_FALSE(given(with("eye-height = 3\n", {"--eye", "1,2,3"})).map.view.eye_height_m);
  CHECK(refusal(with("eye = '1,2'\n", {"--projection", "oblique"})) ==
        "--eye has no meaning in a parallel view: give --view-from AZ/EL, or use --projection "
        "perspective");
  // One file serves all commands: an option of another one isn't unknown.
  CHECK(refusal(with("azimuth = '0:360:5'\nrepeats = 3\nworst-case = 5\n", {})) == "accepted");
  const auto sweep = parse_sweep(with("view-from = '1/2'\nelevation = '5,10'\nlight = 'off'\n",
                                      {"in.tif", "out", "--azimuth", "0,90"}));
  REQUIRE(sweep);
  CHECK(sweep->axes.size() == 2);
  CHECK_FALSE(sweep->render.map.style.light);
  CHECK(sweep->options.contains("--elevation"));
  CHECK_FALSE(sweep->options.contains("--settings"));
  const auto accuracy = parse_accuracy(with("profiles = '20,rows'\nlight = 'off'\n", {"in.tif"}));
  REQUIRE(accuracy);
  CHECK(accuracy->profiles.size() == 2);
  CHECK(parse_fragmentation(with("azimuths = 90\nfov = 3\n", {"in.tif"}))->azimuths_deg ==
        std::vector<double>{90});
}

TEST_CASE("paths in a settings file are taken from its folder") {
  const MadeFolder folder;
  make_scenes(folder);
  std::filesystem::create_directory(folder.path("sub"));
  const auto scene_of = [&](const std::string& name, const std::string& value) {
    return given({"--settings", folder.write(name, settings_line("--scene", value))}).scene_file;
  };
  CHECK(scene_of("a.toml", "hut.toml") == folder.path("hut.toml"));
  CHECK(scene_of("sub/a.toml", "../hut.toml") == folder.path("sub/../hut.toml"));
  CHECK(scene_of("sub/b.toml", folder.path("hut.toml")) == folder.path("hut.toml"));
  const std::string gdal = folder.write("c.toml", settings_line("--breaklines", "GPKG:a.gpkg:b"));
  CHECK(given({"--settings", gdal}).reading.breaklines == "GPKG:a.gpkg:b");
  // What is written is named from where the command runs.
  CHECK(given({"--settings", folder.write("d.toml", settings_line("--report", "r.json"))}).report ==
        "r.json");
}

TEST_CASE("plain settings are of use beside any view") {
  const std::string plain = OROGRAPH_SOURCE_DIR "/data_samples/settings/plain.toml";
  for (const Words& options : {Words{},
                               {"--eye", "1,2"},
                               {"--eye", "1,2", "--look-at", "3,4"},
                               {"--oblique", "cabinet"},
                               {"--projection", "orthographic"},
                               {"--view-from", "1/2"},
                               {"--profiles", "3"}}) {
    Words all{"--settings", plain};
    all.insert(all.end(), options.begin(), options.end());
    CHECK(refusal(all) == "accepted");
    CHECK_FALSE(given(all).map.style.light);
  }
}
