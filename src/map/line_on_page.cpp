// SPDX-License-Identifier: GPL-3.0-or-later
// Notation: s is a share of the way along the picture, t along the line in space. The picture is a
// central projection with weights w at the ends: s = t w_to / ((1 - t) w_from + t w_to).
#include "map/line_on_page.hpp"

#include <algorithm>

namespace orograph {
namespace {

// The shares between which a + s * (b - a) is inside [low, high] (Liang and Barsky).
void keep_between(double a, double b, double low, double high, double& begin, double& end) {
  const double step = b - a;
  if (step == 0) {
    if (a < low || a > high) end = -1;
    return;
  }
  double enters = (low - a) / step, leaves = (high - a) / step;
  if (enters > leaves) std::swap(enters, leaves);
  begin = std::max(begin, enters);
  end = std::min(end, leaves);
}

} // namespace

std::optional<LineOnPage> LineOnPage::of(const ProfileLine& line, const View& view,
                                         const Homography& to_page, const Box2& frame_mm) {
  LineOnPage out;
  if (view.is_perspective() && (line.from.v <= 0 || line.to.v <= 0)) return std::nullopt;
  const Vec2 from = project(view, line.from), to = project(view, line.to);
  out.w_from_ = to_page.w(from) * (view.is_perspective() ? line.from.v : 1);
  out.w_to_ = to_page.w(to) * (view.is_perspective() ? line.to.v : 1);
  if (!(out.w_from_ > 0) || !(out.w_to_ > 0)) return std::nullopt;
  const Vec2 a = to_page(from), b = to_page(to);
  keep_between(a.x, b.x, frame_mm.low.x, frame_mm.high.x, out.begin_, out.end_);
  keep_between(a.y, b.y, frame_mm.low.y, frame_mm.high.y, out.begin_, out.end_);
  if (!(out.begin_ < out.end_)) return std::nullopt;
  out.length_mm_ = (out.end_ - out.begin_) * length(b - a);
  if (!(out.length_mm_ > 0)) return std::nullopt;
  return out;
}

double LineOnPage::share_at(double mm) const {
  const double s = begin_ + mm / length_mm_ * (end_ - begin_);
  return std::clamp(s * w_from_ / ((1 - s) * w_to_ + s * w_from_), 0.0, 1.0);
}

double LineOnPage::mm_at(double share) const {
  const double s = share * w_to_ / ((1 - share) * w_from_ + share * w_to_);
  return (s - begin_) / (end_ - begin_) * length_mm_;
}

} // namespace orograph
