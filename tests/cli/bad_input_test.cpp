// SPDX-License-Identifier: GPL-3.0-or-later
// Bad input, as a user meets it: the cases of bad_input.txt, and disks that are full.
#include "tests/catch.hpp"
#include "tests/cli/bad_inputs.hpp"
#include "tests/cli/made_files.hpp"
#include "tests/cli/run_program.hpp"

#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>

using namespace orograph;
namespace fs = std::filesystem;

namespace {

struct Case {
  std::string name, run, error;
  int exit_code = 0;
};

std::vector<Case> read_cases() {
  std::ifstream file(std::string(OROGRAPH_SOURCE_DIR) + "/tests/cli/bad_input.txt");
  std::vector<Case> cases;
  std::string line;
  while (std::getline(file, line)) {
    if (line.empty() || line.starts_with('#')) continue;
    const auto colon = line.find(':');
    const std::string word = line.substr(0, colon);
    const std::string rest = line.size() > colon + 2 ? line.substr(colon + 2) : "";
    if (word == "case") cases.push_back({.name = rest, .run = {}, .error = {}});
    REQUIRE_FALSE(cases.empty());
    if (word == "run") cases.back().run = rest;
    if (word == "exit") cases.back().exit_code = std::stoi(rest);
    if (word == "error") cases.back().error = rest;
  }
  return cases;
}

std::vector<std::string> words(const std::string& text) {
  std::istringstream stream(text);
  return {std::istream_iterator<std::string>(stream), {}};
}

const std::vector<std::string> kExtensions{"svg", "pdf", "ps", "eps", "png", "geojson", "gpkg"};

} // namespace

TEST_CASE("bad input gets one line, the right exit code, and leaves no file", "[slow]") {
  const MadeFolder folder;
  make_bad_inputs(folder);
  const auto before = folder.names();
  const std::string hill = folder.read("hill.asc");
  const std::string hut = folder.read("hut.toml"), tetrahedron = folder.read("tetrahedron.off");
  const auto cases = read_cases();
  CHECK(cases.size() > 40);
  for (const auto& c : cases) {
    const auto result = run_orograph(words(c.run), {.folder = folder.path()});
    INFO(c.name << "\norograph " << c.run << "\n" << result.err);
    CHECK(result.exit_code == c.exit_code);
    CHECK(fault_of_message(result.err) == "");
    CHECK(result.err.find(c.error) != std::string::npos);
    CHECK(result.out == "");
    CHECK(folder.names() == before);
    CHECK(folder.read("old.svg") == "an older drawing");
    CHECK(folder.read("hill.asc") == hill);
    CHECK(folder.read("hut.toml") == hut);
    CHECK(folder.read("tetrahedron.off") == tetrahedron);
  }
}

TEST_CASE("a file-size limit is an error in every format, and the old output stays") {
  const MadeFolder folder;
  make_bad_inputs(folder);
  for (const auto& extension : kExtensions)
    for (const bool replaces : {false, true}) {
      const std::string output = "full." + extension;
      if (replaces) folder.write(output, "older");
      const auto before = folder.names();
      std::vector<std::string> arguments{"render", "hill.asc", output};
      if (replaces) arguments.push_back("--overwrite");
      const auto result =
          run_orograph(arguments, {.folder = folder.path(), .largest_file_bytes = 2048});
      INFO(output << ": " << result.err);
      CHECK(result.exit_code == 1);
      CHECK(fault_of_message(result.err) == "");
      CHECK(folder.names() == before);
      if (replaces) CHECK(folder.read(output) == "older");
    }
}

TEST_CASE("a report that doesn't fit is an error, and no report is left") {
  const MadeFolder folder;
  make_bad_inputs(folder);
  const auto whole =
      run_orograph({"render", "hill.asc", "a.svg", "--page", "30x20", "--margin", "1", "--profiles",
                    "2", "--layers", "profiles", "--report", "a.json"},
                   {.folder = folder.path()});
  INFO(whole.err);
  REQUIRE(whole.exit_code == 0);
  const auto svg_size = fs::file_size(folder.path("a.svg"));
  const auto report_size = fs::file_size(folder.path("a.json"));
  REQUIRE(svg_size + 10 < report_size);
  const auto result =
      run_orograph({"render", "hill.asc", "b.svg", "--page", "30x20", "--margin", "1", "--profiles",
                    "2", "--layers", "profiles", "--report", "b.json"},
                   {.folder = folder.path(), .largest_file_bytes = svg_size + 10});
  INFO(result.err);
  CHECK(result.exit_code == 1);
  CHECK(fault_of_message(result.err) == "");
  CHECK_FALSE(fs::exists(folder.path("b.json")));
}

TEST_CASE("a full device on standard output is an error") {
  const MadeFolder folder;
  make_bad_inputs(folder);
  for (const std::string run :
       {"info hill.asc", "render hill.asc - --of svg", "render --help", "--version"}) {
    const auto result =
        run_orograph(words(run), {.folder = folder.path(), .out_path = "/dev/full"});
    INFO(run << ": " << result.err);
    CHECK(result.exit_code == 1);
    CHECK(fault_of_message(result.err) == "");
  }
}

TEST_CASE("a full disk is an error in every format") {
  // A small tmpfs needs the right to mount one: as root, or in a name space of our own.
  const MadeFolder folder;
  make_bad_inputs(folder);
  fs::create_directory(folder.path("disk"));
  const std::string mount = "mount -t tmpfs -o size=16k tmpfs disk && ";
  std::vector<std::string> shell{"unshare", "-m", "sh", "-c", mount + "true"};
  if (RunningProgram(shell, {.folder = folder.path()}).wait().exit_code != 0)
    shell.insert(shell.begin() + 1, "-r");
  if (RunningProgram(shell, {.folder = folder.path()}).wait().exit_code != 0) {
    WARN("no tmpfs can be mounted here; only the file-size limit stands for a full disk");
    return;
  }
  for (const auto& extension : kExtensions) {
    // Most of the disk is taken, so that every format meets its end; then nothing else is on it.
    shell.back() = mount + "head -c 12288 /dev/zero >disk/taken && \"$0\" render hill.asc disk/a." +
                   extension + " --spacing 0.3mm; code=$?; ls -A disk; exit $code";
    auto command = shell;
    command.push_back(OROGRAPH_PROGRAM);
    const auto result = RunningProgram(command, {.folder = folder.path()}).wait();
    INFO(extension << ": " << result.err);
    CHECK(result.exit_code == 1);
    CHECK(fault_of_message(result.err) == "");
    CHECK(result.out == "taken\n");
  }
}
