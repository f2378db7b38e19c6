// SPDX-License-Identifier: GPL-3.0-or-later
// Blocks: what of their walls is drawn is what an eye sees of them, and all else stays as it was.
#include "dem/approximate/tin_of_grid.hpp"
#include "geometry/error.hpp"
#include "hidden_lines/instruments.hpp"
#include "hidden_lines/void_walls.hpp"
#include "map/draw_map.hpp"
#include "placing/block.hpp"
#include "placing/contours.hpp"
#include "placing/placed_view.hpp"
#include "placing/terrain_of_view.hpp"
#include "profiles/outline.hpp"
#include "profiles/slab_lines.hpp"
#include "tests/blocks/block_walk.hpp"
#include "tests/blocks/scene_with_voids.hpp"
#include "tests/catch.hpp"
#include "tests/scenes/random_earth_scene.hpp"
#include "tests/scenes/random_scene.hpp"
#include "tests/scenes/same_drawing.hpp"
#include "tests/scenes/vary_view.hpp"
#include "tests/support/grid_of.hpp"
#include "tests/support/random.hpp"
#include "view/sectors.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

namespace orograph::block_scenes_test {
namespace {

const std::uint64_t kScenes = last_seed(500);

RandomScene with_block(std::uint64_t seed, Random& random) {
  RandomScene scene = scene_with_voids(seed, random);
  Style& style = scene.spec.style;
  style.layers.insert(style.layers.end(), {"block", "contours"});
  style.block.sides = BlockSides::lines;
  style.pen_width_mm = 2; // so that hatching is wide
  style.join_mm = scene.spec.style.min_stroke_mm.emplace(0);
  if (seed % 4 != 3) vary_view(seed, scene.terrain, scene.spec, random);
  return scene;
}

struct Tally {
  std::uint64_t asked = 0, unsure = 0, visible = 0, hidden_but_drawn = 0, missing = 0,
                far_walls = 0; ///< left out, behind their void's near rim
};

// Asks of points on the walls' lines, and of points anywhere on any wall: those that are seen must
// be on a wall that has lines.
class WallCheck : public LineObserver {
public:
  WallCheck(const TerrainData& terrain, const PlacedView& placed, Random& random)
      : terrain_(terrain), placed_(placed), random_(random) {}

  void see(const SeenProfile&) override {}
  void see(const SeenLines& seen) override {
    const View& view = seen.sector.view;
    if (!view.is_perspective() && !(view.y_per_z > 1e-3)) return; // from straight above
    tolerance_ = tie_tolerance(seen.sector, 1e-4);
    const std::vector<BlockWall> walls = walls_in(terrain_, placed_, view);
    const BlockWalk walk(triangles_in(terrain_, view), walls, view);
    std::vector<std::uint32_t> lines;
    for (std::uint32_t i = 0; i < seen.lines.size(); ++i)
      if (is_on_wall(seen.lines.line(i).kind)) lines.push_back(i);
    constexpr int kOfLines = 60, kOfWalls = 20;
    for (int k = 0; k < kOfLines && !lines.empty(); ++k) {
      const std::uint32_t line =
          lines[static_cast<std::size_t>(random_.whole(0, static_cast<int>(lines.size()) - 1))];
      const auto part = std::find_if(seen.visible.begin(), seen.visible.end(),
                                     [&](const LinePart& p) { return p.line == line; });
      double t = random_.between(0, 1);
      if (part != seen.visible.end() && random_.chance(0.4))
        t = (random_.chance(0.5) ? part->t_begin : part->t_end) + random_.pick({-1e-3, 1e-3});
      if (!(t > 0 && t < 1)) continue;
      bool is_drawn = false;
      for (auto p = part; p != seen.visible.end() && p->line == line; ++p)
        is_drawn = is_drawn || (p->t_begin <= t && t <= p->t_end);
      const ProfileLine whole = seen.lines.whole(line);
      // A rim may be the wall's own upper edge, or that of one turned away.
      ask(walk, seen, point_between(whole.from, whole.to, t), is_drawn);
    }
    for (int k = 0; k < kOfWalls; ++k) {
      const auto& [a, b, a_foot, b_foot] =
          walls[static_cast<std::size_t>(random_.whole(0, static_cast<int>(walls.size()) - 1))];
      const double t = random_.between(0.01, 0.99);
      const ProfilePoint top = point_between(a, b, t), foot = point_between(a_foot, b_foot, t);
      const ProfilePoint at{top.u, top.v, std::lerp(foot.z, top.z, random_.between(0.01, 0.99))};
      // Whether it has lines is told by whether those of its edge were made.
      const double turn =
          view.is_perspective() ? a.v * b.u - a.u * b.v : b.u - a.u + view.x_per_v * (b.v - a.v);
      const double size = std::hypot(b.u - a.u, b.v - a.v);
      if (std::abs(turn) < 1e-6 * size * (view.is_perspective() ? std::hypot(a.u, a.v) : 1))
        continue;
      if (turn < 0) ask(walk, seen, at, false);
    }
    ask_far_walls(walk, seen, walls);
  }

