// SPDX-License-Identifier: GPL-3.0-or-later
// A gap hides nothing, and nothing is drawn over it: made scenes with voids, asked of the ray walk
// and of the ground.
#include "dem/height_at.hpp"
#include "profiles/outline.hpp"
#include "reference/ray_walk.hpp"
#include "tests/catch.hpp"
#include "tests/scenes/asked_scenes.hpp"
#include "tests/scenes/random_scene.hpp"
#include "tests/support/grid_of.hpp"
#include "tests/support/random.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>

namespace orograph::voids_test {
namespace {

const std::uint64_t kScenes = last_seed(300);
constexpr float kMissing = std::numeric_limits<float>::quiet_NaN();

struct VoidScene {
  RandomScene scene;
  std::vector<std::size_t> gap; ///< vertices, none at the grid's sides; still with heights
  float& height_m(std::size_t vertex) {
    return std::get<Heights<float>>(grid_of(scene.terrain).heights_m).own()[vertex];
  }
  void set_gap(float height) {
    for (const std::size_t vertex : gap) height_m(vertex) = height;
  }
};

// The gap is what a walk from somewhere in the middle comes by.
VoidScene void_scene(std::uint64_t seed) {
  VoidScene made{random_scene(seed), {}};
  Random random(seed + 300000);
  const Grid& grid = grid_of(made.scene.terrain);
  int column = random.whole(3, grid.columns - 4), row = random.whole(3, grid.rows - 4);
  for (int steps = random.whole(1, 60); steps > 0; --steps) {
    made.gap.push_back(grid.index(column, row));
    (random.chance(0.7) ? column : row) += random.pick({-1, 1});
    column = std::clamp(column, 2, grid.columns - 3);
    row = std::clamp(row, 2, grid.rows - 3);
  }
  made.scene.spec.style.layers.push_back("voids");
  return made;
}

Map draw(const TerrainData& terrain, const PlacedView& scene, MapSpec spec) {
  spec.style.simplify_mm = 0;
  spec.style.silhouette_jump = 0;
  spec.ground_points = true; // strokes then have their places on the ground
  return draw_map(terrain, scene, spec, [](double) {});
}

// Calls take(Vec3) with points of the straight pieces of a layer's strokes.
void for_points(const Layer& layer, Random& random, const std::function<void(Vec3)>& take) {
  for (const Stroke& stroke : layer.strokes)
    for (std::size_t i = 1; i < stroke.point_count; ++i) {
      const Vec3 a = layer.map[stroke.first_point + i - 1], b = layer.map[stroke.first_point + i];
      take(a + random.share() * (b - a));
    }
}

const Layer* layer_of(const Drawing& drawing, const std::string& name) {
  for (const Layer& layer : drawing.layers)
    if (layer.name == name) return &layer;
  return nullptr;
}

// A stretch ends where either of two lines that meet there crosses it, which is a few ulp apart.
bool holds(const Layer& layer, Vec3 at) {
  constexpr double kSame_m = 1e-8;
  return std::any_of(layer.map.begin(), layer.map.end(), [&](const Vec3& p) {
    return std::abs(p.x - at.x) <= kSame_m && std::abs(p.y - at.y) <= kSame_m &&
           std::abs(p.z - at.z) <= kSame_m;
  });
}

// Height of the ground at a point or, at the border, a hair beside it.
std::optional<double> ground_at(const Grid& grid, Vec2 at) {
  if (const auto height = height_at(grid, at)) return height;
  const double hair_m = 1e-6 * cell_size_m(grid);
  for (int i = 0; i < 16; ++i) {
    const double angle = 0.3927 * i;
    if (const auto height = height_at(grid, at + hair_m * Vec2{std::cos(angle), std::sin(angle)}))
      return height;
  }
  return std::nullopt;
}

bool is_hidden(const RayWalk& walk, const View& view, ProfilePoint p) {
  const InFront in_front = walk.in_front(p);
  return in_front.greatest_y > project(view, p).y + in_front.rounding;
}
bool is_tied(const RayWalk& walk, const View& view, ProfilePoint p) {
  const InFront in_front = walk.in_front(p);
  return std::abs(in_front.greatest_y - project(view, p).y) <= in_front.rounding + 1e-9;
}
// By no tie, and wherever rounding puts the place: aside what stands in front may end.
bool is_surely_hidden(const RayWalk& walk, const View& view, ProfilePoint p) {
  const double hair_m = 1e-12 * (std::abs(p.u) + std::abs(p.v));
  return std::ranges::all_of(std::array{-hair_m, 0.0, hair_m}, [&](double aside_m) {
    const ProfilePoint at{p.u + aside_m, p.v, p.z};
    const InFront in_front = walk.in_front(at);
    return in_front.greatest_y > project(view, at).y + in_front.rounding + 1e-9;
  });
}

} // namespace

TEST_CASE("around voids the ray walk agrees with every line, and every line is on the ground") {
  Asked sum;
  std::uint64_t points = 0, of_voids = 0, off_ground = 0, beside_height = 0;
  for (std::uint64_t seed = 1; seed <= kScenes; ++seed) {
    VoidScene made = void_scene(seed);
    made.set_gap(kMissing);
    const auto& [terrain, spec, what] = made.scene;
    CAPTURE(seed, what);
    sum.add(ask(terrain, spec, 1000));

    Random random(seed);
    const Map drawn = draw(terrain, placed_view(terrain, spec), spec);
    const Grid& grid = grid_of(terrain);
    for (const Layer& layer : drawn.drawing.layers)
      for_points(layer, random, [&](Vec3 p) {
        ++points;
        of_voids += layer.name == "voids";
        const auto height = ground_at(grid, {p.x, p.y});
        if (!height)
          ++off_ground;
        else
          beside_height += std::abs(*height - p.z) > 0.01;
      });
  }
  report("scenes with voids", sum);
  WARN(points << " points of strokes, " << of_voids << " of them around voids");
  CHECK(sum.ties < sum.asked / 20);
  CHECK(of_voids > 10 * kScenes);
  CHECK(off_ground == 0);
  CHECK(beside_height == 0);
}

TEST_CASE("what stood behind a ridge is seen through the gap that takes its place") {
  std::uint64_t through = 0, wrong = 0, kept = 0, newly_hidden = 0;
  for (std::uint64_t seed = 1; seed <= kScenes; ++seed) {
    VoidScene made = void_scene(seed);
    MapSpec& spec = made.scene.spec;
    const TerrainData& terrain = made.scene.terrain;
    spec.view.from_elevation = Angle::degrees(5);
    const SurfaceExtent extent = extent_of(terrain.surface);
    made.set_gap(static_cast<float>(extent.box.high.z + 20 * cell_size_m(grid_of(terrain))));
    CAPTURE(seed, made.scene.what);
    Random random(seed);
    const PlacedView with_ridge = placed_view(terrain, spec);
    const View& view = with_ridge.view;
    const Map ridge = draw(terrain, with_ridge, spec);
    const TerrainData ridge_terrain = terrain;
    const RayWalk over_ridge(ridge_terrain.surface, view);

    // The same view and plan; the border is the other surface's own.
    made.set_gap(kMissing);
    PlacedView with_gap = with_ridge;
    with_gap.border = border_edges(grid_of(terrain), false);
    with_gap.level = {};
    spec.style.flat = FlatGround::draw;
    const Map gap = draw(terrain, with_gap, spec);
    const RayWalk over_gap(terrain.surface, view);
    for_points(*layer_of(gap.drawing, "profiles"), random, [&](Vec3 at) {
      const ProfilePoint p = to_profile_frame(view, at);
      wrong += is_surely_hidden(over_gap, view, p);
      through += is_hidden(over_ridge, view, p);
    });
    // Less ground hides less.
    for_points(*layer_of(ridge.drawing, "profiles"), random, [&](Vec3 at) {
      if (!height_at(terrain.surface, {at.x, at.y})) return;
      const ProfilePoint p = to_profile_frame(view, at);
      ++kept;
      newly_hidden += is_surely_hidden(over_gap, view, p);
    });
  }
  WARN(through << " points of strokes seen through gaps, " << kept << " seen past ridges");
  CHECK(through > 20 * kScenes);
  CHECK(kept > 100 * kScenes);
  CHECK(wrong == 0);
  CHECK(newly_hidden == 0);
}

TEST_CASE("voids are outlined only if asked for, and nothing else in the drawing depends on it") {
  std::uint64_t outlined = 0, tied = 0, others = 0, gone = 0;
  for (std::uint64_t seed = 1; seed <= kScenes; ++seed) {
    VoidScene made = void_scene(seed);
    made.set_gap(kMissing);
    const auto& [terrain, spec, what] = made.scene;
    CAPTURE(seed, what);
    MapSpec plain = spec;
    plain.style.layers.pop_back();
    const PlacedView scene = placed_view(terrain, spec);
    const Map without = draw(terrain, scene, plain), with = draw(terrain, scene, spec);
    const RayWalk walk(terrain.surface, scene.view);
    CHECK(layer_of(without.drawing, "voids") == nullptr);
    REQUIRE(layer_of(with.drawing, "voids"));
    outlined += layer_of(with.drawing, "voids")->strokes.size();
    for (const Layer& layer : without.drawing.layers) {
      const Layer* other = layer_of(with.drawing, layer.name);
      REQUIRE(other);
      // Where a line is tied with a void's edge (a plateau seen edge-on) one of the two is drawn:
      // the line, where the edge isn't.
      for (const Vec3& at : layer.map) {
        if (holds(*other, at)) continue;
        ++(is_tied(walk, scene.view, to_profile_frame(scene.view, at)) ? tied : others);
      }
      for (const Vec3& at : other->map) gone += !holds(layer, at);
    }
  }
  WARN(outlined << " strokes around voids, " << tied << " points of other lines tied with them");
  CHECK(outlined > kScenes);
  CHECK(tied < outlined / 20);
  CHECK(others == 0);
  CHECK(gone == 0);
}

} // namespace orograph::voids_test
