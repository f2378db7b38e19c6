// SPDX-License-Identifier: GPL-3.0-or-later
// Furniture and letters as the command draws them, and what it says where something is wrong.
#include "tests/catch.hpp"
#include "tests/cli/made_files.hpp"
#include "tests/cli/run_program.hpp"

#include <cmath>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace orograph::lettering_options_test {
namespace {

using Words = std::vector<std::string>;

ProgramRun render(const MadeFolder& folder, const std::string& output, Words more) {
  RunConditions there;
  there.folder = folder.path();
  more.insert(more.begin(), {"render", "hill.asc", output, "--overwrite"});
  return run_orograph(more, there);
}

void write_files(const MadeFolder& folder) {
  folder.write("hill.asc", ascii_grid(40, 40, [](int column, int row) {
                 return hill_m(column, row, 40) + 20 * std::sin(0.5 * column);
               }));
}

bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

} // namespace

TEST_CASE("Texts are text in SVG, strokes where a pen draws, and the options are said to hold") {
  const MadeFolder folder;
  write_files(folder);
  const Words map{"--furniture", "map", "--title", "A <b> & \"c\"", "--source", "S", "--date", "D"};
  REQUIRE(render(folder, "a.svg", map).exit_code == 0);
  const std::string svg = folder.read("a.svg");
  CHECK(has(svg, ">A &lt;b&gt; &amp; &quot;c&quot;</text>"));
  CHECK(has(svg, ">S · D</text>"));
  CHECK(has(svg, " furniture\" fill"));
  for (const Words& more : {Words{"--text", "stroke"}, Words{"--clip-to", "150x150"}}) {
    Words words = map;
    words.insert(words.end(), more.begin(), more.end());
    REQUIRE(render(folder, "b.svg", words).exit_code == 0);
    CHECK_FALSE(has(folder.read("b.svg"), "<text"));
  }
  // The same bytes on any number of threads.
  for (const char* name : {"c.svg", "c.pdf", "c.hpgl", "c.png"}) {
    Words one = map, four = map;
    one.insert(one.end(), {"--jobs", "1"});
    four.insert(four.end(), {"--jobs", "4"});
    REQUIRE(render(folder, name, one).exit_code == 0);
    const std::string bytes = folder.read(name);
    REQUIRE(render(folder, name, four).exit_code == 0);
    CHECK((folder.read(name) == bytes));
  }
}

TEST_CASE("Cairo and Pango are loaded for what needs them, and not for a plain SVG") {
  const MadeFolder folder;
  write_files(folder);
  const auto loads_them = [&](const std::string& output) {
    const std::string told =
        folder.path() + "/" + output + ".libraries"; // and the process's number
    REQUIRE(RunningProgram({"env", "LD_DEBUG=files", "LD_DEBUG_OUTPUT=" + told, OROGRAPH_PROGRAM,
                            "render", "hill.asc", output},
                           {.folder = folder.path()})
                .wait()
                .exit_code == 0);
    std::string libraries;
    for (const auto& file : std::filesystem::directory_iterator(folder.path()))
      if (file.path().string().starts_with(told)) libraries += folder.read(file.path().filename());
    REQUIRE(has(libraries, "libgdal.so"));
    return has(libraries, "libpangocairo-1.0.so");
  };
  CHECK_FALSE(loads_them("plain.svg"));
  CHECK(loads_them("plain.pdf"));
}

TEST_CASE("What no letters are there for is told in a line") {
  const MadeFolder folder;
  write_files(folder);
  const ProgramRun run =
      render(folder, "a.hpgl", {"--furniture", "title", "--title", "富 x", "--font", "No Font"});
  CHECK(run.exit_code == 0);
  CHECK(has(run.err, "orograph: stroke letters lack '富'"));
  CHECK(has(run.err, "orograph: the font 'No Font' isn't there"));
}

TEST_CASE("A template says what no option says") {
  const MadeFolder folder;
  write_files(folder);
  folder.write("t.toml", "furniture = ['title', 'source']\ntitle = 'of template'\n"
                         "source = 'its source'\ntitle-size = 8\n");
  REQUIRE(render(folder, "a.svg", {"--template", "t.toml", "--title", "given"}).exit_code == 0);
  const std::string svg = folder.read("a.svg");
  CHECK(has(svg, ">given</text>"));
  CHECK(has(svg, ">its source</text>"));
  CHECK(has(svg, "font-size=\"8\""));
}

TEST_CASE("Without furniture nothing changes, with an empty title there is none") {
  const MadeFolder folder;
  write_files(folder);
  REQUIRE(render(folder, "a.svg", {}).exit_code == 0);
  REQUIRE(render(folder, "b.svg", {"--furniture", "none", "--text", "stroke"}).exit_code == 0);
  CHECK((folder.read("a.svg") == folder.read("b.svg")));
  REQUIRE(render(folder, "c.svg", {"--furniture", "title", "--title", ""}).exit_code == 0);
  CHECK_FALSE(has(folder.read("c.svg"), "<text"));
}

TEST_CASE("What is wrong with furniture is one line that says what would be right") {
  const MadeFolder folder;
  write_files(folder);
  folder.write("bad.toml", "title = 'x'\nfurniture = 'nort'\n");
  const std::vector<std::pair<Words, std::string>> wrong{
      {{"--furniture", "nort"}, "there is no furniture 'nort': did you mean north?"},
      {{"--furniture", "map,zzzzz"}, "there is no furniture 'zzzzz': none, or some of map"},
      {{"--furniture", "azimuths"}, "no meaning but in a panorama"},
      {{"--furniture", "viewpoint"}, "no meaning without an eye"},
      {{"--subtitle", "x"}, "--subtitle is printed nowhere"},
      {{"--font", ""}, "--font"},
      {{"--text", "thin"}, "--text"},
      {{"--template", "bad.toml"}, "bad.toml, line 2: there is no furniture 'nort'"},
      {{"--template", "none.toml"}, "none.toml: no such file"},
      {{"--furniture", "map", "--page", "60x30"}, "leaves no room on a page of 60 x 30 mm"},
      {{"--furniture", "map", "--of", "geojson"}, "which has no page"}};
  for (const auto& [words, said] : wrong) {
    const ProgramRun run = render(folder, "a.svg", words);
    INFO(words[1] << ": " << run.err);
    CHECK(run.exit_code != 0);
    CHECK(has(run.err, said));
    CHECK(run.err.find('\n') == run.err.size() - 1);
  }
}

} // namespace orograph::lettering_options_test