  Tally tally;

private:
  // What is left out of voids' far walls, since their near rim hides it.
  void ask_far_walls(const BlockWalk& walk, const SeenLines& seen,
                     const std::vector<BlockWall>& walls) {
    if (placed_.panorama || placed_.sectors.size() > 1) return;
    const View& view = seen.sector.view;
    const std::vector<bool> of_void = around_voids(terrain_.surface, placed_.border);
    const EdgeEnds ends(terrain_.surface, view);
    std::vector<ProfilePoint> vertices;
    for (std::uint32_t i = 0; i < vertex_count(terrain_.surface); ++i)
      vertices.push_back(ends.vertex(i));
    std::vector<VoidRim> rims;
    std::vector<BlockWall> of_rims;
    for (std::size_t i = 0; i < walls.size(); ++i) {
      if (!of_void[i]) continue;
      const auto& [edge, left] = placed_.border[i];
      const auto& [a, b, a_foot, b_foot] = walls[i];
      const double turn =
          view.is_perspective() ? a.v * b.u - a.u * b.v : b.u - a.u + view.x_per_v * (b.v - a.v);
      rims.push_back({edge.from, edge.to, turn > 0});
      of_rims.push_back(walls[i]);
    }
    const std::vector<double> below_y = hidden_below(view, vertices, rims, tolerance_.greatest_y);
    for (std::size_t k = 0; k < 2 * rims.size(); ++k) {
      const std::size_t i = k / 2;
      const auto& [a, b, a_foot, b_foot] = of_rims[i];
      const double t = random_.between(0.01, 0.99);
      const ProfilePoint top = point_between(a, b, t), foot = point_between(a_foot, b_foot, t);
      const ProfilePoint at{top.u, top.v, std::lerp(foot.z, top.z, random_.between(0.01, 0.99))};
      if (!(project(view, at).y < below_y[i])) continue;
      ++tally.far_walls;
      ask(walk, seen, at, false);
    }
  }

  void ask(const BlockWalk& walk, const SeenLines& seen, ProfilePoint at, bool is_drawn) {
    const View& view = seen.sector.view;
    // Edges that lie between two sectors hide only from so far ahead on.
    const double from_m = std::max(kNearPlanesAhead * view.near_m, view.drawn_from_m);
    if (view.is_perspective() && at.v <= 1.01 * from_m) return;
    const double x = project(view, at).x;
    if (!(x > seen.clipped.begin && x < seen.clipped.end)) return;
    ++tally.asked;
    // What is as high as a line in front, to the tolerance on the page, is drawn only once.
    const Vec2 plane = project(view, at);
    const double sure_m = 1e-5 + 2 * tolerance_.at(plane.x, plane.y) *
                                     (view.is_perspective() ? at.v : 1 / view.y_per_z);
    const auto side = [&](ProfilePoint p) {
      const double inside_m = walk.depth_inside_m(p);
      return inside_m > sure_m ? 1 : inside_m < -sure_m ? -1 : 0;
    };
    const int here = side(at);
    // What ends just at the point's X is a matter of rounding: a little aside, in front of the
    // wall.
    const double aside = 1e-7 * std::hypot(at.u, at.v);
    const auto nudged = [&](double across) {
      const double along = u_along_ray(view, at), size = std::hypot(along, 1);
      return side({at.u + (across - 20 * aside * along) / size,
                   at.v - (across * along + 20 * aside) / size,
                   at.z - 20 * aside / size * z_along_ray(view, at)});
    };
    const bool is_sure = here != 0 && nudged(aside) == here && nudged(-aside) == here;
    if (!is_sure)
      ++tally.unsure;
    else if (here > 0 && is_drawn)
      ++tally.hidden_but_drawn;
    else if (here < 0 && !is_drawn)
      ++tally.missing;
    if (here < 0) ++tally.visible;
  }

