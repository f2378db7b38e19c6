// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/mesh/piece_vertices.hpp"

#include "dem/mesh/common_ground.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace orograph {
namespace {

std::optional<std::uint32_t> own_vertex(const Tin& tin, std::uint32_t triangle, Vec2 p) {
  for (const std::uint32_t v : tin.triangles[triangle])
    if (tin.vertices_m[v].x == p.x && tin.vertices_m[v].y == p.y) return v;
  return std::nullopt;
}

double height_along(const Tin& tin, const PlanEdge& edge, Vec2 p) {
  const Vec3 &a = tin.vertices_m[edge[0]], &b = tin.vertices_m[edge[1]];
  const double share = std::abs(b.x - a.x) > std::abs(b.y - a.y) ? (p.x - a.x) / (b.x - a.x)
                                                                 : (p.y - a.y) / (b.y - a.y);
  return a.z + std::clamp(share, 0.0, 1.0) * (b.z - a.z);
}

double height_of(const Tin& tin, std::uint32_t triangle, Vec2 p,
                 const std::vector<PlanEdge>& edges) {
  for (std::uint32_t k = 0; k < 3; ++k) {
    const PlanEdge edge = edge_of(tin.triangles[triangle], k);
    if (std::find(edges.begin(), edges.end(), edge) != edges.end())
      return height_along(tin, edge, p);
  }
  const auto& [i, j, k] = tin.triangles[triangle];
  const auto [low, high] =
      std::minmax({tin.vertices_m[i].z, tin.vertices_m[j].z, tin.vertices_m[k].z});
  return std::clamp(height_on(tin, triangle, p), low, high);
}

} // namespace

PieceVertices give_heights(const Tin& tin, std::span<const PlanPiece> pieces,
                           std::span<const Vec2> points,
                           std::span<const std::vector<PlanEdge>> edges_at, double tolerance_m) {
  PieceVertices result{tin.vertices_m, {}};
  std::vector<std::vector<std::uint32_t>> at(points.size()); // vertices at each point
  for (const PlanPiece& piece : pieces) // the Tin's first, so that new heights can join them
    for (const std::uint32_t point : piece.points)
      if (const auto v = own_vertex(tin, piece.of, points[point]))
        if (std::find(at[point].begin(), at[point].end(), *v) == at[point].end())
          at[point].push_back(*v);

  const auto vertex = [&](std::uint32_t point, std::uint32_t triangle) {
    const Vec2 p = points[point];
    if (const auto v = own_vertex(tin, triangle, p)) return *v;
    const double height_m = height_of(tin, triangle, p, edges_at[point]);
    const auto distance = [&](std::uint32_t v) {
      return std::abs(result.vertices_m[v].z - height_m);
    };
    const auto nearest =
        std::min_element(at[point].begin(), at[point].end(), [&](std::uint32_t a, std::uint32_t b) {
          return distance(a) < distance(b);
        });
    if (nearest != at[point].end() && distance(*nearest) <= tolerance_m) return *nearest;
    result.vertices_m.push_back({p.x, p.y, height_m});
    at[point].push_back(static_cast<std::uint32_t>(result.vertices_m.size() - 1));
    return at[point].back();
  };
  for (const PlanPiece& piece : pieces) {
    const auto& [a, b, c] = piece.points;
    const std::uint32_t i = vertex(a, piece.of), j = vertex(b, piece.of), k = vertex(c, piece.of);
    result.triangles.push_back({i, j, k});
  }
  return result;
}

} // namespace orograph
