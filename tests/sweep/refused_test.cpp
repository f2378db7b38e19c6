// SPDX-License-Identifier: GPL-3.0-or-later
// Sweeps that don't begin: another sweep, other files, other words.
#include "tests/catch.hpp"
#include "tests/sweep/made_sweep.hpp"

#include <filesystem>

using namespace orograph;
namespace fs = std::filesystem;

namespace {

void check_refused(const MadeFolder& folder, const Words& arguments, int exit_code,
                   const std::string& part) {
  const auto before = contents(folder, ".");
  const ProgramRun ended = run(folder, arguments);
  std::string line;
  for (const std::string& word : arguments) line += " " + word;
  INFO("orograph" << line << "\n" << ended.err);
  CHECK(ended.exit_code == exit_code);
  CHECK(fault_of_message(ended.err) == "");
  CHECK(ended.err.find(part) != std::string::npos);
  CHECK(differences(before, contents(folder, ".")) == "");
}

} // namespace

TEST_CASE("a sweep goes on only as the same sweep") {
  const MadeFolder folder;
  make_terrains(folder);
  folder.write("list.toml",
               "[[view]]\nprojection = 'parallel'\nvrp = [120, 120, 100]\n"
               "vpn = [0, -1, 1]\nprp = [0, 0, 100]\nwindow = [-150, -150, 150, 150]\n");
  folder.write("path.csv", "id,WKT\n1,\"LINESTRING(120 20,120 30)\"\n");
  const Words same = words("sweep hill.asc out --azimuth 0,90 -q") + kSmall;
  run_well(folder, same);
  const auto refused = [&](const Words& arguments, const std::string& part) {
    check_refused(folder, arguments, 1, part);
  };
  refused(same, "out holds this sweep already, with 2 of 2 views: give --resume to go on with it, "
                "--overwrite to begin anew, or another folder");
  refused(words("sweep hill.asc out --azimuth 0,91 --resume") + kSmall,
          "out holds a sweep with --azimuth 0,90, not --azimuth 0,91: give the same again");
  refused(words("sweep hill.asc out --resume") + kSmall,
          "out holds a sweep with --azimuth 0,90, not no --azimuth");
  refused(same + words("--resume --elevation 10"),
          "out holds a sweep with no --elevation, not --elevation 10");
  refused(same + words("--resume --no-seconds"), "with no --no-seconds, not --no-seconds");
  refused(same + words("--resume --of pdf"), "with no --of, not --of pdf");
  refused(same + words("--shard 1/2 --title Hills"), "with no --title, not --title Hills");
  refused(words("sweep other.asc out --azimuth 0,90 --resume") + kSmall,
          "out holds a sweep of hill.asc, which is not other.asc as it is now");
  refused(words("sweep utm.asc out --azimuth 0,90 --resume") + kSmall, "which is not utm.asc");
  refused(same + words("--shard 1/2"), "out holds this sweep already, with 1 of 1 views");

  // How it is worked at may differ, and where the file is.
  fs::create_directory(folder.path("elsewhere"));
  fs::copy(folder.path("hill.asc"), folder.path("elsewhere/hill.asc"));
  const auto before = identities(folder, "out");
  run_well(folder,
           words("sweep elsewhere/hill.asc out --azimuth=0,90 --resume -j 2 --yes --no-progress") +
               kSmall);
  for (const auto& [path, identity] : identities(folder, "out"))
    if (path.ends_with(".svg")) CHECK(before.at(path) == identity);

  // What the files say counts, not their names.
  run_well(folder, words("sweep hill.asc listed --views list.toml"));
  run_well(folder, words("sweep hill.asc walked --eye-path path.csv -q"));
  std::string list = folder.read("list.toml");
  folder.write("list.toml", "# The same.\n" + list);
  run_well(folder, words("sweep hill.asc listed --views list.toml --resume"));
  folder.write("list.toml", list.replace(list.find("100]"), 3, "101"));
  refused(words("sweep hill.asc listed --views list.toml --resume"),
          "listed holds a sweep of other views: the path or list was changed");
  folder.write("path.csv", "id,WKT\n1,\"LINESTRING(120 20,120 31)\"\n");
  refused(words("sweep hill.asc walked --eye-path path.csv --resume"),
          "walked holds a sweep of other views");

  folder.write("pens.toml", "[[pen]]\nnumber = 1\nwidth = 0.1\n");
  const Words by_pens = words("sweep hill.asc inked --azimuth 0,90 --pens pens.toml -q");
  run_well(folder, by_pens);
  fs::copy(folder.path("pens.toml"), folder.path("elsewhere/pens.toml"));
  run_well(folder,
           words("sweep hill.asc inked --azimuth 0,90 --pens elsewhere/pens.toml --resume"));
  folder.write("pens.toml", "[[pen]]\nnumber = 1\nwidth = 0.2\n");
  refused(by_pens + words("--resume"), "inked holds a sweep with --pens pens.toml ");

  // Overwriting removes what the old one has made, and nothing else.
  folder.write("out/notes.txt", "mine");
  folder.write("out/azimuth-45.svg", "mine as well");
  run_well(folder, words("sweep hill.asc out --azimuth 180 --overwrite -q") + kSmall);
  std::string names;
  for (const auto& [path, ignored] : contents(folder, "out")) names += path + " ";
  CHECK(names == "azimuth-45.svg index.html notes.txt plan.json rows/view.json sweep.csv "
                 "sweep.json view.svg ");
  run_well(folder, words("sweep hill.asc alone --azimuth 180 -q") + kSmall);
  refused({"merge", "out", "alone", "listed"}, "holds a sweep with");
}

