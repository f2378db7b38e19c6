// SPDX-License-Identifier: GPL-3.0-or-later
// The order of strips of cells on the earth, by its definition: nothing is taken before what a ray
// meets earlier, and all that a ray meets is among what is told to be shown. Steep lattices, whose
// vertices lean by up to a third of a cell, with voids and spikes; eyes beside them and over them.
#include "dem/limit_lean.hpp"
#include "profiles/earth_strips.hpp"
#include "profiles/lattice_order.hpp"
#include "tests/catch.hpp"
#include "tests/profiles/triangle_cuts.hpp"
#include "tests/support/made_earth_grid.hpp"
#include "tests/support/random.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <vector>

namespace orograph::earth_strips_test {
namespace {

Grid steep_grid(Random& random) {
  MadeEarth made;
  made.columns = random.whole(3, 24);
  made.rows = random.whole(3, 24);
  made.lon_step_deg = random.pick({1, -1}) / 1200.0;
  made.lat_step_deg = random.pick({1, 1, 4}) / 1200.0;
  made.west_deg += random.between(-0.5, 0.5);
  made.north_deg += random.between(-0.3, 0.3);
  return made_earth_grid(random, made);
}

// So high that they would lean over the cells beside them.
void add_spikes(Random& random, Grid& grid) {
  std::visit(
      [&](auto& heights) {
        for (auto& height : heights.own())
          if (random.chance(0.03)) height = static_cast<float>(random.pick({-32767, 15000, 32767}));
      },
      grid.heights_m);
}

// From beside the grid, along its lines or not, or from over it.
View any_view(Random& random, const Grid& grid) {
  const double azimuth_deg = random.chance(0.5)
                                 ? random.pick({0.0, 90.0, 180.0, 270.0}) + random.between(-3, 3)
                                 : random.between(0, 360);
  const Vec2 forward = direction_of_azimuth(Angle::degrees(azimuth_deg));
  const bool over = random.chance(0.4);
  const Vec3 at =
      grid.earth().vertex_m(random.whole(0, grid.columns - 1), random.whole(0, grid.rows - 1), 0);
  const double away_m = over ? random.pick({0.0, 20.0, 50.0}) : random.between(500, 20000);
  View view = looking(forward, {at.x - away_m * forward.x, at.y - away_m * forward.y});
  if (!over && random.chance(0.2)) {
    view.x_per_v = random.pick({0.0, 0.5, -1.0});
    return view;
  }
  view.projection = Projection::perspective;
  view.eye_z_m = at.z + random.between(-1000, 6000);
  return view;
}

// What a ray meets: a triangle along a stretch of it, or an edge.
struct Met {
  double from_m, to_m; ///< depths
  LatticeOrder::Turn turn;
  int strip, cell, line; ///< of an edge along a line that one, otherwise -1
  bool is_upright;       ///< at the cell's beginning, or at the strip's end
};

double aside(const View& view, ProfilePoint p, double x) {
  return view.is_perspective() ? p.u - x * p.v : p.u + p.v * view.x_per_v - x;
}

std::optional<double> crossed_m(const View& view, ProfilePoint a, ProfilePoint b, double x) {
  const double of_a = aside(view, a, x), of_b = aside(view, b, x);
  if ((of_a < 0) == (of_b < 0)) return std::nullopt;
  return a.v + of_a / (of_a - of_b) * (b.v - a.v);
}

class Ray {
public:
  Ray(const Grid& grid, const View& view, const LatticeOrder& order, double from_m, double x)
      : grid_(grid), view_(view), order_(order), from_m_(from_m), x_(x) {
    for (int r = 0; r < grid.rows; ++r)
      for (int c = 0; c < grid.columns; ++c) {
        if (c + 1 < grid.columns) take_edge(c, r, 1, 0);
        if (r + 1 < grid.rows) take_edge(c, r, 0, 1);
        if (c + 1 == grid.columns || r + 1 == grid.rows) continue;
        take_edge(c, r, 1, 1);
        for (const Half half : {Half::lower, Half::upper}) take_triangle(c, r, half);
      }
  }
  std::vector<Met> met;

private:
  ProfilePoint at(int c, int r) const { return to_profile_frame(view_, grid_.vertex_m(c, r)); }
  bool is_rows() const { return order_.rows_are_strips(); }

