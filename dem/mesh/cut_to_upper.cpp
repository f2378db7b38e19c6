// SPDX-License-Identifier: GPL-3.0-or-later
// All edges are arranged first, which tells what is highest where; then only the lines that are
// seen are arranged again, so that what lies hidden leaves no cuts in what hides it.
#include "dem/mesh/cut_to_upper.hpp"

#include "dem/mesh/highest_triangle.hpp"
#include "dem/mesh/plan_arrangement.hpp"
#include "dem/mesh/seen_lines.hpp"

#include <algorithm>
#include <utility>

namespace orograph {
namespace {

Vec2 plan(const Vec3& p) {
  return {p.x, p.y};
}

// Each edge with the points where it pierces triangles, from its lower vertex to its higher.
std::vector<std::vector<Vec2>> edge_lines(const Tin& tin, std::span<const PlanEdge> edges,
                                          std::span<const CommonGround> grounds) {
  std::vector<PiercedEdge> pierced;
  for (const CommonGround& ground : grounds)
    pierced.insert(pierced.end(), ground.pierced.begin(), ground.pierced.end());
  const auto along = [&](const PiercedEdge& p) {
    const Vec2 from = plan(tin.vertices_m[p.edge[0]]), to = plan(tin.vertices_m[p.edge[1]]);
    return dot(p.at - from, to - from);
  };
  std::sort(pierced.begin(), pierced.end(), [&](const PiercedEdge& a, const PiercedEdge& b) {
    return a.edge != b.edge ? a.edge < b.edge : along(a) < along(b);
  });
  std::vector<std::vector<Vec2>> lines;
  auto next = pierced.begin();
  for (const PlanEdge& edge : edges) {
    auto& line = lines.emplace_back(std::vector{plan(tin.vertices_m[edge[0]])});
    const Vec2 last = plan(tin.vertices_m[edge[1]]);
    while (next != pierced.end() && next->edge < edge) ++next;
    for (; next != pierced.end() && next->edge == edge; ++next)
      if (next->at != line.back() && next->at != last) line.push_back(next->at);
    line.push_back(last);
  }
  return lines;
}

bool before(Vec2 a, Vec2 b) {
  return a.x != b.x ? a.x < b.x : a.y < b.y;
}

// Where edges end, in order.
std::vector<Vec2> vertices_of(const Tin& tin, std::span<const PlanEdge> edges) {
  std::vector<Vec2> vertices;
  for (const PlanEdge& edge : edges)
    for (const std::uint32_t v : edge) vertices.push_back(plan(tin.vertices_m[v]));
  std::sort(vertices.begin(), vertices.end(), before);
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  return vertices;
}

std::vector<Vec2> those_on(std::span<const std::vector<Vec2>> lines,
                           const std::vector<Vec2>& vertices) {
  std::vector<Vec2> there;
  for (const auto& line : lines)
    for (const Vec2 p : line)
      if (std::binary_search(vertices.begin(), vertices.end(), p, before)) there.push_back(p);
  return there;
}

bool same_corners(std::array<std::uint32_t, 3> a, std::array<std::uint32_t, 3> b) {
  std::sort(a.begin(), a.end());
  std::sort(b.begin(), b.end());
  return a == b;
}

// Edges of which other points than their ends are left, or no stretch from end to end.
std::vector<PlanEdge> split_edges(std::span<const PlanEdge> edges, std::span<const SeenLine> seen,
                                  const PlanArrangement& arrangement) {
  std::vector<PlanEdge> split;
  for (std::size_t i = 0; i < seen.size(); ++i) {
    if (seen[i].of >= edges.size()) continue;
    const bool alone = (i == 0 || seen[i - 1].of != seen[i].of) &&
                       (i + 1 == seen.size() || seen[i + 1].of != seen[i].of);
    if (!alone || arrangement.lines[i].size() > 2) split.push_back(edges[seen[i].of]);
  }
  split.erase(std::unique(split.begin(), split.end()), split.end());
  return split;
}

} // namespace

std::vector<PlanEdge> edges_of(const Tin& tin, std::span<const std::uint32_t> triangles) {
  std::vector<PlanEdge> edges;
  for (const std::uint32_t t : triangles)
    for (std::uint32_t k = 0; k < 3; ++k) edges.push_back(edge_of(tin.triangles[t], k));
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  return edges;
}

UpperPieces cut_to_upper(const Tin& tin, std::span<const std::uint32_t> chosen,
                         std::span<const std::uint32_t> whole,
                         std::span<const CommonGround> grounds, double tolerance_m) {
  const std::vector<PlanEdge> edges = edges_of(tin, chosen);
  const double reach_m = tolerance_m / 64; // some hundred roundings of the largest coordinate
  std::vector<std::vector<Vec2>> lines = edge_lines(tin, edges, grounds);
  for (const CommonGround& ground : grounds)
    if (ground.pierce) lines.push_back({(*ground.pierce)[0], (*ground.pierce)[1]});
  const auto highest_in = [&](const PlanArrangement& arrangement) {
    return highest_triangles(tin, chosen, whole, arrangement, tolerance_m);
  };
  std::vector<Vec2> fixed = vertices_of(tin, edges);
  const PlanArrangement all = arrange(lines, fixed, reach_m);
  const std::vector<SeenLine> seen = seen_lines(all, highest_in(all));

  lines.clear();
  for (const SeenLine& line : seen) lines.push_back(line.points);
  fixed = those_on(lines, fixed);
  const PlanArrangement arrangement = arrange(lines, fixed, reach_m);
  const std::vector<std::uint32_t> highest = highest_in(arrangement);
  std::vector<PlanPiece> pieces;
  for (std::size_t f = 0; f < highest.size(); ++f)
    if (highest[f] != kNoTriangle) pieces.push_back({highest[f], arrangement.faces[f]});
  std::stable_sort(pieces.begin(), pieces.end(),
                   [](const PlanPiece& a, const PlanPiece& b) { return a.of < b.of; });

  std::vector<std::vector<PlanEdge>> edges_at(arrangement.points.size());
  for (std::size_t i = 0; i < seen.size(); ++i)
    if (seen[i].of < edges.size())
      for (const std::uint32_t point : arrangement.lines[i])
        edges_at[point].push_back(edges[seen[i].of]);
  PieceVertices high = give_heights(tin, pieces, arrangement.points, edges_at, tolerance_m);

  UpperPieces upper{std::move(high.vertices_m), {}, split_edges(edges, seen, arrangement)};
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const auto& triangle = tin.triangles[pieces[i].of];
    upper.pieces.push_back(
        {pieces[i].of, same_corners(high.triangles[i], triangle) ? triangle : high.triangles[i]});
  }
  return upper;
}

} // namespace orograph
