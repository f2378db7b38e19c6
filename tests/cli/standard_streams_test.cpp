// SPDX-License-Identifier: GPL-3.0-or-later
// What the command says, where nobody can hear it or it isn't fit to be shown; and whose the files
// are that it replaces.
#include "cli/report/measurements.hpp"
#include "tests/catch.hpp"
#include "tests/cli/made_files.hpp"
#include "tests/cli/run_program.hpp"

#include <sys/stat.h>

#include <filesystem>
#include <string>
#include <vector>

using namespace orograph;

namespace {

constexpr int kHillSide = 20;

MadeFolder& with_hill(MadeFolder& folder) {
  folder.write("hill.asc", ascii_grid(kHillSide, kHillSide,
                                      [](int x, int y) { return hill_m(x, y, kHillSide); }));
  return folder;
}

// By a shell, which closes streams or leads them elsewhere.
ProgramRun in_shell(const MadeFolder& folder, const std::string& arguments) {
  RunningProgram shell({"/bin/sh", "-c", "exec \"$0\" " + arguments, OROGRAPH_PROGRAM},
                       {.folder = folder.path()});
  return shell.wait();
}

mode_t rights_of(const std::string& path) {
  struct stat file {};
  REQUIRE(::stat(path.c_str(), &file) == 0);
  return file.st_mode & 07777U;
}

} // namespace

TEST_CASE("what can't be said costs no drawing, and goes into no file") {
  MadeFolder folder;
  with_hill(folder);
  REQUIRE(in_shell(folder, "render hill.asc said.svg").exit_code == 0);
  const std::string drawing = folder.read("said.svg");
  for (const std::string streams :
       {"2>&-", "2>/dev/full", "<&- 2>&-", "<&- >&- 2>&-", "--progress 2>/dev/full"}) {
    INFO(streams);
    CHECK(in_shell(folder, "render hill.asc map.svg --report r.json " + streams).exit_code == 0);
    CHECK(folder.read("map.svg") == drawing);
    CHECK(folder.names() == std::vector<std::string>{"hill.asc", "map.svg", "r.json", "said.svg"});
    for (const char* name : {"map.svg", "r.json"}) std::remove(folder.path(name).c_str());
    CHECK(in_shell(folder, "render hill.asc map.svg --view-from up " + streams).exit_code == 2);
  }
}

TEST_CASE("what was to go to a closed standard output is missed") {
  MadeFolder folder;
  with_hill(folder);
  for (const std::string arguments : {"info hill.asc", "render hill.asc - --of svg", "--help"}) {
    INFO(arguments);
    const ProgramRun ended = in_shell(folder, arguments + " >&-");
    CHECK(ended.exit_code == 1);
    CHECK(fault_of_message(ended.err) == "");
  }
  CHECK(folder.names() == std::vector<std::string>{"hill.asc"});
}

TEST_CASE("messages show no controls and aren't longer than a few lines") {
  MadeFolder folder;
  with_hill(folder);
  folder.write("null.toml", "[view]\n\"proj\\u0000ection\" = 1\n\"\\u001b[31m\" = 2\n");
  const auto check = [&](const std::vector<std::string>& arguments, int exit_code,
                         const std::string& part) {
    const ProgramRun ended = run_orograph(arguments, {.folder = folder.path()});
    INFO(ended.err);
    CHECK(ended.exit_code == exit_code);
    CHECK(fault_of_message(ended.err) == "");
    CHECK(ended.err.find(part) != std::string::npos);
    CHECK(ended.err.find('\x1b') == std::string::npos);
    CHECK(ended.err.find('\0') == std::string::npos);
    CHECK(ended.err.size() < 1100);
  };
  check({"render", "hill.asc", "map.svg", "--view-from", "\x1b[31m"}, 2, "'?[31m' can't be used");
  check({"render", "\x1b[2J.asc", "map.svg"}, 1, "?[2J.asc: no such file: give the path of a DEM");
  check({"render", std::string(3000, 'x'), "map.svg"}, 1, "xxx … xxx");
  check({"render", std::string(3000, 'x') + ".tif", "map.svg"}, 1, "give");
  check({"render", "hill.asc", "map.svg", "--view", "null.toml"}, 1, "null.toml");
  check({"\x1b]0;title\x07"}, 2, "unknown command ?]0;title?");
}

TEST_CASE("what `info` prints shows no controls of names and files") {
  MadeFolder folder;
  with_hill(folder);
  std::string crs(kUtm32);
  folder.write("\x1b[2J.asc", ascii_grid(4, 4, [](int, int) { return 1.0; }));
  folder.write("\x1b[2J.prj", crs.replace(crs.find('"') + 1, 1, "\x1b[31m"));
  const ProgramRun ended = run_orograph({"info", "\x1b[2J.asc"}, {.folder = folder.path()});
  CHECK(ended.exit_code == 0);
  CHECK(ended.out.find("?[2J.asc") != std::string::npos);
  CHECK(ended.out.find("?[31m") != std::string::npos);
  CHECK(ended.out.find('\x1b') == std::string::npos);
}

TEST_CASE("a link that leads to itself is told of as the system does") {
  MadeFolder folder;
  with_hill(folder);
  std::filesystem::create_symlink("loop.svg", folder.path("loop.svg"));
  const ProgramRun ended =
      run_orograph({"render", "hill.asc", "loop.svg", "--overwrite"}, {.folder = folder.path()});
  CHECK(ended.exit_code == 1);
  CHECK(ended.err.find("loop.svg can't be written (Too many levels of symbolic links)") !=
        std::string::npos);
}

TEST_CASE("a drawing that replaces another has its rights") {
  MadeFolder folder;
  with_hill(folder);
  for (const mode_t rights : {0600, 0640, 0664, 0444 | 0200}) {
    folder.write("map.svg", "older");
    REQUIRE(::chmod(folder.path("map.svg").c_str(), rights) == 0);
    const ProgramRun ended = run_orograph({"render", "hill.asc", "map.svg", "--overwrite", "-q"},
                                          {.folder = folder.path()});
    INFO(ended.err);
    CHECK(ended.exit_code == 0);
    CHECK(folder.read("map.svg").ends_with("</svg>\n"));
    CHECK(rights_of(folder.path("map.svg")) == rights);
  }
}

TEST_CASE("no cell of a table is a formula") {
  for (const std::string plain : {"", "view 1", "a=b", "3-4"}) CHECK(csv_text(plain) == plain);
  CHECK(csv_text("a\x1b[31m\n\xC2\x9Bz") == "\"a?[31m\n?z\"");
  CHECK(csv_text("a,\"b\"") == "\"a,\"\"b\"\"\"");
  for (const char first : {'=', '+', '-', '@', '\t', '\r'})
    CHECK(csv_text(first + std::string("cmd|x")) == "\"'" + (first + std::string("cmd|x\"")));
}
