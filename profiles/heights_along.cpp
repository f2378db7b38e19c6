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

bool is_on(const Grid& grid, Vec2 p) {
  return p.x >= 0 && p.y >= 0 && p.x <= grid.columns - 1 && p.y <= grid.rows - 1;
}
// Of the cell that a place of the lattice is in.
int column_of(const Grid& grid, Vec2 p) {
  return std::min(static_cast<int>(p.x), grid.columns - 2);
}
int row_of(const Grid& grid, Vec2 p) {
  return std::min(static_cast<int>(p.y), grid.rows - 2);
}

// As the grid has it; NaN where no ground is. Both halves of a cell are reckoned alike: which one
// it is changes from place to place, and a branch would be guessed wrong at every second.
template <class Values>
double height_at(const Grid& grid, const Values& heights, Vec2 p) {
  if (!is_on(grid, p)) return std::numeric_limits<double>::quiet_NaN();
  const int column = column_of(grid, p), row = row_of(grid, p);
  const double x = p.x - column, y = p.y - row;
  const std::size_t corner = grid.index(column, row), below = grid.index(column, row + 1);
  const double greater = std::max(x, y), less = std::min(x, y);
  const auto height = [&](std::size_t vertex) { return static_cast<double>(heights[vertex]); };
  return (1 - greater) * height(corner) + (greater - less) * height(x > y ? corner + 1 : below) +
         less * height(below + 1);
}

bool is_level_at(const Grid& grid, const TriangleSet& level, Vec2 p) {
  if (level.empty() || !is_on(grid, p)) return false;
  const int column = column_of(grid, p), row = row_of(grid, p);
  const Half half = p.x - column > p.y - row ? Half::upper : Half::lower;
  return level.has(grid_triangle(grid, column, row, half));
}

template <class Values>
void heights_on_plane(const Grid& grid, const Values& heights, const View& view,
                      const TriangleSet& level, const AskedProfile& asked) {
  const auto& [depth_m, at, out] = asked;
  const auto& [first, column_m, row_m] = grid.plane();
  const double area = cross(column_m, row_m);
  const auto in_cells = [&](Vec2 way) {
    return Vec2{cross(way, row_m) / area, cross(column_m, way) / area};
  };
  const Vec2 begin = in_cells(view.depth_origin_m - first + depth_m * view.forward +
                              at.begin_m * view.right),
             step = in_cells(at.step_m * view.right);
  for (std::size_t i = 0; i < at.count; ++i) {
    const Vec2 place = begin + static_cast<std::int32_t>(i) * step;
    out->z_m[i] =
        height_at(grid, heights, place) * view.exaggeration - view.drop.at(at[i], depth_m);
    out->is_level[i] = is_level_at(grid, level, place) ? 1 : 0;
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

// A profile of a grid in degrees, place by place.
template <class Values>
class WalkOnEarth {
public:
  WalkOnEarth(const Grid& grid, const Values& heights, const View& view, const TriangleSet& level,
              const AskedProfile& asked)
      : grid_(grid), heights_(heights), view_(view), level_(level), asked_(asked),
        step_(static_cast<std::size_t>(
            std::clamp(std::floor(kFromNodeToNode_m / asked.at.step_m), 1.0, 128.0))),
        next_(upright(0)) {}

  std::size_t count() const { return asked_.at.count; }
  // REQUIRES each place after the one before it.
  void take(std::size_t i) {
    if (i == end_) go_on();
    // Vertices lean by an angle that is the distance from the origin over the earth's radius, 0.05
    // at 300 km: each round leaves of the height's error that times the slope.
    constexpr int kRounds = 2;
    const auto k = static_cast<std::int32_t>(i - first_);
    const double low_z_m = from_.z_m + k * change_.z_m, low_h_m = from_.h_m + k * change_.h_m,
                 z_a_metre = 1 / (from_.h_a_metre + k * change_.h_a_metre);
    const Vec2 low = from_.cell + k * change_.cell,
               cell_a_metre = from_.cell_a_metre + k * change_.cell_a_metre;
    double above_m = std::isnan(z_m_) ? 0 : z_m_ - low_z_m; // as at the place before
    Vec2 place;
    for (int round = 0; round < kRounds; ++round) {
      place = low + above_m * cell_a_metre;
      above_m =
          (grid_.earth().exaggeration() * height_at(grid_, heights_, place) - low_h_m) * z_a_metre;
    }
    z_m_ = low_z_m + above_m;
    asked_.heights->z_m[i] = z_m_;
    asked_.heights->is_level[i] = is_level_at(grid_, level_, place) ? 1 : 0;
  }

private:
  Upright upright(std::size_t i) const {
    return upright_at(grid_.earth(), view_.depth_origin_m + asked_.depth_m * view_.forward +
                                         asked_.at[i] * view_.right);
  }
  void go_on() {
    first_ = end_;
    end_ += step_;
    from_ = next_;
    next_ = upright(end_);
    change_ = a_step(from_, next_, static_cast<double>(step_));
  }

  const Grid& grid_;
  const Values& heights_;
  const View& view_;
  const TriangleSet& level_;
  AskedProfile asked_;
  std::size_t step_, first_ = 0, end_ = 0; // from one upright to the next
  Upright from_, next_, change_;
  double z_m_ = std::numeric_limits<double>::quiet_NaN();
};

// Each place of a profile waits for the one before it, so that a processor reckons four profiles in
// half the time of one after the other.
constexpr std::size_t kAtOnce = 4;

template <class Values>
void heights_on_earth(const Grid& grid, const Values& heights, const View& view,
                      const TriangleSet& level, std::span<const AskedProfile> profiles) {
  for (std::size_t first = 0; first < profiles.size(); first += kAtOnce) {
    std::vector<WalkOnEarth<Values>> walks;
    std::size_t longest = 0;
    for (const AskedProfile& asked :
         profiles.subspan(first).first(std::min(kAtOnce, profiles.size() - first))) {
      walks.emplace_back(grid, heights, view, level, asked);
      longest = std::max(longest, asked.at.count);
    }
    for (std::size_t i = 0; i < longest; ++i)
      for (auto& walk : walks)
        if (i < walk.count()) walk.take(i);
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

void heights_along(const Grid& grid, const View& view, const TriangleSet& level,
                   std::span<const AskedProfile> profiles) {
  for (const AskedProfile& asked : profiles) clear(asked.at.count, *asked.heights);
  if (grid.columns < 2 || grid.rows < 2) return;
  std::visit(
      [&](const auto& heights) {
        if (grid.is_on_earth())
          heights_on_earth(grid, heights, view, level, profiles);
        else
          for (const AskedProfile& asked : profiles)
            heights_on_plane(grid, heights, view, level, asked);
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