TEST_CASE("files that are of no sweep are not replaced") {
  const MadeFolder folder;
  make_terrains(folder);
  run_well(folder, words("sweep hill.asc part --azimuth 0,90 -q") + kSmall);
  for (const std::string name : {"azimuth-90.svg", "index.html", "sweep.csv", "sweep.json"}) {
    fs::create_directory(folder.path("out"));
    folder.write("out/" + name, "mine");
    for (const Words& arguments : {words("sweep hill.asc out --azimuth 0,90") + kSmall,
                                   words("sweep hill.asc out --azimuth 0,90 --resume") + kSmall,
                                   words("sweep hill.asc out --azimuth 0,90 --overwrite") + kSmall,
                                   words("sweep hill.asc out --azimuth 0,90 --shard 1/2") + kSmall,
                                   {"merge", "out", "part"}})
      check_refused(folder, arguments, 1,
                    "out/" + name + " exists already, and is of no sweep: give another folder");
    fs::remove_all(folder.path("out"));
  }
  fs::create_directory(folder.path("out"));
  fs::create_symlink("nowhere", folder.path("out/index.html")); // what it leads to isn't made
  check_refused(folder, words("sweep hill.asc out --azimuth 0,90") + kSmall, 1, "out/index.html");
  fs::remove_all(folder.path("out"));
  fs::create_directory(folder.path("out"));
  folder.write("out/notes.txt", "mine"); // in nobody's way
  run_well(folder, words("sweep hill.asc out --azimuth 0,90 -q") + kSmall);
}

TEST_CASE("what render alone can is told so") {
  const MadeFolder folder;
  make_terrains(folder);
  check_refused(folder, words("sweep hill.asc out --azimuth 0,90 --sheets 2x2"), 2,
                "--sheets is an option of orograph render that a sweep hasn't: orograph sweep "
                "--help lists what there is");
  check_refused(folder, words("sweep hill.asc out --view a.toml"), 2,
                "that a sweep hasn't: did you mean --views?");
}

