// SPDX-License-Identifier: GPL-3.0-or-later
// Eyes in the landscape that aren't told how steeply to look: skyline and foreground fill the page.
#include "dem/height_at.hpp"
#include "geometry/error.hpp"
#include "placing/frame_eye_view.hpp"
#include "placing/geodesy.hpp"
#include "placing/placed_view.hpp"
#include "reference/ray_walk.hpp"
#include "tests/catch.hpp"
#include "tests/scenes/random_scene.hpp"
#include "tests/support/grid_of.hpp"
#include "tests/support/made_grid.hpp"
#include "tests/support/random.hpp"
#include "view/sectors.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

using namespace orograph;

namespace {

struct EyeScene {
  TerrainData terrain;
  MapSpec spec;
};

// Over the ground, in the terrain or before it, looking anywhere or towards the terrain's centre.
EyeScene eye_scene(std::uint64_t seed) {
  const RandomScene made = random_scene(seed, 24);
  Random random(seed + 1000);
  EyeScene out{made.terrain, {}};
  const Grid& grid = grid_of(out.terrain);
  const Vec2 at = grid.plane().position_m(0, 0) +
                  random.between(0.1, 0.9) * (grid.columns - 1) * grid.plane().column_step_m +
                  random.between(0.1, 1.6) * (grid.rows - 1) * grid.plane().row_step_m;
  const auto height = height_at(grid, at);
  const Box3 box = extent_of(grid).box;
  const double above_m = random.pick({0.5, 3.0, 50.0, 300.0});
  const double z_m = (height ? *height : box.high.z) + above_m;
  const Vec3 eye = out.terrain.map.to_map({at.x, at.y, z_m});
  out.spec.view.eye_map = GivenPlace(eye);
  if (random.chance(0.7))
    out.spec.view.look_azimuth = Angle::degrees(random.pick({0.0, 90.0, random.between(0, 360)}));
  out.spec.view.field_of_view = Angle::degrees(random.pick({20.0, 60.0, 110.0}));
  out.spec.view.exaggeration = random.pick({1.0, 2.0});
  out.spec.view.curvature = random.pick({Curvature::on, Curvature::off});
  out.spec.style.light.reset(); // tone takes most of the time, and frames nothing
  out.spec.style.spread = Spread::planes;
  if (random.chance(0.3)) out.spec.page.crop = true;
  if (random.chance(0.2)) {
    out.spec.page.height_mm.reset();
    out.spec.page.orientation = Orientation::as_given;
  }
  return out;
}

// Above 0: by so much outside of what is between the window's sides and beyond the near plane.
double outside(const View& view, ProfilePoint p) {
  return std::max(
      {view.window.low.x * p.v - p.u, p.u - view.window.high.x * p.v, view.near_m - p.v});
}

double y(const View& view, ProfilePoint p) {
  return (p.z - view.eye_z_m) / p.v;
}

// Where the part of an edge that is inside begins and ends. `outside` is convex along the edge: its
// least is found by thirds, and then where it is 0 by halves.
void take_ends(const View& view, ProfilePoint a, ProfilePoint b, std::vector<ProfilePoint>& ends) {
  const auto at = [&](double t) { return outside(view, point_between(a, b, t)); };
  double low = 0, high = 1;
  for (int step = 0; step < 120; ++step) {
    const double left = low + (high - low) / 3, right = high - (high - low) / 3;
    if (at(left) < at(right))
      high = right;
    else
      low = left;
  }
  const double inmost = 0.5 * (low + high);
  if (at(inmost) > 0) return;
  for (const double end : {0.0, 1.0}) {
    double in = inmost, out = end;
    for (int step = 0; step < 100 && at(end) > 0; ++step) {
      const double middle = 0.5 * (in + out);
      (at(middle) <= 0 ? in : out) = middle;
    }
    ends.push_back(point_between(a, b, at(end) > 0 ? in : end));
  }
}

struct Brute {
  double highest = -kInfinity;    ///< greatest Y of all edges, whatever is seen of them, and of
                                  ///< heights in voids that no triangle has
  double lowest_seen = kInfinity; ///< of the ends of border edges that the ray walk sees
};

Brute brute(const Grid& grid, const View& view) {
  const auto place = [&](std::uint32_t vertex) {
    return to_profile_frame(view, vertex_m(grid, vertex));
  };
  std::vector<ProfilePoint> all, border;
  for (const GridTriangle& triangle : triangles_of(grid))
    for (std::size_t k = 0; k < 3; ++k)
      take_ends(view, place(triangle.vertices[k]), place(triangle.vertices[(k + 1) % 3]), all);
  for (const auto& [from, to] : outline_by_triangles(grid))
    take_ends(view, place(from), place(to), border);
  for (std::uint32_t i = 0; i < grid.size(); ++i)
    if (!std::isnan(vertex_m(grid, i).z) && outside(view, place(i)) <= 0) all.push_back(place(i));
  Brute out;
  for (const ProfilePoint& p : all) out.highest = std::max(out.highest, y(view, p));
  const RayWalk walk(grid, view);
  for (const ProfilePoint& p : border) {
    const InFront before = walk.in_front(p);
    if (before.greatest_y_apart <= y(view, p) + before.rounding)
      out.lowest_seen = std::min(out.lowest_seen, y(view, p));
  }
  return out;
}

// Vertices `step_m` apart, from (0, 0) to the south-east.
template <class Height>
TerrainData made_terrain(int columns, int rows, double step_m, const Height& height) {
  std::vector<double> heights;
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column) heights.push_back(height(column, row));
  TerrainData terrain;
  terrain.surface =
      Grid{columns, rows, PlaneLattice{{0, 0}, {step_m, 0}, {0, -step_m}}, std::move(heights)};
  return terrain;
}

} // namespace

