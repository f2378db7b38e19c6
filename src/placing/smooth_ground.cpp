// SPDX-License-Identifier: GPL-3.0-or-later
#include "placing/smooth_ground.hpp"

#include "geometry/on_all_cores.hpp"
#include "profiles/cut_surface.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

namespace orograph {
namespace {

constexpr double kMostNodes = 4e6;

// What of the profile frame holds the terrain; of an ordinary perspective view no more than what
// its page shows.
Box2 bounds_of(const PlacedView& placed) {
  const View& view = placed.view;
  const Box3& box = placed.extent.box;
  Box2 out;
  for (int i = 0; i < 4; ++i) {
    const ProfilePoint p = to_profile_frame(
        view, {i % 2 == 0 ? box.low.x : box.high.x, i < 2 ? box.low.y : box.high.y, 0});
    out.include({p.u, p.v});
  }
  if (placed.panorama || !view.is_perspective() || placed.sectors.size() != 1) return out;
  const XRange range = page_range(placed.sectors.front());
  out.low.y = std::max(out.low.y, view.near_m);
  if (!std::isfinite(range.begin) || !std::isfinite(range.end)) return out;
  out.low.x = std::max(out.low.x, std::min(range.begin * out.low.y, range.begin * out.high.y));
  out.high.x = std::min(out.high.x, std::max(range.end * out.low.y, range.end * out.high.y));
  return out;
}

// A quadratic B-spline about the nearest node, at a place up to half a step from it.
struct Basis {
  std::array<double, 3> value, slope;
  explicit Basis(double t)
      : value{0.5 * (0.5 - t) * (0.5 - t), 0.75 - t * t, 0.5 * (0.5 + t) * (0.5 + t)},
        slope{t - 0.5, -2 * t, t + 0.5} {}
};

} // namespace

SmoothGround::SmoothGround(const Surface& surface, const PlacedView& placed, double over_mm)
    : placed_(placed), over_mm_(over_mm), bounds_m_(bounds_of(placed)) {
  if (!(bounds_m_.width() > 0 && bounds_m_.height() > 0)) return;
  node_m_ = std::max(placed.cell_m, std::sqrt(bounds_m_.width() * bounds_m_.height() / kMostNodes));
  sample(surface);
  add_levels();
}

void SmoothGround::sample(const Surface& surface) {
  const auto count = [&](double size_m) {
    return static_cast<std::size_t>(std::ceil(size_m / node_m_)) + 1;
  };
  Level level{count(bounds_m_.width()), count(bounds_m_.height()), {}};
  level.z_m.resize(level.columns * level.rows);
  const SurfaceCutter cutter(surface, placed_.view, placed_.level.triangles, placed_.for_cutters,
                             &placed_.extent.box);
  on_all_cores(level.rows, [&](std::size_t row) {
    thread_local HeightsAlong ground;
    cutter.heights(bounds_m_.low.y + static_cast<double>(row) * node_m_,
                   {bounds_m_.low.x, node_m_, level.columns}, ground);
    for (std::size_t i = 0; i < level.columns; ++i)
      level.z_m[row * level.columns + i] = static_cast<float>(ground.z_m[i]);
  });
  levels_.push_back(std::move(level));
}

// Each of half as many columns and rows, until there are few.
void SmoothGround::add_levels() {
  constexpr std::size_t kFew = 4;
  while (std::min(levels_.back().columns, levels_.back().rows) > kFew) {
    const Level& fine = levels_.back();
    Level coarse{(fine.columns + 1) / 2, (fine.rows + 1) / 2, {}};
    coarse.z_m.resize(coarse.columns * coarse.rows);
    on_all_cores(coarse.rows, [&](std::size_t row) {
      for (std::size_t i = 0; i < coarse.columns; ++i) {
        double sum = 0;
        int there = 0;
        for (std::size_t r = 2 * row; r < std::min(2 * row + 2, fine.rows); ++r)
          for (std::size_t c = 2 * i; c < std::min(2 * i + 2, fine.columns); ++c)
            if (const double z = fine.z_m[r * fine.columns + c]; !std::isnan(z)) {
              sum += z;
              ++there;
            }
        // A mean of less than half of a square is that of another place.
        coarse.z_m[row * coarse.columns + i] =
            there >= 2 ? static_cast<float>(sum / there) : std::numeric_limits<float>::quiet_NaN();
      }
    });
    levels_.push_back(std::move(coarse));
  }
}

// About the nearest node, which has to be there. Beside the border, and a void, the ground goes on
// as it comes: across the node from one that is there, or beside two that are.
SmoothGround::Spline SmoothGround::spline_at(std::size_t number, double u_m, double v_m) const {
  const Level& level = levels_[number];
  const double step_m = std::ldexp(node_m_, static_cast<int>(number));
  // A mean's place is the middle of its square.
  const double first_m = 0.5 * (step_m - node_m_);
  const double x = (u_m - bounds_m_.low.x - first_m) / step_m,
               y = (v_m - bounds_m_.low.y - first_m) / step_m;
  const auto columns = static_cast<std::int64_t>(level.columns),
             rows = static_cast<std::int64_t>(level.rows);
  if (!(x > -0.5 && y > -0.5 && x < static_cast<double>(columns) - 0.5 &&
        y < static_cast<double>(rows) - 0.5))
    return {};
  const auto column = static_cast<std::int64_t>(x + 0.5), row = static_cast<std::int64_t>(y + 0.5);
  const float* const at = level.z_m.data() + row * columns + column;
  const double middle = *at;
  if (std::isnan(middle)) return {};
  const auto node = [&](int c, int r) {
    const bool is_inside =
        column + c >= 0 && column + c < columns && row + r >= 0 && row + r < rows;
    return is_inside ? static_cast<double>(at[r * columns + c])
                     : std::numeric_limits<double>::quiet_NaN();
  };
  std::array<double, 9> heights;
  double all = 0;
  for (int i = 0; i < 9; ++i)
    all += heights[static_cast<std::size_t>(i)] = node(i % 3 - 1, i / 3 - 1);
  if (std::isnan(all)) {
    const auto height = [&](int c, int r) {
      const double here = node(c, r), across = 2 * middle - node(-c, -r);
      if (!std::isnan(here)) return here;
      if (!std::isnan(across)) return across;
      const double beside = c != 0 && r != 0 ? node(c, 0) + node(0, r) - middle : here;
      return std::isnan(beside) ? middle : beside;
    };
    for (int i = 0; i < 9; ++i) heights[static_cast<std::size_t>(i)] = height(i % 3 - 1, i / 3 - 1);
  }
  const Basis across(x - static_cast<double>(column)), along(y - static_cast<double>(row));
  Spline sum{};
  for (std::size_t r = 0; r < 3; ++r) {
    const double* const z = &heights[3 * r];
    const double value = across.value[0] * z[0] + across.value[1] * z[1] + across.value[2] * z[2],
                 slope = across.slope[0] * z[0] + across.slope[1] * z[1] + across.slope[2] * z[2];
    sum.z += along.value[r] * value;
    sum.per_u += along.value[r] * slope;
    sum.per_v += along.slope[r] * value;
  }
  sum.per_u /= step_m;
  sum.per_v /= step_m;
  sum.is_there = true;
  return sum;
}

std::optional<double> SmoothGround::nearest_node_m(double u_m, double v_m) const {
  const Level& level = levels_.front();
  const double x = (u_m - bounds_m_.low.x) / node_m_ + 0.5,
               y = (v_m - bounds_m_.low.y) / node_m_ + 0.5;
  if (!(x >= 0 && y >= 0 && x < static_cast<double>(level.columns) &&
        y < static_cast<double>(level.rows)))
    return std::nullopt;
  const double z =
      level.z_m[static_cast<std::size_t>(y) * level.columns + static_cast<std::size_t>(x)];
  return std::isnan(z) ? std::nullopt : std::optional(z);
}

std::optional<SmoothPlace> SmoothGround::at(double u_m, double v_m) const {
  if (levels_.empty()) return std::nullopt;
  const View& view = placed_.view;
  const std::optional<double> z_m = nearest_node_m(u_m, v_m);
  if (!z_m) return std::nullopt;
  const ProfilePoint here{u_m, v_m, *z_m};
  if (!(placed_.on_page(here).z > 0)) return std::nullopt;
  // To the right the page shows ground as it is, whatever its slope.
  Vec2 right{1, 0};
  if (placed_.panorama) right = (1 / std::hypot(u_m, v_m)) * Vec2{v_m, -u_m};
  const double mm_a_metre = placed_.mm_per_step(here, {right.x, right.y, 0});
  if (!(mm_a_metre > 0)) return std::nullopt;
  const double level = std::clamp(std::log2(over_mm_ / (mm_a_metre * node_m_)), 0.0,
                                  static_cast<double>(levels_.size() - 1));
  const auto lower = static_cast<std::size_t>(level);
  const double share = level - static_cast<double>(lower);
  Spline found = spline_at(lower, u_m, v_m);
  if (!found.is_there) return std::nullopt;
  if (share > 0) {
    const Spline coarse = spline_at(lower + 1, u_m, v_m);
    if (coarse.is_there) {
      found.z = std::lerp(found.z, coarse.z, share);
      found.per_u = std::lerp(found.per_u, coarse.per_u, share);
      found.per_v = std::lerp(found.per_v, coarse.per_v, share);
    }
  }
  SmoothPlace out{found.z,     found.per_u, found.per_v,
                  found.per_u, found.per_v, std::ldexp(node_m_, static_cast<int>(lower))};
  // What the frame let sink, and the ellipsoid's own curve, is no slope.
  const FrameDrop& drop = view.drop;
  out.up_u += 2 * drop.per_uu * u_m + drop.per_uv * v_m;
  out.up_v += 2 * drop.per_vv * v_m + drop.per_uv * u_m;
  if (placed_.curvature.on_ellipsoid) {
    const Vec2 ground = view.depth_origin_m + u_m * view.right + v_m * view.forward;
    const CurvatureRadii& radii = placed_.curvature.radii;
    const Vec2 sunk{ground.x / radii.prime_vertical_m, ground.y / radii.meridian_m};
    out.up_u += dot(sunk, view.right);
    out.up_v += dot(sunk, view.forward);
  }
  out.up_u /= placed_.exaggeration;
  out.up_v /= placed_.exaggeration;
  return out;
}

} // namespace orograph
