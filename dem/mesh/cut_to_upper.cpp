// SPDX-License-Identifier: GPL-3.0-or-later
// All edges are arranged first, which tells what is highest where; then only the lines that are
// seen are arranged again, so that what lies hidden leaves no cuts in what hides it.
#include "dem/mesh/tin_index.hpp"
#include "dem/mesh/upper_surface.hpp"
#include "dem/triangulate/orientation.hpp"
#include "dem/triangulate/plan_arrangement.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace orograph {
namespace {

using Face = std::array<Vec2, 3>;

// A face may run over the hidden edge of a triangle, which doesn't hold all of it then: its middle
// alone could lie on that edge, at the height of what hides it.
bool holds(const Tin& tin, std::uint32_t triangle, const Face& face, double tolerance_m) {
  for (std::uint32_t k = 0; k < 3; ++k) {
    const auto [i, j] = ends_of(tin.triangles[triangle], k);
    const Vec2 from{tin.vertices_m[i].x, tin.vertices_m[i].y};
    const Vec2 along = Vec2{tin.vertices_m[j].x, tin.vertices_m[j].y} - from;
    for (const Vec2 corner : face)
      if (cross(along, corner - from) < -tolerance_m * length(along)) return false;
  }
  return true;
}

bool is_over(const Tin& tin, std::uint32_t triangle, Vec2 p) {
  for (std::uint32_t k = 0; k < 3; ++k) {
    const auto [i, j] = ends_of(tin.triangles[triangle], k);
    const Vec3 &a = tin.vertices_m[i], &b = tin.vertices_m[j];
    if (orientation({a.x, a.y}, {b.x, b.y}, p) < 0) return false;
  }
  return true;
}

// For each face of the arrangement the triangle, among the chosen ones, that is highest in its
// middle; only triangles that hold the whole face, but for `tolerance_m`, are asked. kNoTriangle
// where there is none, or where a triangle of `whole` is over the middle, which has nothing over
// it. Of heights within `tolerance_m` of each other the one of the triangle that
// is chosen first counts.
std::vector<std::uint32_t> highest_triangles(const Tin& tin, std::span<const std::uint32_t> chosen,
                                             std::span<const std::uint32_t> whole,
                                             const PlanArrangement& arrangement,
                                             double tolerance_m) {
  Tin part{tin.vertices_m, {}, {}}; // those chosen, then those whole
  for (const std::uint32_t t : chosen) part.triangles.push_back(tin.triangles[t]);
  for (const std::uint32_t t : whole) part.triangles.push_back(tin.triangles[t]);
  const TinIndex index(part);
  std::vector<std::uint32_t> highest, near;
  for (const auto& [a, b, c] : arrangement.faces) {
    const Face face{arrangement.points[a], arrangement.points[b], arrangement.points[c]};
    const Vec2 middle = (1.0 / 3) * (face[0] + face[1] + face[2]);
    std::uint32_t found = kNoTriangle;
    double height_m = 0;
    index.meeting({middle, middle}, near);
    for (const std::uint32_t t : near) {
      // The whole ones come last and undo what was found.
      if (t >= chosen.size() && is_over(part, t, middle)) found = kNoTriangle;
      if (t >= chosen.size() || !holds(part, t, face, tolerance_m)) continue;
      const double here = height_on(part, t, middle);
      if (found != kNoTriangle && here <= height_m + tolerance_m) continue;
      found = chosen[t];
      height_m = here;
    }
    highest.push_back(found);
  }
  return highest;
}

// An edge between faces that is on no line, where rounding led lines past each other.
constexpr std::uint32_t no_line = 0xffffffff;

// A stretch of a line on whose two sides different triangles are the highest.
struct SeenLine {
  std::uint32_t of = 0; ///< the line, by number; or no_line
  std::vector<Vec2> points;
};

using Link = std::array<std::uint32_t, 2>; // two points, the lower number first

Link link(std::uint32_t a, std::uint32_t b) {
  return {std::min(a, b), std::max(a, b)};
}

// Edges of faces with different triangles on their sides, each once, in order.
std::vector<Link> seen_links(const PlanArrangement& arrangement,
                             std::span<const std::uint32_t> highest) {
  const auto beside = find_neighbours(arrangement.faces, arrangement.points.size()).of;
  std::vector<Link> links;
  for (std::size_t f = 0; f < arrangement.faces.size(); ++f)
    for (std::uint32_t k = 0; k < 3; ++k) {
      const std::uint32_t other = beside[f][k];
      if (highest[f] == (other == kNoTriangle ? kNoTriangle : highest[other])) continue;
      const auto [a, b] = ends_of(arrangement.faces[f], k);
      links.push_back(link(a, b));
    }
  std::sort(links.begin(), links.end());
  links.erase(std::unique(links.begin(), links.end()), links.end());
  return links;
}

// `highest` has a triangle for each face, or kNoTriangle. Points in a stretch's midst at which no
// other stretch ends are left out.
std::vector<SeenLine> seen_lines(const PlanArrangement& arrangement,
                                 std::span<const std::uint32_t> highest) {
  const std::vector<Link> links = seen_links(arrangement, highest);
  std::vector<std::uint32_t> links_at(arrangement.points.size());
  for (const Link& l : links)
    for (const std::uint32_t point : l) ++links_at[point];

  std::vector<SeenLine> seen;
  std::vector<bool> on_a_line(links.size(), false);
  for (std::uint32_t i = 0; i < arrangement.lines.size(); ++i) {
    const auto& line = arrangement.lines[i];
    bool runs_on = false;
    for (std::size_t j = 1; j < line.size(); ++j) {
      const Vec2 from = arrangement.points[line[j - 1]], to = arrangement.points[line[j]];
      const Link step = link(line[j - 1], line[j]);
      const auto place = std::lower_bound(links.begin(), links.end(), step);
      const bool is_seen = place != links.end() && *place == step;
      if (is_seen) on_a_line[static_cast<std::size_t>(place - links.begin())] = true;
      if (is_seen && !runs_on) seen.push_back({i, {from}});
      if (is_seen && runs_on && links_at[line[j - 1]] == 2) seen.back().points.pop_back();
      if (is_seen) seen.back().points.push_back(to);
      runs_on = is_seen;
    }
  }
  for (std::size_t i = 0; i < links.size(); ++i)
    if (!on_a_line[i])
      seen.push_back({no_line, {arrangement.points[links[i][0]], arrangement.points[links[i][1]]}});
  return seen;
}

// A part of a triangle, by points of the plane.
struct PlanPiece {
  std::uint32_t of = 0; ///< the triangle
  std::array<std::uint32_t, 3> points;
};

struct PieceVertices {
  std::vector<Vec3> vertices_m;                        ///< the Tin's, and new ones after them
  std::vector<std::array<std::uint32_t, 3>> triangles; ///< the pieces, by vertices
};

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

// At a point a piece has its triangle's own vertex, if one is there; else the height of the
// triangle's edge that is said to go through the point (`edges_at`, for each point), so that two
// neighbours have the same; else that of its plane. Heights at a point that are within
// `tolerance_m` are one vertex, except for different vertices of the Tin.
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

bool is_before(Vec2 a, Vec2 b) {
  return a.x != b.x ? a.x < b.x : a.y < b.y;
}

// Where edges end, in order.
std::vector<Vec2> vertices_of(const Tin& tin, std::span<const PlanEdge> edges) {
  std::vector<Vec2> vertices;
  for (const PlanEdge& edge : edges)
    for (const std::uint32_t v : edge) vertices.push_back(plan(tin.vertices_m[v]));
  std::sort(vertices.begin(), vertices.end(), is_before);
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  return vertices;
}

std::vector<Vec2> those_on(std::span<const std::vector<Vec2>> lines,
                           const std::vector<Vec2>& vertices) {
  std::vector<Vec2> there;
  for (const auto& line : lines)
    for (const Vec2 p : line)
      if (std::binary_search(vertices.begin(), vertices.end(), p, is_before)) there.push_back(p);
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
