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

constexpr int kSize = 1000;

/// A terrain that takes seconds to draw: an ESRI .bil of int16 with its header.
void make_big_terrain(const MadeFolder& folder) {
  std::string heights;
  heights.reserve(2 * kSize * kSize);
  for (int row = 0; row < kSize; ++row)
    for (int column = 0; column < kSize; ++column) {
      const int height_m = static_cast<int>(hill_m(column, row, kSize)) + (7 * column * row) % 13;
      heights += static_cast<char>(height_m & 0xff);
      heights += static_cast<char>(height_m >> 8);
    }
  folder.write("big.bil", heights);
  const std::string side = std::to_string(kSize);
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
  int interrupted = 0;
  for (const std::string format : {"hpgl", "gcode", "dxf"})
    for (const bool has_sheets : {false, true}) {
      std::vector<std::string> command{OROGRAPH_PROGRAM, "render", "big.bil",    "map." + format,
                                       "--overwrite",    "-q",     "--profiles", "2000",
                                       "--simplify",     "0"};
      if (has_sheets) command.insert(command.end(), {"--sheets", "2x1"});
      const std::string name = (has_sheets ? "map-1." : "map.") + format;
      folder.write(name, old);
      const auto before = folder.names();
      RunningProgram program(command, {.folder = folder.path()});
      while (!program.has_ended() && !has_temporary_file(folder))
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
      program.send(has_sheets ? SIGTERM : SIGINT);
      const auto result = program.wait();
      INFO(name << ": " << result.err);
      if (result.exit_code == 0) { // it was quicker
        CHECK(folder.read(name) != old);
      } else {
        ++interrupted;
        CHECK(result.exit_code == (has_sheets ? 143 : 130));
        CHECK(folder.names() == before);
        CHECK(folder.read(name) == old);
      }
      for (const std::string& file : folder.names())
        if (file.starts_with("map")) std::filesystem::remove(folder.path(file));
    }
  CHECK(interrupted >= 4);
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
      if (result.exit_code == 0) { // it was quicker, and has drawn the whole map
        CHECK(folder.read("map.svg").ends_with("</svg>\n"));
      } else {
        ++interrupted;
        CHECK(result.exit_code == exit_code);
        CHECK(folder.read("map.svg") == old);
      }
    }
    CHECK(interrupted >= 2);
  }
}
