// SPDX-License-Identifier: GPL-3.0-or-later
#include "hidden_lines/line_pictures.hpp"

#include "geometry/on_all_cores.hpp"
#include "view/sectors.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace orograph {
namespace {

// Lines' sources are told from profiles' segments by the highest bit of their id.
constexpr std::uint64_t kLineBit = std::uint64_t{1} << 63U;

double nearness(const View& view, ProfilePoint p) {
  return view.is_perspective() ? 1 / p.v : -p.v;
}

bool lies_between(const ProfileLine& line, const Sector& sector) {
  const double near_m = sector.view.near_m;
  return sector.keeps_strip && std::abs(line.from.v) <= near_m && std::abs(line.to.v) <= near_m;
}

ProfileLine line_in(const EdgeEnds& ends, const Sector& sector, SurfaceEdge edge) {
  ProfileLine line = ends(edge);
  if (lies_between(line, sector)) line.from.v = line.to.v = kNearPlanesAhead * sector.view.near_m;
  return line;
}

// More than X is rounded by at x, or looked at beside an upright line, from this depth on.
double margin(const View& view, double x, double from_m, double rounding_m) {
  if (std::isinf(x)) return 0;
  return 4 * rounding_m *
         (view.is_perspective() ? (1 + std::abs(x)) / from_m : 1 + std::abs(view.x_per_v));
}

} // namespace

double position_rounding_m(double reach_m, const View& view) {
  return 16 * std::numeric_limits<double>::epsilon() * (reach_m + length(view.depth_origin_m));
}

bool is_below_blocks(const BlockedHorizon& horizon, double x_begin, double x_end, double height) {
  const auto& blocks = horizon.blocks();
  for (std::size_t i = horizon.block_at(x_begin); i < blocks.size() && blocks[i].x_begin <= x_end;
       ++i)
    if (!(height < blocks[i].low)) return false;
  return true;
}

std::uint32_t line_number(const Segment& source) {
  return static_cast<std::uint32_t>(source.id & ~kLineBit);
}

std::uint64_t source_id(std::uint32_t line) {
  return kLineBit | line;
}

LinePictures::LinePictures(const Surface& surface, double reach_m,
                           std::span<const ProfilePoint> points, const Sector& sector,
                           const std::vector<EdgeLine>& lines, XRange range, double from_m,
                           bool overlays_are_lifted)
    : ends_(surface, sector.view, {points, sector.to_view.back()}),
      overlays_are_lifted_(overlays_are_lifted), sector_(sector), view_(sector.view), lines_(lines),
      range_(range), from_m_(from_m), rounding_m_(position_rounding_m(reach_m, sector.view)) {
  beside_range_ = {range.begin - margin(view_, range.begin, from_m, rounding_m_),
                   range.end + margin(view_, range.end, from_m, rounding_m_)};
}

std::uint32_t LinePictures::add_found(const EdgeLine& line) {
  const std::uint32_t number = next_found();
  if (dropped_.empty()) {
    found_.push_back(line);
  } else {
    dropped_.pop_back();
    found_[number - lines_.size()] = line;
  }
  return number;
}

ProfileLine LinePictures::whole(SurfaceEdge edge) const {
  return line_in(ends_, sector_, edge);
}

bool LinePictures::is_moved(SurfaceEdge edge) const {
  return sector_.keeps_strip && lies_between(ends_(edge), sector_);
}

ProfilePoint LinePictures::point(std::uint32_t line, double t) const {
  const ProfileLine ends = whole(line);
  return point_between(ends.from, ends.to, t);
}

