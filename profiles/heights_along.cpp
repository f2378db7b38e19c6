// SPDX-License-Identifier: GPL-3.0-or-later
#include "profiles/heights_along.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <variant>

namespace orograph {
namespace {

void clear(std::size_t count, HeightsAlong& out) {
  out.z_m.assign(count, std::numeric_limits<double>::quiet_NaN());
  out.is_level.assign(count, 0);
}

// A place of the lattice, and what lies there.
struct OnLattice {
  double height_m; ///< as the grid has it; NaN where no ground is
  bool is_level;
};

template <class Values>
OnLattice on_lattice(const Grid& grid, const Values& heights, const TriangleSet& level, Vec2 p) {
  if (!(p.x >= 0 && p.y >= 0 && p.x <= grid.columns - 1 && p.y <= grid.rows - 1))
    return {std::numeric_limits<double>::quiet_NaN(), false};
  const int column = std::min(static_cast<int>(p.x), grid.columns - 2),
            row = std::min(static_cast<int>(p.y), grid.rows - 2);
  const double x = p.x - column, y = p.y - row;
  const std::size_t corner = grid.index(column, row), opposite = grid.index(column + 1, row + 1);
  const Half half = x > y ? Half::upper : Half::lower;
  const auto height = [&](std::size_t vertex) { return static_cast<double>(heights[vertex]); };
  const double height_m =
      half == Half::upper
          ? (1 - x) * height(corner) + (x - y) * height(corner + 1) + y * height(opposite)
          : (1 - y) * height(corner) + (y - x) * height(grid.index(column, row + 1)) +
                x * height(opposite);
  return {height_m, !level.empty() && level.has(grid_triangle(grid, column, row, half))};
}

template <class Values>
void heights_on_plane(const Grid& grid, const Values& heights, const View& view,
                      const TriangleSet& level, double depth_m, const PlacesAlong& at,
                      HeightsAlong& out) {
  const auto& [first, column_m, row_m] = grid.plane();
  const double area = cross(column_m, row_m);
  const auto in_cells = [&](Vec2 way) {
    return Vec2{cross(way, row_m) / area, cross(column_m, way) / area};
  };
  const Vec2 begin = in_cells(view.depth_origin_m - first + depth_m * view.forward +
                              at.begin_m * view.right),
             step = in_cells(at.step_m * view.right);
  for (std::size_t i = 0; i < at.count; ++i) {
    const auto [height_m, is_level] =
        on_lattice(grid, heights, level, begin + static_cast<double>(i) * step);
    out.z_m[i] = height_m * view.exaggeration - view.drop.at(at[i], depth_m);
    out.is_level[i] = is_level ? 1 : 0;
  }
}

// How the lattice lies along an upright line of the frame: its column and row, and the height over
// the ellipsoid, at one z, and by how much they change a metre of z.
struct Upright {
  double z_m = 0, h_m = 0, h_a_metre = 0;
  Vec2 cell, cell_a_metre;
};

Upright upright_at(const EarthLattice& lattice, Vec2 at_m) {
  constexpr double kRise_m = 1000;
  const LocalFrame& frame = lattice.frame();
  const double z_m = -dot(at_m, at_m) / (2 * frame.ellipsoid().semi_major_axis_m);
  const GeoPoint low = frame.to_geodetic({at_m.x, at_m.y, z_m}),
                 high = frame.to_geodetic({at_m.x, at_m.y, z_m + kRise_m});
  const Vec2 cell = lattice.column_row_of(low);
  return {z_m, low.h_m, (high.h_m - low.h_m) / kRise_m, cell,
          (1 / kRise_m) * (lattice.column_row_of(high) - cell)};
}

// What changes from one to the next of so many steps.
Upright a_step(const Upright& from, const Upright& to, double steps) {
  return {(to.z_m - from.z_m) / steps, (to.h_m - from.h_m) / steps,
          (to.h_a_metre - from.h_a_metre) / steps, (1 / steps) * (to.cell - from.cell),
          (1 / steps) * (to.cell_a_metre - from.cell_a_metre)};
}

// Uprights between two that are no farther apart are a mean of both: 2 m off at 50 degrees of
// latitude.
constexpr double kFromNodeToNode_m = 8000;

template <class Values>
void heights_on_earth(const Grid& grid, const Values& heights, const View& view,
                      const TriangleSet& level, double depth_m, const PlacesAlong& at,
                      HeightsAlong& out) {
  // Vertices lean by an angle that is the distance from the origin over the earth's radius, 0.05
  // at 300 km: each round leaves of the height's error that times the slope.
  constexpr int kRounds = 2;
  const EarthLattice& lattice = grid.earth();
  const auto upright = [&](std::size_t i) {
    return upright_at(lattice, view.depth_origin_m + depth_m * view.forward + at[i] * view.right);
  };
  const auto step =
      static_cast<std::size_t>(std::clamp(std::floor(kFromNodeToNode_m / at.step_m), 1.0, 128.0));
  Upright next = upright(0);
  double z_m = std::numeric_limits<double>::quiet_NaN();
  for (std::size_t first = 0; first < at.count; first += step) {
    const std::size_t end = std::min(first + step, at.count);
    const Upright from = next;
    next = upright(first + step);
    const Upright change = a_step(from, next, static_cast<double>(step));
    for (std::size_t i = first; i < end; ++i) {
      const auto k = static_cast<double>(i - first);
      const double low_z_m = from.z_m + k * change.z_m, low_h_m = from.h_m + k * change.h_m,
                   z_a_metre = 1 / (from.h_a_metre + k * change.h_a_metre);
      const Vec2 low = from.cell + k * change.cell,
                 cell_a_metre = from.cell_a_metre + k * change.cell_a_metre;
      double above_m = std::isnan(z_m) ? 0 : z_m - low_z_m; // as at the place before
      OnLattice ground{};
      for (int round = 0; round < kRounds; ++round) {
        ground = on_lattice(grid, heights, level, low + above_m * cell_a_metre);
        above_m = (lattice.exaggeration() * ground.height_m - low_h_m) * z_a_metre;
      }
      z_m = low_z_m + above_m;
      out.z_m[i] = z_m;
      out.is_level[i] = ground.is_level ? 1 : 0;
    }
  }
}

} // namespace

bool has_heights_along(const Grid& grid) {
  if (!grid.is_on_earth()) return true;
  // Chords of larger cells lie more than 0.3 m below the ellipsoid; on so few, cutting is cheap.
  constexpr double kLargestCell_deg = 0.04, kWidest_deg = 20, kFarthestNorth_deg = 80;
  const DegreeLattice& degrees = grid.earth().degrees();
  const double lon_deg = std::abs(degrees.lon_step_deg), lat_deg = std::abs(degrees.lat_step_deg);
  const double farthest_deg =
      std::max(std::abs(degrees.lat_deg(0)), std::abs(degrees.lat_deg(degrees.rows - 1)));
  return std::max(lon_deg, lat_deg) <= kLargestCell_deg &&
         lon_deg * degrees.columns <= kWidest_deg && lat_deg * degrees.rows <= kWidest_deg &&
         farthest_deg <= kFarthestNorth_deg;
}

void heights_along(const Grid& grid, const View& view, const TriangleSet& level, double depth_m,
                   const PlacesAlong& at, HeightsAlong& out) {
  clear(at.count, out);
  if (grid.columns < 2 || grid.rows < 2 || at.count == 0) return;
  std::visit(
      [&](const auto& heights) {
        if (grid.is_on_earth())
          heights_on_earth(grid, heights, view, level, depth_m, at, out);
        else
          heights_on_plane(grid, heights, view, level, depth_m, at, out);
      },
      grid.heights_m);
}

void heights_along(const Profile& profile, const PlacesAlong& at, HeightsAlong& out) {
  clear(at.count, out);
  std::size_t span = 0;
  for (std::size_t i = 0; i < at.count; ++i) {
    const double u = at[i];
    while (span + 1 < profile.size() && profile.u_m[span + 1] <= u) ++span;
    if (span + 1 >= profile.size()) return;
    if (u < profile.u_m[span] || profile.after[span] == Span::gap) continue;
    const double share = (u - profile.u_m[span]) / (profile.u_m[span + 1] - profile.u_m[span]);
    out.z_m[i] = profile.z_m[span] + share * (profile.z_m[span + 1] - profile.z_m[span]);
    out.is_level[i] = profile.after[span] == Span::level ? 1 : 0;
  }
}

} // namespace orograph
