// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/triangulate/triangulate.hpp"

#include "dem/triangulate/cut_by_rings.hpp"
#include "dem/triangulate/inside_rings.hpp"
#include "dem/triangulate/merge_places.hpp"
#include "dem/triangulate/order_tin.hpp"
#include "dem/triangulate/peel_border.hpp"
#include "dem/triangulate/plane_lines.hpp"
#include "dem/triangulate/plane_triangulation.hpp"
#include "geometry/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <string>

namespace orograph {
namespace {

std::vector<Vec2> places_of(const std::vector<Vec3>& vertices_m) {
  std::vector<Vec2> places;
  places.reserve(vertices_m.size());
  for (const Vec3& v : vertices_m) places.push_back({v.x, v.y});
  return places;
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
        fmt::format("--max-edge {} is the least that keeps something", rounded_up(least_m)));
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
  const auto cuts = cut_by_rings(plane, survey.boundary, lines, heights_m);
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
