// SPDX-License-Identifier: GPL-3.0-or-later
#include "profiles/slab_lines.hpp"

#include <algorithm>
#include <numeric>

namespace orograph {

ProfileLine line_of(const Grid& grid, const View& view, GridEdge edge) {
  const auto columns = static_cast<std::uint32_t>(grid.columns);
  const auto end = [&](std::uint32_t index) {
    const int column = static_cast<int>(index % columns), row = static_cast<int>(index / columns);
    const Vec2 at = grid.position_m(column, row);
    return to_profile_frame(view, {at.x, at.y, grid.height_m(column, row)});
  };
  return {end(edge.from), end(edge.to)};
}

SlabLines::SlabLines(std::vector<ProfileLine> lines, double from_m)
    : lines_(std::move(lines)), by_depth_(lines_.size()), from_m_(from_m) {
  const auto nearest = [&](std::uint32_t i) { return std::min(lines_[i].from.v, lines_[i].to.v); };
  std::iota(by_depth_.begin(), by_depth_.end(), std::uint32_t{0});
  std::sort(by_depth_.begin(), by_depth_.end(), [&](std::uint32_t a, std::uint32_t b) {
    return nearest(a) != nearest(b) ? nearest(a) < nearest(b) : a < b;
  });
}

void SlabLines::cut(std::uint32_t i, double to_m) {
  const auto& [from, to] = lines_[i];
  const auto [nearest, farthest] = std::minmax(from.v, to.v);
  if (farthest < from_m_ || (farthest == from_m_ && nearest < farthest)) return;
  const auto t_at = [&, &a = from, &b = to](double depth) {
    return std::clamp((depth - a.v) / (b.v - a.v), 0.0, 1.0);
  };
  double t_near = from.v <= to.v ? 0 : 1, t_far = 1 - t_near;
  if (nearest < from_m_) t_near = t_at(from_m_);
  if (farthest > to_m) t_far = t_at(to_m);
  const auto [begin, end] = std::minmax(t_near, t_far);
  if (begin < end)
    pieces_.push_back(
        {i, begin, end, point_between(from, to, begin), point_between(from, to, end)});
}

std::span<const SlabPiece> SlabLines::next(double to_m) {
  pieces_.clear();
  for (; waiting_ < by_depth_.size(); ++waiting_) {
    const ProfileLine& line = lines_[by_depth_[waiting_]];
    if (std::min(line.from.v, line.to.v) > to_m) break;
    active_.push_back(by_depth_[waiting_]);
  }
  for (const std::uint32_t i : active_) cut(i, to_m);
  std::erase_if(
      active_, [&](std::uint32_t i) { return std::max(lines_[i].from.v, lines_[i].to.v) <= to_m; });
  from_m_ = to_m;
  return pieces_;
}

} // namespace orograph
