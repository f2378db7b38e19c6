// SPDX-License-Identifier: GPL-3.0-or-later
// The frame's sides are half-planes in homogeneous page coordinates (x, y, w), in which a straight
// line stays straight: x - left * w >= 0 and so on, and w > 0 in front of the picture plane. A
// crossing with a side is therefore found without dividing by w (Liang and Barsky's way).
#include "draw/stroke_builder.hpp"

#include "draw/simplify.hpp"

#include <algorithm>
#include <array>

namespace orograph {

void StrokeBuilder::begin(std::int32_t profile, double depth_m) {
  stroke_.profile = profile;
  stroke_.depth_m = depth_m;
  has_last_ = false;
}

StrokeBuilder::PagePoint StrokeBuilder::page_of(Vec2 p) const {
  const auto& m = settings_.to_page.m;
  return {m[0] * p.x + m[1] * p.y + m[2], m[3] * p.x + m[4] * p.y + m[5],
          m[6] * p.x + m[7] * p.y + m[8]};
}

bool StrokeBuilder::is_inside(const PagePoint& p) const {
  const Box2& frame = settings_.frame_mm;
  return p.w > 0 && p.x >= frame.low.x * p.w && p.x <= frame.high.x * p.w &&
         p.y >= frame.low.y * p.w && p.y <= frame.high.y * p.w;
}

StrokePoint StrokeBuilder::between(const StrokePoint& a, const StrokePoint& b, double share) const {
  const double depth_share =
      settings_.perspective ? share_in_depth(share, a.scene.v, b.scene.v) : share;
  return {
      {a.plane.x + share * (b.plane.x - a.plane.x), a.plane.y + share * (b.plane.y - a.plane.y)},
      point_between(a.scene, b.scene, depth_share)};
}

void StrokeBuilder::append(const StrokePoint& point) {
  // A point cut at the frame may round to just outside of it.
  const Vec2 page = settings_.to_page(point.plane);
  const Box2& frame = settings_.frame_mm;
  page_mm_.push_back({std::clamp(page.x, frame.low.x, frame.high.x),
                      std::clamp(page.y, frame.low.y, frame.high.y)});
  if (settings_.to_map) scene_.push_back(point.scene);
}

void StrokeBuilder::add(const StrokePoint& point) {
  const PagePoint page = page_of(point.plane);
  const bool inside = is_inside(page);
  if (!has_last_) {
    if (inside) append(point);
  } else if (inside && last_inside_) {
    append(point);
  } else {
    const Box2& frame = settings_.frame_mm;
    const auto sides = [&](const PagePoint& p) {
      return std::array<double, 5>{p.w, p.x - frame.low.x * p.w, frame.high.x * p.w - p.x,
                                   p.y - frame.low.y * p.w, frame.high.y * p.w - p.y};
    };
    const auto from = sides(last_page_), to = sides(page);
    double enter = 0, leave = 1;
    for (std::size_t i = 0; i < from.size(); ++i) {
      if (from[i] < 0 && to[i] < 0)
        enter = 1, leave = 0;
      else if (from[i] < 0)
        enter = std::max(enter, from[i] / (from[i] - to[i]));
      else if (to[i] < 0)
        leave = std::min(leave, from[i] / (from[i] - to[i]));
    }
    if (enter < leave) {
      if (!last_inside_) append(between(last_, point, enter));
      append(inside ? point : between(last_, point, leave));
    } else if (inside) {
      append(point); // on the frame itself: nothing of the line so far, but it may go on
    }
    if (!inside) flush();
  }
  last_ = point;
  last_page_ = page;
  last_inside_ = inside;
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
  for (std::size_t i = 1; i < page_mm_.size(); ++i)
    length_mm += length(page_mm_[i] - page_mm_[i - 1]);
  if (length_mm >= settings_.min_stroke_mm) return true;
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