  const TerrainData& terrain_;
  const PlacedView& placed_;
  Random& random_;
  TieTolerance tolerance_;
};

// An eye beside the terrain, or over a void, no higher than its summit and above its base.
void put_eye_beside(RandomScene& scene, Random& random) {
  const Grid& grid = grid_of(scene.terrain);
  std::vector<Vec3> ground;
  std::vector<Vec2> voids;
  for (int row = 0; row < grid.rows; ++row)
    for (int column = 0; column < grid.columns; ++column) {
      const Vec3 vertex = grid.vertex_m(column, row);
      if (std::isnan(vertex.z))
        voids.push_back(grid.plane().position_m(column, row));
      else
        ground.push_back(vertex);
    }
  const auto any_of = [&](const auto& places) {
    return places[static_cast<std::size_t>(random.whole(0, static_cast<int>(places.size()) - 1))];
  };
  Vec2 at{};
  if (!voids.empty() && random.chance(0.4)) {
    at = any_of(voids);
  } else {
    double column = random.between(-1, grid.columns), row = random.between(-1, grid.rows);
    const double beside = random.between(0.1, 6);
    if (random.chance(0.5))
      column = random.chance(0.5) ? -beside : grid.columns - 1 + beside;
    else
      row = random.chance(0.5) ? -beside : grid.rows - 1 + beside;
    at = grid.plane().position_m(0, 0) + column * grid.plane().column_step_m +
         row * grid.plane().row_step_m;
  }
  const auto [lowest, highest] = std::ranges::minmax(ground, {}, &Vec3::z);
  const double top_m = highest.z,
               base_m = lowest.z - random.between(0.1, 1) * (top_m - lowest.z + 10);
  scene.spec.style.block.base = base_m;
  const Vec3 eye{at.x, at.y, std::lerp(base_m, top_m, random.between(0.01, 1))};
  Vec3 target = any_of(ground);
  target.z = std::lerp(eye.z, target.z, random.between(0, 1));
  ViewSpec& view = scene.spec.view;
  view.projection = Projection::perspective;
  view.exaggeration = 1;
  view.field_of_view = Angle::degrees(random.pick({30.0, 60.0, 90.0}));
  view.eye_map = eye;
  view.look_at_map = target;
}

// Draws the scene with its walls asked; false where the view is refused.
bool check_walls(const RandomScene& scene, Random& random, Instruments instruments, Tally& sum) {
  const std::optional<PlacedView> placed = placed_if_any(scene.terrain, scene.spec);
  if (!placed) return false;
  WallCheck check(scene.terrain, *placed, random);
  instruments.observers = {&check};
  draw_map(
      scene.terrain, *placed, scene.spec, [](double) {}, instruments);
  CHECK(check.tally.hidden_but_drawn == 0);
  CHECK(check.tally.missing == 0);
  sum.asked += check.tally.asked;
  sum.unsure += check.tally.unsure;
  sum.visible += check.tally.visible;
  sum.far_walls += check.tally.far_walls;
  return true;
}

void tell(std::uint64_t drawn, const Tally& sum) {
  WARN(drawn << " scenes, " << sum.asked << " asked, " << sum.unsure << " unsure, " << sum.visible
             << " visible, " << sum.far_walls << " behind a void's near rim");
}

bool is_of_block(const Layer& layer) {
  return layer.name == "block" || layer.name.starts_with("wall");
}

} // namespace

TEST_CASE("a block's walls are drawn where they are seen, and nowhere else") {
  Tally sum;
  std::uint64_t drawn = 0;
  for (std::uint64_t seed = 1; seed <= kScenes; ++seed) {
    Random random(seed);
    RandomScene scene = with_block(seed, random);
    const bool is_tin = seed % 5 == 0;
    if (is_tin) {
      const Grid grid = grid_of(scene.terrain);
      scene.terrain.surface = tin_of(grid);
    }
    INFO("seed " << seed << ": " << scene.what << (is_tin ? ", a TIN" : ""));
    drawn += check_walls(scene, random,
                         {.hidden_ground = seed % 2 == 0, .order_always = seed % 4 != 0}, sum);
  }
  tell(drawn, sum);
  CHECK(sum.asked > 25 * kScenes);
  CHECK(sum.visible > 8 * kScenes);
  CHECK(sum.far_walls > enough(75)); // few scenes needn't have had any
  CHECK(sum.unsure < sum.asked / 20);
}

TEST_CASE("and from eyes beside a block or over its voids, lower than its summit") {
  Tally sum;
  std::uint64_t drawn = 0;
  for (std::uint64_t seed = 1; seed <= kScenes; ++seed) {
    Random random(seed);
    RandomScene scene = with_block(4 * seed + 3, random); // whose view isn't varied
    put_eye_beside(scene, random);
    INFO("seed " << seed << ": " << scene.what);
    drawn += check_walls(scene, random, {.order_always = seed % 4 != 0}, sum);
  }
  tell(drawn, sum);
  CHECK(drawn > kScenes / 2);
  CHECK(sum.visible > 3 * drawn);
  CHECK(sum.unsure < sum.asked / 10);
}

TEST_CASE("and in degrees, where walls are upright in the view's frame") {
  Tally sum;
  std::uint64_t drawn = 0;
  for (std::uint64_t seed = 1; seed <= kScenes / 5; ++seed) {
    Random random(seed);
    RandomScene scene = random_earth_scene(
        seed, random.pick({Stand::frames_terrain, Stand::in_air, Stand::on_ground}));
    scene.spec.style.layers.insert(scene.spec.style.layers.end(), {"block", "contours"});
    scene.spec.style.block.sides = BlockSides::lines;
    scene.spec.style.pen_width_mm = 2;
    INFO("seed " << seed << ": " << scene.what);
    stand_on_earth(scene.terrain, scene.spec.view);
    drawn += check_walls(scene, random, {.order_always = seed % 2 == 0}, sum);
  }
  tell(drawn, sum);
  CHECK(drawn > kScenes / 10);
  CHECK(sum.visible > 5 * drawn);
  CHECK(sum.unsure < sum.asked / 10);
}

TEST_CASE("all else is the same with a block and without, to the bit") {
  std::uint64_t compared = 0;
  for (std::uint64_t seed = 1; seed <= kScenes / 4; ++seed) {
    Random random(seed);
    // In degrees contours of eight levels and more are found on the way.
    const bool on_earth = seed % 5 == 1;
    RandomScene scene =
        on_earth ? random_earth_scene(seed, Stand::frames_terrain) : with_block(seed, random);
    if (on_earth)
      scene.spec.style.layers.insert(scene.spec.style.layers.end(), {"block", "contours"});
    if (seed % 5 == 0) {
      const Grid grid = grid_of(scene.terrain);
      scene.terrain.surface = tin_of(grid);
    }
    INFO("seed " << seed << ": " << scene.what);
    std::optional<PlacedView> placed = placed_if_any(scene.terrain, scene.spec);
    if (!placed) continue;
    Map with = draw_map(scene.terrain, *placed, scene.spec, [](double) {});
    CHECK(!find_fault(with.drawing).has_value());
    CHECK(std::ranges::any_of(with.drawing.layers, is_of_block));
    std::erase_if(with.drawing.layers, is_of_block);
    // On the page that was framed with the block.
    std::erase_if(scene.spec.style.layers, [](const LayerSpec& of) { return of.name == "block"; });
    const Map without = draw_map(scene.terrain, *placed, scene.spec, [](double) {});
    CHECK(difference(with.drawing, without.drawing).empty());
    ++compared;
  }
  CHECK(compared > kScenes / 8);
}

TEST_CASE("a block's base is below all heights, by 0.15 of the relief unless told otherwise") {
  TerrainData terrain;
  Grid& grid = grid_of(terrain);
  grid.columns = grid.rows = 2;
  grid.heights_m = std::vector<float>{100, 200, 300, 400};
  CHECK(block_base_m(terrain, {}) == Approx(55));
  // Contours on the walls go down to it.
  const ContourLevels on_walls = contour_levels(terrain, {.interval = 50}, 55);
  CHECK(on_walls.heights == std::vector<double>{100, 150, 200, 250, 300, 350, 400});
  CHECK(contour_levels(terrain, {.interval = 50}, 20).heights.front() == 50);
  CHECK(contour_levels(terrain, {.interval = 50}).heights.front() == 150);
  CHECK(contour_levels(terrain, {.levels = {10, 60, 250}}, 55).heights ==
        std::vector<double>{60, 250});
  CHECK(block_base_m(terrain, {.base = 99}) == 99);
  CHECK(block_base_m(terrain, {.base = 100, .unit_m = 0.3048}) == Approx(30.48));
  CHECK_THROWS_AS(block_base_m(terrain, {.base = 100}), Error);
  grid.heights_m = std::vector<float>{7, 7, 7, 7};
  CHECK_THROWS_AS(block_base_m(terrain, {}), Error);
  CHECK(block_base_m(terrain, {.base = 0}) == 0);
}

TEST_CASE("a page that frames a block holds its feet") {
  RandomScene scene = random_scene(3);
  scene.spec.view.projection = Projection::orthographic;
  scene.spec.view.from_elevation = Angle::degrees(20);
  const PlacedView plain = placed_view(scene.terrain, scene.spec);
  scene.spec.style.layers.emplace_back("block");
  const PlacedView placed = placed_view(scene.terrain, scene.spec);
  REQUIRE(placed.block_base_m);
  const Box2& frame = placed.frame_mm;
  double lowest = 0;
  for (const Vec3& foot : block_feet_m(scene.terrain, placed.border, *placed.block_base_m)) {
    const Vec3 image = placed.on_page(to_profile_frame(placed.view, foot));
    CHECK(image.y / image.z <= frame.high.y + 1e-6);
    lowest = std::max(lowest, image.y / image.z);
  }
  const Vec3 before = plain.on_page({0, 0, 0}), now = placed.on_page({0, 0, 0});
  CHECK(!(before.y / before.z == now.y / now.z));
  CHECK(lowest > 0.5 * (frame.low.y + frame.high.y));
}

} // namespace orograph::block_scenes_test
