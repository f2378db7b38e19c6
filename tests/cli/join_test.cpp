// SPDX-License-Identifier: GPL-3.0-or-later
// Several files on the command line.
#include "cli/options/options.hpp"
#include "geometry/error.hpp"
#include "tests/catch.hpp"
#include "tests/cli/made_files.hpp"
#include "tests/cli/run_program.hpp"

#include <nlohmann/json.hpp>

using namespace orograph;

namespace {

using Words = std::vector<std::string>;

constexpr int kTileSide = 40;

// The hill's columns and rows from (column, row) on; rows count from the north.
std::string hill_part(int column, int row, int columns, int rows) {
  std::string text = ascii_grid(
      columns, rows, [=](int c, int r) { return hill_m(column + c, row + r, kTileSide); });
  const auto set = [&text](const std::string& word, int value) {
    const auto at = text.find(word + " 0\n");
    text.replace(at, word.size() + 3, word + " " + std::to_string(value) + "\n");
  };
  set("xllcorner", 10 * column);
  set("yllcorner", 10 * (kTileSide - row - rows));
  return text;
}

void write_tiles(const MadeFolder& folder) {
  folder.write("hill.asc", hill_part(0, 0, kTileSide, kTileSide));
  folder.write("a.asc", hill_part(0, 0, 21, 40)); // shares a column with the next
  folder.write("b.asc", hill_part(20, 0, 20, 15));
  folder.write("c.asc", hill_part(20, 15, 20, 25));
}

} // namespace

TEST_CASE("several inputs, and the last argument is the output") {
  const auto render = parse_render({"a.tif", "--fov", "20", "b.tif", "-q", "c.tif", "out.svg"});
  REQUIRE(render);
  CHECK(render->inputs == Words{"a.tif", "b.tif", "c.tif"});
  CHECK(render->output == "out.svg");
  CHECK(parse_accuracy({"a.tif", "b.tif"})->render.inputs == Words{"a.tif", "b.tif"});
  CHECK(parse_info({"a.tif", "--bbox", "0,0,1,1", "b.tif"})->inputs == Words{"a.tif", "b.tif"});
  const auto tin = parse_tin({"a.tif", "b.tif", "out.ply", "--max-error", "1m"});
  REQUIRE(tin);
  CHECK(tin->inputs == Words{"a.tif", "b.tif"});
  CHECK(tin->output == "out.ply");

  CHECK_THROWS_AS(parse_render({"a.tif"}), UsageError);
  CHECK_THROWS_AS(parse_info({"a.tif", ""}), UsageError);
  for (const Words& words : {Words{"a.ply", "b.tif", "a.ply"}, Words{"b.tif", "a.ply", "a.ply"}})
    CHECK_THROWS_AS(parse_tin(words), UsageError);
}

TEST_CASE("a drawing of joined files is that of one file, but for its title") {
  const MadeFolder folder;
  write_tiles(folder);
  REQUIRE(
      run_in(folder.path(), {"render", "hill.asc", "hill.svg", "--title", "x", "-q"}).exit_code ==
      0);
  const auto joined = run_in(folder.path(), {"render", "c.asc", "a.asc", "b.asc", "joined.svg",
                                             "--title", "x", "-q", "--report", "r.json"});
  INFO(joined.err);
  REQUIRE(joined.exit_code == 0);
  CHECK(folder.read("joined.svg") == folder.read("hill.svg"));
  const auto report = nlohmann::json::parse(folder.read("r.json"));
  CHECK(report["input"]["paths"] == nlohmann::json{"c.asc", "a.asc", "b.asc"});
  CHECK(report["input"]["columns"] == kTileSide);

  REQUIRE(
      run_in(folder.path(), {"render", "c.asc", "a.asc", "b.asc", "titled.svg", "-q"}).exit_code ==
      0);
  CHECK(folder.read("titled.svg").find("<title>c.asc and 2 more</title>") != std::string::npos);
}

TEST_CASE("info and tin take several files") {
  const MadeFolder folder;
  write_tiles(folder);
  const auto told = run_in(folder.path(), {"info", "a.asc", "b.asc", "c.asc"});
  CHECK(told.exit_code == 0);
  CHECK(told.out.find("File       a.asc\nFile       b.asc\nFile       c.asc\n") == 0);
  CHECK(told.out.find("40 x 40 vertices") != std::string::npos);
  const Words options{"--max-error", "1m", "-q"};
  const auto tin = [&](Words words) {
    words.insert(words.begin(), "tin");
    words.insert(words.end(), options.begin(), options.end());
    return run_in(folder.path(), words).exit_code;
  };
  CHECK(tin({"hill.asc", "hill.ply"}) == 0);
  CHECK(tin({"a.asc", "b.asc", "c.asc", "joined.ply"}) == 0);
  CHECK(folder.read("joined.ply") == folder.read("hill.ply"));
}

TEST_CASE("OUTPUT is none of the inputs") {
  const MadeFolder folder;
  write_tiles(folder);
  folder.write("a.svg", "not a raster");
  for (const Words& words : {Words{"render", "a.asc", "a.svg", "b.asc", "./a.svg"},
                             Words{"render", "a.svg", "b.asc", "a.svg"},
                             Words{"render", "a.asc", "b.asc", "out.svg", "--report", "b.asc"}}) {
    const auto result = run_in(folder.path(), words);
    CHECK(result.exit_code == 2);
    CHECK(result.err.find("is the INPUT") != std::string::npos);
  }
  CHECK(folder.read("a.svg") == "not a raster");
}
