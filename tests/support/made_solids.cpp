// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/made_solids.hpp"

#include <cmath>
#include <map>
#include <numbers>
#include <utility>

namespace orograph {
namespace {

using Vertex = std::uint32_t;

bool in_one_plane(const std::vector<Vec3>& at, const std::array<Vertex, 3>& a,
                  const std::array<Vertex, 3>& b) {
  const auto normal = [&](const std::array<Vertex, 3>& t) {
    const Vec3 n = cross(at[t[1]] - at[t[0]], at[t[2]] - at[t[0]]);
    return (1 / length(n)) * n;
  };
  return dot(normal(a), normal(b)) > 1 - 1e-12;
}

// Corners counterclockwise seen from outside.
void add_quad(Triangles& triangles, Vertex a, Vertex b, Vertex c, Vertex d) {
  triangles.push_back({a, b, c});
  triangles.push_back({a, c, d});
}

// Between two rings of vertices with centres, counterclockwise seen from above: vertices 2k and
// 2k + 1 below and above, then the two centres.
Solid upright_ring(std::vector<Vec3> vertices) {
  const auto n = static_cast<Vertex>(vertices.size() / 2);
  vertices.push_back({0, 0, 0});
  vertices.push_back({0, 0, 1});
  Triangles triangles;
  for (Vertex k = 0; k < n; ++k) {
    const Vertex low = 2 * k, next = 2 * ((k + 1) % n);
    add_quad(triangles, low, next, next + 1, low + 1);
    triangles.push_back({2 * n, next, low});
    triangles.push_back({2 * n + 1, low + 1, next + 1});
  }
  return solid_of(std::move(vertices), std::move(triangles));
}

Vec2 on_circle(int k, int of) {
  const double turn = 2 * std::numbers::pi * k / of;
  return {std::cos(turn), std::sin(turn)};
}

} // namespace

Solid solid_of(std::vector<Vec3> vertices_m, Triangles triangles) {
  Solid solid{std::move(vertices_m), std::move(triangles), {}};
  std::map<std::pair<Vertex, Vertex>, Vertex> left;
  for (Vertex t = 0; t < solid.triangles.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k)
      left[{solid.triangles[t][k], solid.triangles[t][(k + 1) % 3]}] = t;
  for (const auto& [ends, triangle] : left) {
    if (ends.first > ends.second) continue;
    SolidEdge edge{ends.first, ends.second, triangle, left.at({ends.second, ends.first}), false};
    edge.smooth =
        in_one_plane(solid.vertices_m, solid.triangles[edge.left], solid.triangles[edge.right]);
    solid.edges.push_back(edge);
  }
  return solid;
}

Solid made_cells(const std::vector<std::string>& rows) {
  const int high = static_cast<int>(rows.size()), wide = static_cast<int>(rows.front().size());
  const auto there = [&](int x, int y) {
    return x >= 0 && y >= 0 && x < wide && y < high &&
           rows[static_cast<std::size_t>(high - 1 - y)][static_cast<std::size_t>(x)] == '#';
  };
  std::vector<Vec3> vertices;
  std::map<std::array<int, 3>, Vertex> numbers;
  const auto vertex = [&](int x, int y, int z) {
    const auto [found, is_new] =
        numbers.try_emplace({x, y, z}, static_cast<Vertex>(vertices.size()));
    if (is_new)
      vertices.push_back({static_cast<double>(x), static_cast<double>(y), static_cast<double>(z)});
    return found->second;
  };
  Triangles triangles;
  const auto wall = [&](int ax, int ay, int bx, int by) {
    add_quad(triangles, vertex(ax, ay, 0), vertex(bx, by, 0), vertex(bx, by, 1), vertex(ax, ay, 1));
  };
  for (int y = 0; y < high; ++y)
    for (int x = 0; x < wide; ++x) {
      if (!there(x, y)) continue;
      add_quad(triangles, vertex(x, y, 1), vertex(x + 1, y, 1), vertex(x + 1, y + 1, 1),
               vertex(x, y + 1, 1));
      add_quad(triangles, vertex(x, y, 0), vertex(x, y + 1, 0), vertex(x + 1, y + 1, 0),
               vertex(x + 1, y, 0));
      if (!there(x, y - 1)) wall(x, y, x + 1, y);
      if (!there(x + 1, y)) wall(x + 1, y, x + 1, y + 1);
      if (!there(x, y + 1)) wall(x + 1, y + 1, x, y + 1);
      if (!there(x - 1, y)) wall(x, y + 1, x, y);
    }
  return solid_of(std::move(vertices), std::move(triangles));
}

Solid made_box() {
  return made_cells({"#"});
}

Solid made_star(int points) {
  std::vector<Vec3> vertices;
  for (int k = 0; k < 2 * points; ++k) {
    const Vec2 at = (k % 2 ? 0.4 : 1) * on_circle(k, 2 * points);
    vertices.push_back({at.x, at.y, 0});
    vertices.push_back({at.x, at.y, 1});
  }
  return upright_ring(std::move(vertices));
}

Solid made_round(int sides, bool cone) {
  std::vector<Vec3> vertices;
  for (int k = 0; k < sides; ++k) {
    const Vec2 at = on_circle(k, sides);
    vertices.push_back({at.x, at.y, 0});
    if (!cone) vertices.push_back({at.x, at.y, 1});
  }
  Solid solid;
  if (cone) {
    const auto n = static_cast<Vertex>(sides);
    vertices.push_back({0, 0, 0});
    vertices.push_back({0, 0, 1});
    Triangles triangles;
    for (Vertex k = 0; k < n; ++k) {
      triangles.push_back({n, (k + 1) % n, k});
      triangles.push_back({n + 1, k, (k + 1) % n});
    }
    solid = solid_of(std::move(vertices), std::move(triangles));
  } else {
    solid = upright_ring(std::move(vertices));
  }
  for (SolidEdge& edge : solid.edges) {
    const Vec3 &a = solid.vertices_m[edge.from], &b = solid.vertices_m[edge.to];
    if (a.z != b.z) edge.smooth = true;
  }
  return solid;
}

Solid made_pyramid() {
  return solid_of({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0.5, 0.5, 1}},
                  {{0, 2, 1}, {0, 3, 2}, {0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}});
}

