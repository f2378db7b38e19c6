// SPDX-License-Identifier: GPL-3.0-or-later
// The frame's sides are planes in homogeneous page coordinates (x, y, w), in which a straight line
// stays straight: x - left * w >= 0 and so on. A crossing with a side is therefore found without
// dividing by w.
#include "draw/stroke_builder.hpp"

#include "draw/simplify.hpp"

#include <algorithm>

namespace orograph {
namespace {

StrokePoint between(const StrokePoint& a, const StrokePoint& b, double share) {
  return {a.plane + share * (b.plane - a.plane), point_between(a.scene, b.scene, share)};
}

} // namespace

void StrokeBuilder::begin(std::int32_t profile, double depth_m) {
  stroke_.profile = profile;
  stroke_.depth_m = depth_m;
  last_.reset();
}

// That w >= 0 follows from back and front.
PlaneValues StrokeBuilder::plane_values(const StrokePoint& point, const Vec3& page) const {
  const auto& [x, y, w] = page;
  const auto& [low, high] = settings_.frame_mm;
  double depth = -0.5 * w;
  if (const auto& d = settings_.depth)
    depth = d->per_u * point.scene.u + d->per_v * point.scene.v + d->per_z * point.scene.z +
            d->at_origin;
  const double slack = kInPlane * w;
  return {x - low.x * w,  high.x * w - x,    y - low.y * w,
          high.y * w - y, w + depth + slack, slack - depth};
}

void StrokeBuilder::add_clipped(const StrokePoint& point, const Vec3& page) {
  const PlaneValues values = plane_values(point, page);
  const bool inside = is_in_frame(page) && values[4] >= 0 && values[5] >= 0;
  if (!last_) {
    if (inside) append(point, page);
  } else if (inside && last_->inside) {
    append(point, page);
  } else {
    const PlaneValues last_values =
        plane_values(last_->point, settings_.to_page.of(last_->point.plane));
    const auto shares = clip_by_planes(last_values, values);
    if (shares && shares->begin < shares->end) {
      if (!last_->inside) append(between(last_->point, point, shares->begin));
      append(inside ? point : between(last_->point, point, shares->end));
    } else if (inside) {
      append(point, page); // on the frame itself: nothing of the line so far, but it may go on
    }
    if (!inside) flush();
  }
  last_ = {point, inside};
}

void StrokeBuilder::end() {
  flush();
  last_.reset();
}

bool StrokeBuilder::is_long_enough() {
  if (page_mm_.size() < 2) return false;
  if (settings_.min_stroke_mm <= 0) return true;
  double length_mm = 0;
  for (std::size_t i = 1; i < page_mm_.size(); ++i) {
    length_mm += length(page_mm_[i] - page_mm_[i - 1]);
    if (length_mm >= settings_.min_stroke_mm) return true;
  }
  left_out_mm_ += length_mm;
  return false;
}

void StrokeBuilder::flush() {
  if (is_long_enough()) {
    simplify(page_mm_, settings_.simplify_mm, kept_);
    stroke_.first_point = static_cast<std::uint32_t>(layer_.page_mm.size());
    stroke_.point_count = static_cast<std::uint32_t>(kept_.size());
    for (const std::uint32_t i : kept_) {
      layer_.page_mm.push_back(page_mm_[i]);
      if (settings_.to_map) layer_.map.push_back(settings_.to_map(scene_[i]));
    }
    layer_.strokes.push_back(stroke_);
  }
  page_mm_.clear();
  scene_.clear();
}

} // namespace orograph
