// SPDX-License-Identifier: GPL-3.0-or-later
// The ray walk against hand-reckoned cases and against the surface sampled densely along the ray.
#include "reference/ray_walk.hpp"

#include "dem/height_at.hpp"
#include "tests/catch.hpp"
#include "tests/support/made_grid.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

using namespace orograph;

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kHole = std::numeric_limits<double>::quiet_NaN();

// A view that looks towards an azimuth; the window plays no part here.
View looking(Projection projection, double azimuth_deg, double descent_deg, Vec2 depth_origin_m,
             double eye_z_m = 0) {
  View view;
  view.projection = projection;
  view.forward = direction_of_azimuth(Angle::degrees(azimuth_deg));
  view.right = {view.forward.y, -view.forward.x};
  view.depth_origin_m = depth_origin_m;
  view.eye_z_m = eye_z_m;
  view.elevation = Angle::degrees(descent_deg);
  view.sin_elevation = sin(view.elevation);
  view.cos_elevation = cos(view.elevation);
  view.near_m = 0.01;
  return view;
}

// Vertices 1 m apart, (0, 0) in the south-west, heights by column and row as listed from the north.
Grid square_grid(int columns, std::vector<double> heights) {
  const int rows = static_cast<int>(heights.size()) / columns;
  return {columns, rows, {0, rows - 1.0}, {1, 0}, {0, -1}, std::move(heights)};
}

Grid heights_by(const GridLattice& lattice, const std::function<double(int, int)>& height) {
  Grid grid{lattice.columns,       lattice.rows,       lattice.first_vertex_m,
            lattice.column_step_m, lattice.row_step_m, std::vector<double>()};
  auto& heights = std::get<std::vector<double>>(grid.heights_m);
  for (int r = 0; r < grid.rows; ++r)
    for (int c = 0; c < grid.columns; ++c) heights.push_back(height(c, r));
  return grid;
}

// The place at depth w on the ray of p.
ProfilePoint on_ray(const View& view, ProfilePoint p, double w) {
  return {view.is_perspective() ? p.u / p.v * w : p.u, w, 0};
}
std::optional<double> surface_y(const Grid& grid, const View& view, ProfilePoint place) {
  const Vec3 ground = to_ground_m(view, place);
  const auto height_m = height_at(grid, {ground.x, ground.y});
  if (!height_m) return std::nullopt;
  return project(view, {place.u, place.v, *height_m * view.exaggeration}).y;
}

struct Sums {
  int asked = 0, hidden = 0, bare = 0; ///< bare: with nothing in front
};

// The surface at p is reckoned here: `p.z` isn't looked at. Whatever a dense sampling finds the
// walk must have found; and where it says that it found more, the surface must be that high.
void check(const Grid& grid, const RayWalk& walk, const View& view, ProfilePoint p, Sums& sums) {
  const Vec3 ground = to_ground_m(view, p);
  const auto height_m = height_at(grid, {ground.x, ground.y});
  if (!height_m || (view.is_perspective() && p.v < 2 * view.near_m)) return;
  p.z = *height_m * view.exaggeration;
  const InFront front = walk.in_front(p);

  constexpr int samples = 400;
  const double begin = view.is_perspective() ? view.near_m : p.v - 100;
  double greatest = -kInfinity;
  for (int i = 0; i < samples; ++i) {
    const double w = begin + (p.v - begin) * i / samples;
    greatest = std::max(greatest, surface_y(grid, view, on_ray(view, p, w)).value_or(-kInfinity));
  }
  const double own = project(view, p).y;
  INFO("u " << p.u << " v " << p.v << ": walk " << front.greatest_y << " at " << front.at_depth_m
            << ", sampled " << greatest << ", own " << own);
  REQUIRE(front.rounding >= 0);
  // `height_at` puts a place within 1e-9 of a cell onto the line. At most 100 m high, near_m near.
  const double slack = front.rounding + 1e-7 / begin_scale;
  REQUIRE(front.greatest_y >= std::min(greatest, greatest) - slack);
}

} // namespace
