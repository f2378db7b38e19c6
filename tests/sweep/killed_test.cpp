// SPDX-License-Identifier: GPL-3.0-or-later
// Sweeps that are killed at any moment and go on.
#include "tests/catch.hpp"
#include "tests/support/random.hpp"
#include "tests/sweep/made_sweep.hpp"

#include <nlohmann/json.hpp>
#include <signal.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <thread>

using namespace orograph;
namespace fs = std::filesystem;

namespace {

Words sweep_of(const std::string& out_dir, const Words& more) {
  return words("sweep fine.asc -q --no-seconds --of geojson --page 100x75 --margin 2 --profiles 160"
               " --azimuth 0:354:6 --elevation 30 --name v{index}") +
         Words{out_dir} + more;
}

// The files of views that are done: their rows are whole, and are written last.
std::map<std::string, FileIdentity> finished(const MadeFolder& folder, const std::string& out_dir) {
  std::map<std::string, FileIdentity> done;
  if (!fs::exists(folder.path(out_dir))) return done;
  const auto all = identities(folder, out_dir);
  for (const auto& [path, identity] : all) {
    if (!path.starts_with("rows/v")) continue;
    CHECK(nlohmann::json::accept(folder.read(out_dir + "/" + path)));
    const std::string drawing = fs::path(path).stem().string() + ".geojson";
    const auto drawn = all.find(drawing);
    INFO(path);
    REQUIRE(drawn != all.end());
    CHECK(nlohmann::json::accept(folder.read(out_dir + "/" + drawing)));
    done[path] = identity;
    done[drawing] = drawn->second;
  }
  return done;
}

// Until some view has its row which had none, or else until the sweep has ended.
void wait_for_row(const MadeFolder& folder, const std::string& out_dir, RunningProgram& program) {
  const auto count = [&] {
    const fs::path rows = folder.path(out_dir + "/rows");
    if (!fs::exists(rows)) return std::ptrdiff_t{0};
    return std::count_if(fs::directory_iterator(rows), {}, [](const fs::directory_entry& entry) {
      return entry.path().filename().string().starts_with('v'); // others are being written
    });
  };
  const auto before = count();
  while (count() <= before && !program.has_ended())
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
}

bool holds_all(const std::map<std::string, FileIdentity>& now,
               const std::map<std::string, FileIdentity>& before) {
  return std::all_of(before.begin(), before.end(), [&](const auto& file) {
    const auto found = now.find(file.first);
    return found != now.end() && found->second == file.second;
  });
}

} // namespace

TEST_CASE("a sweep killed at twelve random moments loses nothing and repeats nothing", "[slow]") {
  const MadeFolder folder;
  make_terrains(folder);
  const auto start = std::chrono::steady_clock::now();
  // By a process with a start of its own, as those that are killed.
  const Words undisturbed = Words{OROGRAPH_PROGRAM} + sweep_of("undisturbed", words("-j 2"));
  REQUIRE(RunningProgram(undisturbed, {.folder = folder.path()}).wait().exit_code == 0);
  const std::chrono::duration<double> whole = std::chrono::steady_clock::now() - start;
  const auto expected = contents(folder, "undisturbed");

  Random random(5);
  int kills = 0, in_the_middle = 0;
  while (kills < 12) {
    const auto before = finished(folder, "out");
    Words command = Words{OROGRAPH_PROGRAM} + sweep_of("out", words("-j 2 --resume"));
    RunningProgram program(command, {.folder = folder.path()});
    if (kills % 2 == 1) wait_for_row(folder, "out", program); // half of them while views are drawn
    std::this_thread::sleep_for(whole * random.between(0, kills % 2 == 1 ? 0.1 : 0.4));
    const bool was_over = program.has_ended();
    program.send(SIGKILL);
    const ProgramRun ended = program.wait();
    const auto after = finished(folder, "out");
    REQUIRE(holds_all(after, before));
    if (after.size() > before.size() && after.size() < 120) ++in_the_middle;
    if (!was_over && ended.exit_code != 0) {
      CHECK(ended.exit_code == 128 + SIGKILL);
      ++kills;
      continue;
    }
    INFO(ended.err);
    REQUIRE(ended.exit_code == 0);
    REQUIRE(differences(expected, contents(folder, "out")) == "");
    fs::remove_all(folder.path("out"));
  }
  CHECK(in_the_middle > 1);
  const auto before = finished(folder, "out");
  run_well(folder, sweep_of("out", words("--resume")));
  CHECK(holds_all(finished(folder, "out"), before));
  CHECK(differences(expected, contents(folder, "out")) == "");
}

TEST_CASE("whatever an end has left is taken up") {
  const MadeFolder folder;
  make_terrains(folder);
  run_well(folder, sweep_of("out", {}));
  const auto expected = contents(folder, "out");
  const auto before = identities(folder, "out");

  // Between the drawing and its row; before the drawing; in the middle of writing; before tables.
  fs::remove(folder.path("out/rows/v03.json"));
  fs::remove(folder.path("out/rows/v59.json"));
  fs::remove(folder.path("out/v59.geojson"));
  fs::remove(folder.path("out/v40.geojson"));
  fs::remove(folder.path("out/sweep.csv"));
  fs::remove(folder.path("out/index.html"));
  folder.write("out/.orograph-123-4.geojson", "half");
  folder.write("out/rows/.orograph-123-5.json", "");
  run_well(folder, sweep_of("out", words("--resume -j 2")));
  CHECK(differences(expected, contents(folder, "out")) == "");
  auto after = identities(folder, "out");
  for (const auto& [path, identity] : before) {
    const bool again = path.find("v03") != std::string::npos ||
                       path.find("v40") != std::string::npos ||
                       path.find("v59") != std::string::npos || path == "sweep.csv" ||
                       path == "sweep.json" || path == "index.html";
    INFO(path);
    CHECK((after[path] == identity) != again);
  }

  // Of shards too: the last to know is the merge.
  folder.write("out/.orograph-123-4.geojson", "half");
  fs::remove(folder.path("out/rows/v03.json"));
  run_well(folder, sweep_of("out", words("--resume --shard 1/3"))); // has v03
  run_well(folder, {"merge", "out"});
  CHECK(differences(expected, contents(folder, "out")) == "");
}

TEST_CASE("Ctrl-C ends a sweep between views, and it goes on", "[slow]") {
  const MadeFolder folder;
  make_terrains(folder);
  for (const auto& [signal_number, exit_code] : {std::pair{SIGINT, 130}, {SIGTERM, 143}}) {
    RunningProgram program(Words{OROGRAPH_PROGRAM} + sweep_of("out", words("-j 2")),
                           {.folder = folder.path()});
    while (!program.has_ended() && !fs::exists(folder.path("out/rows/v05.json")))
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    program.send(signal_number);
    CHECK(program.wait().exit_code == exit_code);
    CHECK_FALSE(fs::exists(folder.path("out/sweep.csv")));
    const auto before = finished(folder, "out");
    CHECK(before.size() >= 10);
    run_well(folder, sweep_of("out", words("--resume")));
    CHECK(holds_all(identities(folder, "out"), before));
    for (const auto& [path, ignored] : identities(folder, "out"))
      CHECK(path.find(".orograph-") == std::string::npos);
    fs::remove_all(folder.path("out"));
  }
}
