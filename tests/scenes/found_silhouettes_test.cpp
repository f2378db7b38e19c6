// SPDX-License-Identifier: GPL-3.0-or-later
// Silhouettes that the pass through the lattice finds itself, and the folds that it leaves out on
// the way, against the same pass with a list of all silhouettes and folds judged behind it: the
// same drawing.
#include "hidden_lines/lines_of_view.hpp"
#include "map/draw_map.hpp"
#include "placing/placed_view.hpp"
#include "placing/terrain_of_view.hpp"
#include "tests/catch.hpp"
#include "tests/scenes/random_earth_scene.hpp"
#include "tests/scenes/random_scene.hpp"
#include "tests/scenes/same_drawing.hpp"
#include "tests/scenes/vary_view.hpp"
#include "tests/support/random.hpp"

#include <cmath>
#include <optional>

namespace orograph::found_silhouettes_test {
namespace {

using Layers = std::vector<LayerSpec>;

const std::uint64_t kScenes = last_seed(400);

// Whoever watches is shown a list of all lines.
class Watcher : public LineObserver {
public:
  void see(const SeenProfile&) override {}
  void see(const SeenLines&) override {}
};

Map drawn(const RandomScene& scene, const PlacedView& placed, double vertices_a_strip,
          bool listed) {
  Watcher watcher;
  Instruments instruments{.order_always = true, .vertices_a_strip = vertices_a_strip};
  if (listed) instruments.observers = {&watcher};
  return draw_map(
      scene.terrain, placed, scene.spec, [](double) {}, instruments);
}

struct Tally {
  std::size_t strokes = 0;
  double folded_mm = 0;
  std::uint64_t refused = 0, two_sectors = 0, slivers = 0, found = 0;
};

void vary_style(Style& style, Random& random) {
  style.join_mm = 0; // each of the lines for itself
  style.min_stroke_mm = 0;
  style.silhouette_jump = random.pick({0.0, 0.003, 0.02, 0.3});
  style.layers = random.pick({Layers{"profiles", "silhouettes", "skyline", "border", "shores"},
                              Layers{"silhouettes", "edges"}, Layers{"profiles", "skyline"},
                              Layers{"profiles", "shores", "voids"}});
}

void compare(const RandomScene& scene, Tally& tally) {
  std::optional<PlacedView> placed = placed_if_any(scene.terrain, scene.spec);
  if (!placed) {
    ++tally.refused;
    return;
  }
  tally.two_sectors += placed->sectors.size() > 1 ? 1 : 0;
  tally.found +=
      lines_of_view(scene.terrain, *placed, scene.spec.style, {.order_always = true}, nullptr)
          .silhouettes.has_value();
  for (const double vertices_a_strip : {600.0, 5.0}) {
    INFO(vertices_a_strip << " vertices a strip");
    const Map found = drawn(scene, *placed, vertices_a_strip, false),
              listed = drawn(scene, *placed, vertices_a_strip, true);
    const double mm = found.facts.left_out.silhouette_jump_mm,
                 listed_mm = listed.facts.left_out.silhouette_jump_mm;
    const bool same = difference(found.drawing, listed.drawing).empty() &&
                      std::abs(mm - listed_mm) <= 1e-9 * (1 + listed_mm);
    // Seen edge-on, what hides a sliver of a level ridge may be the ridge itself, to rounding.
    constexpr double kSliver_mm = 0.01;
    if (!same && std::abs(mm - listed_mm) < kSliver_mm)
      ++tally.slivers;
    else
      CHECK(same);
    tally.strokes += found.facts.counts.strokes;
    tally.folded_mm += mm;
  }
}

void report(const Tally& tally) {
  WARN(tally.strokes << " strokes, " << tally.folded_mm << " mm of folds; " << tally.two_sectors
                     << " of two sectors, " << tally.found << " in order, " << tally.refused
                     << " refused, " << tally.slivers << " differ by a sliver");
}

} // namespace

TEST_CASE("silhouettes found on the way are drawn as those of a list") {
  Tally tally;
  for (std::uint64_t seed = 1; seed <= kScenes; ++seed) {
    RandomScene scene = random_scene(seed);
    Random random(seed);
    vary_style(scene.spec.style, random);
    vary_view(seed, scene.terrain, scene.spec, random);
    INFO("seed " << seed << ": " << scene.what << ", jump " << scene.spec.style.silhouette_jump);
    compare(scene, tally);
  }
  report(tally);
  CHECK(tally.slivers <= kScenes / 500);
  CHECK(tally.refused < kScenes / 4);
  CHECK(tally.two_sectors > kScenes / 20);
  CHECK(tally.strokes > 30 * kScenes);
  CHECK(tally.folded_mm > 10.0 * static_cast<double>(kScenes));
}

TEST_CASE("so they are in degrees, where strips of cells have an order") {
  const std::uint64_t kOnEarth = last_seed(160);
  Tally tally;
  for (std::uint64_t seed = 1; seed <= kOnEarth; ++seed) {
    RandomScene scene = random_earth_scene(seed, seed % 2 == 0   ? Stand::frames_terrain
                                                 : seed % 4 == 1 ? Stand::on_ground
                                                                 : Stand::in_air);
    Random random(seed);
    vary_style(scene.spec.style, random);
    INFO("seed " << seed << ": " << scene.what << ", jump " << scene.spec.style.silhouette_jump);
    stand_on_earth(scene.terrain, scene.spec.view);
    compare(scene, tally);
  }
  report(tally);
  CHECK(tally.slivers <= kOnEarth / 100);
  CHECK(tally.found > kOnEarth / 2);
  CHECK(tally.strokes > 20 * kOnEarth);
}

} // namespace orograph::found_silhouettes_test
