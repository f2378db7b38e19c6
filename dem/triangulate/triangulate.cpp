// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/triangulate/triangulate.hpp"

#include "dem/triangulate/place_order.hpp"
#include "dem/triangulate/plane_triangulation.hpp"
#include "geometry/error.hpp"
#include "geometry/on_all_cores.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <string>

namespace orograph {
namespace {

// True if every point of the ring has a height.
bool has_heights(const BoundaryRing& ring) {
  return std::none_of(ring.points_m.begin(), ring.points_m.end(),
                      [](const Vec3& p) { return std::isnan(p.z); });
}

struct MergedPlaces {
  std::vector<Vec3> vertices_m; ///< all at different places, in an order of place
  // Vertices of each breakline and of each ring of the boundary, in their order; those of a ring
  // without heights are empty.
  std::vector<std::vector<std::uint32_t>> breaklines, rings;
  std::uint64_t points = 0, merged = 0;
  double greatest_merged_m = 0;
};

// One list of all points: the scattered ones, then those of breaklines, then those of rings.
struct Listed {
  std::vector<Vec3> points_m;
  std::size_t scattered = 0;
};

Listed list_of(const Survey& survey) {
  Listed all{survey.points_m, survey.points_m.size()};
  for (const auto& line : survey.breaklines_m)
    all.points_m.insert(all.points_m.end(), line.begin(), line.end());
  for (const BoundaryRing& ring : survey.boundary)
    if (has_heights(ring))
      all.points_m.insert(all.points_m.end(), ring.points_m.begin(), ring.points_m.end());
  for (Vec3& p : all.points_m) { // -0.0 and 0.0 are one place
    p.x += 0.0;
    p.y += 0.0;
  }
  return all;
}

// Of sorted heights. From the lowest on, so that equal heights keep theirs to the last bit.
double mean(std::span<const double> heights) {
  double above = 0;
  for (const double height : heights) above += height - heights.front();
  return heights.front() + above / static_cast<double>(heights.size());
}

// The height at one place: of lines if there are any, else of points. Both lists get sorted.
double height_of(std::vector<double>& of_points, std::vector<double>& of_lines) {
  std::sort(of_points.begin(), of_points.end());
  std::sort(of_lines.begin(), of_lines.end());
  return mean(of_lines.empty() ? of_points : of_lines);
}

double range_of(const std::vector<double>& a, const std::vector<double>& b) {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const auto* heights : {&a, &b})
    if (!heights->empty()) {
      low = std::min(low, heights->front());
      high = std::max(high, heights->back());
    }
  return high - low;
}

// The next `count` numbers of the list.
std::vector<std::uint32_t> take(const std::vector<std::uint32_t>& numbers, std::size_t& at,
                                std::size_t count) {
  const auto first = numbers.begin() + static_cast<std::ptrdiff_t>(at);
  at += count;
  return {first, first + static_cast<std::ptrdiff_t>(count)};
}

// Points at one place become one vertex, by rule (1) of `triangulate`. The vertices don't depend
// on the order in which points and lines are given. Throws Error where there are more points than
// a Tin can number.
MergedPlaces merge_places(const Survey& survey) {
  const Listed all = list_of(survey);
  // Triangles are numbered with 32 bits as well, and there are up to two a vertex.
  constexpr std::size_t most = 2'000'000'000;
  if (all.points_m.size() > most)
    throw Error(fmt::format("{} points are too many", all.points_m.size()),
                fmt::format("at most {} can be triangulated; thin them out first", most));

  std::vector<Vec2> places;
  places.reserve(all.points_m.size());
  for (const Vec3& p : all.points_m) places.push_back({p.x, p.y});
  const std::vector<std::uint32_t> order = hilbert_order(places);

  MergedPlaces merged;
  merged.points = all.points_m.size();
  merged.vertices_m.reserve(order.size());
  std::vector<std::uint32_t> vertex_of(order.size());
  std::vector<double> of_points, of_lines;
  for (std::size_t begin = 0, end = 0; begin < order.size(); begin = end) {
    throw_if_stopped(merged.vertices_m.size());
    const Vec2 place = places[order[begin]];
    of_points.clear();
    of_lines.clear();
    for (end = begin; end < order.size() && places[order[end]] == place; ++end) {
      (order[end] < all.scattered ? of_points : of_lines).push_back(all.points_m[order[end]].z);
      vertex_of[order[end]] = static_cast<std::uint32_t>(merged.vertices_m.size());
    }
    merged.vertices_m.push_back({place.x, place.y, height_of(of_points, of_lines)});
    merged.greatest_merged_m = std::max(merged.greatest_merged_m, range_of(of_points, of_lines));
  }
  merged.merged = order.size() - merged.vertices_m.size();

  std::size_t at = all.scattered;
  for (const auto& line : survey.breaklines_m)
    merged.breaklines.push_back(take(vertex_of, at, line.size()));
  for (const BoundaryRing& ring : survey.boundary)
    merged.rings.push_back(take(vertex_of, at, has_heights(ring) ? ring.points_m.size() : 0));
  return merged;
}

double longest_edge_m(const PlaneMesh& mesh, const std::vector<Vec2>& places,
                      std::size_t triangle) {
  const auto& [a, b, c] = mesh.triangles[triangle];
  return std::max({length(places[b] - places[a]), length(places[c] - places[b]),
                   length(places[a] - places[c])});
}

// A triangle that is kept, has nothing kept beyond one of its edges and has an edge longer than
// `max_edge_m`, is kept no more; until there is none. Returns how many went.
std::uint64_t peel_border(const PlaneMesh& mesh, const std::vector<Vec2>& places, double max_edge_m,
                          std::vector<char>& kept) {
  std::uint64_t gone = 0;
  std::vector<std::uint32_t> open;
  const auto at_border = [&](std::uint32_t t) {
    if (!kept[t] || longest_edge_m(mesh, places, t) <= max_edge_m) return;
    kept[t] = 0;
    ++gone;
    open.push_back(t);
  };
  const auto is_border = [&](std::uint32_t beyond) {
    return beyond == kNoTriangle || !kept[beyond];
  };
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t)
    if (std::any_of(mesh.neighbours[t].begin(), mesh.neighbours[t].end(), is_border)) at_border(t);
  while (!open.empty()) {
    const std::uint32_t t = open.back();
    open.pop_back();
    for (const std::uint32_t next : mesh.neighbours[t])
      if (next != kNoTriangle) at_border(next);
  }
  return gone;
}

