// SPDX-License-Identifier: GPL-3.0-or-later
// Along one vertical plane of rays, the ground's mean plane has a straight line as its picture.
// `PagePath` measures, in mm along it, how far a depth is from the nearest one; profiles stand at
// equal steps of that measure.
#include "profiles/plan.hpp"

#include "geometry/error.hpp"
#include "view/sectors.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace orograph {
namespace {

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

double first_depth(const PlanGround& ground, const View& view) {
  if (!view.is_perspective() || shows_beside(view)) return ground.nearest_m;
  return std::max(ground.nearest_m, view.near_m);
}

// Not beside the eye, where a profile would have no picture.
double beside_no_eye(double depth, const View& view) {
  return view.is_perspective() && std::abs(depth) < view.near_m ? kNearPlanesAhead * view.near_m
                                                                : depth;
}

class PagePath {
public:
  PagePath(const PlanGround& ground, const View& view, const Homography& to_page)
      : view_(view), to_page_(to_page), nearest_(first_depth(ground, view)),
        farthest_(ground.farthest_m),
        drop_(std::max(view.eye_z_m - ground.mean_z_m, kLeastDrop * ground.relief_m)) {
    if (drop_ <= 0) drop_ = 1e-3 * farthest_; // level ground at the eye's own height
    if (view.is_perspective() && view.frames_terrain && nearest_ < 0) {
      // Of a plane behind the picture plane there is no picture.
      const double nearest_seen = to_page.m[7] / to_page.m[8] * drop_;
      if (to_page.m[8] > 0 && nearest_ <= nearest_seen)
        nearest_ = nearest_seen + 1e-3 * (farthest_ - nearest_seen);
    }
    on_page_ = nearest_;
    if (view.is_perspective() && !view.frames_terrain) enter_page(ground.relief_m);
  }

  double length_mm() const { return before_page_mm_ + page_mm(on_page_, farthest_); }

  // The way that profiles share out between them: in a low view, where slopes and not the ground
  // fill the picture, no less than kLeastFill of its height.
  double filled_mm() const {
    const Vec2 centre = view_.window.centre();
    const double height_mm =
        length(on_page({centre.x, view_.window.high.y}) - on_page({centre.x, view_.window.low.y}));
    return std::max(length_mm(), kLeastFill * height_mm);
  }

  // The depth at a way along the path; bisection, since the measure rises with depth.
  double depth_at(double way_mm) const {
    if (way_mm <= before_page_mm_)
      return nearest_ + (on_page_ - nearest_) * (way_mm / before_page_mm_);
    double low = on_page_, high = farthest_;
    for (int step = 0; step < 100 && low < high; ++step) {
      const double middle = 0.5 * (low + high);
      if (middle <= low || middle >= high) break;
      (page_mm(on_page_, middle) < way_mm - before_page_mm_ ? low : high) = middle;
    }
    return 0.5 * (low + high);
  }

private:
  Vec2 on_page(Vec2 picture) const {
    const Vec3 image = to_page_.of(ray_of_picture(view_, picture));
    return {image.x / image.z, image.y / image.z};
  }
  Vec2 page_at(double depth) const {
    if (as_if_level_) return {0, mm_per_tangent_ * drop_ / depth};
    if (!view_.is_perspective()) return to_page_({0, depth * std::max(view_.y_per_v, kLeastSine)});
    const Vec3 image = to_page_.of({depth * u_per_depth_, -drop_, depth});
    return {image.x / image.z, image.y / image.z};
  }
  double page_mm(double from, double to) const { return length(page_at(to) - page_at(from)); }

  // Through the middle of the window, where that is well ahead; else along u = 0.
  Rays middle_rays() const {
    Vec3 at = ray_of_picture(view_, view_.window.centre());
    const double ahead = std::hypot(at.x, at.z);
    if (at.z > kLeastSine * length(at))
      return {at, {-at.y * at.x / ahead, ahead, -at.y * at.z / ahead}};
    at.x = 0;
    return {at, {0, at.z, -at.y}};
  }

  // In front of where the plane comes onto the page there may still be hills that stand on it: the
  // profiles go on there as far apart on the ground as where it does. A page that shows no ground
  // but hills above it (the eye looks up, or over all of the plane) is planned as if it looked
  // level.
  void enter_page(double relief_m) {
    const Rays middle = middle_rays();
    if (middle.at.z > 0) u_per_depth_ = middle.at.x / middle.at.z;
    // Down the picture from its middle to the page's end.
    const Vec3 centre = view_.to_picture.of(middle.at), above = view_.to_picture.of(middle.above);
    const Vec2 start{centre.x / centre.z, centre.y / centre.z};
    const Vec2 down{start.x * above.z - above.x, start.y * above.z - above.y};
    const auto reach = [](double begin, double step, double low, double high) {
      return step == 0 ? std::numeric_limits<double>::infinity()
                       : ((step < 0 ? low : high) - begin) / step;
    };
    const Box2& window = view_.window;
    const double way = std::max(0.0, std::min(reach(start.x, down.x, window.low.x, window.high.x),
                                              reach(start.y, down.y, window.low.y, window.high.y)));
    const Vec3 lowest = ray_of_picture(view_, start + way * down);
    as_if_level_ = !(lowest.y < 0 && -lowest.y * farthest_ > drop_ * lowest.z);
    const double entered = as_if_level_ ? drop_ / way : drop_ * lowest.z / -lowest.y;
    if (as_if_level_) {
      const Vec3 page = to_page_.of(middle.at), page_above = to_page_.of(middle.above);
      mm_per_tangent_ = std::hypot(page_above.x - page.x / page.z * page_above.z,
                                   page_above.y - page.y / page.z * page_above.z) /
                        page.z;
    }
    // Behind the eye, where the ray has gone down through all heights nothing more can stand.
    if (entered < 0) nearest_ = std::max(nearest_, entered * (1 + relief_m / drop_));
    on_page_ = std::clamp(entered, nearest_, farthest_);
    const double step = 1e-3 * std::abs(on_page_);
    if (on_page_ > nearest_)
      before_page_mm_ = page_mm(on_page_, on_page_ + step) / step * (on_page_ - nearest_);
  }

  const View& view_;
  const Homography& to_page_;
  double nearest_, farthest_, drop_;
  double on_page_, before_page_mm_ = 0;
  double u_per_depth_ = 0; ///< of the ground under the path
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
  if (count > kMostProfiles)
    throw Error("that spacing makes more than 100000 profiles", "use a wider --spacing");
}

} // namespace

std::vector<double> plan_depths(const PlanRequest& request, const PlanGround& ground,
                                const View& view, const Homography& to_page) {
  if (const auto* spacing = std::get_if<GroundSpacing>(&request)) {
    const double from = first_depth(ground, view);
    const double count = std::max(1.0, std::round((ground.farthest_m - from) / spacing->m));
    check_count(count);
    std::vector<double> depths;
    for (int i = 0; i < count; ++i) {
      const double depth = beside_no_eye(from + (i + 0.5) * spacing->m, view);
      if (depth < ground.farthest_m && (depths.empty() || depth > depths.back()))
        depths.push_back(depth);
    }
    if (depths.empty()) depths.push_back(0.5 * (from + ground.farthest_m)); // wider than the ground
    return depths;
  }
  const PagePath path(ground, view, to_page);
  if (const auto* number = std::get_if<ProfileCount>(&request))
    return evenly_on_page(number->count, path, view);
  const double count =
      std::max(1.0, std::round(path.filled_mm() / std::get<PageSpacing>(request).mm));
  check_count(count);
  return evenly_on_page(count, path, view);
}

} // namespace orograph