LinePicture LinePictures::picture(std::uint32_t line, const ProfileLine& whole) const {
  double t0 = 0, t1 = 1;
  const auto& [from, to] = whole;
  if (std::min(from.v, to.v) < from_m_) // what is nearer has no picture
    (from.v < to.v ? t0 : t1) = (from_m_ - from.v) / (to.v - from.v);
  const ProfilePoint p0 = point_between(from, to, t0), p1 = point_between(from, to, t1);
  LinePicture out{{}, t0, t1, p0, p1, nearness(view_, p0), nearness(view_, p1), rounding_m_};
  Vec2 left, right;
  if (view_.is_perspective()) { // `project`, whose one division is that of nearness
    left = {p0.u * out.nearness_left, (p0.z - view_.eye_z_m) * out.nearness_left};
    right = {p1.u * out.nearness_right, (p1.z - view_.eye_z_m) * out.nearness_right};
    out.beside *= (1 + std::abs(left.x)) * std::max(out.nearness_left, out.nearness_right);
  } else {
    left = project(view_, p0);
    right = project(view_, p1);
    out.beside *= 1 + std::abs(view_.x_per_v);
  }
  // A line that runs straight away from the eye is told from one that doesn't by more than
  // rounding, which would make one visible by turns.
  const bool upright = std::abs(left.x - right.x) <= out.beside;
  // Of a vertical edge, which is as near at both ends, the foot comes first.
  const bool turned =
      out.left.v != out.right.v ? out.left.v > out.right.v : out.left.z > out.right.z;
  if (upright ? turned : left.x > right.x) {
    std::swap(out.t_left, out.t_right);
    std::swap(out.left, out.right);
    std::swap(out.nearness_left, out.nearness_right);
    std::swap(left, right);
  }
  if (upright) right.x = left.x;
  out.source = {left.x, left.y, right.x, right.y, source_id(line)};
  return out;
}

void LinePictures::add_part(std::uint32_t line, const LinePicture& p, double t_begin, double t_end,
                            std::vector<LinePart>& parts) const {
  auto [begin, end] = std::minmax({along_edge(p, t_begin), along_edge(p, t_end)});
  if (std::min(p.left.v, p.right.v) < view_.drawn_from_m) {
    if (std::max(p.left.v, p.right.v) <= view_.drawn_from_m) return;
    const double from = p.t_left + (view_.drawn_from_m - p.left.v) / (p.right.v - p.left.v) *
                                       (p.t_right - p.t_left);
    const bool rises = (p.t_left < p.t_right) == (p.left.v < p.right.v);
    (rises ? begin : end) = rises ? std::max(begin, from) : std::min(end, from);
    if (!(begin < end)) return;
  }
  parts.push_back({line, begin, end});
}

void LinePictures::add_seen(std::uint32_t line, const LinePicture& p, double t_begin, double t_end,
                            std::vector<LinePart>& parts) const {
  add_part(line, p, t_begin, t_end, parts);
  if (line >= seen_with_.size() || seen_with_[line].line == SeenWith::kNone) return;
  const auto& [other, is_turned] = seen_with_[line];
  LinePicture turned = p;
  if (is_turned) {
    turned.t_left = 1 - p.t_left;
    turned.t_right = 1 - p.t_right;
  }
  add_part(other, turned, t_begin, t_end, parts);
}

double LinePictures::along_edge(const LinePicture& p, double share) const {
  if (share <= 0) return p.t_left;
  if (share >= 1) return p.t_right;
  const double in_space =
      view_.is_perspective() ? share_in_depth(share, p.left.v, p.right.v) : share;
  return p.t_left + in_space * (p.t_right - p.t_left);
}

SurfaceLine LinePictures::surface_line(const EdgeLine& taken, const LinePicture& p) const {
  const bool upright = p.is_upright();
  return {p.source,
          p.nearness_left,
          p.nearness_right,
          upright ? 0 : p.source.x0,
          upright ? 1 : p.source.x1,
          taken.hides,
          taken.drawn,
          p.beside,
          rounding_m_ / 4, // which is generous: what is farther apart is told apart
          view_.is_perspective(),
          taken.covers,
          false,
          0,
          overlays_are_lifted_ && taken.kind == LineKind::drape};
}

bool LinePictures::cut_to_range(SurfaceLine& line) const {
  if (line.upright()) return line.source.x0 >= range_.begin && line.source.x0 <= range_.end;
  line.begin = std::max(line.begin, beside_range_.begin);
  line.end = std::min(line.end, beside_range_.end);
  return line.begin < line.end;
}

