// SPDX-License-Identifier: GPL-3.0-or-later
// Lines on the water: seen where the ray walk says so, and nothing else is drawn otherwise for
// them.
#include "dem/approximate/tin_of_grid.hpp"
#include "geometry/error.hpp"
#include "hidden_lines/instruments.hpp"
#include "map/check.hpp"
#include "map/draw_map.hpp"
#include "placing/placed_view.hpp"
#include "placing/terrain_facts.hpp"
#include "reference/judge.hpp"
#include "tests/catch.hpp"
#include "tests/scenes/asked_scenes.hpp"
#include "tests/scenes/random_overlay.hpp"
#include "tests/scenes/random_scene.hpp"
#include "tests/scenes/same_drawing.hpp"
#include "tests/scenes/vary_view.hpp"
#include "tests/support/grid_of.hpp"
#include "tests/support/random.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <span>

namespace orograph::ground_lines_test {
namespace {

const std::uint64_t kScenes = last_seed(120);

// A random scene, of which half the ground is under water.
RandomScene flooded(std::uint64_t seed, Random& random) {
  RandomScene scene = random_scene(seed, 60);
  const auto heights = std::get<Heights<float>>(grid_of(scene.terrain).heights_m).own();
  std::vector<float> sorted;
  for (const float h : heights)
    if (!std::isnan(h)) sorted.push_back(h);
  std::sort(sorted.begin(), sorted.end());
  const auto share =
      static_cast<std::size_t>(random.between(0.3, 0.7) * static_cast<double>(sorted.size()));
  const float sea = sorted[std::min(share, sorted.size() - 1)];
  for (float& h : heights) h = std::isnan(h) ? h : std::max(h, sea);
  scene.spec.style.flat = FlatGround::waterlines;
  scene.spec.style.join_mm = scene.spec.style.min_stroke_mm.emplace(0);
  scene.spec.style.shore_smooth_mm = 0;
  vary_view(seed, scene.terrain, scene.spec, random);
  return scene;
}

// Contours, and a mesh along the lattice, aslant to it, or along the view.
RandomScene with_lines(std::uint64_t seed, Random& random) {
  RandomScene scene = random_scene(seed, 40);
  Style& style = scene.spec.style;
  style.layers.insert(style.layers.end(), {"contours", "mesh", "drape"});
  if (random.chance(0.3)) style.overlay_above_m = random.between(0, 20);
  style.join_mm = scene.spec.style.min_stroke_mm.emplace(0);
  style.contours.index_every = random.whole(0, 3);
  style.contours.ticks = seed % 2 == 1;
  if (random.chance(0.3)) { // many of them through vertices
    const auto heights = std::get<Heights<float>>(grid_of(scene.terrain).heights_m).own();
    const float step = random.chance(0.5) ? 1 : 20;
    for (float& h : heights) h = std::isnan(h) ? h : step * std::round(h / step);
    style.contours.interval = step;
    const auto [low, high] = std::minmax_element(heights.begin(), heights.end());
    while ((*high - *low) / *style.contours.interval > 60) *style.contours.interval *= 2;
  }
  style.mesh.along_view = random.chance(0.4);
  style.mesh.count = random.whole(1, 25);
  if (random.chance(0.3)) // along the lattice's lines
    style.mesh.spacing_m = length(grid_of(scene.terrain).plane().column_step_m);
  vary_view(seed, scene.terrain, scene.spec, random);
  return scene;
}

// The lines on the ground alone: with others, few of the points asked would be on them.
class GroundCheck : public LineObserver {
public:
  GroundCheck(const TerrainData& terrain, const PlacedView& placed, Random& random)
      : judges_(judges_of(terrain.surface, placed, 1e-4)), random_(random) {}

