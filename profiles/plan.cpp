// SPDX-License-Identifier: GPL-3.0-or-later
#include "profiles/plan.hpp"

#include "geometry/error.hpp"
#include "view/sectors.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
#include <limits>

namespace orograph {
namespace {

DepthRange in_parallel(const PlanGround& ground, const View& view) {
  double low = kInfinity, high = -kInfinity;
  for (const Vec3& ray : corner_rays(view)) {
    low = std::min(low, ray.y);
    high = std::max(high, ray.y);
  }
  const double middle = ground.mean_z_m * view.y_per_z, relief = ground.relief_m * view.y_per_z;
  if (!(view.y_per_v > 0)) return {-kInfinity, kInfinity}; // Y tells nothing of depth
  // Far off, ground has sunk, or risen, by the earth's curvature.
  const double farthest_m = std::max(std::abs(ground.nearest_m), std::abs(ground.farthest_m));
  const double sunk = std::abs(view.drop.at(0, farthest_m)) * view.y_per_z;
  return {(low - middle - relief - sunk) / view.y_per_v,
          (high - middle + relief + sunk) / view.y_per_v};
}

DepthRange in_perspective(const PlanGround& ground, const View& view) {
  const std::array<Vec3, 4> rays = corner_rays(view);
  // Of ground, from the eye's height; it sinks by the earth's curvature.
  const double mean = ground.mean_z_m - view.eye_z_m;
  const double sunk =
      std::abs(view.drop.at(0, std::max(std::abs(ground.nearest_m), ground.farthest_m)));
  const double top = mean + ground.relief_m, bottom = mean - ground.relief_m - sunk;
  const auto all = [&](auto holds) { return std::ranges::all_of(rays, holds); };
  const bool down = all([](Vec3 r) { return r.y < 0; }), up = all([](Vec3 r) { return r.y > 0; });
  const bool ahead = all([](Vec3 r) { return r.z > 0; });
  if ((down && bottom >= 0) || (up && top <= 0)) return {0, 0};
  DepthRange range{kInfinity, -kInfinity};
  const auto take = [&](Vec3 ray, double height) {
    const double depth = ray.z * height / ray.y;
    range.nearest_m = std::min(range.nearest_m, depth);
    range.farthest_m = std::max(range.farthest_m, depth);
  };
  if (down || up) {
    for (const Vec3& ray : rays)
      for (const double height :
           {down ? bottom : std::max(bottom, 0.0), down ? std::min(top, 0.0) : top})
        take(ray, height);
    return range;
  }
  // Level rays are among them, which may meet ground at any distance.
  if (!ahead) return {-kInfinity, kInfinity};
  for (const Vec3& ray : rays)
    if (ray.y < 0) take(ray, std::min(top, 0.0));
  return {top > 0 ? 0 : range.nearest_m, kInfinity};
}

} // namespace

DepthRange shown_depths(const PlanGround& ground, const View& view) {
  DepthRange range{ground.nearest_m, ground.farthest_m};
  if (view.is_perspective() && !shows_beside(view))
    range.nearest_m = std::max(range.nearest_m, view.near_m);
  if (view.frames_terrain) return range;
  const DepthRange shown =
      view.is_perspective() ? in_perspective(ground, view) : in_parallel(ground, view);
  range.nearest_m =
      std::clamp(shown.nearest_m, range.nearest_m, std::max(range.nearest_m, range.farthest_m));
  range.farthest_m =
      std::clamp(shown.farthest_m, range.nearest_m, std::max(range.nearest_m, range.farthest_m));
  return range;
}

namespace {

// Along one vertical plane of rays, the ground's mean plane has a straight line as its picture.
// `PagePath` measures, in mm along it, how far a depth is from the nearest one; profiles stand at
// equal steps of that measure.

constexpr double kMostProfiles = 1e5;

// A parallel view that descends by less than this shows slopes, not ground: sin 6 degrees.
constexpr double kLeastSine = 0.1;
// The plane lies at least this share of the relief under the eye.
constexpr double kLeastDrop = 0.5;
// From 25 degrees the ground takes up about 0.8 of a mountain picture's height, from 5 degrees 0.3.
constexpr double kLeastFill = 2.0 / 3;

// A ray, and the one a right angle above it, in the homogeneous coordinates of the visibility
// plane.
struct Rays {
  Vec3 at, above;
};

// Not beside the eye, where a profile would have no picture; nor so close to that plane that what
// hides it is cut away.
double beside_no_eye(double depth, const View& view) {
  if (!view.is_perspective()) return depth;
  const double ahead_m = kNearPlanesAhead * view.near_m;
  if (std::abs(depth) >= (shows_beside(view) ? ahead_m : view.near_m)) return depth;
  return depth < -view.near_m ? -ahead_m : ahead_m;
}

// length(a) < way, for which squares mostly do.
bool is_shorter(Vec2 a, double way) {
  constexpr double kRounding = 8 * std::numeric_limits<double>::epsilon();
  const double square = dot(a, a), asked = way * way;
  if (std::abs(square - asked) > kRounding * asked) return square < asked;
  return length(a) < way;
}

class PagePath {
public:
  PagePath(const PlanGround& ground, const DepthRange& range, const View& view,
           const Homography& to_page)
      : view_(view), to_page_(to_page), nearest_(range.nearest_m), farthest_(range.farthest_m),
        relief_(ground.relief_m),
        drop_(std::max(view.eye_z_m - ground.mean_z_m, kLeastDrop * ground.relief_m)) {
    // From below the plane is above the eye.
    if (view.is_perspective() && view.frames_terrain && view.elevation < Angle())
      drop_ = -std::max(ground.mean_z_m - view.eye_z_m, kLeastDrop * ground.relief_m);
    else if (drop_ <= 0)
      drop_ = 1e-3 * farthest_; // level ground at the eye's own height
    enters_ = nearest_;
    leaves_ = farthest_;
    if (!view.is_perspective()) return;
    if (view.frames_terrain)
      lower_plane();
    else
      cross_page(ground.farthest_m);
  }

