// SPDX-License-Identifier: GPL-3.0-or-later
// The same bytes from any number of threads and shards.
#include "tests/catch.hpp"
#include "tests/sweep/made_sweep.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <sstream>

using namespace orograph;

namespace {

const Words kViews = words("--azimuth 0:360:72 --elevation 10:50:20");

void sweep_into(const MadeFolder& folder, const std::string& out_dir, const Words& more) {
  run_well(folder, words("sweep hill.asc -q") + Words{out_dir} + kSmall + kViews + more);
}

// Without the last column, which is the seconds.
std::string without_last_column(const std::string& csv) {
  std::istringstream lines(csv);
  std::string line, out;
  while (std::getline(lines, line)) out += line.substr(0, line.rfind(',')) + "\n";
  return out;
}

} // namespace

TEST_CASE("threads, shards and merging change no byte of any file") {
  const MadeFolder folder;
  make_terrains(folder);
  const Words no_seconds{"--no-seconds"};
  sweep_into(folder, "one", no_seconds + words("-j 1"));
  const auto expected = contents(folder, "one");
  REQUIRE(expected.size() == 2 * 15 + 4);
  for (const std::string jobs : {"2", "7"}) {
    sweep_into(folder, "j" + jobs, no_seconds + Words{"-j", jobs});
    CHECK(differences(expected, contents(folder, "j" + jobs)) == "");
  }
  for (const int count : {3, 40}) {
    const std::string together = fmt::format("together{}", count);
    Words apart;
    for (int index = count; index >= 1; --index) {
      if (count == 40 && index < 14) continue; // those after the 15th have nothing to draw
      const Words shard{"--shard", fmt::format("{}/{}", index, count)};
      sweep_into(folder, together, no_seconds + shard);
      apart.push_back(fmt::format("part{}of{}", index, count));
      sweep_into(folder, apart.back(), no_seconds + shard + words("-j 2"));
    }
    if (count == 40) {
      // A merge of some tells what is missing, and makes tables of what there is.
      const ProgramRun ended = run(folder, {"merge", together});
      CHECK(ended.exit_code == 1);
      INFO(ended.err);
      CHECK(fault_of_message(ended.err) == "");
      CHECK(ended.err.find("13 of 15 views are missing in together40, "
                           "'azimuth-000_elevation-10' among them") != std::string::npos);
      continue;
    }
    run_well(folder, {"merge", together, "-q"});
    CHECK(differences(expected, contents(folder, together)) == "");
    const std::string merged = fmt::format("merged{}", count);
    run_well(folder, Words{"merge", merged} + apart);
    CHECK(differences(expected, contents(folder, merged)) == "");
    run_well(folder, {"merge", merged}); // once more changes nothing
    CHECK(differences(expected, contents(folder, merged)) == "");
    run_well(folder, Words{"merge"} + apart); // into the first of them
    CHECK(differences(expected, contents(folder, apart.front())) == "");
  }
}

TEST_CASE("of two runs only the seconds differ") {
  const MadeFolder folder;
  make_terrains(folder);
  sweep_into(folder, "a", words("-j 1"));
  sweep_into(folder, "b", words("-j 2"));
  auto a = contents(folder, "a"), b = contents(folder, "b");
  for (auto* files : {&a, &b}) {
    auto& csv = (*files)["sweep.csv"];
    CHECK(csv.substr(0, csv.find('\n')).ends_with(",seconds"));
    csv = without_last_column(csv);
    auto table = nlohmann::ordered_json::parse((*files)["sweep.json"]);
    for (auto& row : table["views"]) {
      CHECK(row["seconds"].get<double>() > 0);
      row.erase("seconds");
    }
    (*files)["sweep.json"] = table.dump();
    files->erase("index.html"); // holds the table
    for (auto& [path, text] : *files)
      if (path.starts_with("rows/")) {
        auto row = nlohmann::ordered_json::parse(text);
        row["row"].erase("seconds");
        text = row.dump();
      }
  }
  CHECK(differences(a, b) == "");
}

TEST_CASE("the tables tell the same, and name every file") {
  const MadeFolder folder;
  make_terrains(folder);
  sweep_into(folder, "out", words("--title comma,\"quote\" --no-seconds"));
  const auto table = nlohmann::ordered_json::parse(folder.read("out/sweep.json"));
  std::istringstream csv(folder.read("out/sweep.csv"));
  std::string line;
  std::getline(csv, line);
  std::string names;
  for (const auto& column : table["columns"])
    names += (names.empty() ? "" : ",") + column["name"].get<std::string>();
  CHECK(line == names);
  CHECK(table["varied"] == nlohmann::json({"azimuth_deg", "elevation_deg"}));
  CHECK(table["views_planned"] == 15);
  REQUIRE(table["views"].size() == 15);
  std::size_t view = 0;
  for (const int azimuth : {0, 72, 144, 216, 288})
    for (const int elevation : {10, 30, 50}) {
      const auto& row = table["views"][view];
      CHECK(row["view"] == view);
      CHECK(row["azimuth_deg"] == azimuth);
      CHECK(row["elevation_deg"] == elevation);
      CHECK(row["error"].is_null());
      CHECK(row["file"] == fmt::format("azimuth-{:03}_elevation-{}.svg", azimuth, elevation));
      CHECK(folder.read("out/" + row["file"].get<std::string>()).ends_with("</svg>\n"));
      CHECK(row["visible_share"].get<double>() > 0);
      CHECK(row["visible_share"].get<double>() <= 1 + 1e-9);
      std::getline(csv, line);
      std::istringstream cells(line);
      for (const auto& column : table["columns"]) {
        std::string cell;
        std::getline(cells, cell, ',');
        const auto& value = row[column["name"].get<std::string>()];
        CHECK(cell == (value.is_null()     ? ""
                       : value.is_string() ? value.get<std::string>()
                                           : value.dump()));
      }
      ++view;
    }
}