TEST_CASE("skyline and foreground fill an eye's page, uprights upright") {
  int framed = 0, centred = 0, over_ground = 0, ended = 0;
  for (std::uint64_t seed = 1; seed <= last_seed(200); ++seed) {
    EyeScene scene = eye_scene(seed);
    CAPTURE(seed);
    std::optional<PlacedView> placed;
    try {
      placed = placed_view(scene.terrain, scene.spec);
    } catch (const Error&) {
      continue; // all of the terrain is behind the eye
    }
    const View& view = placed->view;
    if (!placed->framed_by_skyline) continue;
    ++framed;
    const Grid& grid = grid_of(scene.terrain);
    const Brute seen = brute(grid, view);
    CAPTURE(seen.highest, seen.lowest_seen, view.window.low.y, view.window.high.y, view.near_m);
    CHECK(view.elevation == Angle());
    CHECK_FALSE(shows_beside(view));
    CHECK(view.window.low.x == -view.window.high.x);
    const double width = view.window.width(), height = view.window.height();
    const double top = view.window.high.y - kSkyShare * height;
    const double rounding = 1e-9 * (1 + std::abs(view.window.high.y) + std::abs(view.window.low.y));
    const bool ends = scene.spec.page.ends_with_picture();
    const bool stands = height_at(grid, view.depth_origin_m).has_value();
    if (stands || seen.lowest_seen <= view.window.low.y || ends) {
      if (std::max(std::abs(view.window.low.y), std::abs(view.window.high.y)) > 15) continue;
      CHECK(std::abs(top - seen.highest) <= rounding);
    } else {
      const double middle = 0.5 * (seen.highest + seen.lowest_seen);
      // A void's rim counts, too, seen or not.
      const bool has_voids = placed->extent.valid < grid.size();
      CHECK(view.window.centre().y <= middle + rounding);
      CHECK((has_voids || view.window.centre().y >= middle - rounding));
      ++centred;
    }
    over_ground += stands;
    if (!ends) {
      CHECK(std::abs(height - 190.0 / 277 * width) <= 1e-9 * height);
      continue;
    }
    ++ended;
    if (placed->page.inner_mm().height() <= 1) continue; // paper's least
    // As high as the page is, a quarter of the width below the skyline or to where the ground ends.
    CHECK(std::abs(placed->page.inner_mm().height() / placed->page.inner_mm().width() -
                   height / width) <= 1e-9 * height / width);
    CHECK(height <= (scene.spec.page.height_mm ? 190.0 / 277 : 1) * width * (1 + 1e-9));
    CHECK((view.window.low.y <= seen.highest - kForegroundShare * width + rounding ||
           (!stands && view.window.low.y <= seen.lowest_seen + rounding)));
  }
  CHECK(framed > enough(150));
  CHECK(centred > enough(5));
  CHECK(over_ground > enough(80));
  CHECK(ended > enough(40));
}

