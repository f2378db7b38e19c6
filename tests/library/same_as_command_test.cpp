// SPDX-License-Identifier: GPL-3.0-or-later
// What the library draws and writes is, byte for byte, what `orograph render` writes.
#include "orograph.hpp"
#include "tests/catch.hpp"
#include "tests/cli/made_files.hpp"
#include "tests/cli/run_program.hpp"

#include <functional>
#include <string>
#include <vector>

using namespace orograph;

namespace {

using Words = std::vector<std::string>;

const std::string kData = std::string(OROGRAPH_SOURCE_DIR) + "/data_samples/";

// One request in the command's words and in the library's.
struct Request {
  std::string format;
  Words words;
  std::function<void(MapSpec&)> set;
};

// Both outputs of one terrain; `draw` is the library's.
void check_same(const Words& inputs, const std::function<Session()>& open,
                const std::vector<Request>& requests) {
  const MadeFolder folder;
  const Session session = open();
  for (const auto& [format, words, set] : requests) {
    Words command{"render"};
    command.insert(command.end(), inputs.begin(), inputs.end());
    command.insert(command.begin() + 2, "command." + format);
    command.insert(command.end(), words.begin(), words.end());
    command.insert(command.end(), {"--overwrite", "--quiet"});
    const ProgramRun run = run_orograph(command, {.folder = folder.path()});
    INFO(inputs.front() << " as " << format << ": " << run.err);
    REQUIRE(run.exit_code == 0);

    MapSpec spec;
    if (set) set(spec);
    const std::string path = folder.path("library." + format);
    const WriteOptions options{.format = format_of_path(path), .overwrite = true};
    spec.ground_points = is_tied_to_ground(options.format);
    spec.pen_order = pen_order_for(options.format);
    if (has_one_width(options.format)) spec.style.light->by_density = true;
    write_drawing(session.draw(spec).drawing, path, options);
    CHECK(folder.read("library." + format).size() > 400);
    CHECK((folder.read("library." + format) == folder.read("command." + format)));
  }
}

} // namespace

TEST_CASE("the default view in every format") {
  std::vector<Request> requests;
  for (const char* format :
       {"svg", "pdf", "ps", "eps", "png", "geojson", "gpkg", "hpgl", "gcode", "dxf"})
    requests.push_back({format, {}, {}});
  const std::string dem = kData + "volcano.tif";
  check_same(
      {dem}, [&] { return Session(Terrain::read({dem})); }, requests);
}

TEST_CASE("views, styles and pages of a terrain with solids on it") {
  const std::string dem = kData + "volcano.tif", scene = kData + "scenes/village.toml";
  const Request all_layers{
      "svg",
      {"--layers", "profiles,edges,shores,border,voids,silhouettes,skyline,solids", "--hidden",
       "dash", "--projection", "orthographic", "--view-from", "300/40", "--silhouette-jump", "0",
       "--min-stroke", "0.4", "--title", "All of it"},
      [](MapSpec& spec) {
        spec.style.layers = {"profiles",    "edges",   "shores", "border", "voids",
                             "silhouettes", "skyline", "solids", "hidden"};
        spec.view.projection = Projection::orthographic;
        spec.view.from_azimuth = Angle::degrees(300);
        spec.view.from_elevation = Angle::degrees(40);
        spec.style.silhouette_jump = 0;
        spec.style.min_stroke_mm = 0.4;
        spec.title = "All of it";
      }};
  const Request profiles_alone{"geojson",
                               {"--occluder", "profiles", "--profiles", "50", "--exaggeration",
                                "2.5", "--flat", "draw", "--page", "200x100", "--margin", "7",
                                "--pen-width", "0.3"},
                               [](MapSpec& spec) {
                                 spec.style.occluder = Occluder::profiles;
                                 spec.style.plan = ProfileCount{50};
                                 spec.view.exaggeration = 2.5;
                                 spec.style.flat = FlatGround::draw;
                                 spec.page = {200, 100, Orientation::as_given, 7};
                                 spec.style.pen_width_mm = 0.3;
                               }};
  const Request coloured{"png",
                         {"--contours", "auto", "--palette", "map", "--colour",
                          "profiles=#123456,index-contours=brown", "--dpi", "300"},
                         [](MapSpec& spec) {
                           spec.style.palette = Palette::map;
                           spec.style.layers.emplace_back("contours");
                           spec.style.layers.emplace_back("index-contours").colour =
                               colour_of("brown");
                           spec.style.layers.front().colour = Colour{0x12, 0x34, 0x56};
                         }};
  check_same({dem, "--scene", scene},
             [&] { return Session(Terrain::read({dem}), Solids::read(scene)); },
             {{"svg", {}, {}}, all_layers, coloured});
  const Request hidden{
      "svg",
      {"--contours", "20m", "--contour-ticks", "--hidden-layers", "contours,border,profiles"},
      [](MapSpec& spec) {
        spec.style.contours.interval = 20;
        spec.style.contours.unit_m = 1;
        spec.style.contours.ticks = true;
        spec.style.layers.insert(spec.style.layers.end(), {"contours", "hidden-contours",
                                                           "hidden-border", "hidden-profiles"});
      }};
  check_same({dem}, [&] { return Session(Terrain::read({dem})); }, {profiles_alone, hidden});
}

TEST_CASE("a terrain in degrees, from its side and from an eye on it") {
  const std::string dem = kData + "archipelago.tif";
  const Request from_an_eye{"svg",
                            {"--eye-lonlat", "2.45,0.15", "--look-azimuth", "30", "--pitch", "-5",
                             "--eye-height", "400", "--fov", "90"},
                            [](MapSpec& spec) {
                              spec.view.eye_lonlat = GivenPlace(2.45, 0.15);
                              spec.view.look_azimuth = Angle::degrees(30);
                              spec.view.pitch = Angle::degrees(-5);
                              spec.view.eye_height_m = 400;
                              spec.view.field_of_view = Angle::degrees(90);
                            }};
  check_same({dem}, [&] { return Session(Terrain::read({dem})); },
             {{"geojson", {}, {}}, from_an_eye});
}

TEST_CASE("points with breaklines, checked by the ray walk") {
  const std::string points = kData + "quarry_points.csv",
                    lines = kData + "quarry_breaklines.geojson";
  ReadOptions options;
  options.breaklines = lines;
  const Request checked{"svg", {"--check", "500", "--view-from", "205/30"}, [](MapSpec& spec) {
                          spec.check = 500;
                          spec.view.from_azimuth = Angle::degrees(205);
                          spec.view.from_elevation = Angle::degrees(30);
                        }};
  check_same({points, "--breaklines", lines},
             [&] { return Session(Terrain::read({points}, options)); },
             {{"geojson", {}, {}}, checked});
}

TEST_CASE("a view from a file, with planes that cut the terrain") {
  const std::string dem = kData + "islands.tif", view = kData + "views/three_point.toml";
  check_same({dem}, [&] { return Session(Terrain::read({dem})); },
             {{"svg", {"--view", view}, [&](MapSpec& spec) {
                 spec.view.file = read_view_file(view);
                 spec.view.file_name = view;
               }}});
}
