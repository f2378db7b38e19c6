// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/profiles/triangle_cuts.hpp"

#include "tests/support/made_grid.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace orograph {
namespace {

struct FramePoint {
  double u, v, z;
};

std::vector<FramePoint> frame_points(const Grid& grid, const View& view) {
  std::vector<FramePoint> points;
  for (std::uint32_t i = 0; i < grid.size(); ++i) {
    const Vec3 p = vertex_m(grid, i);
    const double x = p.x - view.depth_origin_m.x, y = p.y - view.depth_origin_m.y;
    points.push_back({x * view.right.x + y * view.right.y, x * view.forward.x + y * view.forward.y,
                      p.z * view.exaggeration});
  }
  return points;
}

bool straddles(const FramePoint& a, const FramePoint& b, double depth) {
  return (a.v < depth && b.v > depth) || (a.v > depth && b.v < depth);
}

PlaneVertex crossing(const FramePoint& a, const FramePoint& b, double depth) {
  const long double t =
      (static_cast<long double>(depth) - a.v) / (static_cast<long double>(b.v) - a.v);
  return {a.u + t * (static_cast<long double>(b.u) - a.u),
          a.z + t * (static_cast<long double>(b.z) - a.z)};
}

void cut_edge(const FramePoint& a, const FramePoint& b, double depth,
              std::vector<PlaneVertex>& vertices) {
  if (straddles(a, b, depth)) vertices.push_back(crossing(a, b, depth));
}

} // namespace

View looking(Vec2 forward, Vec2 depth_origin_m, double exaggeration) {
  View view;
  view.projection = Projection::orthographic;
  view.forward = forward;
  view.right = {forward.y, -forward.x};
  view.depth_origin_m = depth_origin_m;
  view.exaggeration = exaggeration;
  return view;
}

TriangleCuts cut_by_triangles(const Grid& grid, const View& view, const TriangleSet& level,
                              double depth) {
  const std::vector<FramePoint> points = frame_points(grid, view);
  TriangleCuts cuts;
  for (int r = 0; r < grid.rows; ++r)
    for (int c = 0; c < grid.columns; ++c) {
      const FramePoint& here = points[grid.index(c, r)];
      const bool east = c + 1 < grid.columns, south = r + 1 < grid.rows;
      if (here.v == depth) cuts.vertices.push_back({here.u, here.z});
      if (east) cut_edge(here, points[grid.index(c + 1, r)], depth, cuts.vertices);
      if (south) cut_edge(here, points[grid.index(c, r + 1)], depth, cuts.vertices);
      if (east && south) cut_edge(here, points[grid.index(c + 1, r + 1)], depth, cuts.vertices);
    }
  for (const GridTriangle& triangle : triangles_of(grid)) {
    std::vector<PlaneVertex> met;
    for (std::size_t k = 0; k < 3; ++k) {
      const FramePoint& a = points[triangle.vertices[k]];
      if (a.v == depth) met.push_back({a.u, a.z});
      cut_edge(a, points[triangle.vertices[(k + 1) % 3]], depth, met);
    }
    if (met.size() < 2) continue; // not met, or touched in a vertex
    const bool is_level = !level.empty() && level.has(grid_triangle(grid, triangle.column,
                                                                    triangle.row, triangle.half));
    const bool in_order = met[0].u <= met[1].u;
    cuts.segments.push_back({met[in_order ? 0 : 1], met[in_order ? 1 : 0], is_level});
  }
  std::sort(cuts.vertices.begin(), cuts.vertices.end(),
            [](const PlaneVertex& a, const PlaneVertex& b) { return a.u < b.u; });
  return cuts;
}

namespace {

bool is_near(double u, double z, const PlaneVertex& v, double tolerance) {
  if (std::abs(u - v.u) > tolerance) return false;
  // On an edge with one height only, the crossing rounds to the vertex that has it, or not.
  return std::isnan(z) || std::isnan(v.z) || std::abs(z - v.z) <= 1e3 * tolerance;
}

// What the triangles say about the middle of a span.
Span span_at(const TriangleCuts& cuts, long double u, long double z, double tolerance) {
  Span span = Span::gap;
  for (const auto& [left, right, level] : cuts.segments) {
    if (!(left.u < u && u < right.u)) continue;
    const long double t = (u - left.u) / (right.u - left.u);
    if (!(std::abs(left.z + t * (right.z - left.z) - z) <= 1e3 * tolerance)) continue;
    if (span != Span::level) span = level ? Span::level : Span::slope;
  }
  return span;
}

} // namespace