  void take_edge(int c, int r, int right, int down) {
    const ProfilePoint a = at(c, r), b = at(c + right, r + down);
    // An edge of no triangle isn't there.
    const auto is_there = [&](int column, int row) {
      return column >= 0 && row >= 0 && column < grid_.columns && row < grid_.rows &&
             !std::isnan(grid_.height_m(column, row));
    };
    const bool is_edge = right != 0 && down != 0 ? is_there(c + 1, r) || is_there(c, r + 1)
                         : right != 0            ? is_there(c, r - 1) || is_there(c + 1, r + 1)
                                                 : is_there(c - 1, r) || is_there(c + 1, r + 1);
    if (!is_edge || std::isnan(a.z + b.z)) return;
    const auto depth = crossed_m(view_, a, b, x_);
    if (!depth || *depth < from_m_) return;
    const SurfaceEdge edge{static_cast<std::uint32_t>(grid_.index(c, r)),
                           static_cast<std::uint32_t>(grid_.index(c + right, r + down))};
    const bool along = is_rows() ? down == 0 : right == 0;
    met.push_back({*depth, *depth, order_.turn(edge), is_rows() ? r : c, is_rows() ? c : r,
                   along ? (is_rows() ? r : c) : -1, !along && (right == 0 || down == 0)});
  }
  void take_triangle(int c, int r, Half half) {
    const std::array<ProfilePoint, 3> corners{at(c, r), at(c + 1, r + 1),
                                              half == Half::lower ? at(c, r + 1) : at(c + 1, r)};
    if (std::isnan(corners[0].z + corners[1].z + corners[2].z)) return;
    std::vector<double> depths;
    for (std::size_t k = 0; k < 3; ++k)
      if (const auto depth = crossed_m(view_, corners[k], corners[(k + 1) % 3], x_))
        depths.push_back(std::max(*depth, from_m_));
    if (depths.empty()) return;
    const auto [low, high] = std::ranges::minmax(depths);
    if (high - low > kTouching_m)
      met.push_back(
          {low, high, order_.turn(c, r, half), is_rows() ? r : c, is_rows() ? c : r, -1, false});
  }

  static constexpr double kTouching_m = 1e-6;
  const Grid& grid_;
  const View& view_;
  const LatticeOrder& order_;
  double from_m_, x_;
};

} // namespace

TEST_CASE("strips of cells on the earth are in order along every ray that is looked at") {
  std::uint64_t asked = 0, limited = 0, views = 0, none = 0, over = 0, restless = 0;
  for (std::uint64_t seed = 1; seed <= last_seed(400); ++seed) {
    INFO("seed " << seed);
    Random random(seed);
    Grid grid = steep_grid(random);
    if (random.chance(0.3)) add_spikes(random, grid);
    limit_lean(grid);
    if (leaning_triangles(grid) > 0) continue; // of a mirrored lattice, or by rounding
    limited += grid.earth().lean_limits() ? 1 : 0;
    const View view = any_view(random, grid);
    const double from_m = view.is_perspective() ? 0.9 : -1e9;
    const double middle = view.is_perspective() ? random.between(-0.5, 0.5) : 0;
    const double wide = view.is_perspective() ? random.pick({0.01, 0.3, 1.0, 3.0}) : 1e6;
    const LookedAt looked{{middle - wide, middle + wide}, from_m};
    for (const bool rows : {true, false}) {
      const auto strips = EarthStrips::of(grid, view, looked, rows);
      if (!strips) {
        ++none;
        continue;
      }
      ++views;
      over += strips->own() >= 0 && strips->own() < strips->strips() ? 1 : 0;
      for (int i = 0; i < strips->strips(); ++i) restless += strips->runs_of(i).size() > 1 ? 1 : 0;
      const LatticeOrder order(*strips);
      std::uint64_t wrong = 0, not_shown = 0;
      for (int i = 0; i < 30; ++i) {
        const ProfilePoint of = to_profile_frame(
            view, grid.vertex_m(random.whole(0, grid.columns - 1), random.whole(0, grid.rows - 1)));
        if (std::isnan(of.z) || of.v <= from_m) continue;
        const double x = project(view, of).x + random.between(-1e-3, 1e-3);
        if (x <= looked.range.begin || x >= looked.range.end) continue;
        const Ray ray(grid, view, order, from_m, x);
        const double beside = random.chance(0.5) ? 0 : random.between(0, 0.01);
        const XRange shown_x{std::max(x - beside, looked.range.begin),
                             std::min(x + beside, looked.range.end)};
        for (const Met& near : ray.met) {
          const int other = near.line < 0 ? near.strip + 1 : near.line;
          const EarthStrips::Shown shown = strips->shown(near.strip, other, shown_x);
          if (shown.cells.first > near.cell || near.cell - near.is_upright >= shown.cells.end ||
              shown.nearest_m > near.from_m + 1e-6 || shown.farthest_m < near.to_m - 1e-6)
            ++not_shown;
          for (const Met& far : ray.met) {
            // Two edges at one place have no order.
            const bool both_edges = near.from_m == near.to_m && far.from_m == far.to_m;
            if (&near == &far || !(near.to_m <= far.from_m + 1e-9)) continue;
            if (both_edges && far.from_m - near.to_m < 1e-6) continue;
            ++asked;
            if (near.turn >= far.turn) ++wrong;
          }
        }
      }
      CHECK(wrong == 0);
      CHECK(not_shown == 0);
    }
  }
  WARN(asked << " pairs in " << views << " orders, " << over
             << " of them with the eye over a strip, " << restless
             << " strips whose cells turn more than twice; " << none << " without; " << limited
             << " grids whose lean is limited");
  CHECK(limited > enough(10));
  CHECK(asked > enough(1e6));
  CHECK(over > enough(10));
  CHECK(restless > enough(12));
}

} // namespace orograph::earth_strips_test
