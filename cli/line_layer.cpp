// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/line_layer.hpp"

#include "draw/chain.hpp"

#include <algorithm>

namespace orograph {
namespace {

std::vector<ProfileLine> lines_of(const Grid& grid, const View& view,
                                  const std::vector<GridEdge>& edges) {
  std::vector<ProfileLine> lines;
  lines.reserve(edges.size());
  for (const GridEdge& edge : edges) lines.push_back(line_of(grid, view, edge));
  return lines;
}

} // namespace

LineLayer::LineLayer(const Grid& grid, const View& view, std::vector<GridEdge> edges, double from_m)
    : view_(view), edges_(std::move(edges)), slabs_(lines_of(grid, view, edges_), from_m) {}

void LineLayer::take_slab(double to_m, const Horizon& horizon) {
  for (const SlabPiece& piece : slabs_.next(to_m)) {
    scratch_.clear();
    clip_line(project(view_, piece.begin), project(view_, piece.end), horizon, scratch_);
    const auto t_at = [&](double share) {
      if (share <= 0) return piece.t_begin;
      if (share >= 1) return piece.t_end;
      const double along =
          view_.is_perspective() ? share_in_depth(share, piece.begin.v, piece.end.v) : share;
      return piece.t_begin + along * (piece.t_end - piece.t_begin);
    };
    for (const LinePart& part : scratch_)
      parts_.push_back({piece.line, t_at(part.begin), t_at(part.end)});
  }
}

// The parts of one line that meet at a slab's plane become one.
void LineLayer::join_parts() {
  std::sort(parts_.begin(), parts_.end(), [](const VisiblePart& a, const VisiblePart& b) {
    return a.line != b.line ? a.line < b.line : a.t_begin < b.t_begin;
  });
  std::size_t count = 0;
  for (const VisiblePart& part : parts_) {
    if (count > 0 && parts_[count - 1].line == part.line && parts_[count - 1].t_end == part.t_begin)
      parts_[count - 1].t_end = part.t_end;
    else
      parts_[count++] = part;
  }
  parts_.resize(count);
}

void LineLayer::draw(StrokeBuilder& builder) {
  join_parts();
  std::vector<ChainLink> links;
  links.reserve(parts_.size());
  for (const auto& [line, t_begin, t_end] : parts_)
    links.push_back(
        {t_begin <= 0 ? edges_[line].from : kLooseEnd, t_end >= 1 ? edges_[line].to : kLooseEnd});
  for (const auto& pieces : chain(links)) {
    builder.begin(-1, std::numeric_limits<double>::quiet_NaN());
    const auto add = [&](const ChainedPiece& piece, bool at_end) {
      const VisiblePart& part = parts_[piece.piece];
      const auto& [from, to] = slabs_.line(part.line);
      const ProfilePoint at = point_between(from, to, at_end ? part.t_end : part.t_begin);
      builder.add({project(view_, at), at});
    };
    add(pieces.front(), pieces.front().turned);
    for (const ChainedPiece& piece : pieces) add(piece, !piece.turned);
    builder.end();
  }
}

} // namespace orograph
