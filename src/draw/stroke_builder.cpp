// SPDX-License-Identifier: GPL-3.0-or-later
// The frame's sides are planes in homogeneous page coordinates (x, y, w), in which a straight line
// stays straight: x - left * w >= 0 and so on. A crossing with a side is therefore found without
// dividing by w.
#include "draw/stroke_builder.hpp"

#include "draw/simplify.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace orograph {
namespace {

constexpr std::size_t kPointsAtOnce = 128;

// The pictures of as many points as `page_mm` has room for, at most kPointsAtOnce, by the same
// arithmetic as of one; tells whether all of them have one that is in the frame.
//
// One loop that the compiler turns into vector instructions, and one that it doesn't.
bool to_page_mm(const Homography& to_page, const PointsAtDepth& depth, const Box2& frame,
                std::span<const double> u_m, std::span<const double> z_m, std::span<Vec2> page_mm) {
  std::array<double, kPointsAtOnce> x, y, w;
  const auto& m = to_page.m;
  const double x_of_w = m[2] * depth.w, y_of_w = m[5] * depth.w, w_of_w = m[8] * depth.w;
  const std::size_t count = page_mm.size();
  for (std::size_t i = 0; i < count; ++i) {
    const double plane_x = depth.u_sign * u_m[i] + depth.aside;
    const double plane_y = depth.per_z * z_m[i] + depth.above;
    w[i] = m[6] * plane_x + m[7] * plane_y + w_of_w;
    x[i] = (m[0] * plane_x + m[1] * plane_y + x_of_w) / w[i];
    y[i] = (m[3] * plane_x + m[4] * plane_y + y_of_w) / w[i];
  }
  Box2 box{{x[0], y[0]}, {x[0], y[0]}};
  double least_w = w[0];
  for (std::size_t i = 0; i < count; ++i) {
    page_mm[i] = {x[i], y[i]};
    least_w = std::min(least_w, w[i]);
    box.low = {std::min(box.low.x, x[i]), std::min(box.low.y, y[i])};
    box.high = {std::max(box.high.x, x[i]), std::max(box.high.y, y[i])};
  }
  return least_w > 0 && box.low.x >= frame.low.x && box.high.x <= frame.high.x &&
         box.low.y >= frame.low.y && box.high.y <= frame.high.y;
}

// Where a straight line is at an azimuth between those of its ends.
double share_at_azimuth(ProfilePoint a, ProfilePoint b, double azimuth) {
  const double s = std::sin(azimuth), c = std::cos(azimuth);
  const double across = a.u * c - a.v * s, b_across = b.u * c - b.v * s;
  return std::clamp(across / (across - b_across), 0.0, 1.0);
}
ProfilePoint at_azimuth(ProfilePoint a, ProfilePoint b, double azimuth) {
  return point_between(a, b, share_at_azimuth(a, b, azimuth));
}

StrokePoint between(const StrokePoint& a, const StrokePoint& b, double share) {
  return {a.plane + share * (b.plane - a.plane), point_between(a.scene, b.scene, share)};
}

} // namespace

// That w >= 0 follows from back and front.
PlaneValues plane_values(const Box2& frame_mm, const std::optional<VolumeDepth>& depth,
                         const Vec3& page, ProfilePoint scene) {
  const auto& [x, y, w] = page;
  const auto& [low, high] = frame_mm;
  const double at = depth ? depth->per_u * scene.u + depth->per_v * scene.v +
                                depth->per_z * scene.z + depth->at_origin
                          : -0.5 * w;
  const double slack = kInPlane * w;
  return {x - low.x * w, high.x * w - x, y - low.y * w, high.y * w - y, w + at + slack, slack - at};
}

void StrokeBuilder::begin(std::int32_t profile, double depth_m) {
  stroke_.profile = profile;
  stroke_.depth_m = depth_m;
  stroke_.width_mm = width_mm_ = 0;
  last_.reset();
  bent_.reset();
}

// A panorama's point is bent first: what is clipped, then, lies flat on the page.
void StrokeBuilder::add_bent_at(ProfilePoint scene, double azimuth) {
  const PanoramaPage& page = *settings_.panorama;
  const double tangent = page.tangent(scene);
  if (!std::isfinite(tangent)) return; // straight above or below the eye
  add_straight({{page.x_mm(azimuth), page.y_mm(tangent), 1}, scene});
  bent_ = {scene, azimuth};
}

