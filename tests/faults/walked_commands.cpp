// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/faults/walked_commands.hpp"

#include "tests/cli/run_program.hpp"

#include <signal.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <set>
#include <sstream>
#include <thread>

namespace orograph {
namespace {

namespace fs = std::filesystem;
using Files = std::map<std::string, std::string>;

// Files by their paths in the folder, but for `inputs`.
Files files_in(const MadeFolder& folder, const Files& inputs) {
  Files files;
  for (const auto& entry : fs::recursive_directory_iterator(folder.path())) {
    if (!entry.is_regular_file()) continue;
    const std::string name = fs::relative(entry.path(), folder.path()).string();
    std::ifstream file(entry.path(), std::ios::binary);
    std::string content(std::istreambuf_iterator<char>(file), {});
    const auto input = inputs.find(name);
    if (input == inputs.end() || input->second != content) files[name] = std::move(content);
  }
  return files;
}

struct Outcome {
  ProgramRun run;
  bool hangs = false;
  Files files;
};

class Walker {
public:
  explicit Walker(const WalkedCommand& command) : command_(command) {
    first_ = outcome("none:0");
    const Outcome second = outcome("none:0");
    for (const auto& [name, content] : first_.files) {
      const auto again = second.files.find(name);
      if (again == second.files.end() || again->second != content) varying_.insert(name);
    }
  }

  // What is wrong without a fault.
  std::string fault_of_reference() const {
    return first_.run.exit_code != 0 ? "without a fault: " + first_.run.err : "";
  }

  std::size_t calls(const std::string& kind) {
    count_ = true;
    const Outcome counted = outcome(kind + ":0");
    count_ = false;
    return counts_.empty() ? 0 : std::strtoul(counts_.c_str(), nullptr, 10);
  }

  // What is wrong with a run in which a call failed, or nothing.
  std::string fault_of(const Outcome& outcome) const {
    const auto& [run, hangs, files] = outcome;
    if (hangs) return "hangs";
    if (run.exit_code != 0 && run.exit_code != 1)
      return "ends with " + std::to_string(run.exit_code) + ": " + run.err;
    for (const auto& [name, content] : files) {
      const auto right = first_.files.find(name);
      const auto older = std::find_if(command_.older.begin(), command_.older.end(),
                                      [&](const auto& file) { return file.first == name; });
      if (older != command_.older.end() && older->second == content && run.exit_code == 1) continue;
      if (right == first_.files.end()) return "leaves " + name;
      const std::string& whole = right->second;
      const bool is_whole = !whole.empty() && content.ends_with(whole.back());
      const bool may_vary =
          varying_.contains(name) || (command_.in_parts && !name.ends_with(".svg"));
      if (content != right->second && !(may_vary && is_whole)) return "leaves another " + name;
    }
    if (run.exit_code == 1) return fault_of_message(run.err);
    if (run.err.find("error") != run.err.npos) return "tells of an error and goes on: " + run.err;
    for (const auto& [name, content] : first_.files)
      if (!files.contains(name)) return "makes no " + name;
    return run.out == first_.run.out || varying_.size() > 0 ? "" : "says something else";
  }

  // Whether the call that failed was another library's own: by the first frame of its stack that is
  // neither the preloaded library nor the C or C++ library.
  bool is_of_others(const std::string& fault) {
    tells_ = true;
    const std::string told = outcome(fault).run.err;
    tells_ = false;
    std::istringstream lines(told);
    for (std::string line; std::getline(lines, line);) {
      const bool is_frame = line.find("[0x") != line.npos;
      if (!is_frame || line.find("/fail_call.so") != line.npos ||
          line.find("/libc.so") != line.npos || line.find("/libstdc++.so") != line.npos)
        continue;
      return line.find(OROGRAPH_PROGRAM) == line.npos && line.find(".so") != line.npos;
    }
    return false;
  }