  double length_mm() const { return before_mm() + page_mm(enters_, leaves_) + after_mm(); }

  // The way that profiles share out between them: in a low view, where slopes and not the ground
  // fill the picture, no less than kLeastFill of its height, as far as the terrain is that high.
  double filled_mm() const {
    const Vec2 centre = view_.window.centre();
    double height_mm =
        length(on_page({centre.x, view_.window.high.y}) - on_page({centre.x, view_.window.low.y}));
    if (!view_.frames_terrain) {
      const double middle = 0.5 * (enters_ + leaves_);
      const Vec2 foot = page_at(middle), top = page_at(middle, relief_);
      height_mm = std::min(height_mm, length_mm() + length(top - foot));
    }
    return std::max(length_mm(), kLeastFill * height_mm);
  }

  // The depth at a way along the path; bisection, since the measure rises with depth.
  double depth_at(double way_mm) const {
    if (way_mm < before_mm()) return nearest_ + (enters_ - nearest_) * (way_mm / before_mm());
    way_mm -= before_mm();
    const double on_page_mm = page_mm(enters_, leaves_);
    if (way_mm > on_page_mm)
      return leaves_ + (farthest_ - leaves_) * std::min(1.0, (way_mm - on_page_mm) / after_mm());
    const Vec2 begin = page_at(enters_);
    double low = enters_, high = leaves_;
    for (int step = 0; step < 100 && low < high; ++step) {
      const double middle = 0.5 * (low + high);
      if (middle <= low || middle >= high) break;
      (is_shorter(page_at(middle) - begin, way_mm) ? low : high) = middle;
    }
    return 0.5 * (low + high);
  }

  /// Whether it is planned as if the page showed level ground ahead.
  bool is_as_if_level() const { return as_if_level_; }

private:
  Vec2 on_page(Vec2 picture) const { return to_page_.at(ray_of_picture(view_, picture)); }
  Vec2 page_at(double depth, double above_plane = 0) const {
    if (as_if_level_) return {0, mm_per_tangent_ * (drop_ - above_plane) / depth};
    if (!view_.is_perspective())
      return to_page_(
          {0, depth * std::max(std::abs(view_.y_per_v), kLeastSine) + above_plane * view_.y_per_z});
    return to_page_.at({depth * u_per_depth_, above_plane - drop_, depth});
  }
  double page_mm(double from, double to) const { return length(page_at(to) - page_at(from)); }

