// SPDX-License-Identifier: GPL-3.0-or-later
// Passes in strips of X, with the horizon in blocks, against the same with one horizon in one
// list: the same drawing to the bit, however many strips there are. Only where plateaus are
// seen exactly edge-on, so that several occluders are equally high at one place, another of them
// may be kept, and the line there be drawn as another or as a part of another.
#include "map/draw_map.hpp"
#include "placing/placed_view.hpp"
#include "tests/catch.hpp"
#include "tests/scenes/random_scene.hpp"
#include "tests/scenes/random_tin_scene.hpp"
#include "tests/scenes/same_drawing.hpp"
#include "tests/support/random.hpp"

namespace orograph::strips_test {
namespace {

constexpr std::uint64_t kScenes = last_seed(400);

struct Tally {
  std::size_t strips = 0, points = 0;
  std::size_t edge_on = 0, others = 0; ///< scenes that differ: all, and not from elevation 0
};

void check_strips(const TerrainData& terrain, const MapSpec& spec, Tally& tally) {
  const PlacedView scene = placed_view(terrain, spec);
  const auto draw = [&](const Instruments& instruments) {
    return draw_map(
               terrain, scene, spec, [](double) {}, instruments)
        .drawing;
  };
  const Drawing in_list = draw({.one_list = true});
  bool same = true;
  for (const double vertices_a_strip : {1e9, 30.0, 2.0})
    same = same && difference(draw({.beyond_page = true, .vertices_a_strip = vertices_a_strip}),
                              in_list) == "";
  if (!same) tally.others += scene.view.elevation.in_degrees() == 0 ? 0 : 1;
  tally.edge_on += same ? 0 : 1;
  for (const Sector& sector : scene.sectors)
    tally.strips += plan_strips(scene, sector, page_range(sector), 2).size();
  for (const Layer& layer : in_list.layers) tally.points += layer.page_mm.size();
}

template <class SceneOf>
void check_scenes(const SceneOf& scene_of) {
  Tally tally;
  for (std::uint64_t seed = 1; seed <= kScenes; ++seed) {
    const auto scene = scene_of(seed);
    INFO(scene.what);
    check_strips(scene.terrain, scene.spec, tally);
  }
  WARN(tally.strips << " strips, " << tally.points << " points; " << tally.edge_on
                    << " scenes differ, " << tally.others << " not from elevation 0");
  CHECK(tally.edge_on <= kScenes / 50);
  CHECK(tally.others == 0);
  CHECK(tally.strips > 7 * kScenes);
}

} // namespace

TEST_CASE("strips leave no trace in drawings of grids", "[slow]") {
  check_scenes([](std::uint64_t seed) {
    RandomScene scene = random_scene(seed);
    scene.spec.style.simplify_mm = seed % 2 ? 0.02 : 0;
    scene.spec.style.layers = {"profiles", "silhouettes", "skyline", "border", "shores", "edges"};
    return scene;
  });
}

TEST_CASE("nor in those of TINs with walls") {
  check_scenes([](std::uint64_t seed) { return random_tin_scene(seed); });
}

} // namespace orograph::strips_test
