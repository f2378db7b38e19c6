// SPDX-License-Identifier: GPL-3.0-or-later
// Contours that the pass through the lattice finds itself, against the same pass with a list of all
// their pieces: the same segments, of the same heights; and the same strokes, however the view is
// parted.
#include "hidden_lines/lines_of_view.hpp"
#include "map/draw_map.hpp"
#include "placing/placed_view.hpp"
#include "placing/terrain_of_view.hpp"
#include "tests/catch.hpp"
#include "tests/scenes/random_earth_scene.hpp"
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

const std::uint64_t kScenes = last_seed(160);

// Whoever watches is shown a list of all lines.
class Watcher : public LineObserver {
public:
  void see(const SeenProfile&) override {}
  void see(const SeenLines&) override {}
};

void put_contours(RandomScene& scene, Random& random) {
  Style& style = scene.spec.style;
  style.layers = {"contours", "index-contours"};
  if (random.chance(0.5)) style.layers.push_back("silhouettes"); // tied with them
  style.contours.index_every = random.whole(0, 3);
  style.contours.ticks = random.chance(0.2);
  style.min_stroke_mm = 0;
  if (random.chance(0.4)) { // many of them through vertices and along edges
    const auto heights = std::get<Heights<float>>(grid_of(scene.terrain).heights_m).own();
    const float step = random.chance(0.5) ? 1 : 20;
    float low = HUGE_VALF, high = -low; // fmin and fmax leave out a NaN
    for (float& h : heights) {
      h = std::isnan(h) ? h : step * std::round(h / step);
      low = std::fmin(low, h);
      high = std::fmax(high, h);
    }
    style.contours.interval = step;
    while ((high - low) / *style.contours.interval > 60) *style.contours.interval *= 2;
  }
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

struct Tally {
  // Seen edge-on, or straight down, a piece that is tied with what hides it may be seen or not.
  std::size_t slivers = 0;
  std::size_t pieces = 0, one_sector = 0, refused = 0, found = 0;
};

void compare(RandomScene& scene, Tally& tally) {
  const std::optional<PlacedView> placed = placed_if_any(scene.terrain, scene.spec);
  if (!placed) {
    ++tally.refused;
    return;
  }
  tally.one_sector += placed->sectors.size() == 1 ? 1 : 0;
  tally.found +=
      lines_of_view(scene.terrain, *placed, scene.spec.style, {.order_always = true}, nullptr)
              .on_ground.levels_to_find_m.empty()
          ? 0
          : 1;
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
  tally.slivers += same ? 0 : 1;
  tally.pieces += listed.size();
}

void report(const Tally& tally) {
  WARN(tally.pieces << " pieces, " << tally.one_sector << " of one sector, " << tally.found
                    << " found on the way, " << tally.refused << " refused, " << tally.slivers
                    << " differ by a sliver");
}

} // namespace

TEST_CASE("contours found on the way are those of a list, whatever the strips") {
  Tally tally;
  for (std::uint64_t seed = 1; seed <= kScenes; ++seed) {
    Random random(seed);
    RandomScene scene = random_scene(seed, 60);
    put_contours(scene, random);
    vary_view(seed, scene.terrain, scene.spec, random);
    INFO("seed " << seed << ": " << scene.what);
    compare(scene, tally);
  }
  report(tally);
  CHECK(tally.slivers <= 1 + kScenes / 100);
  CHECK(tally.one_sector > kScenes / 3);
  CHECK(tally.refused < kScenes / 4);
  CHECK(tally.pieces > 500 * kScenes);
}

TEST_CASE("so are those in degrees, where strips of cells have an order") {
  const std::uint64_t kOnEarth = last_seed(80);
  Tally tally;
  for (std::uint64_t seed = 1; seed <= kOnEarth; ++seed) {
    Random random(seed);
    RandomScene scene = random_earth_scene(seed, seed % 2 == 0   ? Stand::frames_terrain
                                                 : seed % 4 == 1 ? Stand::on_ground
                                                                 : Stand::in_air);
    put_contours(scene, random);
    INFO("seed " << seed << ": " << scene.what);
    stand_on_earth(scene.terrain, scene.spec.view);
    compare(scene, tally);
  }
  report(tally);
  CHECK(tally.slivers <= kOnEarth / 40);
  CHECK(tally.found > kOnEarth / 3);
  CHECK(tally.pieces > 100 * kOnEarth);
}

} // namespace orograph::found_contours_test