// The least `max_edge_m` by which something would stay of the kept triangles.
double least_max_edge_m(const PlaneMesh& mesh, const std::vector<Vec2>& places,
                        const std::vector<char>& kept) {
  // A triangle whose edges are short enough is never taken; with none, all are in the end.
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    if (kept[t]) least = std::min(least, longest_edge_m(mesh, places, t));
  return least;
}

// A triangle's new vertices from the first on, and where it was.
struct Placed {
  std::array<std::uint32_t, 3> vertices;
  std::uint32_t before;
  std::uint32_t turned; ///< its corner k was (k + turned) % 3
};

// New numbers of the vertices that are used; `tin` gets them in their new order.
std::vector<std::uint32_t> number_vertices(const PlaneMesh& mesh, const std::vector<char>& kept,
                                           const std::vector<Vec2>& places,
                                           const std::vector<double>& heights_m, Tin& tin) {
  std::vector<std::uint32_t> number(places.size(), kNoTriangle), used;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    if (kept[t])
      for (const std::uint32_t v : mesh.triangles[t]) number[v] = 0;
  std::vector<Vec2> used_places;
  for (std::uint32_t v = 0; v < places.size(); ++v)
    if (number[v] == 0) {
      used.push_back(v);
      used_places.push_back(places[v]);
    }
  tin.vertices_m.reserve(used.size());
  for (const std::uint32_t i : hilbert_order(used_places)) {
    number[used[i]] = static_cast<std::uint32_t>(tin.vertices_m.size());
    tin.vertices_m.push_back({used_places[i].x, used_places[i].y, heights_m[used[i]]});
  }
  return number;
}