// To a point on the same side of the seam.
void StrokeBuilder::bend_to(ProfilePoint to, double azimuth) {
  constexpr double kMostTurn = 0.5;
  const auto [from, from_azimuth] = *bent_;
  if (const double turn = azimuth - from_azimuth; std::abs(turn) > kMostTurn) {
    const double half = from_azimuth + 0.5 * turn;
    const double share = share_at_azimuth(from, to, half);
    const ProfilePoint middle = point_between(from, to, share);
    constexpr double kMostTangent = 1e7, kBeside = 1e-9;
    if (std::abs(settings_.panorama->tangent(middle)) < kMostTangent) {
      bend_to(middle, half);
      bend_to(to, azimuth);
      return;
    }
    // Through below the eye, or above it: down beyond the page on one side, and up on the other.
    add_bent_at(point_between(from, to, share * (1 - kBeside)), from_azimuth);
    flush();
    last_.reset();
    add_bent_at(point_between(from, to, share + (1 - share) * kBeside), azimuth);
    add_bent_at(to, azimuth);
    return;
  }
  // What is far below the frame, as the ground at the eye's feet is, may stay straight.
  const PanoramaPage& page = *settings_.panorama;
  const double most = 2 *
                      std::max(std::abs(settings_.frame_mm.low.y - page.ahead_mm.y),
                               std::abs(settings_.frame_mm.high.y - page.ahead_mm.y)) /
                      page.radius_mm;
  std::array<double, 2> crossings = page.crossings(from, to, most);
  for (const double share : crossings)
    if (share > 0 && share < 1) {
      const ProfilePoint at = point_between(from, to, share);
      bend_part_to(at,
                   std::clamp(PanoramaPage::azimuth(at), std::min(from_azimuth, azimuth),
                              std::max(from_azimuth, azimuth)),
                   most);
    }
  bend_part_to(to, azimuth, most);
}

// A straight line is a sine on the cylinder, whose curvature is its height: y'' = -y. On the net
// of altitudes it is that sine's arc tangent; its curvature has a bound in the ends' tangents and
// their difference.
void StrokeBuilder::bend_part_to(ProfilePoint to, double azimuth, double most) {
  const PanoramaPage& page = *settings_.panorama;
  const auto [from, from_azimuth] = *bent_;
  const double turn = azimuth - from_azimuth;
  const double tangent = page.tangent(to), from_tangent = page.tangent(from);
  constexpr double kRise = 1.15; // of a sine between two ends half a radian apart, over the higher
  const double highest = kRise * std::max(std::abs(tangent), std::abs(from_tangent)),
               step = tangent - from_tangent;
  const bool is_outside =
      std::abs(page.tangent(point_between(from, to, 0.5))) > most && highest > most;
  const double steep = page.kind == PanoramaKind::cylindrical ? 0 : 2 * step * step;
  const double bent_mm = highest * (turn * turn + steep) * page.radius_mm / 8;
  const double pieces = is_outside || std::abs(turn) < 1e-12 || !std::isfinite(bent_mm)
                            ? 1
                            : std::ceil(std::sqrt(bent_mm / settings_.bend_mm));
  for (int i = 1; i < pieces; ++i) {
    const double at = from_azimuth + i / pieces * turn;
    add_bent_at(at_azimuth(from, to, at), at);
  }
  add_bent_at(to, azimuth);
}

void StrokeBuilder::add_bent(ProfilePoint scene) {
  const double azimuth = PanoramaPage::azimuth(scene);
  if (!bent_) {
    add_bent_at(scene, azimuth);
    return;
  }
  const ProfilePoint from = bent_->scene;
  if (const auto share = seam_crossing(from, scene)) {
    const double side = from.u >= 0 ? 1 : -1;
    ProfilePoint seam = point_between(from, scene, *share);
    seam.u = 0;
    bend_to(seam, side * std::numbers::pi);
    flush();
    last_.reset();
    add_bent_at(seam, -side * std::numbers::pi);
  }
  bend_to(scene, azimuth);
}

