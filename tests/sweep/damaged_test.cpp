// SPDX-License-Identifier: GPL-3.0-or-later
// Full disks, folders that can't be written to, and files that something else has spoilt: one clear
// line, nothing lost, and the sweep goes on when it can.
#include "tests/catch.hpp"
#include "tests/sweep/made_sweep.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <filesystem>

using namespace orograph;
namespace fs = std::filesystem;

namespace {

Words sweep_into(const std::string& out_dir, const Words& more = {}) {
  return words("sweep hill.asc --no-seconds --azimuth 0:300:60 --elevation 15,50") +
         Words{out_dir} + kSmall + more;
}

void check_line(const ProgramRun& ended, const std::string& part) {
  INFO(ended.err);
  CHECK(ended.exit_code == 1);
  CHECK(fault_of_message(ended.err) == "");
  CHECK(ended.err.find(part) != std::string::npos);
}

bool has_leftovers(const MadeFolder& folder, const std::string& out_dir) {
  for (const auto& [path, ignored] : contents(folder, out_dir))
    if (path.find(".orograph-") != std::string::npos) return true;
  return false;
}

} // namespace

TEST_CASE("a file-size limit ends a sweep, which goes on without it") {
  const MadeFolder folder;
  make_terrains(folder);
  run_well(folder, sweep_into("whole"));
  const auto expected = contents(folder, "whole");
  std::size_t plan = expected.at("plan.json").size(), least = 1'000'000, most = 0, page = 0;
  for (const auto& [path, bytes] : expected)
    if (path.ends_with(".svg")) {
      least = std::min(least, bytes.size());
      most = std::max(most, bytes.size());
    }
  page = expected.at("index.html").size();
  REQUIRE(plan > 1000);
  REQUIRE(page > most);
  // Nothing fits; some drawings fit, or none; all but the page fits.
  for (const std::size_t limit : {std::size_t{1000}, (least + most) / 2, most, page - 1}) {
    INFO("limit of " << limit << " bytes");
    fs::remove_all(folder.path("out"));
    for (const std::string jobs : {"1", "2"}) {
      const ProgramRun ended =
          run(folder, sweep_into("out", {"-j", jobs, "--resume", "-q"}), limit);
      check_line(ended, "out/");
      CHECK_FALSE(has_leftovers(folder, "out"));
    }
    for (const auto& [path, bytes] : contents(folder, "out")) {
      INFO(path);
      CHECK(bytes == expected.at(path));
    }
    run_well(folder, sweep_into("out", {"--resume"}));
    CHECK(differences(expected, contents(folder, "out")) == "");
  }
  check_line(run(folder, {"merge", "out"}, page - 1), "out/index.html");
  CHECK(differences(expected, contents(folder, "out")) == "");
}

TEST_CASE("a full disk ends a sweep, which goes on when there is room") {
  const MadeFolder folder;
  make_terrains(folder);
  run_well(folder, sweep_into("whole"));
  fs::create_directory(folder.path("disk"));
  const std::string mount = "mount -t tmpfs -o size=400k tmpfs disk && ";
  Words shell{"unshare", "-m", "sh", "-c", mount + "true"};
  if (RunningProgram(shell, {.folder = folder.path()}).wait().exit_code != 0)
    shell.insert(shell.begin() + 1, "-r");
  if (RunningProgram(shell, {.folder = folder.path()}).wait().exit_code != 0) {
    WARN("no tmpfs can be mounted here; only the file-size limit stands for a full disk");
    return;
  }
  std::string line = "\"$0\"";
  for (const std::string& word : sweep_into("disk/out", words("-j 2 --resume -q")))
    line += " " + word;
  for (const int taken_kb : {396, 370, 330, 290}) {
    shell.back() = mount + fmt::format("head -c {} /dev/zero >disk/taken; ", taken_kb * 1024) +
                   line + "; echo $? >&2; find disk -name '.orograph-*'; rm disk/taken; " + line +
                   " && diff -r whole disk/out && echo same";
    const ProgramRun ended =
        RunningProgram(shell + Words{OROGRAPH_PROGRAM}, {.folder = folder.path()}).wait();
    INFO(taken_kb << " kB taken: " << ended.err);
    CHECK(ended.out == "same\n");
    CHECK(ended.err.starts_with("orograph: error: disk/out"));
    CHECK(ended.err.ends_with("\n1\n"));
    CHECK(std::count(ended.err.begin(), ended.err.end(), '\n') == 2);
  }
}

