// SPDX-License-Identifier: GPL-3.0-or-later
#include "profiles/surface_edges.hpp"

#include "geometry/on_all_cores.hpp"
#include "profiles/facing.hpp"
#include "profiles/slab_lines.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

namespace orograph {
namespace {

void sort(std::vector<SurfaceEdge>& edges) {
  std::size_t steps = 0;
  std::sort(edges.begin(), edges.end(), StoppableLess(steps));
}

// With the vertex of lowest index first, as `facing_of` asks.
std::array<std::uint32_t, 3> lowest_first(std::array<std::uint32_t, 3> triangle) {
  std::rotate(triangle.begin(), std::min_element(triangle.begin(), triangle.end()), triangle.end());
  return triangle;
}

// Whether the edge is the upper border of a wall on one side of it. A vertical edge isn't.
bool is_top_of(const Tin& tin, std::uint32_t wall, SurfaceEdge edge) {
  const Vec3 a = tin.vertices_m[edge.from], b = tin.vertices_m[edge.to];
  const Vec3 apex = tin.vertices_m[apex_of(tin, wall, edge)];
  const Vec2 along{b.x - a.x, b.y - a.y}, to_apex{apex.x - a.x, apex.y - a.y};
  const double square = dot(along, along);
  return square > 0 && apex.z < a.z + dot(to_apex, along) / square * (b.z - a.z);
}

using Place = std::pair<double, double>;

// At the places of walls' vertices: how high the ground is that lies towards the eye, or along the
// way to it.
std::map<Place, double> ground_in_front(const Tin& tin, const TriangleSet& walls,
                                        const View& view) {
  std::map<Place, double> heights;
  const auto place = [&](std::uint32_t vertex) {
    return Place{tin.vertices_m[vertex].x, tin.vertices_m[vertex].y};
  };
  constexpr double kNone = -std::numeric_limits<double>::infinity();
  for (std::size_t t = 0; t < tin.triangles.size(); ++t) {
    throw_if_stopped(t);
    if (walls.has(t))
      for (const std::uint32_t vertex : tin.triangles[t]) heights.emplace(place(vertex), kNone);
  }
  for (std::size_t t = 0; t < tin.triangles.size(); ++t) {
    throw_if_stopped(t);
    if (walls.has(t)) continue;
    for (std::size_t k = 0; k < 3; ++k) {
      const auto height = heights.find(place(tin.triangles[t][k]));
      if (height == heights.end()) continue;
      const auto at = [&](std::size_t i) {
        return to_profile_frame(view, tin.vertices_m[tin.triangles[t][(k + i) % 3]]);
      };
      const ProfilePoint p = at(0), next = at(1), last = at(2);
      const Vec2 to_eye = view.is_perspective() ? Vec2{-p.u, -p.v} : Vec2{0, -1};
      const Vec2 to_next{next.u - p.u, next.v - p.v}, to_last{last.u - p.u, last.v - p.v};
      constexpr double kRounding = 1e-12;
      if (cross(to_next, to_eye) >= -kRounding * length(to_next) * length(to_eye) &&
          cross(to_eye, to_last) >= -kRounding * length(to_last) * length(to_eye))
        height->second = std::max(height->second, tin.vertices_m[tin.triangles[t][k]].z);
    }
  }
  return heights;
}

} // namespace

std::vector<std::uint8_t> facing_of_triangles(const Tin& tin, const View& view) {
  std::vector<std::uint8_t> facing(tin.triangles.size());
  const auto at = [&](std::uint32_t i) { return to_profile_frame(view, tin.vertices_m[i]); };
  on_all_cores(tasks_of_triangles(tin), [&](std::size_t task) {
    for (const std::uint32_t t : triangles_of_task(tin, task)) {
      const auto [a, b, c] = lowest_first(tin.triangles[t]);
      facing[t] = facing_of(view, at(a), at(b), at(c));
    }
  });
  return facing;
}

TriangleSet walls_of(const Tin& tin) {
  std::vector<std::vector<std::uint32_t>> of_tasks(tasks_of_triangles(tin));
  on_all_cores(of_tasks.size(), [&](std::size_t task) {
    for (const std::uint32_t t : triangles_of_task(tin, task)) {
      const auto& [a, b, c] = tin.triangles[t];
      const Vec3 p = tin.vertices_m[a], q = tin.vertices_m[b], r = tin.vertices_m[c];
      const double one = (q.x - p.x) * (r.y - p.y), other = (q.y - p.y) * (r.x - p.x);
      constexpr double kRounding = 4 * std::numeric_limits<double>::epsilon();
      if (std::abs(one - other) > kRounding * (std::abs(one) + std::abs(other))) continue;
      of_tasks[task].push_back(t);
    }
  });
  TriangleSet walls;
  for (const auto& of_task : of_tasks)
    for (const std::uint32_t t : of_task) {
      if (walls.empty()) walls = TriangleSet(tin.triangles.size());
      walls.add(t);
    }
  return walls;
}

std::vector<SurfaceEdge> edges_behind_walls(const Tin& tin, const View& view) {
  std::vector<SurfaceEdge> edges;
  const TriangleSet walls = walls_of(tin);
  if (walls.empty()) return edges;
  const std::vector<std::uint8_t> facing = facing_of_triangles(tin, view);
  const std::map<Place, double> heights_in_front = ground_in_front(tin, walls, view);
  for_each_edge(tin, [&](const TinEdge& e) {
    const Vec3 a = tin.vertices_m[e.edge.from], b = tin.vertices_m[e.edge.to];
    if (a.x == b.x && a.y == b.y) {
      const auto ground = heights_in_front.find({a.x, a.y});
      if (ground != heights_in_front.end() && ground->second >= std::max(a.z, b.z))
        edges.push_back(e.edge);
      return;
    }
    for (const std::uint32_t wall : {e.left, e.right}) {
      if (wall == kNoTriangle || !walls.has(wall) || facing[wall] != kMayTurn ||
          is_top_of(tin, wall, e.edge))
        continue;
      edges.push_back(e.edge);
      return;
    }
  });
  sort(edges);
  return edges;
}

namespace {

template <class Height>
std::vector<SurfaceEdge> edges_of(const Grid& grid, const Heights<Height>& heights) {
  const auto valid = [&](int column, int row) {
    return column >= 0 && row >= 0 && column < grid.columns && row < grid.rows &&
           !std::isnan(heights[grid.index(column, row)]);
  };
  std::vector<SurfaceEdge> edges;
  for (int row = 0; row < grid.rows; ++row) {
    throw_if_stopped();
    for (int column = 0; column < grid.columns; ++column) {
      if (!valid(column, row)) continue;
      const auto add = [&](int c, int r) {
        edges.push_back({static_cast<std::uint32_t>(grid.index(column, row)),
                         static_cast<std::uint32_t>(grid.index(c, r))});
      };
      // Each edge is there if one of its two triangles is.
      const bool east = valid(column + 1, row), south = valid(column, row + 1),
                 across = valid(column + 1, row + 1);
      if (east && (across || valid(column, row - 1))) add(column + 1, row);
      if (south && (across || valid(column - 1, row))) add(column, row + 1);
      if (across && (east || south)) add(column + 1, row + 1);
    }
  }
  return edges;
}

} // namespace

std::vector<SurfaceEdge> edges_of(const Grid& grid) {
  return std::visit([&](const auto& heights) { return edges_of(grid, heights); }, grid.heights_m);
}

std::vector<SurfaceEdge> edges_of(const Tin& tin) {
  std::vector<SurfaceEdge> edges;
  for_each_edge(tin, [&](const TinEdge& e) { edges.push_back(e.edge); });
  sort(edges);
  return edges;
}

std::vector<SurfaceEdge> edges_of(const Surface& surface) {
  return std::visit([](const auto& s) { return edges_of(s); }, surface);
}

std::vector<SurfaceEdge> brinks(const Surface& surface, const std::vector<BorderEdge>& border,
                                const View& view) {
  const Tin* tin = std::get_if<Tin>(&surface);
  const TriangleSet walls = tin ? walls_of(*tin) : TriangleSet();
  const auto is_ground_in_front = [&](SurfaceEdge edge, bool on_left) {
    const auto [from, to] = line_of(surface, view, edge);
    const double eye_on_left = view.is_perspective()
                                   ? from.u * to.v - to.u * from.v
                                   : from.u - to.u + view.x_per_v * (from.v - to.v);
    return on_left ? eye_on_left > 0 : eye_on_left < 0;
  };
  std::vector<SurfaceEdge> edges;
  if (walls.empty()) {
    std::size_t step = 0;
    for (const auto& [edge, left] : border) {
      throw_if_stopped(step++);
      if (is_ground_in_front(edge, left)) edges.push_back(edge);
    }
    return edges;
  }
  const auto is_ground = [&](std::uint32_t t) { return t != kNoTriangle && !walls.has(t); };
  for_each_edge(*tin, [&](const TinEdge& e) {
    if (is_ground(e.left) != is_ground(e.right) && is_ground_in_front(e.edge, is_ground(e.left)))
      edges.push_back(e.edge);
  });
  sort(edges);
  return edges;
}

std::vector<SurfaceEdge> edges_behind_walls(const Surface& surface, const View& view) {
  const Tin* tin = std::get_if<Tin>(&surface);
  return tin ? edges_behind_walls(*tin, view) : std::vector<SurfaceEdge>();
}

} // namespace orograph
