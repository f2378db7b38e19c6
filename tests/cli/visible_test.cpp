// SPDX-License-Identifier: GPL-3.0-or-later
// `orograph visible`, and the table of the skyline: files in, files out.
#include "tests/catch.hpp"
#include "tests/cli/made_files.hpp"
#include "tests/cli/run_program.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <sstream>
#include <string>
#include <vector>

namespace orograph::visible_test {
namespace {

const std::string kAlps = std::string(OROGRAPH_SOURCE_DIR) + "/data_samples/fractal_alps.tif";
const std::string kEye = "515000,104000";

std::string line(const std::string& text, std::size_t number) {
  std::istringstream lines(text);
  std::string out;
  for (std::size_t i = 0; i <= number; ++i) std::getline(lines, out);
  return out;
}

// x and y in the terrain's CRS, one of them beside it; a name that a spreadsheet would run.
const char* const kPoints = "name,x,y,state\n\"Top, high\",512000,104500,old\n=1+1,501000,101000,\n"
                            "beside,100,100,\n";

} // namespace

TEST_CASE("Points are written with their attributes, none is dropped") {
  const MadeFolder folder;
  folder.write("points.csv", kPoints);
  const ProgramRun csv = run_in(folder.path(), {"visible", kAlps, "points.csv", "--eye", kEye});
  INFO(csv.err);
  REQUIRE(csv.exit_code == 0);
  CHECK(line(csv.out, 0) == "x,y,name,state_,state,hidden_m,hidden_deg,azimuth_deg,"
                            "altitude_deg,distance_m,height");
  CHECK(line(csv.out, 1).starts_with("512000,104500,\"Top, high\",old,"));
  CHECK(line(csv.out, 2).starts_with("501000,101000,\"'=1+1\","));
  CHECK(line(csv.out, 3).starts_with("100,100,beside,,outside,,,"));
  CHECK(line(csv.out, 4).empty());
  CHECK(csv.err.find("3 points, ") != std::string::npos);
  CHECK(csv.err.find("1 outside of the terrain") != std::string::npos);

  const ProgramRun file = run_in(
      folder.path(), {"visible", kAlps, "points.csv", "--eye", kEye, "--output", "seen.geojson"});
  INFO(file.err);
  REQUIRE(file.exit_code == 0);
  const auto json = nlohmann::json::parse(folder.read("seen.geojson"));
  REQUIRE(json["features"].size() == 3);
  CHECK(json["features"][0]["properties"]["name"] == "Top, high");
  CHECK(json["features"][2]["properties"]["state"] == "outside");
  CHECK(json["features"][0]["geometry"]["coordinates"][0] == 512000);
  // What was written is read again, and gives the same; on one core as well.
  const ProgramRun again =
      run_in(folder.path(), {"visible", kAlps, "seen.geojson", "--eye", kEye, "-j", "1"});
  REQUIRE(again.exit_code == 0);
  const auto results = [](const std::string& row) { return row.substr(row.size() - 40); };
  CHECK(results(line(again.out, 1)) == results(line(csv.out, 1)));
}

TEST_CASE("The same bytes on any number of cores") {
  const MadeFolder folder;
  std::string points = "x,y\n";
  for (int i = 0; i < 500; ++i)
    points +=
        std::to_string(500000 + 60 * i) + "," + std::to_string(92000 + 37 * (i * 7 % 500)) + "\n";
  folder.write("points.csv", points);
  const auto of = [&](const std::string& jobs) {
    const ProgramRun made =
        run_in(folder.path(), {"visible", kAlps, "points.csv", "--eye", kEye, "--horizon-table",
                               "h.csv", "--horizon-step", "0.5", "--overwrite", "-j", jobs});
    INFO(made.err);
    REQUIRE(made.exit_code == 0);
    return made.out + folder.read("h.csv");
  };
  const std::string one = of("1");
  CHECK(one == of("2"));
  CHECK(one == of("7"));
  CHECK(std::ranges::count(one, '\n') == 501 + 721);
}

TEST_CASE("A picture's report has the most distant ground, and its table the skyline") {
  const MadeFolder folder;
  const ProgramRun made = run_in(folder.path(), {"render", kAlps, "map.svg", "--eye", kEye,
                                                 "--eye-summit", "--look-azimuth", "10",
                                                 "--horizon-table", "h.csv", "--report", "r.json"});
  INFO(made.err);
  REQUIRE(made.exit_code == 0);
  CHECK(made.err.find("the eye ") != std::string::npos);
  const std::string table = folder.read("h.csv");
  CHECK(line(table, 0) == "azimuth_deg,altitude_deg,distance_m,longitude,latitude");
  CHECK(line(table, 91).starts_with("90,"));
  CHECK(std::ranges::count(table, '\n') == 361);
  const auto report = nlohmann::json::parse(folder.read("r.json"));
  CHECK(report["skyline"]["directions"] == 360);
  CHECK(report["skyline"]["most_distant"]["distance_m"] > 1000);
  CHECK(report["settings"]["eye-summit"] == "50");
  CHECK_FALSE(report["settings"].contains("horizon-table"));
  // The report's settings draw the same map.
  const ProgramRun again =
      run_in(folder.path(), {"render", kAlps, "again.svg", "--settings", "r.json"});
  INFO(again.err);
  REQUIRE(again.exit_code == 0);
  CHECK(folder.read("again.svg") == folder.read("map.svg"));
}

TEST_CASE("What can't be looked at is one line with what would be right") {
  const MadeFolder folder;
  folder.write("points.csv", kPoints);
  folder.write("names.csv", "name,height\na,3\n");
  folder.write("lines.geojson",
               R"({"type":"FeatureCollection","features":[{"type":"Feature","properties":{},)"
               R"("geometry":{"type":"LineString","coordinates":[[0,0],[9,45]]}}]})");
  folder.write("elsewhere.csv", "lon,lat\n100,10\n");
  const std::vector<std::string> eye{"--eye", kEye};
  struct Case {
    std::vector<std::string> arguments;
    int exit_code;
    const char* error;
  };
  for (const auto& [arguments, exit_code, error] : std::vector<Case>{
           {{"points.csv"}, 2, "no eye"},
           {{"none.csv", "--eye", kEye}, 1, "none.csv"},
           {{"names.csv", "--eye", kEye}, 1, "name them lon and lat"},
           {{"elsewhere.csv", "--eye", kEye}, 1, "nothing of elsewhere.csv"},
           {{"points.csv", "--eye", "100,100"}, 1, "outside of the terrain"},
           {{"points.csv", "--eye", kEye + ",-100"}, 1, "under the ground"},
           {{"points.csv", "--eye", kEye, "--eye-summit", "0"}, 2, "--eye-summit '0'"},
           {{"points.csv", "--eye", kEye, "--eye-summit", "nan"}, 2, "--eye-summit 'nan'"},
           {{"points.csv", "--eye", kEye, "--target-height", "-1"}, 2, "--target-height '-1'"},
           {{"points.csv", "--eye", kEye, "--output", "a.shp"}, 2, "names no format"},
           {{"points.csv", "--eye", kEye, "--output", "points.csv"}, 2, "points.csv"},
           {{"points.csv", "--eye", kEye, "--horizon-table", "h.csv", "--horizon-step", "0"},
            2,
            "--horizon-step '0'"},
           {{"points.csv", "--eye", kEye, "--horizon-table", "h.csv", "--horizon-step", "nan"},
            2,
            "--horizon-step 'nan'"},
           {{"points.csv", "--eye", kEye, "--horizon-step", "2"}, 2, "without a table"}}) {
    std::vector<std::string> whole{"visible", kAlps};
    whole.insert(whole.end(), arguments.begin(), arguments.end());
    const ProgramRun made = run_in(folder.path(), whole);
    INFO(made.err << "for " << error);
    CHECK(made.exit_code == exit_code);
    CHECK(fault_of_message(made.err).empty());
    CHECK(made.err.find(error) != std::string::npos);
    CHECK(made.out.empty());
  }
  const ProgramRun no_eye =
      run_in(folder.path(), {"render", kAlps, "a.svg", "--horizon-table", "h.csv"});
  CHECK(no_eye.exit_code == 2);
  CHECK(no_eye.err.find("needs an eye") != std::string::npos);
}

} // namespace orograph::visible_test
