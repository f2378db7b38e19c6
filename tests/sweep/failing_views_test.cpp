// SPDX-License-Identifier: GPL-3.0-or-later
// Views that can't be drawn are rows with their reason; the others are drawn.
#include "tests/catch.hpp"
#include "tests/sweep/made_sweep.hpp"

#include <nlohmann/json.hpp>

#include <filesystem>

using namespace orograph;
namespace fs = std::filesystem;

TEST_CASE("eyes under the ground fail alone") {
  const MadeFolder folder;
  make_terrains(folder);
  // Over the hill in the middle at a height that the plain is below, and the hill above.
  folder.write(
      "through.csv",
      "id,WKT\n1,\"LINESTRING Z(120 20 250,120 60 250,120 110 250,120 130 250,120 200 250)\"\n");
  const Words sweep =
      words("sweep hill.asc out --eye-path through.csv --fov 60,80 --look-at 120,125") + kSmall;
  const ProgramRun ended = run(folder, sweep + words("-j 2 --no-seconds"));
  INFO(ended.err);
  CHECK(ended.exit_code == 1);
  CHECK(fault_of_message(ended.err) == "");
  CHECK(
      ended.err.find("4 of 10 views failed, the others are drawn; 'eye-2_fov-60' failed with: ") !=
      std::string::npos);
  const auto table = nlohmann::json::parse(folder.read("out/sweep.json"));
  REQUIRE(table["views"].size() == 10);
  for (const auto& row : table["views"]) {
    const bool fails = row["eye"] == 2 || row["eye"] == 3;
    INFO(row["name"]);
    CHECK(row["error"].is_null() == !fails);
    if (fails) CHECK(row["error"].get<std::string>().find("under the ground") != std::string::npos);
    CHECK(row["visible_mm"].is_null() == fails);
    CHECK(row["fov_deg"].is_number());
    CHECK(fs::exists(folder.path("out/" + row["file"].get<std::string>())) == !fails);
  }

  // Tried again, in vain; the others stay.
  const auto before = identities(folder, "out");
  const ProgramRun again = run(folder, sweep + words("--no-seconds --resume"));
  CHECK(again.exit_code == 1);
  CHECK(fault_of_message(again.err) == "");
  auto after = identities(folder, "out");
  for (const auto& [path, identity] : before)
    if (path.ends_with(".svg")) CHECK(after[path] == identity);
  CHECK_FALSE(after["rows/eye-2_fov-60.json"] == before.at("rows/eye-2_fov-60.json"));

  const ProgramRun merged = run(folder, {"merge", "out"});
  CHECK(merged.exit_code == 1);
  CHECK(merged.err.find("4 of 10 views failed") != std::string::npos);
}

TEST_CASE("a picture without anything in it fails alone") {
  const MadeFolder folder;
  make_terrains(folder);
  const std::string view = "[[view]]\nprojection = 'parallel'\nvrp = [120, 120, 100]\n"
                           "vpn = [0, -1, 1]\n";
  const std::string here = "prp = [0, 0, 100]\nwindow = [-150, -150, 150, 150]\n";
  folder.write("list.toml", view + "prp = [5200, 0, 9]\nwindow = [5000, -200, 5400, 200]\n" + view +
                                here + view + here + "front = -900\n");
  const ProgramRun ended =
      run(folder, words("sweep hill.asc out --views list.toml --no-seconds") + kSmall);
  INFO(ended.err);
  CHECK(ended.exit_code == 1);
  CHECK(fault_of_message(ended.err) == "");
  CHECK(ended.err.find("2 of 3 views failed") != std::string::npos);
  CHECK(fs::exists(folder.path("out/view-1.svg")));
  CHECK_FALSE(fs::exists(folder.path("out/view-0.svg")));
  const auto table = nlohmann::json::parse(folder.read("out/sweep.json"));
  CHECK(table["views"][0]["error"].is_string());
  CHECK(table["views"][2]["error"].get<std::string>().find("front and back plane") !=
        std::string::npos);
  // By shards the one with failures says so.
  fs::remove_all(folder.path("out"));
  for (const auto& [shard, code] : {std::pair{"1/3", 1}, {"2/3", 0}, {"3/3", 1}})
    CHECK(run(folder, words("sweep hill.asc out --views list.toml --no-seconds") + kSmall +
                          Words{"--shard", shard})
              .exit_code == code);
}

TEST_CASE("a view that has failed in one shard is taken from another that has drawn it") {
  const MadeFolder folder;
  make_terrains(folder);
  const Words sweep = words("sweep hill.asc whole --azimuth 0,90 --no-seconds -q") + kSmall;
  run_well(folder, sweep);
  const auto expected = contents(folder, "whole");
  fs::copy(folder.path("whole"), folder.path("failed"), fs::copy_options::recursive);
  auto row = nlohmann::ordered_json::parse(folder.read("failed/rows/azimuth-90.json"));
  row["row"]["error"] = "not enough memory";
  folder.write("failed/rows/azimuth-90.json",
               "{\"row\":" + row["row"].dump() + ",\n\"preview\":null}\n");
  fs::remove(folder.path("failed/azimuth-90.svg"));
  for (const Words& order : {Words{"failed", "whole"}, {"whole", "failed"}}) {
    run_well(folder, Words{"merge", "merged"} + order);
    CHECK(differences(expected, contents(folder, "merged")) == "");
    fs::remove_all(folder.path("merged"));
  }
  const ProgramRun alone = run(folder, {"merge", "merged", "failed"});
  CHECK(alone.exit_code == 1);
  CHECK(alone.err.find("1 of 2 views failed, the others are drawn; 'azimuth-90' failed with: not "
                       "enough memory") != std::string::npos);
}