TEST_CASE("lists of views that can't be drawn are told of by file and line") {
  const MadeFolder folder;
  make_terrains(folder);
  const std::string view = "projection = 'parallel'\nvrp = [120, 120, 100]\nvpn = [0, -1, 1]\n"
                           "prp = [0, 0, 100]\nwindow = [-150, -150, 150, 150]\n";
  const auto refused = [&](const std::string& text, const std::string& part) {
    folder.write("list.toml", text);
    check_refused(folder, words("sweep hill.asc out --views list.toml"), 1, "list.toml" + part);
  };
  refused("", " holds no view: begin each view with a line [[view]]");
  refused(view, ", line 1: 'projection' is no list of views");
  refused("[view]\n" + view, ", line 1: 'view' is no list of views");
  refused("view = 5\n", ", line 1: 'view' is no list of views");
  refused("view = []\n", "");
  refused("name = 'a'\n[[view]]\n" + view, ", line 1: 'name' is no list of views");
  refused("[[views]]\n" + view, ", line 1: 'views' is no list of views");
  refused("[[view]]\n" + view + "[[view]]\n", ": projection is missing");
  refused("[[view]]\n" + view + "\n[[view]]\nnam = 'a'\n" + view, ", line 9: unknown key 'nam'");
  refused("[[view]]\n" + view + "fron = 3\n", ", line 7: unknown key 'fron': did you mean front?");
  refused("[[view]]\nname = 5\n" + view, ", line 2: this can't be a view's name");
  refused("[[view]]\nname = ''\n" + view, ", line 2: this can't be a view's name");
  refused("[[view]]\nname = 'a/b'\n" + view, ", line 2: this can't be a view's name");
  refused("[[view]]\nname = 'a\n", ", line 2: this isn't TOML");
  check_refused(folder, words("sweep hill.asc out --views hill.asc"), 1, "hill.asc, line 1");
  check_refused(folder, words("sweep hill.asc out --views nowhere.toml"), 1,
                "nowhere.toml: no such file");
  folder.write("list.toml", "[[view]]\nname = 'a'\n" + view + "[[view]]\nname = 'a'\n" + view);
  check_refused(folder, words("sweep hill.asc out --views list.toml"), 2,
                "views 0 and 1 would both be called 'view-a'");
  folder.write("list.toml", "[[view]]\nname = '.a'\n" + view);
  check_refused(folder, words("sweep hill.asc out --views list.toml --name {view}"), 2,
                "'.a' begins with a point");
}

TEST_CASE("paths that lead nowhere") {
  const MadeFolder folder;
  make_terrains(folder);
  const auto refused = [&](const std::string& name, const std::string& text,
                           const std::string& part, const Words& more = {}) {
    folder.write(name, text);
    check_refused(folder, words("sweep utm.asc out --eye-path") + Words{name} + more, 1,
                  name + part);
  };
  refused("empty.geojson", R"({"type":"FeatureCollection","features":[]})", " holds no line");
  refused("two.csv", "id,WKT\n1,\"LINESTRING(1 2,3 4)\"\n2,\"LINESTRING(1 2,3 4)\"\n",
          " holds more than one line");
  refused("short.csv", "id,WKT\n1,\"LINESTRING(1 2,1 2)\"\n", ": its line has no length");
  refused("long.csv", "id,WKT\n1,\"LINESTRING(1 2,1 9999)\"\n", " is ",
          words("--eye-step 0.000001"));
  check_refused(folder, words("sweep utm.asc out --eye-path nowhere.gpkg"), 1, "nowhere.gpkg");
  check_refused(folder, words("sweep utm.asc out --eye-path utm.asc"), 1, "utm.asc can't be read");
  // Far from the terrain there is no ground to stand on: views that fail, one line.
  folder.write("far.geojson", line_text("[10,46],[10.1,46]"));
  const ProgramRun ended = run(folder, words("sweep utm.asc out --eye-path far.geojson -q"));
  INFO(ended.err);
  CHECK(ended.exit_code == 1);
  CHECK(fault_of_message(ended.err) == "");
  CHECK(ended.err.find("2 of 2 views failed") != std::string::npos);
  CHECK(ended.err.find("outside of the terrain") != std::string::npos);
}