void StrokeBuilder::add_clipped(const StrokePoint& point, const Vec3& page) {
  const PlaneValues values = values_of(point, page);
  const bool inside = is_in_frame(page) && values[4] >= 0 && values[5] >= 0;
  if (!last_) {
    if (inside) append(point, page);
  } else if (inside && last_->inside) {
    append(point, page);
  } else {
    const PlaneValues last_values =
        values_of(last_->point, settings_.to_page.of(last_->point.plane));
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

// Appends all of the points, if the polyline is inside and so are they, and tells whether. Pictures
// that are in the frame need not be moved into it, and their rounding is far below kInPlane.
bool StrokeBuilder::append_inside(const PointsAtDepth& depth, std::span<const double> u_m,
                                  std::span<const double> z_m) {
  if (settings_.depth || !last_ || !last_->inside) return false;
  const std::size_t before = page_mm_.size();
  page_mm_.resize(before + u_m.size());
  if (!to_page_mm(settings_.to_page, depth, settings_.frame_mm, u_m, z_m,
                  std::span(page_mm_).subspan(before))) {
    page_mm_.resize(before);
    return false;
  }
  if (settings_.keeps_scene())
    for (std::size_t i = 0; i < u_m.size(); ++i) scene_.push_back(depth.at(u_m[i], z_m[i]).scene);
  last_->point = depth.at(u_m.back(), z_m.back());
  return true;
}

void StrokeBuilder::add(const PointsAtDepth& depth, std::span<const double> u_m,
                        std::span<const double> z_m) {
  if (settings_.panorama) {
    for (std::size_t i = 0; i < u_m.size(); ++i) add(depth.at(u_m[i], z_m[i]));
    return;
  }
  while (!u_m.empty()) {
    const std::size_t count = std::min(u_m.size(), kPointsAtOnce);
    if (!append_inside(depth, u_m.first(count), z_m.first(count)))
      for (std::size_t i = 0; i < count; ++i) add(depth.at(u_m[i], z_m[i]));
    u_m = u_m.subspan(count);
    z_m = z_m.subspan(count);
  }
}

void StrokeBuilder::end() {
  flush();
  last_.reset();
  bent_.reset();
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

void StrokeBuilder::widen(double width_mm) {
  if (page_mm_.size() <= 1)
    stroke_.width_mm = width_mm;
  else if (width_mm != width_mm_)
    widenings_.push_back({page_mm_.size() - 1, width_mm});
  width_mm_ = width_mm;
}

// Those so near the end; of those so near one another, or the begin, the last stays.
void StrokeBuilder::drop_short_widenings() {
  if (widenings_.empty() || settings_.keeps_widths) return;
  constexpr double kShort_mm = kShortWidth_mm;
  std::vector<double> way_mm(page_mm_.size(), 0);
  for (std::size_t i = 1; i < page_mm_.size(); ++i)
    way_mm[i] = way_mm[i - 1] + plain_length(page_mm_[i] - page_mm_[i - 1]);
  std::size_t kept = 0;
  double last_mm = 0;
  for (const Widening& widening : widenings_) {
    const double here_mm = way_mm[widening.point];
    if (way_mm.back() - here_mm < kShort_mm) break;
    if (here_mm - last_mm >= kShort_mm) {
      widenings_[kept++] = widening;
      last_mm = here_mm;
    } else {
      (kept > 0 ? widenings_[kept - 1].width_mm : stroke_.width_mm) = widening.width_mm;
    }
  }
  widenings_.resize(kept);
}

double StrokeBuilder::depth_m(ProfilePoint scene) const {
  return settings_.panorama ? plain_length({scene.u, scene.v}) : scene.v;
}

void StrokeBuilder::append_stroke(std::size_t first, std::size_t last) {
  const auto points = std::span(page_mm_).subspan(first, last + 1 - first);
  simplify(points, settings_.simplify_mm, kept_);
  stroke_.first_point = static_cast<std::uint32_t>(layer_.page_mm.size());
  stroke_.point_count = static_cast<std::uint32_t>(kept_.size());
  for (const std::uint32_t i : kept_) {
    layer_.page_mm.push_back(points[i]);
    if (settings_.to_map) layer_.map.push_back(settings_.to_map(scene_[first + i]));
    if (settings_.keeps_depths)
      layer_.depths_m.push_back(static_cast<float>(depth_m(scene_[first + i])));
  }
  layer_.strokes.push_back(stroke_);
}

void StrokeBuilder::flush() {
  if (is_long_enough()) {
    drop_short_widenings();
    std::size_t first = 0;
    for (const auto& [point, width_mm] : widenings_) {
      append_stroke(first, point);
      stroke_.width_mm = width_mm;
      first = point;
    }
    append_stroke(first, page_mm_.size() - 1);
  }
  stroke_.width_mm = width_mm_;
  page_mm_.clear();
  scene_.clear();
  widenings_.clear();
}

} // namespace orograph