  void see(const SeenProfile&) override {}
  void see(const SeenLines& seen) override {
    const Judge& judge = judges_[sector_++];
    const View& view = seen.sector.view;
    auto part = seen.visible.begin();
    for (std::uint32_t i = 0; i < seen.lines.size(); ++i) {
      const auto first =
          std::find_if(part, seen.visible.end(), [&](const LinePart& p) { return p.line >= i; });
      part = first;
      if (!is_on_ground(seen.lines.line(i).kind)) continue;
      const ProfileLine whole = seen.lines.whole(i);
      std::vector<double> places{random_.between(0, 1)};
      for (auto p = first; p != seen.visible.end() && p->line == i; ++p)
        for (const double end : {p->t_begin, p->t_end})
          for (const double aside : {-1e-3, 1e-3})
            if (end + aside > 1e-9 && end + aside < 1 - 1e-9) places.push_back(end + aside);
      for (const double t : places) {
        const ProfilePoint at = seen.lines.point(i, t);
        if (view.is_perspective() &&
            at.v <= std::max(view.near_m, view.drawn_from_m) + 4 * seen.lines.rounding_m())
          continue;
        const double x = project(view, at).x;
        if (!(x >= seen.clipped.begin && x <= seen.clipped.end)) continue;
        bool drawn = false;
        for (auto p = first; p != seen.visible.end() && p->line == i; ++p)
          drawn = drawn || (p->t_begin <= t && t <= p->t_end);
        ++counts.asked;
        const Verdict verdict = judge.verdict(whole, t, seen.lines.is_edge(i), drawn);
        if (verdict == Verdict::tied)
          ++counts.ties;
        else if ((verdict == Verdict::visible) != drawn)
          ++(drawn ? counts.hidden : counts.missing);
        visible += drawn ? 1 : 0;
      }
    }
  }