// In buckets by the first vertex, as there are only a few triangles for each; then each bucket.
std::vector<Placed> in_order(const PlaneMesh& mesh, const std::vector<char>& kept,
                             const std::vector<std::uint32_t>& number, std::size_t vertices) {
  const auto placed = [&](std::uint32_t t) {
    const auto& [a, b, c] = mesh.triangles[t];
    const std::array<std::uint32_t, 3> v{number[a], number[b], number[c]};
    const auto first = static_cast<std::uint32_t>(std::min_element(v.begin(), v.end()) - v.begin());
    return Placed{{v[first], v[(first + 1) % 3], v[(first + 2) % 3]}, t, first};
  };
  std::vector<std::uint32_t> end(vertices + 1, 0);
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    throw_if_stopped(t);
    if (kept[t]) ++end[placed(t).vertices[0] + 1];
  }
  for (std::size_t v = 0; v < vertices; ++v) end[v + 1] += end[v];
  std::vector<Placed> ordered(end.back());
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    throw_if_stopped(t);
    if (!kept[t]) continue;
    const Placed here = placed(t);
    ordered[end[here.vertices[0]]++] = here;
  }
  // Each bucket's begin has become its end.
  for (std::size_t v = 0, begin = 0; v < vertices; begin = end[v], ++v) {
    throw_if_stopped(v);
    std::sort(ordered.begin() + static_cast<std::ptrdiff_t>(begin),
              ordered.begin() + static_cast<std::ptrdiff_t>(end[v]),
              [](const Placed& a, const Placed& b) { return a.vertices < b.vertices; });
  }
  return ordered;
}

// Vertices come along a Hilbert curve, those of no kept triangle are left out; a triangle starts
// with its first vertex, and triangles come in the order of their vertices.
Tin order_tin(const PlaneMesh& mesh, const std::vector<char>& kept, const std::vector<Vec2>& places,
              const std::vector<double>& heights_m) {
  Tin tin;
  const auto number = number_vertices(mesh, kept, places, heights_m, tin);
  const auto ordered = in_order(mesh, kept, number, tin.vertices_m.size());
  std::vector<std::uint32_t> now(mesh.triangles.size(), kNoTriangle);
  for (std::uint32_t t = 0; t < ordered.size(); ++t) now[ordered[t].before] = t;
  tin.triangles.reserve(ordered.size());
  tin.neighbours.reserve(ordered.size());
  for (const Placed& triangle : ordered) {
    throw_if_stopped(tin.triangles.size());
    tin.triangles.push_back(triangle.vertices);
    auto& across = tin.neighbours.emplace_back();
    for (std::uint32_t k = 0; k < 3; ++k) {
      const std::uint32_t before = mesh.neighbours[triangle.before][(k + triangle.turned) % 3];
      across[k] = before == kNoTriangle ? kNoTriangle : now[before];
    }
  }
  return tin;
}

std::vector<Vec2> places_of(const std::vector<Vec3>& vertices_m) {
  std::vector<Vec2> places;
  places.reserve(vertices_m.size());
  for (const Vec3& v : vertices_m) places.push_back({v.x, v.y});
  return places;
}

// Of the rings that have no heights.
std::vector<std::vector<Vec2>> places_of(const std::vector<BoundaryRing>& rings) {
  std::vector<std::vector<Vec2>> all;
  for (const BoundaryRing& ring : rings) {
    if (has_heights(ring)) continue;
    auto& places = all.emplace_back();
    for (const Vec3& p : ring.points_m) places.push_back({p.x + 0.0, p.y + 0.0}); // no -0.0
  }
  return all;
}

