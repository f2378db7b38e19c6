// SPDX-License-Identifier: GPL-3.0-or-later
#include "profiles/voids.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <tuple>

namespace orograph {
namespace {

std::uint32_t tail(const BorderEdge& b) {
  return b.left ? b.edge.from : b.edge.to;
}
std::uint32_t head(const BorderEdge& b) {
  return b.left ? b.edge.to : b.edge.from;
}

// The edges' numbers, by their vertex of higher index. (They come by that of lower index.)
std::vector<std::uint32_t> by_higher_vertex(const std::vector<BorderEdge>& border) {
  std::vector<std::uint64_t> keys(border.size());
  for (std::uint64_t i = 0; i < border.size(); ++i)
    keys[i] = std::uint64_t{border[i].edge.to} << 32U | i;
  std::sort(keys.begin(), keys.end());
  return {keys.begin(), keys.end()}; // the lower halves
}

// Where several loops meet: seen from above and counterclockwise, missing ground begins at an
// arriving edge and ends at a leaving one, along which its loop goes on.
template <class At>
void part_loops(const std::vector<BorderEdge>& border, const At& at, std::uint32_t vertex,
                const std::vector<std::uint32_t>& arriving,
                const std::vector<std::uint32_t>& leaving, std::vector<std::uint32_t>& next) {
  struct Spoke {
    double angle;
    bool leaves;
    std::uint32_t edge;
    bool operator<(const Spoke& o) const {
      return std::tie(angle, leaves, edge) < std::tie(o.angle, o.leaves, o.edge);
    }
  };
  std::vector<Spoke> spokes;
  const auto add = [&](std::uint32_t edge, std::uint32_t other, bool leaves) {
    const Vec2 along = at(other) - at(vertex);
    spokes.push_back({std::atan2(along.y, along.x), leaves, edge});
  };
  for (const std::uint32_t edge : arriving) add(edge, tail(border[edge]), false);
  for (const std::uint32_t edge : leaving) add(edge, head(border[edge]), true);
  std::sort(spokes.begin(), spokes.end());
  std::vector<bool> taken(spokes.size());
  for (std::size_t i = 0; i < spokes.size(); ++i) {
    if (spokes[i].leaves) continue;
    std::size_t k = i;
    while (!spokes[k].leaves || taken[k]) k = (k + 1) % spokes.size();
    taken[k] = true;
    next[spokes[i].edge] = spokes[k].edge;
  }
}

// The edge that follows each one on its loop. As many edges leave a vertex as arrive at it.
template <class At>
std::vector<std::uint32_t> following_edges(const std::vector<BorderEdge>& border, const At& at) {
  const auto count = static_cast<std::uint32_t>(border.size());
  const std::vector<std::uint32_t> by_higher = by_higher_vertex(border);
  std::vector<std::uint32_t> next(count), arriving, leaving;
  for (std::uint32_t lower = 0, higher = 0; higher < count;) {
    std::uint32_t vertex = border[by_higher[higher]].edge.to;
    if (lower < count) vertex = std::min(vertex, border[lower].edge.from);
    arriving.clear();
    leaving.clear();
    for (; lower < count && border[lower].edge.from == vertex; ++lower)
      (border[lower].left ? leaving : arriving).push_back(lower);
    for (; higher < count && border[by_higher[higher]].edge.to == vertex; ++higher)
      (border[by_higher[higher]].left ? arriving : leaving).push_back(by_higher[higher]);
    if (arriving.size() == 1)
      next[arriving.front()] = leaving.front();
    else
      part_loops(border, at, vertex, arriving, leaving, next);
  }
  return next;
}

template <class At>
std::vector<bool> clockwise_loops(const std::vector<BorderEdge>& border, const At& at) {
  const std::vector<std::uint32_t> next = following_edges(border, at);
  std::vector<bool> clockwise(border.size()), walked(border.size());
  for (std::uint32_t first = 0; first < border.size(); ++first) {
    if (walked[first]) continue;
    const Vec2 origin = at(tail(border[first]));
    double area = 0, rounding = 0; // twice the area
    std::uint32_t i = first;
    do {
      walked[i] = true;
      const Vec2 a = at(tail(border[i])) - origin, b = at(head(border[i])) - origin;
      area += cross(a, b);
      rounding += std::abs(a.x * b.y) + std::abs(a.y * b.x);
      i = next[i];
    } while (i != first);
    constexpr double kRounding = 1e-10; // what a crack between two walls has is far less
    if (area >= -kRounding * rounding) continue;
    do {
      clockwise[i] = true;
      i = next[i];
    } while (i != first);
  }
  return clockwise;
}

} // namespace

std::vector<bool> around_voids(const Grid& grid, const std::vector<BorderEdge>& border) {
  // In columns and rows, which are whole numbers: nothing is rounded.
  const auto columns = static_cast<std::uint32_t>(grid.columns);
  return clockwise_loops(border, [columns](std::uint32_t i) {
    return Vec2{static_cast<double>(i % columns), -static_cast<double>(i / columns)};
  });
}

std::vector<bool> around_voids(const Tin& tin, const std::vector<BorderEdge>& border) {
  return clockwise_loops(border, [&](std::uint32_t i) {
    return Vec2{tin.vertices_m[i].x, tin.vertices_m[i].y};
  });
}

std::vector<bool> around_voids(const Surface& surface, const std::vector<BorderEdge>& border) {
  return std::visit([&](const auto& s) { return around_voids(s, border); }, surface);
}

} // namespace orograph
