// SPDX-License-Identifier: GPL-3.0-or-later
// The frame's sides are planes in homogeneous page coordinates (x, y, w), in which a straight line
// stays straight: x - left * w >= 0 and so on. A crossing with a side is therefore found without
// dividing by w.
#include "draw/stroke_builder.hpp"

#include "draw/simplify.hpp"

#include <algorithm>

namespace orograph {
namespace {

// Rounding puts a point of a plane on either side of it: a picture that fills the frame touches its
// sides (in mm), and along the front and back plane, where they cut the terrain, lines lie in them.
constexpr double kInPlane = 1e-9;

StrokePoint between(const StrokePoint& a, const StrokePoint& b, double share) {
  return {a.plane + share * (b.plane - a.plane), point_between(a.scene, b.scene, share)};
}

} // namespace

void StrokeBuilder::begin(std::int32_t profile, double depth_m) {
  stroke_.profile = profile;
  stroke_.depth_m = depth_m;
  has_last_ = false;
}

// Left, right, above, below, back, front. That w >= 0 follows from back and front.
StrokeBuilder::Place StrokeBuilder::place_of(const StrokePoint& point) const {
  const Vec3 page = settings_.to_page.of(point.plane);
  const auto& [x, y, w] = page;
  const auto& [low, high] = settings_.frame_mm;
  double depth = -0.5 * w;
  if (const auto& d = settings_.depth)
    depth = d->per_u * point.scene.u + d->per_v * point.scene.v + d->per_z * point.scene.z +
            d->at_origin;
  const double slack = kInPlane * w;
  const PlaneValues values{x - low.x * w,  high.x * w - x,    y - low.y * w,
                           high.y * w - y, w + depth + slack, slack - depth};
  const bool inside = w > 0 && values[0] >= -slack && values[1] >= -slack && values[2] >= -slack &&
                      values[3] >= -slack && values[4] >= 0 && values[5] >= 0;
  return {page, values, inside};
}

void StrokeBuilder::append(const StrokePoint& point, const Vec3& page) {
  // A point cut at the frame may round to just outside of it.
  if (!(page.z > 0)) return; // the eye itself
  const Box2& frame = settings_.frame_mm;
  page_mm_.push_back({std::clamp(page.x / page.z, frame.low.x, frame.high.x),
                      std::clamp(page.y / page.z, frame.low.y, frame.high.y)});
  if (settings_.to_map) scene_.push_back(point.scene);
}

void StrokeBuilder::add(const StrokePoint& point) {
  const Place place = place_of(point);
  if (!has_last_) {
    if (place.inside) append(point, place.page);
  } else if (place.inside && last_place_.inside) {
    append(point, place.page);
  } else {
    const auto shares = clip_by_planes(last_place_.values, place.values);
    if (shares && shares->begin < shares->end) {
      if (!last_place_.inside) append(between(last_, point, shares->begin));
      append(place.inside ? point : between(last_, point, shares->end));
    } else if (place.inside) {
      append(point); // on the frame itself: nothing of the line so far, but it may go on
    }
    if (!place.inside) flush();
  }
  last_ = point;
  last_place_ = place;
  has_last_ = true;
}

void StrokeBuilder::end() {
  flush();
  has_last_ = false;
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