std::vector<double> heights_of(const std::vector<Vec3>& vertices_m) {
  std::vector<double> heights;
  heights.reserve(vertices_m.size());
  for (const Vec3& v : vertices_m) heights.push_back(v.z);
  return heights;
}

// Four digits, rounded up: as a bound it still keeps what x does.
std::string rounded_up(double x) {
  const double step = std::pow(10, std::floor(std::log10(x)) - 3);
  return fmt::format("{:.6g}", std::ceil(x / step) * step);
}

void take_long_ones(const PlaneMesh& mesh, const std::vector<Vec2>& places, double max_edge_m,
                    std::vector<char>& kept, TriangulationCounts& counts) {
  const double least_m = least_max_edge_m(mesh, places, kept);
  if (!(least_m <= max_edge_m))
    throw Error(
        fmt::format("every triangle has an edge longer than {:.6g} m", max_edge_m),
        fmt::format("`max_edge_m` {} is the least that keeps something", rounded_up(least_m)));
  counts.beyond_max_edge = peel_border(mesh, places, max_edge_m, kept);
}

} // namespace

Triangulated triangulate(const Survey& survey) {
  Triangulated result;
  TriangulationCounts& counts = result.counts;
  const MergedPlaces merged = merge_places(survey);
  counts.points = merged.points;
  counts.merged = merged.merged;
  counts.greatest_merged_m = merged.greatest_merged_m;
  counts.breaklines = survey.breaklines_m.size();
  if (merged.vertices_m.size() < 3)
    throw Error(fmt::format("{} points at {} different places make no triangle", merged.points,
                            merged.vertices_m.size()),
                "three places at least, not on one line");

  PlaneTriangulation plane(places_of(merged.vertices_m));
  if (!plane.has_area())
    throw Error(fmt::format("all {} places are on one straight line", merged.vertices_m.size()),
                "points beside it as well; check which columns or axes are east and north");
  std::vector<double> heights_m = heights_of(merged.vertices_m);

  std::vector<Edge> edges;
  for (const auto& line : merged.breaklines) append_edges(line, false, edges);
  const std::size_t of_breaklines = edges.size();
  for (const auto& ring : merged.rings) append_edges(ring, true, edges);
  const auto lines = add_lines(plane, edges);
  const SplitHeights crossings = add_heights_of_lines(plane, lines, heights_m);
  counts.crossings = crossings.vertices;
  counts.greatest_crossing_m = crossings.greatest_m;

  std::vector<std::uint32_t> ring_lines(lines.begin() + static_cast<std::ptrdiff_t>(of_breaklines),
                                        lines.end());
  const auto cuts = cut_by_rings(plane, places_of(survey.boundary), lines, heights_m);
  ring_lines.insert(ring_lines.end(), cuts.begin(), cuts.end());

  const PlaneMesh mesh = plane.mesh();
  std::vector<char> kept(mesh.triangles.size(), 1);
  if (!survey.boundary.empty()) {
    kept = inside_rings(plane, mesh, ring_lines);
    for (std::size_t t = 0; t < kept.size(); ++t) {
      const auto& [a, b, c] = mesh.triangles[t];
      if (std::isnan(heights_m[a] + heights_m[b] + heights_m[c]))
        kept[t] = 0; // beyond the points
      else if (!kept[t])
        ++counts.outside;
    }
    if (std::count(kept.begin(), kept.end(), 1) == 0)
      throw Error("no triangle is inside the boundary",
                  "a boundary around the points, in the same coordinates");
  }
  if (survey.max_edge_m) take_long_ones(mesh, plane.places(), *survey.max_edge_m, kept, counts);
  result.tin = order_tin(mesh, kept, plane.places(), heights_m);
  return result;
}

} // namespace orograph