  CheckCounts counts;
  std::uint64_t visible = 0;

private:
  std::vector<Judge> judges_;
  std::size_t sector_ = 0;
  Random& random_;
};

} // namespace

namespace {

// Draws a scene and asks the ray walk about all of its lines on the ground; those of even seeds on
// the grid as a TIN. Tells how many sectors the view has.
template <class MakeScene>
std::size_t ask_scene(std::uint64_t seed, const MakeScene& make, Asked& sum, std::uint64_t& visible,
                      Overlay (*overlay_of)(const TerrainData&, Random&) = random_overlay) {
  Random random(seed);
  RandomScene scene = make(seed, random);
  if (seed % 2 == 0) {
    const Grid grid = grid_of(scene.terrain);
    scene.terrain.surface = tin_of(grid);
  }
  INFO("seed " << seed << ": " << scene.what);
  PlacedView placed = placed_view(scene.terrain, scene.spec);
  const Overlay overlay = overlay_of(scene.terrain, random);
  placed.overlays = std::span(&overlay, 1);
  GroundCheck check(scene.terrain, placed, random);
  Instruments instruments{.hidden_ground = true, .order_always = seed % 4 == 1};
  instruments.observers = {&check};
  draw_map(
      scene.terrain, placed, scene.spec, [](double) {}, instruments);
  CHECK(check.counts.hidden == 0);
  CHECK(check.counts.missing == 0);
  sum.add(check.counts);
  visible += check.visible;
  return placed.sectors.size();
}

template <class MakeScene>
void ask_ray_walk(const char* what, std::uint64_t scenes, const MakeScene& make) {
  Asked sum;
  std::uint64_t refused = 0, two_sectors = 0, visible = 0;
  for (std::uint64_t seed = 1; seed <= scenes; ++seed) {
    try {
      two_sectors += ask_scene(seed, make, sum, visible) > 1 ? 1 : 0;
    } catch (const Error&) { // an eye under the ground, or a view of nothing
      ++refused;
    }
  }
  report(what, sum);
  WARN(visible << " visible, " << two_sectors << " of two sectors, " << refused << " refused");
  CHECK(sum.asked > 100 * scenes);
  CHECK(visible > 20 * scenes);
  CHECK(two_sectors > scenes / 20);
  CHECK(refused < scenes / 4);
}

} // namespace

TEST_CASE("the ray walk sees the lines on the water that are drawn, and no others", "[slow]") {
  ask_ray_walk("lines on water", kScenes, flooded);
}

TEST_CASE("the ray walk sees the contours and meshes that are drawn, and no others",
          "[slow][unsanitized]") {
  ask_ray_walk("contours and meshes", kScenes, with_lines);
}

// One of a mesh along the view's rays is 3e-9 m wide on 15 m, and ends at the border, which hides
// what is at its place: 0.23 % of it were missing where the last slab is 35 mm deep.
TEST_CASE("a line nearly straight away from the eye that ends at the border is seen up to it") {
  Asked sum;
  std::uint64_t visible = 0;
  ask_scene(50955, with_lines, sum, visible);
  CHECK(visible > 49000);
}

// A mesh along the view over a plateau: 2 of its 2,356 points were "visible but not drawn".
TEST_CASE("a line on level ground that a level view looks along has no picture") {
  Asked sum;
  std::uint64_t visible = 0;
  ask_scene(930810, with_lines, sum, visible);
  CHECK(sum.asked > 2000);
}

// Marks have arms along the map's axes, so from its four sides one arm runs straight away from the
// eye. Behind a ridge it falls as the ground does, which hides it there unless it is lifted.
TEST_CASE("what is lifted above the ground isn't hidden by its own nearer end") {
  const auto lifted = [](std::uint64_t seed, Random& random) {
    RandomScene scene = with_lines(seed, random);
    scene.spec.style.layers = {"drape"};
    const Box2 box = map_bounds(scene.terrain);
    scene.spec.style.overlay_above_m = random.between(0.001, 0.02) * box.width();
    scene.spec.view.from_azimuth = Angle::degrees(90.0 * random.whole(0, 3));
    return scene;
  };
  const auto marks = [](const TerrainData& terrain, Random& random) {
    const Box2 box = map_bounds(terrain);
    Overlay out;
    for (int i = 0; i < 60; ++i) {
      out.places.push_back(
          {random.between(box.low.x, box.high.x), random.between(box.low.y, box.high.y)});
      out.features.push_back({{}, out.lines.size(), 1});
      out.lines.push_back({out.places.size() - 1, 1});
    }
    return out;
  };
  Asked sum;
  std::uint64_t visible = 0;
  for (std::uint64_t seed = 1; seed <= kScenes / 3; ++seed) {
    try {
      ask_scene(seed, lifted, sum, visible, marks);
    } catch (const Error&) { // an eye under the ground, or a view of nothing
    }
  }
  report("lifted marks", sum);
  CHECK(visible > 40 * kScenes);
}

TEST_CASE("every other layer is the same with lines on the water and without") {
  for (std::uint64_t seed = 1; seed <= kScenes / 3; ++seed) {
    Random random(seed);
    RandomScene scene = flooded(seed, random);
    const Grid grid = grid_of(scene.terrain);
    if (seed % 2 == 0) scene.terrain.surface = tin_of(grid);
    INFO("seed " << seed << ": " << scene.what);
    std::optional<PlacedView> placed = placed_if_any(scene.terrain, scene.spec);
    if (!placed) continue;
    Map with = draw_map(scene.terrain, *placed, scene.spec, [](double) {});
    scene.spec.style.flat = FlatGround::shore;
    const PlacedView plain = placed_view(scene.terrain, scene.spec);
    const Map without = draw_map(scene.terrain, plain, scene.spec, [](double) {});
    std::erase_if(with.drawing.layers,
                  [](const Layer& layer) { return layer.name == "waterlines"; });
    CHECK(difference(with.drawing, without.drawing).empty());
  }
}

// Three overlays, each in a pass of its own or all in one.
TEST_CASE("overlays that several passes take are drawn as one pass draws them") {
  std::uint64_t draped = 0, two_sectors = 0;
  for (std::uint64_t seed = 1; seed <= kScenes / 3; ++seed) {
    Random random(seed);
    RandomScene scene = with_lines(seed, random);
    const Grid grid = grid_of(scene.terrain);
    if (seed % 4 == 0) scene.terrain.surface = tin_of(grid);
    if (seed % 3 == 0) scene.spec.style.layers.push_back("hidden-drape");
    INFO("seed " << seed << ": " << scene.what);
    std::optional<PlacedView> placed = placed_if_any(scene.terrain, scene.spec);
    if (!placed) continue;
    std::vector<Overlay> overlays;
    for (int i = 0; i < 3; ++i) overlays.push_back(random_overlay(scene.terrain, random));
    placed->overlays = overlays;
    const auto drawn = [&](std::size_t most_draped) {
      return draw_map(scene.terrain, *placed, scene.spec, [](double) {},
                      {.order_always = seed % 2 == 0, .most_draped = most_draped});
    };
    const Map one = drawn(std::numeric_limits<std::size_t>::max()), several = drawn(1);
    CHECK(difference(one.drawing, several.drawing).empty());
    CHECK(one.facts.counts.draped == several.facts.counts.draped);
    CHECK(one.facts.counts.not_draped == several.facts.counts.not_draped);
    CHECK(one.facts.left_out.min_stroke_mm == Approx(several.facts.left_out.min_stroke_mm));
    draped += one.facts.counts.draped;
    two_sectors += placed->sectors.size() > 1 ? 1 : 0;
  }
  CHECK(draped > 2 * kScenes / 3);
  CHECK(two_sectors > 0);
}

} // namespace orograph::ground_lines_test
