// SPDX-License-Identifier: GPL-3.0-or-later
#include "hidden_lines/line_pass.hpp"

#include "hidden_lines/line_parts.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>

namespace orograph {

LinePass::LinePass(const LinePictures& pictures, std::span<const LineAtDepth> which,
                   const TieTolerance& tolerance)
    : pictures_(pictures), tolerance_(tolerance),
      slabs_(which, WholeLine{&pictures}, pictures.from_m()) {}

bool LinePass::in_plane(const ProfileLine& whole, double depth_m) const {
  return std::abs(whole.from.v - depth_m) <= pictures_.rounding_m() &&
         std::abs(whole.to.v - depth_m) <= pictures_.rounding_m();
}

SurfaceLine LinePass::in_slab(const SlabPiece& piece, const LinePicture& p, double to_m) const {
  const View& view = pictures_.sector().view;
  const auto x_at = [&](double t, ProfilePoint at) {
    return t == p.t_left ? p.source.x0 : t == p.t_right ? p.source.x1 : project(view, at).x;
  };
  SurfaceLine line = pictures_.surface_line(piece.line, p);
  line.in_last_plane = in_plane(piece.whole, to_m);
  if (line.upright()) {
    // Shares of the way along the picture, from shares of the way along the edge.
    const auto share = [&](ProfilePoint at) {
      if (at.v <= p.left.v) return 0.0;
      if (at.v >= p.right.v) return 1.0;
      const double in_space = (at.v - p.left.v) / (p.right.v - p.left.v);
      return view.is_perspective() ? share_in_depth(in_space, p.right.v, p.left.v) : in_space;
    };
    if (!line.vertical()) {
      line.begin = share(piece.begin);
      line.end = share(piece.end);
    }
  } else {
    line.begin = x_at(piece.t_begin, piece.begin);
    line.end = x_at(piece.t_end, piece.end);
  }
  if (line.begin > line.end) std::swap(line.begin, line.end);
  return line;
}

template <class AnyHorizon>
void LinePass::begin_slab(double to_m, const AnyHorizon& horizon) {
  in_slab_.clear();
  taken_.clear();
  // Tells whether the line is still to be looked at.
  slabs_.next(to_m, [&](const SlabPiece& piece) {
    const LinePicture p = pictures_.picture(piece.line, piece.whole);
    SurfaceLine line = in_slab(piece, p, to_m);
    if (!pictures_.cut_to_range(line)) return true;
    if constexpr (std::is_same_v<AnyHorizon, BlockedHorizon>) {
      if (line.upright()) {
        if (pictures_.is_hidden(p, horizon)) return false;
      } else if (is_below_blocks(horizon, line.begin, line.end,
                                 std::max(height_at(line.source, line.begin),
                                          height_at(line.source, line.end)))) {
        return !pictures_.is_hidden(p, horizon);
      }
    }
    line.tag = static_cast<std::uint32_t>(taken_.size());
    taken_.push_back(p);
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
    pictures_.add_seen(line_number(line.source), taken_[line.tag], t_begin, t_end, parts_);
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

void join_sectors(const Surface& surface, std::span<const ProfilePoint> points, const View& view,
                  const std::vector<EdgeLine>& lines, double strip_m,
                  std::vector<LinePart>& parts) {
  const EdgeEnds ends(surface, view, {points});
  const auto whole = [&](std::uint32_t line) { return ends(lines[line].edge); };
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

void draw_parts(const Surface& surface, std::span<const ProfilePoint> points, const View& view,
                const std::vector<EdgeLine>& lines, const std::vector<LinePart>& parts,
                StrokeBuilder& builder) {
  const EdgeEnds ends(surface, view, {points});
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
