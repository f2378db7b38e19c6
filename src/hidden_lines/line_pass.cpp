// SPDX-License-Identifier: GPL-3.0-or-later
#include "hidden_lines/line_pass.hpp"

#include "dem/extent.hpp"
#include "geometry/on_all_cores.hpp"
#include "hidden_lines/line_parts.hpp"
#include "view/sectors.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>

namespace orograph {
namespace {

// Lines' sources are told from profiles' segments by the highest bit of their id.
constexpr std::uint64_t kLineBit = std::uint64_t{1} << 63U;

double nearness(const View& view, ProfilePoint p) {
  return view.is_perspective() ? 1 / p.v : -p.v;
}

// Of coordinates in the profile frame: sums of products of lengths up to this.
double position_rounding_m(const Surface& surface, const View& view) {
  const double reach = reach_m(surface);
  return 16 * std::numeric_limits<double>::epsilon() * (reach + length(view.depth_origin_m));
}

bool raises(const SurfaceLine& line) {
  return line.hides && line.begin < line.end && !line.upright();
}
HorizonPiece occluder_of(const SurfaceLine& line) {
  return {line.begin, line.end, line.source, line.drawn};
}
std::uint32_t line_number(const SurfaceLine& line) {
  return static_cast<std::uint32_t>(line.source.id & ~kLineBit);
}

// Whether a height is below all blocks of the horizon between two abscissae.
bool is_below_blocks(const BlockedHorizon& horizon, double x_begin, double x_end, double height) {
  const auto& blocks = horizon.blocks();
  for (std::size_t i = horizon.block_at(x_begin); i < blocks.size() && blocks[i].x_begin <= x_end;
       ++i)
    if (!(height < blocks[i].low)) return false;
  return true;
}

ProfileLine line_in(const EdgeEnds& ends, const Sector& sector, SurfaceEdge edge) {
  ProfileLine line = ends(edge);
  const double near_m = sector.view.near_m;
  if (sector.keeps_strip && std::abs(line.from.v) <= near_m && std::abs(line.to.v) <= near_m)
    line.from.v = line.to.v = kNearPlanesAhead * near_m;
  return line;
}

// More than X is rounded by at x, or looked at beside an upright line, from this depth on.
double margin(const View& view, double x, double from_m, double rounding_m) {
  if (std::isinf(x)) return 0;
  return 4 * rounding_m *
         (view.is_perspective() ? (1 + std::abs(x)) / from_m : 1 + std::abs(view.x_per_v));
}

} // namespace

LinePass::LinePass(const Surface& surface, const Sector& sector, const std::vector<EdgeLine>& lines,
                   std::span<const LineAtDepth> which, XRange range, double from_m,
                   const TieTolerance& tolerance)
    : ends_(surface, sector.view), sector_(sector), view_(sector.view), lines_(lines),
      range_(range), from_m_(from_m), tolerance_(tolerance),
      rounding_m_(position_rounding_m(surface, sector.view)),
      slabs_(which, WholeLine{this}, from_m) {
  beside_range_ = {range.begin - margin(view_, range.begin, from_m, rounding_m_),
                   range.end + margin(view_, range.end, from_m, rounding_m_)};
}

ProfileLine LinePass::whole(std::uint32_t i) const {
  return line_in(ends_, sector_, lines_[i].edge);
}

LinePass::Projected LinePass::project_line(std::uint32_t line, const ProfileLine& whole) const {
  double t0 = 0, t1 = 1;
  const auto& [from, to] = whole;
  if (std::min(from.v, to.v) < from_m_) // what is nearer has no picture
    (from.v < to.v ? t0 : t1) = (from_m_ - from.v) / (to.v - from.v);
  const ProfilePoint p0 = point_between(from, to, t0), p1 = point_between(from, to, t1);
  Projected out{{}, t0, t1, p0, p1, nearness(view_, p0), nearness(view_, p1), rounding_m_};
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
  out.source = {left.x, left.y, right.x, right.y, kLineBit | line};
  return out;
}

double LinePass::along_edge(const AlongEdge& along, double share) const {
  if (share <= 0) return along.t_left;
  if (share >= 1) return along.t_right;
  const double in_space =
      view_.is_perspective() ? share_in_depth(share, along.v_left, along.v_right) : share;
  return along.t_left + in_space * (along.t_right - along.t_left);
}

bool LinePass::in_plane(const ProfileLine& whole, double depth_m) const {
  return std::abs(whole.from.v - depth_m) <= rounding_m_ &&
         std::abs(whole.to.v - depth_m) <= rounding_m_;
}

// Whether any of it is left.
bool LinePass::cut_to_range(SurfaceLine& line) const {
  if (line.upright()) return line.source.x0 >= range_.begin && line.source.x0 <= range_.end;
  line.begin = std::max(line.begin, beside_range_.begin);
  line.end = std::min(line.end, beside_range_.end);
  return line.begin < line.end;
}

// By bounds alone: all of it is below all of the horizon's blocks that it reaches.
bool LinePass::is_hidden(const Projected& p, const BlockedHorizon& horizon) const {
  const Segment& s = p.source;
  const double x = std::max(std::abs(s.x0), std::abs(s.x1));
  const double beside = margin(view_, x, std::min(p.left.v, p.right.v), rounding_m_);
  return is_below_blocks(horizon, std::max(s.x0 - beside, beside_range_.begin),
                         std::min(s.x1 + beside, beside_range_.end), std::max(s.y0, s.y1));
}

SurfaceLine LinePass::in_slab(const SlabPiece& piece, const Projected& p, double to_m) const {
  const auto x_at = [&](double t, ProfilePoint at) {
    return t == p.t_left ? p.source.x0 : t == p.t_right ? p.source.x1 : project(view_, at).x;
  };
  const EdgeLine& taken = lines_[piece.line];
  SurfaceLine line{p.source,
                   p.nearness_left,
                   p.nearness_right,
                   x_at(piece.t_begin, piece.begin),
                   x_at(piece.t_end, piece.end),
                   taken.hides,
                   taken.drawn,
                   p.beside,
                   rounding_m_ / 4, // which is generous: what is farther apart is told apart
                   view_.is_perspective(),
                   taken.covers,
                   in_plane(piece.whole, to_m)};
  if (line.upright()) {
    // Shares of the way along the picture, from shares of the way along the edge.
    const auto share = [&](ProfilePoint at) {
      if (at.v <= p.left.v) return 0.0;
      if (at.v >= p.right.v) return 1.0;
      const double in_space = (at.v - p.left.v) / (p.right.v - p.left.v);
      return view_.is_perspective() ? share_in_depth(in_space, p.right.v, p.left.v) : in_space;
    };
    const bool vertical = p.left.v == p.right.v;
    line.begin = vertical ? 0 : share(piece.begin);
    line.end = vertical ? 1 : share(piece.end);
  }
  if (line.begin > line.end) std::swap(line.begin, line.end);
  return line;
}

template <class AnyHorizon>
void LinePass::begin_slab(double to_m, const AnyHorizon& horizon) {
  in_slab_.clear();
  along_.clear();
  // Tells whether the line is still to be looked at.
  slabs_.next(to_m, [&](const SlabPiece& piece) {
    const Projected p = project_line(piece.line, piece.whole);
    SurfaceLine line = in_slab(piece, p, to_m);
    if (!cut_to_range(line)) return true;
    if constexpr (std::is_same_v<AnyHorizon, BlockedHorizon>) {
      if (line.upright()) {
        if (is_hidden(p, horizon)) return false;
      } else if (is_below_blocks(horizon, line.begin, line.end,
                                 std::max(height_at(line.source, line.begin),
                                          height_at(line.source, line.end)))) {
        return !is_hidden(p, horizon);
      }
    }
    line.tag = static_cast<std::uint32_t>(along_.size());
    along_.push_back({p.t_left, p.t_right, p.left.v, p.right.v});
    in_slab_.push_back(line);
    return true;
  });

  if (!record_) return;
  // Before what is hidden is dropped.
  record_->insert(record_->end(), record_in_last_plane_.begin(), record_in_last_plane_.end());
  record_in_last_plane_.clear();
  for (const SurfaceLine& line : in_slab_)
    if (raises(line))
      (line.in_last_plane ? record_in_last_plane_ : *record_).push_back(occluder_of(line));
}
template void LinePass::begin_slab(double, const Horizon&);
template void LinePass::begin_slab(double, const BlockedHorizon&);

void LinePass::add_visible(std::span<const VisibleLinePart> visible) {
  for (const auto& [index, t_begin, t_end] : visible) {
    const SurfaceLine& line = in_slab_[index];
    const double a = along_edge(along_[line.tag], t_begin), b = along_edge(along_[line.tag], t_end);
    parts_.push_back({line_number(line), std::min(a, b), std::max(a, b)});
  }
}

void LinePass::end_slab() {
  occluders_.clear();
  in_last_plane_.clear();
  for (const SlabHorizon::Begin& begin : slab_horizon_.by_x()) {
    const SurfaceLine& line = in_slab_[begin.line];
    if (raises(line))
      (line.in_last_plane ? in_last_plane_ : occluders_).push_back(occluder_of(line));
  }
}

std::vector<LinePart> LinePass::skyline(const Horizon& horizon) const {
  std::vector<LinePart> parts;
  for (const HorizonPiece& piece : horizon) {
    throw_if_stopped(static_cast<std::size_t>(&piece - horizon.data()));
    if (is_sky(piece) || !(piece.source.id & kLineBit)) continue;
    const auto number = static_cast<std::uint32_t>(piece.source.id & ~kLineBit);
    if (lines_[number].kind != LineKind::silhouette || !lines_[number].drawn) continue;
    const Projected p = project_line(number, whole(number));
    const AlongEdge along{p.t_left, p.t_right, p.left.v, p.right.v};
    const auto [begin, end] = std::minmax({along_edge(along, parameter_at(p.source, piece.x_begin)),
                                           along_edge(along, parameter_at(p.source, piece.x_end))});
    parts.push_back({number, begin, end});
  }
  join(parts);
  return parts;
}

ProfilePoint LinePass::point(std::uint32_t line, double t) const {
  const ProfileLine ends = whole(line);
  return point_between(ends.from, ends.to, t);
}

std::vector<std::vector<LineAtDepth>> lines_by_range(const Surface& surface, const Sector& sector,
                                                     const std::vector<EdgeLine>& lines,
                                                     std::span<const XRange> ranges,
                                                     double from_m) {
  using Found = std::vector<LineAtDepth>;
  const View& view = sector.view;
  const double rounding_m = position_rounding_m(surface, view);
  const EdgeEnds ends(surface, view);
  const auto find = [&](std::uint32_t i, std::vector<Found>& found) {
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
  constexpr std::size_t kLinesOfTask = 1U << 14U;
  std::vector<std::vector<Found>> of_tasks((lines.size() + kLinesOfTask - 1) / kLinesOfTask);
  on_all_cores(of_tasks.size(), [&](std::size_t task) {
    of_tasks[task].resize(ranges.size());
    const std::size_t end = std::min(lines.size(), (task + 1) * kLinesOfTask);
    for (std::size_t i = task * kLinesOfTask; i < end; ++i)
      find(static_cast<std::uint32_t>(i), of_tasks[task]);
  });
  std::vector<Found> out(ranges.size());
  on_all_cores(ranges.size(), [&](std::size_t range) {
    std::size_t count = 0;
    for (const auto& found : of_tasks) count += found[range].size();
    out[range].reserve(count);
    for (const auto& found : of_tasks) {
      throw_if_stopped();
      out[range].insert(out[range].end(), found[range].begin(), found[range].end());
    }
  });
  return out;
}

void join_sectors(const Surface& surface, const View& view, const std::vector<EdgeLine>& lines,
                  double strip_m, std::vector<LinePart>& parts) {
  const auto whole = [&](std::uint32_t line) { return line_of(surface, view, lines[line].edge); };
  // The strip, twice as wide, since its sides are rounded.
  const auto strip = [&](const ProfileLine& line) {
    return 4 * strip_m / std::abs(line.to.v - line.from.v) + kSameShare;
  };
  join(parts, [&](std::uint32_t line) { return strip(whole(line)); });
  // Edges that meet in the strip meet in the drawing as well.
  std::size_t step = 0;
  for (LinePart& part : parts) {
    throw_if_stopped(step++);
    const ProfileLine line = whole(part.line);
    if (std::abs(line.from.v) <= strip_m && part.t_begin <= strip(line)) part.t_begin = 0;
    if (std::abs(line.to.v) <= strip_m && part.t_end >= 1 - strip(line)) part.t_end = 1;
  }
}

void draw_parts(const Surface& surface, const View& view, const std::vector<EdgeLine>& lines,
                const std::vector<LinePart>& parts, StrokeBuilder& builder) {
  const EdgeEnds ends(surface, view);
  draw_chained(
      parts, view,
      [&](const LinePart& part) {
        const SurfaceEdge edge = lines[part.line].edge;
        return ChainLink{part.t_begin <= 0 ? edge.from : kLooseEnd,
                         part.t_end >= 1 ? edge.to : kLooseEnd};
      },
      [&](const LinePart& part, double t) {
        const ProfileLine whole = ends(lines[part.line].edge);
        return point_between(whole.from, whole.to, t);
      },
      builder);
}

} // namespace orograph