bool LinePictures::is_hidden(const LinePicture& p, const BlockedHorizon& horizon) const {
  const Segment& s = p.source;
  const double x = std::max(std::abs(s.x0), std::abs(s.x1));
  const double beside = margin(view_, x, std::min(p.left.v, p.right.v), rounding_m_);
  return is_below_blocks(horizon, std::max(s.x0 - beside, beside_range_.begin),
                         std::min(s.x1 + beside, beside_range_.end), std::max(s.y0, s.y1));
}

std::vector<LinePart> LinePictures::skyline(const Horizon& horizon) const {
  std::vector<LinePart> parts;
  for (const HorizonPiece& piece : horizon) {
    throw_if_stopped(static_cast<std::size_t>(&piece - horizon.data()));
    if (is_sky(piece) || !(piece.source.id & kLineBit)) continue;
    const std::uint32_t number = line_number(piece.source);
    const auto& [edge, kind, hides, drawn, covers] = line(number);
    if (!drawn || kind == LineKind::shore || kind == LineKind::edge) continue;
    const LinePicture p = picture(number, whole(number));
    const auto [begin, end] = std::minmax({along_edge(p, parameter_at(p.source, piece.x_begin)),
                                           along_edge(p, parameter_at(p.source, piece.x_end))});
    parts.push_back({number, begin, end});
  }
  join(parts);
  return parts;
}

std::vector<std::vector<LineAtDepth>>
lines_by_range(const Surface& surface, double reach_m, std::span<const ProfilePoint> points,
               const Sector& sector, const std::vector<EdgeLine>& lines,
               const std::vector<std::uint32_t>* numbers, std::span<const XRange> ranges,
               double from_m) {
  using Found = std::vector<LineAtDepth>;
  const View& view = sector.view;
  const double rounding_m = position_rounding_m(reach_m, view);
  const EdgeEnds ends(surface, view, {points, sector.to_view.back()});
  const auto find = [&](std::uint32_t i, std::vector<Found>& found) {
    if (!lines[i].drawn && !lines[i].hides) return;
    auto [from, to] = line_in(ends, sector, lines[i].edge);
    const auto nearest = static_cast<float>(std::min(from.v, to.v));
    if (std::min(from.v, to.v) < from_m) {
      if (!(std::max(from.v, to.v) >= from_m)) return;
      (from.v < to.v ? from : to) = point_between(from, to, (from_m - from.v) / (to.v - from.v));
    }
    const double a = project(view, from).x, b = project(view, to).x;
    const double low = std::min(a, b) - margin(view, a, from_m, rounding_m);
    const double high = std::max(a, b) + margin(view, b, from_m, rounding_m);
    const auto first = std::partition_point(ranges.begin(), ranges.end(),
                                            [&](const XRange& range) { return range.end < low; });
    for (auto range = first; range != ranges.end() && range->begin <= high; ++range)
      found[static_cast<std::size_t>(range - ranges.begin())].push_back({i, nearest});
  };
  constexpr std::size_t kLinesOfTask = 1U << 12U;
  const std::size_t count = numbers ? numbers->size() : lines.size();
  std::vector<std::vector<Found>> of_tasks((count + kLinesOfTask - 1) / kLinesOfTask);
  on_all_cores(of_tasks.size(), [&](std::size_t task) {
    of_tasks[task].resize(ranges.size());
    const std::size_t end = std::min(count, (task + 1) * kLinesOfTask);
    for (std::size_t i = task * kLinesOfTask; i < end; ++i)
      find(numbers ? (*numbers)[i] : static_cast<std::uint32_t>(i), of_tasks[task]);
  });
  std::vector<Found> out(ranges.size());
  on_all_cores(ranges.size(), [&](std::size_t range) {
    std::size_t all = 0;
    for (const auto& found : of_tasks) all += found[range].size();
    out[range].reserve(all);
    for (const auto& found : of_tasks) {
      throw_if_stopped();
      out[range].insert(out[range].end(), found[range].begin(), found[range].end());
    }
  });
  return out;
}

} // namespace orograph
