// SPDX-License-Identifier: GPL-3.0-or-later
// Silhouettes that the pass through the lattice finds itself, and the folds that it leaves out on
// the way, against the same pass with a list of all silhouettes and folds judged behind it: the
// same drawing.
#include "map/draw_map.hpp"
#include "placing/placed_view.hpp"
#include "tests/catch.hpp"
#include "tests/scenes/random_scene.hpp"
#include "tests/scenes/same_drawing.hpp"
#include "tests/support/random.hpp"

namespace orograph::found_silhouettes_test {
namespace {

using Layers = std::vector<LayerSpec>;

constexpr std::uint64_t kScenes = last_seed(1000);

// Whoever watches is shown a list of all lines.
class Watcher : public LineObserver {
public:
  void see(const SeenProfile&) override {}
  void see(const SeenLines&) override {}
};

Map drawn(const RandomScene& scene, double vertices_a_strip, bool listed) {
  Watcher watcher;
  Instruments instruments{.order_always = true, .vertices_a_strip = vertices_a_strip};
  if (listed) instruments.observers = {&watcher};
  return draw_map(
      scene.terrain, placed_view(scene.terrain, scene.spec), scene.spec, [](double) {},
      instruments);
}

} // namespace

TEST_CASE("silhouettes found on the way are drawn as those of a list") {
  std::size_t strokes = 0;
  double folded_mm = 0;
  for (std::uint64_t seed = 1; seed <= kScenes; ++seed) {
    RandomScene scene = random_scene(seed);
    Random random(seed);
    scene.spec.style.silhouette_jump = random.pick({0.0, 0.003, 0.02, 0.3});
    scene.spec.style.layers =
        random.pick({Layers{"profiles", "silhouettes", "skyline", "border", "shores"},
                     Layers{"silhouettes", "edges"}, Layers{"profiles", "skyline"},
                     Layers{"profiles", "shores", "voids"}});
    INFO("seed " << seed << ": " << scene.what << ", jump " << scene.spec.style.silhouette_jump);
    for (const double vertices_a_strip : {600.0, 5.0}) {
      INFO(vertices_a_strip << " vertices a strip");
      const Map found = drawn(scene, vertices_a_strip, false),
                listed = drawn(scene, vertices_a_strip, true);
      CHECK(difference(found.drawing, listed.drawing) == "");
      const double mm = found.facts.left_out.silhouette_jump_mm,
                   listed_mm = listed.facts.left_out.silhouette_jump_mm;
      CHECK(std::abs(mm - listed_mm) <= 1e-9 * (1 + listed_mm));
      strokes += found.facts.counts.strokes;
      folded_mm += mm;
    }
  }
  WARN(strokes << " strokes, " << folded_mm << " mm of folds");
  CHECK(strokes > 50 * kScenes);
  CHECK(folded_mm > 10.0 * static_cast<double>(kScenes));
}

} // namespace orograph::found_silhouettes_test
