// SPDX-License-Identifier: GPL-3.0-or-later
// Passes in strips of X, with the horizon in blocks, in slabs and in the lattice's order, against
// the pass in slabs with one horizon in one list: the same is visible, however many strips there
// are, but for declared ties.
#include "hidden_lines/strips.hpp"
#include "map/draw_map.hpp"
#include "placing/placed_view.hpp"
#include "placing/terrain_of_view.hpp"
#include "tests/catch.hpp"
#include "tests/scenes/random_earth_scene.hpp"
#include "tests/scenes/random_scene.hpp"
#include "tests/scenes/random_tin_scene.hpp"
#include "tests/scenes/visible_parts.hpp"
#include "tests/support/random.hpp"

namespace orograph::strips_test {
namespace {

const std::uint64_t kScenes = last_seed(200);

struct Tally {
  std::size_t strips = 0, lines = 0;
  std::size_t tied = 0, wrong = 0; ///< stretches that only one of two passes shows
};

void check_strips(const TerrainData& terrain, const MapSpec& spec, Tally& tally) {
  const PlacedView scene = placed_view(terrain, spec);
  const std::vector<Judge> judges =
      judges_of(terrain.surface, scene, spec.style.visibility_tolerance_mm);
  const auto seen = [&](Instruments instruments) {
    VisibleParts parts(scene);
    instruments.observers = {&parts};
    draw_map(
        terrain, scene, spec, [](double) {}, instruments);
    return parts;
  };
  const VisibleParts in_list = seen({.one_list = true});
  for (const double vertices_a_strip : {1e9, 30.0, 2.0})
    for (const bool in_order : {true, false}) {
      const VisibleParts in_strips = seen(
          {.beyond_page = true, .order_always = in_order, .vertices_a_strip = vertices_a_strip});
      const VisibleDifference found = difference(in_strips, in_list, scene, judges);
      INFO(vertices_a_strip << " vertices a strip, " << (in_order ? "in order: " : "in slabs: ")
                            << found.first_wrong);
      CHECK(found.wrong() == 0);
      tally.tied += found.tied;
      tally.wrong += found.wrong();
    }
  for (const Sector& sector : scene.sectors)
    tally.strips += plan_strips(scene, sector, page_range(sector), 2).size();
  tally.lines += in_list.lines.size();
}

template <class SceneOf>
void check_scenes(std::uint64_t scenes, const SceneOf& scene_of) {
  Tally tally;
  for (std::uint64_t seed = 1; seed <= scenes; ++seed) {
    const auto scene = scene_of(seed);
    INFO(scene.what);
    check_strips(scene.terrain, scene.spec, tally);
  }
  WARN(tally.strips << " strips, " << tally.lines << " lines; " << tally.tied
                    << " stretches differ and are tied, " << tally.wrong << " are wrong");
  CHECK(tally.tied <= tally.lines / 1000);
  CHECK(tally.strips > 6 * scenes);
}

} // namespace

TEST_CASE("strips leave no trace in drawings of grids", "[slow]") {
  check_scenes(kScenes, [](std::uint64_t seed) {
    RandomScene scene = random_scene(seed);
    scene.spec.style.simplify_mm = seed % 2 ? 0.02 : 0;
    scene.spec.style.layers = {"profiles", "silhouettes", "skyline", "border", "shores", "edges"};
    return scene;
  });
}

TEST_CASE("nor in those of TINs with walls") {
  check_scenes(kScenes, [](std::uint64_t seed) { return random_tin_scene(seed); });
}

TEST_CASE("nor in those of grids in degrees") {
  check_scenes(last_seed(60), [](std::uint64_t seed) {
    RandomScene scene = random_earth_scene(seed, Stand::frames_terrain);
    stand_on_earth(scene.terrain, scene.spec.view);
    scene.spec.style.layers = {"profiles", "silhouettes", "skyline", "border", "shores", "edges"};
    return scene;
  });
}

} // namespace orograph::strips_test