TEST_CASE("an eye that is told where to look isn't framed") {
  const auto window = [](ViewSpec view) {
    const auto terrain = made_terrain(30, 30, 10, [](int c, int r) { return 2.0 * c + 3 * r % 7; });
    MapSpec spec;
    spec.view = std::move(view);
    const PlacedView placed = placed_view(terrain, spec);
    return std::pair{placed.framed_by_skyline, placed.view};
  };
  ViewSpec view;
  view.eye_map = GivenPlace({100, -150, 200});
  view.look_azimuth = Angle::degrees(40);
  CHECK(window(view).first);
  const Box2 shifted = window(view).second.window;
  CHECK(shifted.high.y != -shifted.low.y);
  ViewSpec pitched = view;
  for (const double pitch_deg : {0.0, -12.5}) {
    pitched.pitch = Angle::degrees(pitch_deg);
    CHECK_FALSE(window(pitched).first);
    CHECK(window(pitched).second.elevation == Angle::degrees(0 - pitch_deg));
    CHECK(window(pitched).second.window.low.y == -window(pitched).second.window.high.y);
  }
  ViewSpec rolled = view;
  rolled.roll = Angle::degrees(1);
  CHECK_FALSE(window(rolled).first);
  ViewSpec at = view;
  at.look_azimuth.reset();
  CHECK(window(at).first); // towards the centre, level
  at.look_at_map = GivenPlace({140, -150, 20});
  CHECK_FALSE(window(at).first);
  CHECK(window(at).second.elevation.in_degrees() > 45);
  ViewSpec above = view; // 45 degrees and more over all there is
  above.eye_map = GivenPlace({150, -150, 5000});
  above.look_azimuth.reset();
  CHECK_FALSE(window(above).first);
}

TEST_CASE("an eye whose own facets hide the world is told how high sees it") {
  // Ground that rises slowly, with a bank of 12 m one cell before the eye.
  const auto terrain =
      made_terrain(41, 41, 46, [](int, int r) { return r == 18 ? 12.0 : 0.1 * r; });
  MapSpec spec;
  const auto near = [&](double row, double height_m) {
    spec.view.eye_map = GivenPlace(20.3 * 46, -46 * row);
    spec.view.eye_height_m = height_m;
    spec.view.look_azimuth = Angle(); // up the rows, to the bank
    return placed_view(terrain, spec).near_skyline;
  };
  const auto told = near(19.5, 2);
  REQUIRE(told);
  CHECK(told->within_m == 92);
  CHECK(std::abs(told->eye_height_m - 2) <= 1e-9);
  REQUIRE(told->clear_of_height_m);
  CHECK_FALSE(near(19.5, *told->clear_of_height_m));
  CHECK(near(19.5, 0.25 * *told->clear_of_height_m));
  CHECK_FALSE(near(30, 2));  // the bank is eleven cells away
  CHECK_FALSE(near(10, 2));  // and behind
  CHECK_FALSE(near(0.5, 2)); // nothing is there to be hidden
}
