// SPDX-License-Identifier: GPL-3.0-or-later
// A raster that isn't read as a whole, from the command line: with an index and without one.
#include "tests/catch.hpp"
#include "tests/cli/made_files.hpp"
#include "tests/cli/run_program.hpp"

#include <nlohmann/json.hpp>

#include <chrono>
#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

namespace orograph::large_raster_test {
namespace {

// Of 4200 x 4200 heights, from a file of 100 x 100.
void make_large(const MadeFolder& folder) {
  folder.write("hill.tif", geotiff(100, 100, [](int column, int row) {
                 return 300 * std::sin(column * 0.07) * std::cos(row * 0.05) + row;
               }));
  folder.write("large.vrt", R"(<VRTDataset rasterXSize="4200" rasterYSize="4200">
  <SRS>EPSG:32632</SRS>
  <GeoTransform>500000, 10, 0, 5000000, 0, -10</GeoTransform>
  <VRTRasterBand dataType="Float32" band="1">
    <SimpleSource resampling="bilinear"><SourceFilename relativeToVRT="1">hill.tif</SourceFilename>
      <SourceBand>1</SourceBand>
      <SrcRect xOff="0" yOff="0" xSize="100" ySize="100"/>
      <DstRect xOff="0" yOff="0" xSize="4200" ySize="4200"/></SimpleSource>
  </VRTRasterBand>
</VRTDataset>)");
}

} // namespace

TEST_CASE("a large raster is drawn the same with an index, and without one that has become old") {
  const MadeFolder folder;
  make_large(folder);
  const auto run = [&](std::vector<std::string> arguments) {
    return run_orograph(arguments, {.folder = folder.path()});
  };
  const auto draw = [&](const char* name, std::vector<std::string> options) {
    options.insert(options.begin(), {"render", "large.vrt", name, "--overwrite", "--title", "a"});
    const auto result = run(options);
    INFO(result.err);
    REQUIRE(result.exit_code == 0);
    return result.err;
  };
  draw("without.svg", {"--report", "a.json"});
  const auto report = nlohmann::json::parse(folder.read("a.json"));
  CHECK(report["input"]["columns"] == 4200);
  CHECK(report["level_of_detail"]["step"].get<double>() >= 4);
  CHECK(report["level_of_detail"]["greatest_departure_m"].get<double>() > 0);
  CHECK(report["level_of_detail"]["greatest_departure_mm"].get<double>() > 0);
  CHECK(report["level_of_detail"]["greatest_departure_mm"] ==
        report["error_budget_mm"]["level_of_detail"]);

  folder.write("large.vrt.levels", "orolev01, of an older version");
  CHECK(holds(draw("old.svg", {}), "large.vrt.levels isn't used: it is no index, or of another"));
  CHECK(folder.read("old.svg") == folder.read("without.svg"));
  REQUIRE(run({"index", "large.vrt"}).exit_code == 0);
  CHECK(holds(run({"info", "large.vrt"}).out, "large.vrt.levels: cells 4 to 32 times as large"));
  CHECK(!holds(draw("with.svg", {}), ".levels"));
  CHECK(folder.read("with.svg") == folder.read("without.svg"));

  // From an eye: its own cells near by, the index far away.
  const std::vector<std::string> eye{"--eye",        "520000,4980000", "--eye-height", "40",
                                     "--projection", "cylindrical",    "--report",     "b.json"};
  draw("eye.svg", eye);
  const auto seen = nlohmann::json::parse(folder.read("b.json"));
  CHECK(seen["level_of_detail"]["step"] == 1);
  CHECK(seen["level_of_detail"]["most_step"].get<double>() >= 8);
  CHECK(seen["input"]["columns"] == 4200);
  std::vector<std::string> without = eye;
  without.insert(without.end(), {"--index", "off"});
  const std::string with_index = folder.read("eye.svg");
  draw("eye.svg", without);
  CHECK(folder.read("eye.svg") == with_index);

  // Within a bound, without all of it in memory (70 MB, and its drawing as much again).
  const std::vector<std::string> bound{"--level-error", "0.5",      "--max-memory",
                                       "120MB",         "--report", "c.json"};
  draw("bound.svg", bound);
  const auto certified = nlohmann::json::parse(folder.read("c.json"));
  CHECK(certified["level_of_detail"]["most_step"].get<double>() >= 8);
  CHECK(certified["error_budget_mm"]["level_of_detail"].get<double>() <= 0.5);
  without = bound;
  without.insert(without.end(), {"--index", "off", "--jobs", "1"});
  draw("bound-without.svg", without);
  CHECK(folder.read("bound.svg") == folder.read("bound-without.svg"));
  const auto refused =
      run({"render", "large.vrt", "none.svg", "--level-error", "0.001", "--max-memory", "120MB"});
  CHECK(refused.exit_code == 1);
  CHECK(holds(refused.err, "within 0.001 mm takes"));
  CHECK(!std::filesystem::exists(folder.path("none.svg")));

  const std::filesystem::path source = folder.path("hill.tif");
  std::filesystem::last_write_time(source, std::filesystem::last_write_time(source) +
                                               std::chrono::seconds(1));
  CHECK(holds(draw("again.svg", {}), "large.vrt.levels isn't used: the heights have changed"));
  CHECK(folder.read("again.svg") == folder.read("without.svg"));
  CHECK(!holds(draw("again.svg", {"--index", "off"}), ".levels"));
}

TEST_CASE("a sweep over a large raster draws what render does, in what memory render takes") {
  const MadeFolder folder;
  make_large(folder);
  const auto run = [&](const std::vector<std::string>& arguments) {
    const auto result = run_orograph(arguments, {.folder = folder.path()});
    INFO(result.err);
    REQUIRE(result.exit_code == 0);
  };
  // As a whole it would take 70 MB and its drawing as much again.
  const std::vector<std::string> options{"--page", "a5",           "--title", "a",
                                         "-q",     "--max-memory", "100MB"};
  const auto with = [&](std::vector<std::string> words) {
    words.insert(words.end(), options.begin(), options.end());
    return words;
  };
  run(with({"sweep", "large.vrt", "turn", "--azimuth", "120,210", "--elevation", "12"}));
  for (const std::string azimuth : {"120", "210"}) {
    run(with({"render", "large.vrt", "a.svg", "--view-from", azimuth + "/12", "--overwrite"}));
    CHECK(folder.read("a.svg") == folder.read("turn/azimuth-" + azimuth + ".svg"));
  }
}

TEST_CASE(
    "a view in a file, and lines draped over what an eye sees, need no more of a large raster") {
  const MadeFolder folder;
  make_large(folder);
  folder.write("view.toml", R"(projection = "parallel"
vrp = [521000, 4979000, 0]
vpn = [0, -1, 1]
prp = [0, 0, 1]
window = [-30000, -20000, 30000, 20000]
)");
  folder.write("way.geojson", R"({"type": "LineString", "crs": {"type": "name",
    "properties": {"name": "EPSG:32632"}}, "coordinates": [[520100, 4979000], [521000, 4985000]]})");
  const auto draw = [&](std::vector<std::string> options) {
    options.insert(options.begin(), {"render", "large.vrt", "a.svg", "--title", "a", "--overwrite",
                                     "--max-memory", "110MB", "--report", "a.json"});
    const auto result = run_orograph(options, {.folder = folder.path()});
    INFO(result.err);
    REQUIRE(result.exit_code == 0);
    return nlohmann::json::parse(folder.read("a.json"))["level_of_detail"];
  };
  CHECK(draw({"--view", "view.toml"})["step"].get<double>() >= 4);
  const auto seen = draw({"--eye", "520000,4980000", "--eye-height", "40", "--look-azimuth", "10",
                          "--fov", "60", "--drape", "way.geojson"});
  CHECK(seen["step"] == 1);
  CHECK(seen["most_step"].get<double>() >= 8);
}

TEST_CASE("a raster that takes too much memory is refused, and another's file isn't replaced") {
  const MadeFolder folder;
  make_large(folder);
  const auto refused =
      run_orograph({"render", "large.vrt", "a.svg", "--detail", "file", "--max-memory", "100MB"},
                   {.folder = folder.path()});
  CHECK(refused.exit_code == 1);
  CHECK(holds(refused.err, "4200 x 4200 heights"));
  CHECK(holds(refused.err, "--max-memory"));
  folder.write("hill.tif.levels", "notes of mine");
  const auto kept = run_orograph({"index", "hill.tif"}, {.folder = folder.path()});
  CHECK(kept.exit_code == 1);
  CHECK(holds(kept.err, "is no index"));
  CHECK(folder.read("hill.tif.levels") == "notes of mine");
  CHECK(folder.names() == std::vector<std::string>{"hill.tif", "hill.tif.levels", "large.vrt"});
}

} // namespace orograph::large_raster_test
