// SPDX-License-Identifier: GPL-3.0-or-later
// Along X = 0, the plane's picture is a straight line on the page. `PagePath` measures, in mm along
// it, how far a depth is from the nearest one; profiles stand at equal steps of that measure.
#include "profiles/plan.hpp"

#include "geometry/error.hpp"
#include "view/place_view.hpp"

#include <algorithm>
#include <cmath>

namespace orograph {
namespace {

constexpr double kMostProfiles = 1e5;

// A parallel view that descends by less than this shows slopes, not ground: sin 6 degrees.
constexpr double kLeastSine = 0.1;
// The plane lies at least this share of the relief under the eye.
constexpr double kLeastDrop = 0.5;
// From 25 degrees the ground takes up about 0.8 of a mountain picture's height, from 5 degrees 0.3.
constexpr double kLeastFill = 2.0 / 3;

class PagePath {
public:
  PagePath(const PlanGround& ground, const View& view, const Homography& to_page)
      : view_(view), to_page_(to_page), nearest_(ground.nearest_m), farthest_(ground.farthest_m),
        drop_(std::max(view.eye_z_m - ground.mean_z_m, kLeastDrop * ground.relief_m)) {
    if (view.is_perspective()) nearest_ = std::max(nearest_, view.near_m);
    if (drop_ <= 0) drop_ = 1e-3 * farthest_; // level ground at the eye's own height
    on_page_ = nearest_;
    if (!view.frames_terrain) enter_page();
  }

  double length_mm() const { return before_page_mm_ + page_mm(on_page_, farthest_); }

  // The way that profiles share out between them: in a low view, where slopes and not the ground
  // fill the picture, no less than kLeastFill of its height.
  double filled_mm() const {
    const auto at = [&](double y) { return to_page_(plane_of_picture(view_, {0, y})); };
    const double height_mm = length(at(view_.window.high.y) - at(view_.window.low.y));
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
  Vec2 page_at(double depth) const {
    if (as_if_level_) return {0, mm_per_picture_ * drop_ / depth};
    if (view_.is_perspective()) return to_page_({0, -drop_ / depth});
    return to_page_({0, depth * std::max(view_.y_per_v, kLeastSine)});
  }
  double page_mm(double from, double to) const { return length(page_at(to) - page_at(from)); }

  // In front of where the plane comes onto the page there may still be hills that stand on it: the
  // profiles go on there as far apart on the ground as where it does. A page that shows no ground
  // but hills above it (the eye looks up, or over all of the plane) is planned as if it looked
  // level.
  void enter_page() {
    const double s = sin(view_.roll), c = cos(view_.roll);
    const double down = std::min(view_.window.high.x / std::abs(s), // along X = 0 to the page's end
                                 view_.window.high.y / std::abs(c));
    double lowest = plane_of_picture(view_, {-down * s, -down * c}).y;
    as_if_level_ = !(-lowest * farthest_ > drop_);
    if (as_if_level_) {
      lowest = -down;
      const Vec2 axis = plane_of_picture(view_, {0, 0});
      mm_per_picture_ = to_page_.mm_per_y(axis) / view_.to_picture.mm_per_y(axis);
    }
    on_page_ = std::clamp(drop_ / -lowest, nearest_, farthest_);
    const double step = 1e-3 * on_page_;
    if (on_page_ > nearest_)
      before_page_mm_ = page_mm(on_page_, on_page_ + step) / step * (on_page_ - nearest_);
  }

  const View& view_;
  const Homography& to_page_;
  double nearest_, farthest_, drop_;
  double on_page_, before_page_mm_ = 0;
  bool as_if_level_ = false;
  double mm_per_picture_ = 1;
};

std::vector<double> evenly_on_page(double count, const PagePath& path) {
  std::vector<double> depths;
  const double step = path.length_mm() / count;
  for (int i = 0; i < count; ++i) {
    const double depth = path.depth_at((i + 0.5) * step);
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
    const double from =
        view.is_perspective() ? std::max(ground.nearest_m, view.near_m) : ground.nearest_m;
    const double count = std::max(1.0, std::round((ground.farthest_m - from) / spacing->m));
    check_count(count);
    std::vector<double> depths;
    for (int i = 0; i < count; ++i) {
      const double depth = from + (i + 0.5) * spacing->m;
      if (depth < ground.farthest_m && (depths.empty() || depth > depths.back()))
        depths.push_back(depth);
    }
    if (depths.empty()) depths.push_back(0.5 * (from + ground.farthest_m)); // wider than the ground
    return depths;
  }
  const PagePath path(ground, view, to_page);
  if (const auto* number = std::get_if<ProfileCount>(&request))
    return evenly_on_page(number->count, path);
  const double count =
      std::max(1.0, std::round(path.filled_mm() / std::get<PageSpacing>(request).mm));
  check_count(count);
  return evenly_on_page(count, path);
}

} // namespace orograph
