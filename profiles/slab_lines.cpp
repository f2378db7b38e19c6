// SPDX-License-Identifier: GPL-3.0-or-later
#include "profiles/slab_lines.hpp"

#include <algorithm>

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

SlabLines::SlabLines(std::uint32_t count, LineOf line_of, double from_m)
    : line_of_(std::move(line_of)), by_depth_(count), from_m_(from_m) {
  struct Key {
    double nearest;
    std::uint32_t line;
  };
  std::vector<Key> keys(count);
  for (std::uint32_t i = 0; i < count; ++i) {
    const ProfileLine line = line_of_(i);
    keys[i] = {std::min(line.from.v, line.to.v), i};
  }
  std::sort(keys.begin(), keys.end(), [](const Key& a, const Key& b) {
    return a.nearest != b.nearest ? a.nearest < b.nearest : a.line < b.line;
  });
  std::transform(keys.begin(), keys.end(), by_depth_.begin(), [](const Key& k) { return k.line; });
}

// Adds the line's piece up to `to_m`; tells whether the line goes on behind it.
bool SlabLines::cut(std::uint32_t i, double to_m) {
  const ProfileLine line = line_of_(i);
  const auto& [from, to] = line;
  const auto [nearest, farthest] = std::minmax(from.v, to.v);
  if (farthest < from_m_ || (farthest == from_m_ && nearest < farthest)) return false;
  const auto t_at = [&, &a = from, &b = to](double depth) {
    return std::clamp((depth - a.v) / (b.v - a.v), 0.0, 1.0);
  };
  double t_near = from.v <= to.v ? 0 : 1, t_far = 1 - t_near;
  if (nearest < from_m_) t_near = t_at(from_m_);
  if (farthest > to_m) t_far = t_at(to_m);
  const auto [begin, end] = std::minmax(t_near, t_far);
  if (begin < end)
    pieces_.push_back(
        {i, begin, end, line, point_between(from, to, begin), point_between(from, to, end)});
  return farthest > to_m;
}

std::span<const SlabPiece> SlabLines::next(double to_m) {
  pieces_.clear();
  std::erase_if(active_, [&](std::uint32_t i) { return !cut(i, to_m); });
  for (; waiting_ < by_depth_.size(); ++waiting_) {
    const std::uint32_t i = by_depth_[waiting_];
    const ProfileLine line = line_of_(i);
    if (std::min(line.from.v, line.to.v) > to_m) break;
    if (cut(i, to_m)) active_.push_back(i);
  }
  from_m_ = to_m;
  return pieces_;
}

} // namespace orograph
