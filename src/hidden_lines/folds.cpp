// SPDX-License-Identifier: GPL-3.0-or-later
#include "hidden_lines/folds.hpp"

#include "draw/stroke_builder.hpp"
#include "geometry/clip_by_planes.hpp"
#include "geometry/on_all_cores.hpp"

#include <algorithm>
#include <cstdint>
#include <limits>

namespace orograph {
namespace {

constexpr std::size_t kPartsOfTask = 1024;

// Calls take(i) with the number of each of so many parts, on all cores.
template <class Take>
void for_each_part(std::size_t count, const Take& take) {
  on_all_cores((count + kPartsOfTask - 1) / kPartsOfTask, [&](std::size_t task) {
    const std::size_t end = std::min(count, (task + 1) * kPartsOfTask);
    for (std::size_t i = task * kPartsOfTask; i < end; ++i) take(i);
  });
}

} // namespace

Folds::Folds(const Surface& surface, const PlacedView& placed, const Sector& sector, double share)
    : placed_(placed), sector_(sector), share_(share),
      parallel_depth_m_(sector.farthest_m - sector.nearest_m) {
  if (share > 0) ground_.emplace(surface, sector.view, placed.for_cutters.of_tin);
}

bool Folds::is_fold(const EdgeLine& line, ProfilePoint middle) const {
  const bool is_below = line.kind == LineKind::underside;
  if (!ground_ || (line.kind != LineKind::silhouette && !is_below)) return false;
  return is_below ? ground_->falls_within(line.edge, middle, reach_m(middle.v))
                  : ground_->rises_within(line.edge, middle, reach_m(middle.v));
}

std::vector<LinePart> Folds::among(const LinePictures& lines,
                                   const std::vector<LinePart>& parts) const {
  std::vector<LinePart> out;
  if (!ground_) return out;
  std::vector<std::uint8_t> folds(parts.size());
  for_each_part(parts.size(), [&](std::size_t i) {
    const auto& [number, t_begin, t_end] = parts[i];
    folds[i] = is_fold(lines.line(number), lines.point(number, 0.5 * (t_begin + t_end))) ? 1 : 0;
  });
  for (std::size_t i = 0; i < parts.size(); ++i) {
    throw_if_stopped(i);
    if (folds[i] != 0) out.push_back(parts[i]);
  }
  return out;
}

double Folds::length_mm(const ProfileLine& whole, const LinePart& part) const {
  const ProfilePoint a = point_between(whole.from, whole.to, part.t_begin),
                     b = point_between(whole.from, whole.to, part.t_end);
  const auto page = [&](ProfilePoint p) {
    return sector_.to_page.of(project_homogeneous(sector_.view, p));
  };
  const auto values = [&](ProfilePoint p) {
    return plane_values(placed_.frame_mm, placed_.depth, page(p), sector_.to_view(p));
  };
  const auto shares = clip_by_planes(values(a), values(b));
  if (!shares) return 0;
  const auto at = [&](double share) {
    const Vec3 p = page(point_between(a, b, share));
    return Vec2{p.x / p.z, p.y / p.z};
  };
  return plain_length(at(shares->end) - at(shares->begin));
}

std::vector<double> Folds::lengths_mm(const LinePictures& lines,
                                      const std::vector<LinePart>& parts) const {
  std::vector<double> out(parts.size());
  for_each_part(parts.size(),
                [&](std::size_t i) { out[i] = length_mm(lines.whole(parts[i].line), parts[i]); });
  return out;
}

double Folds::length_if_inside_mm(Vec2 a, Vec2 b) const {
  const Homography& to_page = sector_.to_page;
  const auto& [low, high] = placed_.frame_mm;
  const auto inside = [&](Vec2 p) {
    return p.x > low.x && p.x < high.x && p.y > low.y && p.y < high.y;
  };
  if (!placed_.depth && to_page.w(a) > 0 && to_page.w(b) > 0) {
    const Vec2 from = to_page(a), to = to_page(b);
    if (inside(from) && inside(to)) return plain_length(to - from);
  }
  return std::numeric_limits<double>::quiet_NaN();
}

} // namespace orograph