  // Hills in front of where the plane comes onto the page, and valleys behind where it leaves it,
  // may show as well: there profiles are as far apart on the ground as at that place.
  double mm_per_m(double depth) const {
    const double step = 1e-3 * (view_.is_perspective() ? std::hypot(depth, drop_) : 1);
    return page_mm(depth, depth + step) / step;
  }
  double before_mm() const {
    return enters_ > nearest_ ? mm_per_m(enters_) * (enters_ - nearest_) : 0;
  }
  double after_mm() const {
    return farthest_ > leaves_ ? mm_per_m(leaves_) * (farthest_ - leaves_) : 0;
  }

  // Where ground under the eye and behind it is framed: the plane has a picture only in front of
  // the picture plane, so that it is taken lower, or not as far back.
  void lower_plane() {
    const double up = to_page_.m[7], ahead = to_page_.m[8];
    if (!(nearest_ < 0 && ahead > 0 && up < 0)) return;
    drop_ = std::max(drop_, std::min(1.05 * nearest_ * ahead / up, drop_ + relief_));
    const double seen_from = drop_ * up / ahead;
    nearest_ = std::max(nearest_, seen_from + 1e-3 * (farthest_ - seen_from));
    enters_ = nearest_;
  }

  // Through the middle of the window, where that is well ahead; else along u = 0.
  Rays middle_rays() const {
    Vec3 at = ray_of_picture(view_, view_.window.centre());
    const double ahead = std::hypot(at.x, at.z);
    if (at.z > kLeastSine * length(at))
      return {at, {-at.y * at.x / ahead, ahead, -at.y * at.z / ahead}};
    at.x = 0;
    return {at, {0, at.z, -at.y}};
  }

  // Finds where the plane comes onto the page and leaves it. A page that shows no ground but hills
  // above it (the eye looks up, or over all of the plane) is planned as if it looked level.
  void cross_page(double farthest_m) {
    const Rays middle = middle_rays();
    if (middle.at.z > 0) u_per_depth_ = middle.at.x / middle.at.z;
    // Down the picture from its middle to the page's end, and up.
    const Vec3 above = view_.to_picture.of(middle.above);
    const Vec2 start = view_.to_picture.at(middle.at);
    const Vec2 down{start.x * above.z - above.x, start.y * above.z - above.y};
    const auto way_along = [&](Vec2 step) {
      const Box2& window = view_.window;
      const auto reach = [](double begin, double change, double low, double high) {
        return change == 0 ? kInfinity : ((change < 0 ? low : high) - begin) / change;
      };
      return std::max(0.0, std::min(reach(start.x, step.x, window.low.x, window.high.x),
                                    reach(start.y, step.y, window.low.y, window.high.y)));
    };
    const double way = way_along(down);
    const Vec3 lowest = ray_of_picture(view_, start + way * down),
               highest = ray_of_picture(view_, start - way_along(-1.0 * down) * down);
    as_if_level_ = !(lowest.y < 0 && -lowest.y * farthest_m > drop_ * lowest.z);
    double enters = drop_ * lowest.z / -lowest.y, leaves = farthest_;
    if (as_if_level_) {
      mm_per_tangent_ = to_page_.mm_per_step(middle.at, middle.above);
      enters = drop_ / way;
    } else if (highest.y < 0) {
      leaves = drop_ * highest.z / -highest.y;
    }
    enters_ = std::clamp(enters, nearest_, farthest_);
    leaves_ = std::clamp(leaves, enters_, farthest_);
  }