TEST_CASE("folders that no sweep can be in") {
  const MadeFolder folder;
  make_terrains(folder);
  const auto before = folder.names();
  check_line(run(folder, sweep_into("hill.asc")), "hill.asc is no folder: give the folder");
  check_line(run(folder, sweep_into("hill.asc/out")), "hill.asc/out");
  check_line(run(folder, sweep_into("/proc/out")), "/proc/out");
  check_line(run(folder, sweep_into("/dev/null/out")), "/dev/null/out");
  check_line(run(folder, {"merge", "nowhere"}), "nowhere holds no sweep");
  check_line(run(folder, {"merge", "out", "nowhere"}), "nowhere holds no sweep");
  check_line(run(folder, {"merge", "hill.asc"}), "hill.asc holds no sweep");
  CHECK(folder.names() == before);
}

TEST_CASE("rows that something has spoilt are told of, and drawn again", "[slow]") {
  const MadeFolder folder;
  make_terrains(folder);
  run_well(folder, sweep_into("out"));
  const auto expected = contents(folder, "out");
  const std::string name = "rows/azimuth-060_elevation-15.json", path = "out/" + name;
  const std::string good = expected.at(name);
  auto no_column = nlohmann::ordered_json::parse(good), odd_error = no_column, boolean = no_column,
       swapped = no_column;
  no_column["row"].erase("ties");
  odd_error["row"]["error"] = 5;
  boolean["row"]["ties"] = true;
  swapped["row"].erase("ties");
  swapped["row"]["ties"] = 0; // last now
  for (const std::string& bad :
       {std::string(), good.substr(0, good.size() / 2), std::string("{}"), std::string("null"),
        std::string("[1,2]"), std::string("{\"row\":{},\"preview\":null}"),
        expected.at("rows/azimuth-000_elevation-15.json"), expected.at("plan.json"),
        std::string("\x00\xff\xfe{", 4), std::string(100'000, '['), good + good, no_column.dump(),
        odd_error.dump(), boolean.dump(), swapped.dump()}) {
    INFO(bad.substr(0, 60));
    folder.write(path, bad);
    const auto before = identities(folder, "out");
    check_line(run(folder, {"merge", "out", "-q"}), "1 of 12 views are missing in out, "
                                                    "'azimuth-060_elevation-15' among them");
    check_line(run(folder, sweep_into("out")),
               "out holds this sweep already, with 11 of 12 views: give --resume");
    const ProgramRun resumed = run(folder, sweep_into("out", words("--resume -q")));
    CHECK(resumed.exit_code == 0);
    CHECK(resumed.err == "orograph: " + path + " can't be read: its view is drawn again\n");
    CHECK(differences(expected, contents(folder, "out")) == "");
    const auto after = identities(folder, "out");
    for (const auto& [file, identity] : before)
      if (file.starts_with("azimuth-") || file.starts_with("rows/"))
        CHECK((after.at(file) == identity) ==
              (file.find("azimuth-060_elevation-15") == std::string::npos));
  }
}

TEST_CASE("files that are folders are in the way, and nothing is lost to them") {
  const MadeFolder folder;
  make_terrains(folder);
  run_well(folder, sweep_into("out"));
  const auto expected = contents(folder, "out");
  for (const std::string name :
       {"azimuth-060_elevation-15.svg", "rows/azimuth-060_elevation-15.json", "plan.json",
        "sweep.csv", "index.html"}) {
    INFO(name);
    const std::string path = "out/" + name;
    fs::rename(folder.path(path), folder.path("aside"));
    fs::create_directory(folder.path(path));
    folder.write(path + "/precious", "mine");
    check_line(run(folder, sweep_into("out", words("--resume -q"))), path);
    CHECK(folder.read(path + "/precious") == "mine");
    fs::remove_all(folder.path(path));
    if (name == "plan.json") fs::rename(folder.path("aside"), folder.path(path));
    run_well(folder, sweep_into("out", words("--resume")));
    CHECK(differences(expected, contents(folder, "out")) == "");
  }
}

TEST_CASE("plans that are none, or reach beyond their folder", "[slow]") {
  const MadeFolder folder;
  make_terrains(folder);
  run_well(folder, sweep_into("out"));
  const auto expected = contents(folder, "out");
  const std::string good = expected.at("plan.json");
  folder.write("precious.svg", "mine");
  const auto changed = [&](const auto& change) {
    auto plan = nlohmann::ordered_json::parse(good);
    change(plan);
    return plan.dump(1) + "\n";
  };
  for (const std::string& bad :
       {std::string(), std::string("{}"), std::string("[]"), good.substr(0, good.size() - 3),
        std::string(10'000, '['), changed([](auto& plan) { plan.erase("options"); }),
        changed([](auto& plan) { plan["options"] = 5; }),
        changed([](auto& plan) { plan["options"]["--azimuth"] = 5; }),
        changed([](auto& plan) { plan.erase("program"); }),
        changed([](auto& plan) { plan["program"] = "orograph"; }),
        changed([](auto& plan) { plan["views"][3] = 7; }),
        changed([](auto& plan) { plan["columns"] = 7; }),
        changed([](auto& plan) { plan["views"][3]["name"] = "../precious"; }),
        changed([](auto& plan) { plan["extension"] = "/../../precious.svg"; })}) {
    INFO(bad.substr(0, 60));
    folder.write("out/plan.json", bad);
    for (const std::string option : {"--resume", "--overwrite"})
      check_line(run(folder, sweep_into("out", {option, "-q"})),
                 "out/plan.json is no plan of a sweep: give another folder");
    check_line(run(folder, {"merge", "out"}), "out/plan.json is no plan of a sweep");
    CHECK(folder.read("precious.svg") == "mine");
    folder.write("out/plan.json", good);
    CHECK(differences(expected, contents(folder, "out")) == "");
  }
  run_well(folder, sweep_into("out", words("--resume")));
  CHECK(differences(expected, contents(folder, "out")) == "");
}

TEST_CASE("neither a sweep nor a merge follows links out of its folder") {
  const MadeFolder folder;
  make_terrains(folder);
  run_well(folder, sweep_into("out"));
  run_well(folder, sweep_into("whole"));
  folder.write("precious", "mine");
  const auto links = [&](const std::string& name) {
    INFO(name);
    const fs::path path = folder.path("out/" + name);
    const fs::path kept = folder.path("kept");
    fs::rename(path, kept);
    fs::create_symlink(folder.path(fs::is_directory(kept) ? "whole/" + name : "precious"), path);
    check_line(run(folder, sweep_into("out", {"--resume", "-q"})), "is a symbolic link");
    check_line(run(folder, {"merge", "out"}), "is a symbolic link");
    check_line(run(folder, {"merge", "merged", "out"}), "is a symbolic link");
    CHECK(folder.read("precious") == "mine");
    fs::remove(path);
    fs::rename(kept, path);
    fs::remove_all(folder.path("merged"));
  };
  std::string drawing;
  for (const auto& [path, bytes] : contents(folder, "out"))
    if (path.ends_with(".svg")) drawing = path;
  for (const std::string& name : {drawing, std::string("sweep.csv"), std::string("rows")})
    links(name);
  run_well(folder, {"merge", "out", "-q"});
  CHECK(differences(contents(folder, "whole"), contents(folder, "out")) == "");
}
