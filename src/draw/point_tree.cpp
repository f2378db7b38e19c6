// SPDX-License-Identifier: GPL-3.0-or-later
#include "draw/point_tree.hpp"

#include "geometry/on_all_cores.hpp"

#include <algorithm>
#include <limits>

namespace orograph {
namespace {

// From 4 to 16 it makes no difference; more take longer to look through, fewer more memory.
constexpr std::uint32_t kMostInLeaf = 8;

double squared_to(const Box2& box, Vec2 p) {
  const Vec2 out{std::max({box.low.x - p.x, 0.0, p.x - box.high.x}),
                 std::max({box.low.y - p.y, 0.0, p.y - box.high.y})};
  return dot(out, out);
}

} // namespace

PointTree::PointTree(std::span<const Vec2> points) : places_(points.size()) {
  entries_.reserve(points.size());
  for (std::uint32_t i = 0; i < points.size(); ++i) entries_.push_back({points[i], i, true});
  // Halves differ by one point at most, so that all leaves are on the last two levels.
  std::size_t nodes = 1;
  for (std::size_t size = points.size(); size > kMostInLeaf; size = (size + 1) / 2)
    nodes = 2 * nodes + 1;
  nodes_.resize(nodes);
  divide(0, 0, static_cast<std::uint32_t>(entries_.size()));
  for (std::uint32_t i = 0; i < entries_.size(); ++i) places_[entries_[i].point] = i;
}

void PointTree::divide(std::size_t node, std::uint32_t begin, std::uint32_t end) {
  throw_if_stopped();
  constexpr double kFar = std::numeric_limits<double>::infinity();
  Box2 box{{kFar, kFar}, {-kFar, -kFar}};
  for (std::uint32_t i = begin; i < end; ++i) {
    const Vec2 p = entries_[i].at;
    box.low = {std::min(box.low.x, p.x), std::min(box.low.y, p.y)};
    box.high = {std::max(box.high.x, p.x), std::max(box.high.y, p.y)};
  }
  nodes_[node] = {box, begin, end, end - begin};
  if (end - begin <= kMostInLeaf) return;
  const bool by_x = box.high.x - box.low.x >= box.high.y - box.low.y;
  const std::uint32_t middle = begin + (end - begin) / 2;
  const auto place = [&](std::uint32_t i) { return entries_.begin() + i; };
  std::nth_element(place(begin), place(middle), place(end), [&](const Entry& a, const Entry& b) {
    const double of_a = by_x ? a.at.x : a.at.y, of_b = by_x ? b.at.x : b.at.y;
    return of_a != of_b ? of_a < of_b : a.point < b.point;
  });
  divide(2 * node + 1, begin, middle);
  divide(2 * node + 2, middle, end);
}

void PointTree::remove(std::uint32_t point) {
  const std::uint32_t place = places_[point];
  if (!entries_[place].is_left) return;
  entries_[place].is_left = false;
  for (std::size_t node = 0;;) {
    --nodes_[node].left;
    const Node& of = nodes_[node];
    if (of.end - of.begin <= kMostInLeaf) return;
    node = 2 * node + (place < nodes_[2 * node + 1].end ? 1 : 2);
  }
}

void PointTree::seek(std::size_t node, Vec2 to, std::size_t count, std::vector<Near>& found) const {
  const Node& of = nodes_[node];
  // What is as near as the last that was found may still have a lower number.
  if (of.left == 0 || (found.size() == count && squared_to(of.box, to) > found.back().squared))
    return;
  if (of.end - of.begin > kMostInLeaf) {
    const bool second_first =
        squared_to(nodes_[2 * node + 2].box, to) < squared_to(nodes_[2 * node + 1].box, to);
    seek(2 * node + (second_first ? 2 : 1), to, count, found);
    seek(2 * node + (second_first ? 1 : 2), to, count, found);
    return;
  }
  for (std::uint32_t i = of.begin; i < of.end; ++i) {
    if (!entries_[i].is_left) continue;
    const Near near{dot(entries_[i].at - to, entries_[i].at - to), entries_[i].point};
    if (found.size() == count) {
      if (!(near < found.back())) continue;
      found.pop_back();
    }
    found.insert(std::upper_bound(found.begin(), found.end(), near), near);
  }
}

std::optional<std::uint32_t> PointTree::nearest(Vec2 to) const {
  std::vector<Near> found;
  found.reserve(1);
  seek(0, to, 1, found);
  return found.empty() ? std::nullopt : std::optional(found.front().point);
}

void PointTree::nearest(Vec2 to, std::size_t count, std::vector<std::uint32_t>& out) const {
  out.clear();
  if (count == 0) return;
  std::vector<Near> found;
  found.reserve(count);
  seek(0, to, count, found);
  for (const Near& near : found) out.push_back(near.point);
}

} // namespace orograph
