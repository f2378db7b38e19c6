// SPDX-License-Identifier: GPL-3.0-or-later
// Ctrl-C, termination and a terminal that is closed, in the middle of a run.
#include "tests/catch.hpp"
#include "tests/cli/made_files.hpp"
#include "tests/cli/run_program.hpp"

#include <signal.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <thread>

using namespace orograph;

namespace {

constexpr int kHillSize = 500;

/// A terrain that takes seconds to draw: an ESRI .bil of int16 with its header.
void make_big_terrain(const MadeFolder& folder) {
  std::string heights;
  heights.reserve(2 * kHillSize * kHillSize);
  for (int row = 0; row < kHillSize; ++row)
    for (int column = 0; column < kHillSize; ++column) {
      const int height_m =
          static_cast<int>(hill_m(column, row, kHillSize)) + (7 * column * row) % 13;
      heights += static_cast<char>(height_m & 0xff);
      heights += static_cast<char>(height_m >> 8);
    }
  folder.write("big.bil", heights);
  const std::string side = std::to_string(kHillSize);
  folder.write("big.hdr", "ncols " + side + "\nnrows " + side +
                              "\nnbands 1\nnbits 16\npixeltype signedint\nbyteorder I\n"
                              "layout bil\nulxmap 0\nulymap 0\nxdim 10\nydim 10\n");
}

/// The drawing has begun to be written: its temporary file holds something.
bool has_temporary_file(const MadeFolder& folder) {
  const auto names = folder.names();
  return std::any_of(names.begin(), names.end(),
                     [](const auto& name) { return name.starts_with(".orograph"); });
}

} // namespace

TEST_CASE("an interrupted plot leaves no half file, of one sheet or of several", "[slow]") {
  const MadeFolder folder;
  make_big_terrain(folder);
  const std::string old = "an older drawing";
  for (const auto& [format, has_sheets] :
       {std::pair<std::string, bool>{"hpgl", false}, {"dxf", true}}) {
    std::vector<std::string> command{OROGRAPH_PROGRAM, "render", "big.bil",    "map." + format,
                                     "--overwrite",    "-q",     "--profiles", "1000",
                                     "--simplify",     "0"};
    if (has_sheets) command.insert(command.end(), {"--sheets", "2x1"});
    std::vector<std::string> names;
    for (const char* sheet : {"-1", "-2", "-overview"})
      if (has_sheets) names.push_back(std::string("map") + sheet + '.' + format);
    if (!has_sheets) names.push_back("map." + format);
    const auto contents = [&] {
      std::vector<std::string> read;
      for (const std::string& name : names) read.push_back(folder.read(name));
      return read;
    };
    REQUIRE(RunningProgram(command, {.folder = folder.path()}).wait().exit_code == 0);
    const auto whole = contents();
    bool interrupted = false;
    // The way from the first byte to the last name is short, and a busy machine may miss it.
    for (int attempt = 0; attempt < 20 && !interrupted; ++attempt) {
      for (const std::string& name : names) folder.write(name, old);
      const auto before = folder.names();
      const auto olds = contents();
      RunningProgram program(command, {.folder = folder.path()});
      while (!program.has_ended() && !has_temporary_file(folder))
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
      program.send(has_sheets ? SIGTERM : SIGINT);
      const auto result = program.wait();
      INFO(names.front() << ": " << result.err);
      CHECK((result.exit_code == 0 || result.exit_code == (has_sheets ? 143 : 130)));
      CHECK(folder.names() == before);
      interrupted = contents() == olds;
      CHECK((interrupted || contents() == whole));
    }
    CHECK(interrupted);
    // Once the first sheet has its name, so have all.
    for (const std::string& name : names) folder.write(name, old);
    RunningProgram program(command, {.folder = folder.path()});
    while (!program.has_ended() &&
           std::filesystem::file_size(folder.path(names.front())) == old.size())
      std::this_thread::sleep_for(std::chrono::microseconds(100));
    program.send(SIGHUP);
    program.wait();
    CHECK(contents() == whole);
  }
}

TEST_CASE("an interrupted run leaves nothing but what was there", "[slow]") {
  const MadeFolder folder;
  make_big_terrain(folder);
  const std::string old = "an older drawing";
  const std::vector<std::string> command{OROGRAPH_PROGRAM, "render",      "big.bil",
                                         "map.svg",        "--overwrite", "--profiles",
                                         "3000",           "--simplify",  "0"};
  for (const auto& [signal_number, exit_code] :
       {std::pair{SIGINT, 130}, {SIGTERM, 143}, {SIGHUP, 129}}) {
    int interrupted = 0;
    for (const int after_ms : {30, 100, 300, 1000, -1}) {
      folder.write("map.svg", old);
      const auto before = folder.names();
      RunningProgram program(command, {.folder = folder.path()});
      const auto start = std::chrono::steady_clock::now();
      while (!program.has_ended() && (after_ms < 0 ? !has_temporary_file(folder)
                                                   : std::chrono::steady_clock::now() - start <
                                                         std::chrono::milliseconds(after_ms)))
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
      program.send(signal_number);
      const auto result = program.wait();
      INFO("after " << after_ms << " ms: " << result.err);
      CHECK(folder.names() == before);
      CHECK((result.exit_code == 0 || result.exit_code == exit_code));
      if (folder.read("map.svg") == old)
        ++interrupted;
      else // it was quicker, and has drawn the whole map
        CHECK(folder.read("map.svg").ends_with("</svg>\n"));
    }
    CHECK(interrupted >= 2);
  }
}