  Outcome outcome(const std::string& fault) {
    const MadeFolder folder;
    make_inputs(folder);
    for (std::vector<std::string> before : command_.before) {
      before.insert(before.begin(), OROGRAPH_PROGRAM);
      RunningProgram(before, {.folder = folder.path()}).wait();
    }
    const Files inputs = files_in(folder, {});
    for (const auto& [name, content] : command_.older) {
      fs::create_directories(fs::path(folder.path(name)).parent_path());
      folder.write(name, content);
    }
    std::vector<std::string> command{"env", "LD_PRELOAD=" OROGRAPH_FAIL_CALL,
                                     "OROGRAPH_FAULT=" + fault, "TMPDIR=" + folder.path()};
    if (count_) command.emplace_back("OROGRAPH_FAULT_COUNT=1");
    if (tells_) command.emplace_back("OROGRAPH_FAULT_TRACE=1");
    command.emplace_back(OROGRAPH_PROGRAM);
    command.insert(command.end(), command_.arguments.begin(), command_.arguments.end());
    RunningProgram program(command, {.folder = folder.path()});
    Outcome outcome;
    const auto start = std::chrono::steady_clock::now();
    while (!program.has_ended() && !outcome.hangs) {
      std::this_thread::sleep_for(std::chrono::milliseconds(2));
      if (std::chrono::steady_clock::now() - start < std::chrono::seconds(60)) continue;
      outcome.hangs = true;
      program.send(SIGKILL);
    }
    outcome.run = program.wait();
    outcome.files = files_in(folder, inputs);
    if (count_) { // it stands behind what the command itself says
      const std::string& out = outcome.run.out;
      counts_ = out.substr(out.find_last_not_of("0123456789") + 1);
      if (first_.run.exit_code == 0 && out.starts_with(first_.run.out))
        counts_ = out.substr(first_.run.out.size());
    }
    return outcome;
  }

private:
  const WalkedCommand& command_;
  bool count_ = false, tells_ = false;
  std::string counts_;
  Outcome first_;
  std::set<std::string> varying_; ///< what differs from run to run
};

std::vector<WalkedCommand> made_commands() {
  std::vector<WalkedCommand> commands;
  const auto render = [&](const std::string& name, const std::string& input,
                          const std::string& output, const std::vector<std::string>& options) {
    std::vector<std::string> arguments{"render", input, output, "--profiles", "12"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    commands.push_back({name, arguments});
  };
  for (const std::string format :
       {"svg", "pdf", "ps", "eps", "png", "geojson", "gpkg", "hpgl", "gcode", "dxf"}) {
    const bool is_png = format == "png";
    render(format, "hill.asc", "map." + format,
           is_png ? std::vector<std::string>{"--dpi", "50"} : std::vector<std::string>{});
    render(format + " over an older one", "hill.asc", "map." + format, {"--overwrite"});
    commands.back().older = {{"map." + format, "older"}};
    if (is_png) commands.back().arguments.insert(commands.back().arguments.end(), {"--dpi", "50"});
  }
  render("standard output", "hill.asc", "-", {"--of", "svg"});
  render("a report", "hill.asc", "map.svg", {"--report", "map.json"});
  render("a view's report", "hill.asc", "map.svg", {"--report", "map.toml"});
  render("sheets", "hill.asc", "map.hpgl", {"--sheets", "2x1", "--page", "a4"});
  render("a GeoTIFF", "hill.tif", "map.svg", {"--contours", "20m"});
  render("two files", "hill.asc", "map.svg", {});
  commands.back().arguments.insert(commands.back().arguments.begin() + 2, "east.asc");
  render("triangles", "hut.off", "map.svg", {});
  render("points", "points.csv", "map.svg", {});
  render("roads", "hill.asc", "map.svg", {"--drape", "roads.geojson"});
  render("a scene", "hill.asc", "map.svg", {"--scene", "scene.toml"});
  render("settings", "hill.asc", "map.svg", {"--settings", "settings.toml"});
  render("pens", "hill.asc", "map.svg", {"--pens", "pens.toml"});
  render("a check", "hill.asc", "map.svg", {"--check", "200"});
  commands.push_back(
      {"sweep",
       {"sweep", "hill.asc", "out", "--azimuth", "0,90", "--profiles", "8", "--no-seconds"},
       {},
       true});
  commands.push_back({"sweep, resumed",
                      {"sweep", "hill.asc", "out", "--azimuth", "0,90", "--profiles", "8",
                       "--no-seconds", "--resume"},
                      {},
                      true});
  commands.push_back({"tin, PLY", {"tin", "points.csv", "a.ply"}});
  commands.push_back({"tin, GeoPackage", {"tin", "hill.asc", "a.gpkg", "--max-error", "5m"}});
  commands.push_back({"merge", {"merge", "out"}, {}, true});
  for (const char* shard : {"1/2", "2/2"})
    commands.back().before.push_back({"sweep", "hill.asc", "out", "--azimuth", "0,90", "--profiles",
                                      "8", "--no-seconds", "--shard", shard});
  commands.push_back({"info", {"info", "hill.asc"}});
  commands.push_back({"an index over an older one", {"index", "large.vrt"}});
  commands.back().older = {{"large.vrt.levels", "orolev01"}};
  commands.push_back({"visible",
                      {"visible", "hill.asc", "points.csv", "--eye", "80,80", "--output",
                       "seen.geojson", "--horizon-table", "skyline.csv", "--horizon-step", "10"},
                      {},
                      true});
  commands.push_back({"accuracy",
                      {"accuracy", "hill.asc", "--profiles", "4,8", "--repeats", "1", "--probes",
                       "100", "--output", "measured"},
                      {},
                      true});
  commands.push_back({"fragmentation",
                      {"fragmentation", "hill.asc", "--profiles", "4", "--worst-case", "0",
                       "--output", "measured"},
                      {},
                      true});
  return commands;
}

} // namespace

const std::vector<WalkedCommand>& walked_commands() {
  static const std::vector<WalkedCommand> commands = made_commands();
  return commands;
}

void make_inputs(const MadeFolder& folder) {
  constexpr int kSize = 16;
  const HeightOf height = [](int column, int row) { return hill_m(column, row, kSize); };
  folder.write("hill.asc", ascii_grid(kSize, kSize, height));
  folder.write("east.asc", ascii_grid(kSize, kSize, height, {.x = 10 * kSize}));
  folder.write("hill.prj", std::string(kUtm32));
  folder.write("east.prj", std::string(kUtm32));
  folder.write("hill.tif", geotiff(kSize, kSize, height));
  folder.write(
      "large.vrt", // the least that has an index
      R"(<VRTDataset rasterXSize="512" rasterYSize="512"><SRS>EPSG:32632</SRS>)"
      R"(<GeoTransform>0,10,0,0,0,-10</GeoTransform><VRTRasterBand dataType="Float32" )"
      R"(band="1"><SimpleSource><SourceFilename relativeToVRT="1">hill.tif</SourceFilename>)"
      R"(<SourceBand>1</SourceBand><SrcRect xOff="0" yOff="0" xSize="16" ySize="16"/>)"
      R"(<DstRect xOff="0" yOff="0" xSize="512" ySize="512"/></SimpleSource>)"
      R"(</VRTRasterBand></VRTDataset>)");
  folder.write("hut.off", "OFF\n5 4 0\n0 0 0\n9 0 1\n9 9 0\n0 9 1\n4 4 8\n3 0 1 4\n3 1 2 4\n3 2 3 "
                          "4\n3 3 0 4\n");
  folder.write("points.csv", "x,y,z\n0,0,1\n90,0,2\n80,95,7\n0,90,3\n40,41,30\n10,60,12\n");
  folder.write("roads.geojson",
               R"({"type":"FeatureCollection","crs":{"type":"name","properties":{"name":)"
               R"("urn:ogc:def:crs:EPSG::32632"}},"features":[{"type":"Feature","properties":)"
               R"({"class":"road"},"geometry":{"type":"LineString","coordinates":[[20,20],[130,)"
               R"(120]]}}]})");
  folder.write("scene.toml", "[part.hut]\nshape = \"box\"\nsize = [20, 20, 20]\n\n"
                             "[[place]]\npart = \"hut\"\nat = [60, 60]\n");
  folder.write("settings.toml", "fov = 40\ncontours = \"20m\"\n");
  folder.write("pens.toml", "[[pen]]\nwidth = 0.3\n");
}

Walk walk(const WalkedCommand& command, const std::vector<std::string>& kinds, std::size_t each) {
  Walk walk;
  Walker walker(command);
  if (const std::string fault = walker.fault_of_reference(); !fault.empty()) {
    walk.wrong.push_back(command.name + ": " + fault);
    return walk;
  }
  for (const std::string& kind : kinds) {
    const std::size_t calls = walker.calls(kind), count = std::min(calls, each);
    for (std::size_t i = 0; i < count; ++i) {
      const std::string fault = kind + ":" + std::to_string(1 + i * calls / count);
      const auto outcome = walker.outcome(fault);
      ++walk.faults;
      walk.refused += outcome.run.exit_code == 1 ? 1 : 0;
      const std::string wrong = walker.fault_of(outcome);
      if (wrong.empty()) continue;
      if (outcome.run.exit_code > 128 && (kind == "memory" || kind == "opened") &&
          walker.is_of_others(fault))
        ++walk.ended_by_others;
      else
        walk.wrong.push_back(command.name + " " + fault + ": " + wrong);
    }
  }
  return walk;
}

const std::vector<std::string>& fault_kinds() {
  static const std::vector<std::string> kinds{"write", "short", "sync",   "rename", "open",
                                              "mkdir", "read",  "memory", "opened", "thread"};
  return kinds;
}

} // namespace orograph
