// SPDX-License-Identifier: GPL-3.0-or-later
// Sweeps of terrains with solids on them, and of solids alone.
#include "placing/fingerprint.hpp"
#include "solids/read_scene.hpp"
#include "tests/catch.hpp"
#include "tests/cli/made_scenes.hpp"
#include "tests/sweep/made_sweep.hpp"

#include <cmath>
#include <filesystem>
#include <limits>
#include <set>

using namespace orograph;

namespace {

void make_inputs(const MadeFolder& folder) {
  make_terrains(folder);
  folder.write("huts.toml", scene_text("part = 'box'\nat = [120, 120]\n[[place]]\npart = 'mast'\n"
                                       "at = [60, 180]"));
}

} // namespace

TEST_CASE("every view of a sweep has the solids that its own drawing has") {
  const MadeFolder folder;
  make_inputs(folder);
  run_well(folder, words("sweep hill.asc on -q --scene huts.toml --azimuth 0:90:30") + kSmall);
  run_well(folder, words("sweep hill.asc bare -q --azimuth 0:90:30") + kSmall);
  run_well(folder, words("sweep huts.toml alone -q --azimuth 0:90:30 --page 60x45 --margin 2"));
  for (const std::string azimuth : {"00", "30", "60", "90"}) {
    const std::string file = "/azimuth-" + azimuth + ".svg",
                      from = std::stoi(azimuth) == 0 ? "0/25" : azimuth + "/25";
    run_well(folder,
             words("render hill.asc one.svg --overwrite -q --scene huts.toml --view-from " + from) +
                 kSmall);
    CHECK(folder.read("on" + file) == folder.read("one.svg"));
    CHECK(folder.read("on" + file) != folder.read("bare" + file));
    run_well(folder, words("render huts.toml one.svg --overwrite -q --page 60x45 --margin 2 "
                           "--view-from " +
                           from));
    CHECK(folder.read("alone" + file) == folder.read("one.svg"));
  }
}

TEST_CASE("solids are seen from a path as well") {
  const MadeFolder folder;
  make_inputs(folder);
  folder.write("path.geojson", line_text("[120,20],[200,20]"));
  run_well(folder, words("sweep hill.asc on -q --eye-path path.geojson --look-azimuth 0 --pitch 20 "
                         "--fov 80 --scene "
                         "huts.toml") +
                       kSmall);
  run_well(
      folder,
      words("sweep hill.asc bare -q --eye-path path.geojson --look-azimuth 0 --pitch 20 --fov 80") +
          kSmall);
  std::size_t drawings = 0;
  for (const auto& [name, bytes] : contents(folder, "on")) {
    if (!name.ends_with(".svg")) continue;
    ++drawings;
    CHECK(bytes.find(" solids\" fill=") != std::string::npos);
    CHECK(folder.read("bare/" + name) != bytes);
  }
  CHECK(drawings == 2);
}

TEST_CASE("a sweep isn't resumed with another scene, only with the same one from elsewhere") {
  const MadeFolder folder;
  make_inputs(folder);
  const Words rest = words("-q --no-seconds --azimuth 0,40") + kSmall;
  run_well(folder, words("sweep hill.asc out --scene huts.toml") + rest);
  const auto drawn = contents(folder, "out");
  std::filesystem::create_directory(folder.path("elsewhere"));
  folder.write("elsewhere/huts.toml", "# moved\n" + folder.read("huts.toml"));
  run_well(folder, words("sweep hill.asc out --resume --scene elsewhere/huts.toml") + rest);
  CHECK(differences(drawn, contents(folder, "out")) == "");

  folder.write("huts.toml", scene_text("part = 'box'\nat = [121, 120]"));
  folder.write("other.toml", folder.read("elsewhere/huts.toml"));
  const auto check_refused = [&](const std::string& with, const std::string& told) {
    const ProgramRun ended = run(folder, words("sweep hill.asc out --resume " + with) + rest);
    INFO(with << ": " << ended.err);
    CHECK(ended.exit_code == 1);
    CHECK(fault_of_message(ended.err) == "");
    CHECK(ended.err.find(told) != std::string::npos);
    CHECK(differences(drawn, contents(folder, "out")) == "");
  };
  check_refused(
      "--scene huts.toml",
      "out holds a sweep with the scene huts.toml, not with the scene huts.toml as it is");
  check_refused("--scene other.toml", "not with the scene other.toml");
  check_refused("", "out holds a sweep with the scene huts.toml, not without a scene");
  check_refused("--scene elsewhere/huts.toml --hidden dash", "no --hidden");
}

TEST_CASE("all that a scene holds shows in its fingerprint, but not what its parts are called") {
  const MadeFolder folder;
  make_inputs(folder);
  const SceneFile scene = read_scene(folder.path("huts.toml"));
  std::set<std::string> prints{fingerprint(scene)};
  CHECK(prints.begin()->size() == 16);
  SceneFile same = scene;
  same.path = "elsewhere";
  for (ScenePlace& place : same.places) place.part = "another", ++place.line;
  CHECK(fingerprint(same) == *prints.begin());
  std::size_t changed = 1;
  const auto add = [&](const auto& change) {
    SceneFile other = scene;
    change(other);
    prints.insert(fingerprint(other));
    CHECK(prints.size() == ++changed);
  };
  const auto next = [](double& number) {
    number = std::nextafter(number, std::numeric_limits<double>::infinity());
  };
  for (std::size_t solid = 0; solid < scene.solids.size(); ++solid)
    for (std::size_t vertex = 0; vertex < scene.solids[solid].vertices_m.size(); ++vertex)
      for (double Vec3::*coordinate : {&Vec3::x, &Vec3::y, &Vec3::z})
        add([&](SceneFile& s) { next(s.solids[solid].vertices_m[vertex].*coordinate); });
  for (std::size_t place = 0; place < scene.places.size(); ++place) {
    add([&](SceneFile& s) { next(s.places[place].x); });
    add([&](SceneFile& s) { next(s.places[place].y); });
    add([&](SceneFile& s) { s.places[place].lonlat = true; });
    add([&](SceneFile& s) { s.places[place].height = 0; });
  }
  for (std::size_t i = 0; i < scene.instances.size(); ++i) {
    add([&](SceneFile& s) { next(s.instances[i].to_place.origin.x); });
    add([&](SceneFile& s) { s.instances[i].to_place.z.z = -1; });
  }
  add([](SceneFile& s) { s.solids[0].triangles.pop_back(); });
  add([](SceneFile& s) { s.solids[0].edges[0].smooth = !s.solids[0].edges[0].smooth; });
  add([](SceneFile& s) { s.instances.pop_back(); });
}
