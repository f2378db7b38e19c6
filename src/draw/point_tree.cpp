// SPDX-License-Identifier: GPL-3.0-or-later
#include "draw/point_tree.hpp"

#include "geometry/on_all_cores.hpp"

#include <algorithm>
#include <limits>

namespace orograph {
namespace {

// From 4 to 16 it makes no difference; more take longer to look through, fewer more memory.
constexpr std::size_t kMostInLeaf = 16;
// So many parts of a tree keep all cores busy.
constexpr std::size_t kParts = 16;

double squared_to(const Box2& box, Vec2 p) {
  const Vec2 out{std::max({box.low.x - p.x, 0.0, p.x - box.high.x}),
                 std::max({box.low.y - p.y, 0.0, p.y - box.high.y})};
  return dot(out, out);
}

} // namespace

struct PointTree::Nearest {
  static constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();
  Near best{std::numeric_limits<double>::infinity(), kNone};

  // What is as near as the last that was found may still have a lower number.
  bool may_be_at(double squared) const { return squared <= best.squared; }
  void take(const Near& near) { best = std::min(best, near); }
  std::optional<std::uint32_t> point() const {
    return best.point == kNone ? std::nullopt : std::optional(best.point);
  }
};

struct PointTree::SomeNearest {
  std::size_t count;
  std::vector<Near> found;

  bool may_be_at(double squared) const {
    return found.size() < count || squared <= found.back().squared;
  }
  void take(const Near& near) {
    if (found.size() == count) {
      if (!(near < found.back())) return;
      found.pop_back();
    }
    found.insert(std::upper_bound(found.begin(), found.end(), near), near);
  }
};

PointTree::PointTree(std::span<const Vec2> points) : places_(points.size()) {
  entries_.reserve(points.size());
  Box2 around;
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    entries_.push_back({points[i], i, true});
    around.include(points[i]);
  }
  while (leaves_ * kMostInLeaf < points.size()) leaves_ *= 2;
  in_leaf_ = std::max<std::size_t>((points.size() + leaves_ - 1) / leaves_, 1);
  boxes_.resize(2 * leaves_);
  left_.resize(2 * leaves_);
  std::vector<Half> parts{{1, 0, points.size(), around}};
  while (parts.size() < std::min(kParts, leaves_)) {
    std::vector<Half> halves(2 * parts.size());
    on_all_cores(parts.size(), [&](std::size_t i) {
      const auto [left, right] = halves_of(parts[i]);
      halves[2 * i] = left;
      halves[2 * i + 1] = right;
    });
    parts.swap(halves);
  }
  on_all_cores(parts.size(), [&](std::size_t i) { divide(parts[i]); });
  for (std::size_t node = parts.size(); node-- > 1;) sum_up(node);
  for (std::uint32_t i = 0; i < entries_.size(); ++i) places_[entries_[i].point] = i;
}

// Entries as many as half of the leaves hold come into the first.
std::array<PointTree::Half, 2> PointTree::halves_of(const Half& whole) {
  throw_if_stopped();
  const auto& [node, begin, end, around] = whole;
  std::size_t first_leaf = 2 * node + 1;
  while (first_leaf < leaves_) first_leaf *= 2;
  const std::size_t middle = std::min(end, (first_leaf - leaves_) * in_leaf_);
  std::array<Half, 2> out{Half{2 * node, begin, middle, around},
                          Half{2 * node + 1, middle, end, around}};
  if (middle == end) return out;
  const auto part = [&](double Vec2::*along) {
    const auto place = [&](std::size_t i) {
      return entries_.begin() + static_cast<std::ptrdiff_t>(i);
    };
    std::nth_element(place(begin), place(middle), place(end),
                     [&](const Entry& a, const Entry& b) { return a.at.*along < b.at.*along; });
    out[0].around.high.*along = out[1].around.low.*along = entries_[middle].at.*along;
  };
  if (around.width() >= around.height())
    part(&Vec2::x);
  else
    part(&Vec2::y);
  return out;
}

void PointTree::divide(const Half& whole) {
  if (whole.node >= leaves_) {
    for (std::size_t i = whole.begin; i < whole.end; ++i)
      boxes_[whole.node].include(entries_[i].at);
    left_[whole.node] = static_cast<std::uint8_t>(whole.end - whole.begin);
    return;
  }
  for (const Half& half : halves_of(whole)) divide(half);
  sum_up(whole.node);
}

void PointTree::sum_up(std::size_t node) {
  for (const std::size_t half : {2 * node, 2 * node + 1}) {
    if (left_[half] == 0) continue;
    boxes_[node].include(boxes_[half].low);
    boxes_[node].include(boxes_[half].high);
    ++left_[node];
  }
}

void PointTree::remove(std::uint32_t point) {
  const std::uint32_t place = places_[point];
  if (!entries_[place].is_left) return;
  entries_[place].is_left = false;
  for (std::size_t node = leaf_of(place); node > 0 && --left_[node] == 0; node /= 2) {
  }
}

// In a node that has any left.
template <class Found>
void PointTree::seek(std::size_t node, Vec2 to, Found& found) const {
  if (node >= leaves_) {
    const std::size_t begin = (node - leaves_) * in_leaf_,
                      end = std::min(begin + in_leaf_, entries_.size());
    for (std::size_t i = begin; i < end; ++i)
      if (entries_[i].is_left)
        found.take({dot(entries_[i].at - to, entries_[i].at - to), entries_[i].point});
    return;
  }
  std::size_t nearer = 2 * node, farther = nearer + 1;
  double to_nearer = squared_to(boxes_[nearer], to), to_farther = squared_to(boxes_[farther], to);
  if (to_farther < to_nearer) {
    std::swap(nearer, farther);
    std::swap(to_nearer, to_farther);
  }
  if (left_[nearer] > 0 && found.may_be_at(to_nearer)) seek(nearer, to, found);
  if (left_[farther] > 0 && found.may_be_at(to_farther)) seek(farther, to, found);
}

std::optional<std::uint32_t> PointTree::nearest(Vec2 to) const {
  Nearest found;
  if (left_[1] > 0) seek(1, to, found);
  return found.point();
}

std::optional<std::uint32_t> PointTree::nearest_to_point(std::uint32_t point) const {
  Nearest found;
  const std::uint32_t place = places_[point];
  const Vec2 to = entries_[place].at;
  std::size_t node = leaf_of(place);
  if (left_[node] > 0) seek(node, to, found);
  for (; node > 1; node /= 2)
    if (const std::size_t beside = node ^ 1U;
        left_[beside] > 0 && found.may_be_at(squared_to(boxes_[beside], to)))
      seek(beside, to, found);
  return found.point();
}

void PointTree::nearest(Vec2 to, std::size_t count, std::vector<std::uint32_t>& out) const {
  out.clear();
  if (count == 0) return;
  SomeNearest found{count, {}};
  found.found.reserve(count);
  if (left_[1] > 0) seek(1, to, found);
  for (const Near& near : found.found) out.push_back(near.point);
}

} // namespace orograph
