// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/page/page_ground.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace orograph {
namespace {

// Places that are closer on the page are the same.
constexpr double kSame_mm = 1e-4;
constexpr int kFirstParts = 4;

// A number that changes along a ray with depth w.
struct AlongRay {
  double at_zero, per_m;
  double operator()(double w) const { return at_zero + w * per_m; }
  // The next depth behind w at which it is whole; a cell's billionth on counts as there.
  double next_whole(double w) const {
    if (per_m == 0) return kInfinity;
    const double number = (*this)(w);
    constexpr double kPassed = 1e-9;
    const double whole =
        per_m > 0 ? std::floor(number + kPassed) + 1 : std::ceil(number - kPassed) - 1;
    return (whole - at_zero) / per_m;
  }
  // Keeps of a range of depths where it is from 0 to `highest`.
  void keep_within(double highest, double& begin, double& end) const {
    if (per_m == 0) {
      if (at_zero < 0 || at_zero > highest) end = -kInfinity;
      return;
    }
    const double at_low = -at_zero / per_m, at_high = (highest - at_zero) / per_m;
    begin = std::max(begin, std::min(at_low, at_high));
    end = std::min(end, std::max(at_low, at_high));
  }
};

} // namespace

PageGround::PageGround(const Grid& grid, const PlacedView& placed)
    : grid_(grid), placed_(placed), water_(find_water(grid)) {
  for (const Sector& sector : placed.sectors) to_rays_.push_back(inverse(sector.to_page));
  const auto& [first, column_m, row_m] = grid.plane();
  const double area = cross(column_m, row_m);
  columns_per_m_ = (1 / area) * Vec2{row_m.y, -row_m.x};
  rows_per_m_ = (1 / area) * Vec2{-column_m.y, column_m.x};
}

std::optional<ShownGround> PageGround::at(Vec2 page_mm) const {
  const Box2& frame = placed_.frame_mm;
  if (page_mm.x < frame.low.x || page_mm.x > frame.high.x || page_mm.y < frame.low.y ||
      page_mm.y > frame.high.y)
    return std::nullopt;
  for (std::size_t i = 0; i < to_rays_.size(); ++i) {
    const Vec3 ray = to_rays_[i].of({page_mm.x, page_mm.y, 1});
    if (ray.z > 0) return on_ray(placed_.sectors[i], {ray.x / ray.z, ray.y / ray.z});
  }
  return std::nullopt;
}

std::optional<ShownGround> PageGround::on_ray(const Sector& sector, Vec2 ray) const {
  const View& view = sector.view;
  const bool perspective = view.is_perspective();
  // The ray's vertical plane meets the ground along a straight line.
  const AlongRay u = perspective ? AlongRay{0, ray.x} : AlongRay{ray.x, -view.x_per_v};
  const auto place_m = [&](double w) {
    return view.depth_origin_m + u(w) * view.right + w * view.forward;
  };
  const Vec2 from_first = place_m(0) - grid_.plane().first_vertex_m,
             per_m = u.per_m * view.right + view.forward;
  const AlongRay column{dot(columns_per_m_, from_first), dot(columns_per_m_, per_m)},
      row{dot(rows_per_m_, from_first), dot(rows_per_m_, per_m)},
      diagonal{column.at_zero - row.at_zero, column.per_m - row.per_m};
  double begin = perspective ? view.near_m : -kInfinity, end = kInfinity;
  column.keep_within(grid_.columns - 1, begin, end);
  row.keep_within(grid_.rows - 1, begin, end);

  // How far a height is above the ray, to a factor; linear on a triangle.
  const auto above = [&](double z, double w) {
    return perspective ? z - view.eye_z_m - ray.y * w : z * view.y_per_z + w * view.y_per_v - ray.y;
  };
  bool has_ground_before = false;
  for (double w = begin; w < end;) {
    const double next =
        std::min({end, column.next_whole(w), row.next_whole(w), diagonal.next_whole(w)});
    const double middle = 0.5 * (w + next);
    const int c = std::clamp(static_cast<int>(column(middle)), 0, grid_.columns - 2),
              r = std::clamp(static_cast<int>(row(middle)), 0, grid_.rows - 2);
    const Half half = column(middle) - c > row(middle) - r ? Half::upper : Half::lower;
    const auto z_m = [&](int right, int down) {
      return to_profile_frame(view, grid_.vertex_m(c + right, r + down)).z;
    };
    const double here = z_m(0, 0), opposite = z_m(1, 1);
    const double third = half == Half::upper ? z_m(1, 0) : z_m(0, 1);
    const double per_column = half == Half::upper ? third - here : opposite - third,
                 per_row = half == Half::upper ? opposite - third : third - here;
    const auto z_at = [&](double depth) {
      return here + (column(depth) - c) * per_column + (row(depth) - r) * per_row;
    };
    const double before = above(z_at(w), w), after = above(z_at(next), next);
    if (std::isnan(before + after)) {
      has_ground_before = false;
    } else {
      if (!has_ground_before && before > 0) return std::nullopt; // it passes below an edge
      if (after >= 0) {
        const double share = before < 0 ? before / (before - after) : 0;
        const double met = w + share * (next - w);
        if (met < view.drawn_from_m) return std::nullopt;
        const Vec2 slope = per_column * columns_per_m_ + per_row * rows_per_m_;
        const double steepness = length(Vec3{slope.x, slope.y, 1});
        return ShownGround{&sector,
                           {u(met), met, z_at(met)},
                           (1 / steepness) * Vec3{-slope.x, -slope.y, 1},
                           !water_.triangles.empty() &&
                               water_.triangles.has(grid_triangle(grid_, c, r, half))};
      }
      has_ground_before = true;
    }
    w = next;
  }
  return std::nullopt;
}

bool PageGround::jumps_between(Vec2 from_mm, Vec2 to_mm) const {
  std::optional<ShownGround> last = at(from_mm);
  Vec2 last_mm = from_mm;
  for (int i = 1; i <= kFirstParts && last; ++i) {
    const Vec2 next_mm = from_mm + (static_cast<double>(i) / kFirstParts) * (to_mm - from_mm);
    const std::optional<ShownGround> next = at(next_mm);
    if (!next || jumps_between(last_mm, *last, next_mm, *next)) return true;
    last = next;
    last_mm = next_mm;
  }
  return !last;
}

bool PageGround::jumps_between(Vec2 from_mm, const ShownGround& from, Vec2 to_mm,
                               const ShownGround& to) const {
  if (from.sector != to.sector) return true;
  const Sector& sector = *from.sector;
  const double extent_m = sector.view.is_perspective() ? std::min(from.at.v, to.at.v)
                                                       : sector.farthest_m - sector.nearest_m;
  if (std::abs(from.at.v - to.at.v) <= Style{}.silhouette_jump * extent_m) return false;
  if (length(to_mm - from_mm) <= kSame_mm) return true;
  const Vec2 middle_mm = 0.5 * (from_mm + to_mm);
  const std::optional<ShownGround> middle = at(middle_mm);
  return !middle || jumps_between(from_mm, from, middle_mm, *middle) ||
         jumps_between(middle_mm, *middle, to_mm, to);
}

} // namespace orograph