std::string false_vertex_of(const Profile& profile, const TriangleCuts& expected,
                            double tolerance) {
  std::ostringstream fault;
  fault.precision(17);
  const std::size_t count = profile.size();
  if (profile.z_m.size() != count || profile.after.size() != count) return "arrays differ in size";
  if (count > 0 && profile.after.back() != Span::gap) return "something after the last vertex";
  for (std::size_t i = 0; i + 1 < count; ++i)
    if (!(profile.u_m[i] <= profile.u_m[i + 1])) {
      fault << "u falls after vertex " << i << " at " << profile.u_m[i];
      return fault.str();
    }
  for (std::size_t i = 0; i < count; ++i)
    if (std::none_of(expected.vertices.begin(), expected.vertices.end(), [&](const PlaneVertex& v) {
          return is_near(profile.u_m[i], profile.z_m[i], v, tolerance);
        })) {
      fault << "vertex " << i << " (" << profile.u_m[i] << ", " << profile.z_m[i]
            << ") is no crossing";
      return fault.str();
    }
  return {};
}

std::string fault_of(const Profile& profile, const TriangleCuts& expected, double tolerance) {
  const std::string false_vertex = false_vertex_of(profile, expected, tolerance);
  if (!false_vertex.empty()) return false_vertex;
  std::ostringstream fault;
  fault.precision(17);
  const std::size_t count = profile.size();
  bool apart = true;
  for (std::size_t k = 0; k < expected.vertices.size(); ++k) {
    const PlaneVertex& v = expected.vertices[k];
    apart = apart && (k == 0 || v.u - expected.vertices[k - 1].u > 4 * tolerance);
    bool found = false;
    for (std::size_t i = 0; i < count && !found; ++i)
      found = is_near(profile.u_m[i], profile.z_m[i], v, tolerance);
    if (!found) {
      fault << "no vertex at the crossing (" << v.u << ", " << v.z << ")";
      return fault.str();
    }
  }
  if (apart && count != expected.vertices.size()) {
    fault << count << " vertices instead of " << expected.vertices.size();
    return fault.str();
  }
  for (std::size_t i = 0; i + 1 < count; ++i) {
    const long double left = profile.u_m[i], right = profile.u_m[i + 1];
    if (right - left <= 4 * tolerance) continue;
    const long double z = (static_cast<long double>(profile.z_m[i]) + profile.z_m[i + 1]) / 2;
    const Span span = span_at(expected, (left + right) / 2, z, tolerance);
    if (profile.after[i] != span) {
      fault << "span after vertex " << i << " at " << profile.u_m[i] << " is "
            << static_cast<int>(profile.after[i]) << ", not " << static_cast<int>(span);
      return fault.str();
    }
  }
  if (std::abs(length_of(profile) - length_of(expected)) >
      1e3 * tolerance * static_cast<double>(count + 1)) {
    fault << "length " << length_of(profile) << " instead of " << length_of(expected);
    return fault.str();
  }
  return {};
}

double length_of(const Profile& profile) {
  double sum = 0;
  for (std::size_t i = 0; i + 1 < profile.size(); ++i)
    if (profile.after[i] != Span::gap)
      sum += std::hypot(profile.u_m[i + 1] - profile.u_m[i], profile.z_m[i + 1] - profile.z_m[i]);
  return sum;
}

double length_of(const TriangleCuts& cuts) {
  std::vector<CutSegment> segments = cuts.segments;
  std::sort(segments.begin(), segments.end(),
            [](const CutSegment& a, const CutSegment& b) { return a.left.u < b.left.u; });
  long double sum = 0, reached = -INFINITY;
  for (const auto& [left, right, level] : segments) {
    if (left.u == right.u || (left.u + right.u) / 2 < reached) continue; // an edge, met twice
    sum += std::hypot(right.u - left.u, right.z - left.z);
    reached = right.u;
  }
  return static_cast<double>(sum);
}

} // namespace orograph