  const View& view_;
  const Homography& to_page_;
  double nearest_, farthest_; ///< depths that are planned
  double relief_, drop_;
  double enters_ = 0, leaves_ = 0; ///< between them the plane is on the page
  double u_per_depth_ = 0;         ///< of the ground under the path
  bool as_if_level_ = false;
  double mm_per_tangent_ = 1; ///< about the middle of the picture
};

std::vector<double> evenly_on_page(double count, const PagePath& path, const View& view) {
  std::vector<double> depths;
  const double step = path.length_mm() / count;
  for (int i = 0; i < count; ++i) {
    const double depth = beside_no_eye(path.depth_at((i + 0.5) * step), view);
    if (depths.empty() || depth > depths.back()) depths.push_back(depth);
  }
  return depths;
}

void check_count(double count) {
  if (!(count <= kMostProfiles))
    throw Error("that spacing makes more than 100000 profiles", "use a wider `plan`");
}

// A spacing may be written with fewer digits than the grid's step has: over the whole grid that may
// add up to this share of a step.
constexpr double kRowRounding = 0.05;

// Every so many of the grid's rows, if the spacing is a whole number of them: those in the middle
// of steps or next behind it, none on the ends.
std::vector<double> along_rows(double spacing_m, const std::vector<double>& rows_m,
                               double nearest_m, const View& view) {
  std::vector<double> depths;
  if (rows_m.size() < 3) return depths;
  const auto steps = static_cast<double>(rows_m.size() - 1);
  const double per_spacing = spacing_m * steps / (rows_m.back() - rows_m.front()),
               whole = std::round(per_spacing);
  if (!(whole >= 1 && whole < steps) || std::abs(per_spacing / whole - 1) * steps > kRowRounding)
    return depths;
  const auto every = static_cast<std::size_t>(whole);
  for (std::size_t i = (every + 1) / 2; i + 1 < rows_m.size(); i += every) {
    if (rows_m[i] <= nearest_m) continue;
    const double depth = beside_no_eye(rows_m[i], view);
    if (depths.empty() || depth > depths.back()) depths.push_back(depth);
  }
  check_count(static_cast<double>(depths.size()));
  return depths;
}

std::vector<double> evenly_on_ground(double spacing_m, const DepthRange& range, const View& view) {
  const double count = std::max(1.0, std::round((range.farthest_m - range.nearest_m) / spacing_m));
  check_count(count);
  std::vector<double> depths;
  for (int i = 0; i < count; ++i) {
    const double depth = beside_no_eye(range.nearest_m + (i + 0.5) * spacing_m, view);
    if (depth < range.farthest_m && (depths.empty() || depth > depths.back()))
      depths.push_back(depth);
  }
  if (depths.empty()) // wider than the ground
    depths.push_back(0.5 * (range.nearest_m + range.farthest_m));
  return depths;
}

// Looking up there is a plan ahead of the eye and one behind it, each as if it were level there.
std::vector<double> on_both_sides(const PlanRequest& request, const PlanGround& ground,
                                  const DepthRange& range, const View& view,
                                  const Homography& to_page) {
  const double near_m = kNearPlanesAhead * view.near_m;
  const PagePath behind({near_m, -range.nearest_m, ground.mean_z_m, ground.relief_m},
                        {near_m, -range.nearest_m}, view, to_page);
  const PagePath ahead(ground, {near_m, range.farthest_m}, view, to_page);
  double of_behind = 0, of_ahead = 0;
  if (const auto* number = std::get_if<ProfileCount>(&request)) {
    const double share = behind.length_mm() / (behind.length_mm() + ahead.length_mm());
    of_behind = std::round(share * number->count);
    of_ahead = number->count - of_behind;
  } else {
    const double spacing_mm = std::get<PageSpacing>(request).mm;
    of_behind = std::max(1.0, std::round(behind.filled_mm() / spacing_mm));
    of_ahead = std::max(1.0, std::round(ahead.filled_mm() / spacing_mm));
  }
  check_count(of_behind + of_ahead);
  std::vector<double> depths = evenly_on_page(of_behind, behind, view);
  for (double& depth : depths) depth = -depth;
  std::ranges::reverse(depths);
  for (const double depth : evenly_on_page(of_ahead, ahead, view)) depths.push_back(depth);
  return depths;
}

} // namespace

std::vector<double> plan_depths(const PlanRequest& request, const PlanGround& ground,
                                const View& view, const Homography& to_page) {
  if (const auto* spacing = std::get_if<GroundSpacing>(&request)) {
    DepthRange all{ground.nearest_m, ground.farthest_m};
    if (view.is_perspective() && !shows_beside(view))
      all.nearest_m = std::max(all.nearest_m, view.near_m);
    std::vector<double> rows = along_rows(spacing->m, ground.row_depths_m, all.nearest_m, view);
    return rows.empty() ? evenly_on_ground(spacing->m, all, view) : rows;
  }
  const DepthRange range = shown_depths(ground, view);
  const PagePath path(ground, range, view, to_page);
  if (path.is_as_if_level() && range.nearest_m < 0 && range.farthest_m > 0)
    return on_both_sides(request, ground, range, view, to_page);
  if (const auto* number = std::get_if<ProfileCount>(&request))
    return evenly_on_page(number->count, path, view);
  const double count =
      std::max(1.0, std::round(path.filled_mm() / std::get<PageSpacing>(request).mm));
  check_count(count);
  return evenly_on_page(count, path, view);
}

} // namespace orograph
