// SPDX-License-Identifier: GPL-3.0-or-later
// Contours that the pass through the lattice finds itself, against the same pass with a list of all
// their pieces: the same segments, of the same heights; and the same strokes, however the view is
// parted.
#include "map/draw_map.hpp"
#include "placing/placed_view.hpp"
#include "tests/catch.hpp"
#include "tests/scenes/random_scene.hpp"
#include "tests/scenes/same_drawing.hpp"
#include "tests/scenes/vary_view.hpp"
#include "tests/support/grid_of.hpp"
#include "tests/support/random.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <string>
#include <tuple>
#include <variant>
#include <vector>

namespace orograph::found_contours_test {
namespace {

constexpr std::uint64_t kScenes = last_seed(160);

// Whoever watches is shown a list of all lines.
class Watcher : public LineObserver {
public:
  void see(const SeenProfile&) override {}
  void see(const SeenLines&) override {}
};

RandomScene with_contours(std::uint64_t seed, Random& random) {
  RandomScene scene = random_scene(seed, 60);
  Style& style = scene.spec.style;
  style.layers = {"contours", "index-contours"};
  if (random.chance(0.5)) style.layers.push_back("silhouettes"); // tied with them
  style.contours.index_every = random.whole(0, 3);
  style.contours.ticks = random.chance(0.2);
  style.min_stroke_mm = 0;
  if (random.chance(0.4)) { // many of them through vertices and along edges
    const auto heights = std::get<Heights<float>>(grid_of(scene.terrain).heights_m).own();
    const float step = random.chance(0.5) ? 1 : 20;
    for (float& h : heights) h = std::isnan(h) ? h : step * std::round(h / step);
    style.contours.interval = step;
    const auto [low, high] = std::minmax_element(heights.begin(), heights.end());
    while ((*high - *low) / *style.contours.interval > 60) *style.contours.interval *= 2;
  }
  vary_view(seed, scene.terrain, scene.spec, random);
  return scene;
}

Drawing drawn(const RandomScene& scene, const PlacedView& placed, double vertices_a_strip,
              bool listed) {
  Watcher watcher;
  Instruments instruments{.order_always = true, .vertices_a_strip = vertices_a_strip};
  if (listed) instruments.observers = {&watcher};
  return draw_map(
             scene.terrain, placed, scene.spec, [](double) {}, instruments)
      .drawing;
}

// Layer, feature, and the ends in order.
using Piece = std::tuple<std::string, std::string, double, double, double, double>;

std::vector<Piece> pieces_of(const Drawing& drawing) {
  std::vector<Piece> out;
  for (const Layer& layer : drawing.layers)
    for (const Stroke& stroke : layer.strokes) {
      std::string feature;
      if (stroke.feature >= 0)
        for (const auto& [name, value] : layer.features[static_cast<std::size_t>(stroke.feature)])
          feature += name + std::visit(
                                [](const auto& v) {
                                  if constexpr (std::is_arithmetic_v<std::decay_t<decltype(v)>>)
                                    return std::to_string(v);
                                  else
                                    return std::string{};
                                },
                                value);
      for (std::uint32_t i = 1; i < stroke.point_count; ++i) {
        const Vec2 a = layer.page_mm[stroke.first_point + i - 1],
                   b = layer.page_mm[stroke.first_point + i];
        const auto [from, to] = std::minmax({std::tuple(a.x, a.y), std::tuple(b.x, b.y)});
        out.emplace_back(layer.name, feature, std::get<0>(from), std::get<1>(from), std::get<0>(to),
                         std::get<1>(to));
      }
    }
  std::sort(out.begin(), out.end());
  return out;
}

} // namespace

TEST_CASE("contours found on the way are those of a list, whatever the strips") {
  // Seen edge-on, or straight down, a piece that is tied with what hides it may be seen or not.
  std::size_t slivers = 0;
  std::size_t pieces = 0, one_sector = 0, refused = 0;
  for (std::uint64_t seed = 1; seed <= kScenes; ++seed) {
    Random random(seed);
    RandomScene scene = with_contours(seed, random);
    INFO("seed " << seed << ": " << scene.what);
    const std::optional<PlacedView> placed = placed_if_any(scene.terrain, scene.spec);
    if (!placed) {
      ++refused;
      continue;
    }
    one_sector += placed->sectors.size() == 1 ? 1 : 0;
    bool same =
        difference(drawn(scene, *placed, 600, false), drawn(scene, *placed, 5, false)).empty();
    scene.spec.style.simplify_mm = 0; // which depends on where a stroke begins
    const std::vector<Piece> listed = pieces_of(drawn(scene, *placed, 600, true));
    for (const double vertices_a_strip : {600.0, 5.0}) {
      const std::vector<Piece> found = pieces_of(drawn(scene, *placed, vertices_a_strip, false));
      std::vector<Piece> other;
      std::ranges::set_symmetric_difference(found, listed, std::back_inserter(other));
      CHECK(other.size() <= 2);
      same = same && other.empty();
    }
    slivers += same ? 0 : 1;
    pieces += listed.size();
  }
  WARN(pieces << " pieces, " << one_sector << " of one sector, " << refused << " refused, "
              << slivers << " differ by a sliver");
  CHECK(slivers <= kScenes / 100);
  CHECK(one_sector > kScenes / 3);
  CHECK(refused < kScenes / 4);
  CHECK(pieces > 500 * kScenes);
}

} // namespace orograph::found_contours_test