Solid made_tetrahedron() {
  return solid_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
                  {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}});
}

Solid made_nested() {
  Solid solid = made_box();
  const Solid inner = solid;
  const auto vertices = static_cast<Vertex>(inner.vertices_m.size()),
             triangles = static_cast<Vertex>(inner.triangles.size());
  for (const Vec3& vertex : inner.vertices_m)
    solid.vertices_m.push_back(Vec3{0.25, 0.25, 0.25} + 0.5 * vertex);
  for (const auto& [a, b, c] : inner.triangles)
    solid.triangles.push_back({a + vertices, b + vertices, c + vertices});
  for (SolidEdge edge : inner.edges) {
    edge.from += vertices;
    edge.to += vertices;
    edge.left += triangles;
    edge.right += triangles;
    solid.edges.push_back(edge);
  }
  return solid;
}

Solid made_wires() {
  Solid solid;
  solid.vertices_m = {{0, 0, 0},     {0, 0, 1},     {-0.3, 0, 0.8},
                      {0.3, 0, 0.8}, {0.5, 0.5, 0}, {-0.5, 0.5, 0}};
  for (const auto& [from, to] : {std::pair<Vertex, Vertex>{0, 1}, {2, 3}, {1, 4}, {1, 5}}) {
    SolidEdge wire;
    wire.from = from;
    wire.to = to;
    solid.edges.push_back(wire);
  }
  return solid;
}

StandingSolid stand(const Solid& solid, bool mirrored, const std::function<Vec3(Vec3)>& place) {
  StandingSolid standing{&solid, {}, mirrored};
  for (const Vec3& vertex : solid.vertices_m) standing.vertices_m.push_back(place(vertex));
  return standing;
}

double volume_m3(const StandingSolid& standing) {
  double sum = 0;
  if (standing.vertices_m.empty()) return sum;
  const Vec3 o = standing.vertices_m.front(); // near it: products of small numbers
  for (const auto& [a, b, c] : standing.solid->triangles)
    sum += dot(standing.vertices_m[a] - o,
               cross(standing.vertices_m[b] - o, standing.vertices_m[c] - o));
  return sum / 6;
}

double winding_number(const StandingSolid& standing, Vec3 point) {
  double angle = 0;
  for (const auto& t : standing.solid->triangles) {
    const Vec3 a = standing.vertices_m[t[0]] - point, b = standing.vertices_m[t[1]] - point,
               c = standing.vertices_m[t[2]] - point;
    const double la = length(a), lb = length(b), lc = length(c);
    angle += 2 * std::atan2(dot(a, cross(b, c)),
                            la * lb * lc + dot(a, b) * lc + dot(b, c) * la + dot(c, a) * lb);
  }
  return angle / (4 * std::numbers::pi);
}

} // namespace orograph
