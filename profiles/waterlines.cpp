// SPDX-License-Identifier: GPL-3.0-or-later
#include "profiles/waterlines.hpp"

#include "geometry/box.hpp"
#include "geometry/on_all_cores.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace orograph {
namespace {

constexpr std::size_t kOfTask = 1U << 14U;

std::size_t triangle_count(const Surface& surface) {
  if (const Grid* grid = std::get_if<Grid>(&surface)) return grid_triangle_count(*grid);
  return std::get<Tin>(surface).triangles.size();
}

Vec3 vertex_m(const Surface& surface, std::uint32_t vertex) {
  if (const Grid* grid = std::get_if<Grid>(&surface)) return grid->vertex_m(std::size_t{vertex});
  return std::get<Tin>(surface).vertices_m[vertex];
}

// In rising order, so that every edge has one direction.
std::array<std::uint32_t, 3> corners_of(const Surface& surface, std::size_t triangle) {
  std::array<std::uint32_t, 3> corners;
  if (const Grid* grid = std::get_if<Grid>(&surface)) {
    const auto cells = static_cast<std::size_t>(grid->columns) - 1;
    const auto column = static_cast<int>(triangle / 2 % cells),
               row = static_cast<int>(triangle / 2 / cells);
    const bool upper = triangle % 2 == static_cast<std::size_t>(Half::upper);
    corners = {static_cast<std::uint32_t>(grid->index(column, row)),
               static_cast<std::uint32_t>(upper ? grid->index(column + 1, row)
                                                : grid->index(column, row + 1)),
               static_cast<std::uint32_t>(grid->index(column + 1, row + 1))};
  } else {
    const auto& of_tin = std::get<Tin>(surface).triangles[triangle];
    std::copy(of_tin.begin(), of_tin.end(), corners.begin());
  }
  std::sort(corners.begin(), corners.end());
  return corners;
}

double squared_distance(Vec3 p, Vec3 from, Vec3 to) {
  const Vec3 way = to - from, at = p - from;
  const double length2 = dot(way, way);
  const double t = length2 > 0 ? std::clamp(dot(at, way) / length2, 0.0, 1.0) : 0;
  const Vec3 rest = at - t * way;
  return dot(rest, rest);
}

// Boxes about boxes about shores: each is halved at the middle of its longer side.
class Shores {
public:
  Shores(const Surface& surface, const std::vector<SurfaceEdge>& edges) {
    lines_.reserve(edges.size());
    for (const SurfaceEdge& edge : edges) {
      throw_if_stopped(lines_.size());
      lines_.push_back({vertex_m(surface, edge.from), vertex_m(surface, edge.to)});
    }
    if (!lines_.empty()) build(0, lines_.size());
  }

  // To the nearest, or `limit2` where none is as near.
  double squared_distance(Vec3 p, double limit2) const {
    if (!nodes_.empty()) ask(0, p, limit2);
    return limit2;
  }

private:
  struct Line {
    Vec3 from, to;
  };
  struct Node {
    Vec3 low, high;
    std::size_t begin, end; // of lines
    std::size_t second = 0; // its second half's node, behind all of the first; 0 of a leaf
  };

  std::size_t build(std::size_t begin, std::size_t end) {
    throw_if_stopped(begin);
    Box3 box;
    for (std::size_t i = begin; i < end; ++i) {
      box.include(lines_[i].from);
      box.include(lines_[i].to);
    }
    const std::size_t number = nodes_.size();
    nodes_.push_back({box.low, box.high, begin, end});
    constexpr std::size_t kOfLeaf = 4;
    if (end - begin <= kOfLeaf) return number;
    const Vec3 size = box.high - box.low;
    const std::size_t middle = begin + (end - begin) / 2;
    const auto at = [](std::size_t i) { return static_cast<std::ptrdiff_t>(i); };
    std::nth_element(lines_.begin() + at(begin), lines_.begin() + at(middle),
                     lines_.begin() + at(end), [&](const Line& a, const Line& b) {
                       return size.x >= size.y ? a.from.x + a.to.x < b.from.x + b.to.x
                                               : a.from.y + a.to.y < b.from.y + b.to.y;
                     });
    build(begin, middle);
    const std::size_t second = build(middle, end);
    nodes_[number].second = second;
    return number;
  }

  static double squared_distance(const Node& node, Vec3 p) {
    const Vec3 off{std::max({node.low.x - p.x, p.x - node.high.x, 0.0}),
                   std::max({node.low.y - p.y, p.y - node.high.y, 0.0}),
                   std::max({node.low.z - p.z, p.z - node.high.z, 0.0})};
    return dot(off, off);
  }

  void ask(std::size_t number, Vec3 p, double& least2) const {
    const Node& node = nodes_[number];
    if (squared_distance(node, p) >= least2) return;
    if (node.second == 0) {
      for (std::size_t i = node.begin; i < node.end; ++i)
        least2 = std::min(least2, orograph::squared_distance(p, lines_[i].from, lines_[i].to));
      return;
    }
    std::size_t nearer = number + 1, farther = node.second;
    if (squared_distance(nodes_[farther], p) < squared_distance(nodes_[nearer], p))
      std::swap(nearer, farther);
    ask(nearer, p, least2);
    ask(farther, p, least2);
  }

  std::vector<Line> lines_;
  std::vector<Node> nodes_;
};

// Of all vertices; at most `limit_m`, and NaN of those that aren't of level ground.
std::vector<double> distances(const Surface& surface, const LevelGround& level,
                              const std::vector<std::uint32_t>& triangles, double limit_m) {
  const Shores shores(surface, level.shores);
  const std::size_t count = vertex_count(surface);
  std::vector<bool> is_level(count);
  std::size_t step = 0;
  for (const std::uint32_t t : triangles) {
    throw_if_stopped(step++);
    for (const std::uint32_t vertex : corners_of(surface, t)) is_level[vertex] = true;
  }
  std::vector<double> out(count, std::numeric_limits<double>::quiet_NaN());
  on_all_cores((count + kOfTask - 1) / kOfTask, [&](std::size_t task) {
    for (std::size_t i = task * kOfTask; i < std::min(count, (task + 1) * kOfTask); ++i) {
      throw_if_stopped(i);
      if (is_level[i])
        out[i] = std::sqrt(shores.squared_distance(vertex_m(surface, static_cast<std::uint32_t>(i)),
                                                   limit_m * limit_m));
    }
  });
  return out;
}

std::vector<std::uint32_t> level_triangles(const Surface& surface, const LevelGround& level) {
  std::vector<std::uint32_t> out;
  const std::size_t count = triangle_count(surface);
  for (std::size_t t = 0; t < count; ++t) {
    throw_if_stopped(t);
    if (level.triangles.has(t)) out.push_back(static_cast<std::uint32_t>(t));
  }
  return out;
}

} // namespace

Isolines waterlines(const Surface& surface, const LevelGround& level,
                    std::span<const double> distances_m) {
  if (level.shores.empty() || distances_m.empty()) return {};
  // Farther than every line, so that none runs along what is out of reach.
  const double limit_m = 2 * distances_m.back();
  const std::vector<double> of_vertices =
      distances(surface, level, level_triangles(surface, level), limit_m);
  return isolines(surface,
                  [&](std::size_t first, std::span<double> out) {
                    std::copy_n(of_vertices.begin() + static_cast<std::ptrdiff_t>(first),
                                out.size(), out.begin());
                  },
                  distances_m, {.triangles = &level.triangles});
}

} // namespace orograph
