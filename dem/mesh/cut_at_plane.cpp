// SPDX-License-Identifier: GPL-3.0-or-later
// Triangles wholly within are copied, those with new vertices on their edges are split. Both sides
// of an edge have the same new vertices on it, so the pieces fit; and the two pieces of neighbours
// cover together what their triangles did, whichever way a vertex between them was rounded.
#include "dem/mesh/cut_at_plane.hpp"

#include "dem/mesh/overlap.hpp"
#include "dem/mesh/tin_from_triangles.hpp"
#include "dem/mesh/walls.hpp"
#include "dem/tin.hpp"
#include "dem/triangulate/orientation.hpp"
#include "geometry/on_all_cores.hpp"
#include "geometry/vec.hpp"

#include <algorithm>
#include <array>
#include <functional>
#include <limits>
#include <optional>
#include <utility>

namespace orograph {
namespace {

// What a plane leaves of a wall. Over each place the wall reaches from a low point to a high one,
// and so does what is left of it. All corners of what is left stand over such places, since the
// border has a point wherever the plane meets it.

// A place on the border of a wall.
struct WallPoint {
  Vec3 at_m;
  int side = 0; ///< of the plane: -1 within, 0 on it, 1 beyond
  std::uint32_t vertex = 0;
};

struct Column {
  WallPoint low, high;
};

// What is left over one place, of the points there, the lowest first.
std::optional<Column> left_over(const HalfSpace& space, std::vector<WallPoint> points,
                                const std::function<std::uint32_t(const Vec3&)>& new_vertex) {
  const WallPoint low = points.front(), high = points.back();
  const bool has_cut =
      std::any_of(points.begin(), points.end(), [](const WallPoint& p) { return p.side == 0; });
  if (low.side * high.side < 0 && !has_cut) {
    const double at_low = beyond(space, low.at_m), at_high = beyond(space, high.at_m);
    const double share = std::clamp(at_low / (at_low - at_high), 0.0, 1.0);
    const Vec3 at{low.at_m.x, low.at_m.y, low.at_m.z + share * (high.at_m.z - low.at_m.z)};
    points.push_back({at, 0, 0});
    // Rounded onto an end it is that end.
    if (at == low.at_m)
      points.back().vertex = low.vertex;
    else if (at == high.at_m)
      points.back().vertex = high.vertex;
    else
      points.back().vertex = new_vertex(at);
  }
  std::erase_if(points, [](const WallPoint& p) { return p.side > 0; });
  if (points.empty()) return std::nullopt;
  const auto lower = [](const WallPoint& a, const WallPoint& b) { return a.at_m.z < b.at_m.z; };
  const auto [least, greatest] = std::minmax_element(points.begin(), points.end(), lower);
  return Column{*least, *greatest};
}

bool before(const WallPoint& a, const WallPoint& b) {
  if (a.at_m.x != b.at_m.x) return a.at_m.x < b.at_m.x;
  return a.at_m.y != b.at_m.y ? a.at_m.y < b.at_m.y : a.at_m.z < b.at_m.z;
}

// The part within, as upright triangles between neighbouring places seen from above, by vertex. A
// triangle runs from its lower corner forth (east, or north along a meridian), up and back; the
// other way round where `turned`. `border` holds the wall's vertices and all new ones on its
// edges: one or two over each place, or three where an upright edge was cut. `new_vertex` gives
// the number of a new one on the plane, inside of the wall.
std::vector<std::array<std::uint32_t, 3>>
cut_wall(const HalfSpace& space, std::vector<WallPoint> border, bool turned,
         const std::function<std::uint32_t(const Vec3&)>& new_vertex) {
  const bool in_plane =
      std::all_of(border.begin(), border.end(), [](const WallPoint& p) { return p.side == 0; });
  std::sort(border.begin(), border.end(), before);
  std::vector<std::optional<Column>> columns;
  for (auto begin = border.begin(); begin != border.end();) {
    const auto end = std::find_if(begin, border.end(), [&](const WallPoint& p) {
      return p.at_m.x != begin->at_m.x || p.at_m.y != begin->at_m.y;
    });
    columns.push_back(left_over(space, {begin, end}, new_vertex));
    begin = end;
  }
  std::vector<std::array<std::uint32_t, 3>> triangles;
  const auto add = [&](const WallPoint& a, const WallPoint& b, const WallPoint& c) {
    if (a.vertex == b.vertex || b.vertex == c.vertex || c.vertex == a.vertex) return;
    if (!in_plane && std::min({a.side, b.side, c.side}) == 0) return;
    triangles.push_back(turned ? std::array{a.vertex, c.vertex, b.vertex}
                               : std::array{a.vertex, b.vertex, c.vertex});
  };
  for (std::size_t i = 0; i + 1 < columns.size(); ++i) {
    if (!columns[i] || !columns[i + 1]) continue;
    const Column &here = *columns[i], &next = *columns[i + 1];
    add(here.low, next.low, next.high);
    add(here.low, next.high, here.high);
  }
  return triangles;
}

// Splitting what is left of ground into triangles. Corners from i to j and the line between them
// are a polygon; it has one triangle at that line, whose third corner lies between i and j and
// splits the rest in two.

// Corners of a triangle, by their place in the polygon.
using PolygonTriangle = std::array<std::uint32_t, 3>;

// Its least height; below zero where it doesn't run counterclockwise.
double thickness_m(Vec2 a, Vec2 b, Vec2 c) {
  if (orientation(a, b, c) <= 0) return -1;
  return std::abs(cross(b - a, c - a)) / std::max({length(b - a), length(c - b), length(a - c)});
}

struct Best {
  double thinnest_m = std::numeric_limits<double>::infinity();
  std::uint32_t corner = 0;
};

// Of all ways to split the polygon the one whose thinnest triangle is the thickest, all of them
// counterclockwise, exactly; nothing where there is no such way. Of equals the first. REQUIRES 3
// corners or more that run counterclockwise. Cost O(n^3) for n corners: meant for few.
std::vector<PolygonTriangle> split_polygon(std::span<const Vec2> corners) {
  const auto n = static_cast<std::uint32_t>(corners.size());
  if (n == 3 && orientation(corners[0], corners[1], corners[2]) > 0) return {{0, 1, 2}};
  std::vector<Best> best(std::size_t{n} * n);
  const auto at = [&](std::uint32_t i, std::uint32_t j) -> Best& {
    return best[std::size_t{i} * n + j];
  };
  for (std::uint32_t length = 2; length < n; ++length)
    for (std::uint32_t i = 0; i + length < n; ++i) {
      const std::uint32_t j = i + length;
      at(i, j).thinnest_m = -1;
      for (std::uint32_t k = i + 1; k < j; ++k) {
        const double thinnest_m = std::min({thickness_m(corners[i], corners[k], corners[j]),
                                            at(i, k).thinnest_m, at(k, j).thinnest_m});
        if (thinnest_m > at(i, j).thinnest_m) at(i, j) = {thinnest_m, k};
      }
    }
  if (at(0, n - 1).thinnest_m < 0) return {};
  std::vector<PolygonTriangle> triangles;
  std::vector<std::array<std::uint32_t, 2>> to_do{{0, n - 1}};
  while (!to_do.empty()) {
    const auto [i, j] = to_do.back();
    to_do.pop_back();
    if (j - i < 2) continue;
    const std::uint32_t k = at(i, j).corner;
    triangles.push_back({i, k, j});
    to_do.push_back({i, k});
    to_do.push_back({k, j});
  }
  return triangles;
}

using Triangle = std::array<std::uint32_t, 3>;

class Cutter {
public:
  Cutter(const Tin& tin, const HalfSpace& space)
      : tin_(tin), space_(space), crossings_(find_crossings(tin, space)) {}

  Tin cut() {
    auto touched = crossings_.touched.begin();
    for (std::uint32_t t = 0; t < tin_.triangles.size(); ++t) {
      throw_if_stopped(t);
      const bool is_touched = touched != crossings_.touched.end() && *touched == t;
      if (is_touched) ++touched;
      const auto& [a, b, c] = tin_.triangles[t];
      const auto [least, greatest] =
          std::minmax({crossings_.side[a], crossings_.side[b], crossings_.side[c]});
      // What has a corner beyond and none within only touches the plane, or is beyond it.
      if (least >= 0 && greatest > 0) continue;
      if (!is_touched)
        triangles_.push_back(tin_.triangles[t]);
      else if (is_wall(tin_, t))
        split_wall(t);
      else
        split_ground(t);
    }
    return finish();
  }

private:
  const Vec3& vertex_m(std::uint32_t v) const {
    const std::size_t old = tin_.vertices_m.size();
    return v < old ? tin_.vertices_m[v] : crossings_.new_vertices_m[v - old];
  }

  // All vertices along the border, from the first corner.
  std::vector<std::uint32_t> border_of(std::uint32_t t) const {
    std::vector<std::uint32_t> border;
    for (std::uint32_t k = 0; k < 3; ++k) {
      const std::uint32_t corner = tin_.triangles[t][k];
      const PlanEdge edge = edge_of(tin_.triangles[t], (k + 2) % 3);
      border.push_back(corner);
      const std::size_t first = border.size();
      for (const PointOnEdge& point : crossings_.on(edge)) border.push_back(point.vertex);
      if (edge[0] != corner)
        std::reverse(border.begin() + static_cast<std::ptrdiff_t>(first), border.end());
    }
    return border;
  }

  void split_ground(std::uint32_t t) {
    std::vector<std::uint32_t> polygon = border_of(t);
    std::erase_if(polygon, [&](std::uint32_t v) { return crossings_.side[v] > 0; });
    std::vector<Vec2> corners;
    for (const std::uint32_t v : polygon) corners.push_back({vertex_m(v).x, vertex_m(v).y});
    const std::vector<PolygonTriangle> pieces = split_polygon(corners);
    has_thin_ = has_thin_ || is_thin(t);
    for (const auto& [i, j, k] : pieces) triangles_.push_back({polygon[i], polygon[j], polygon[k]});
    if (!pieces.empty()) return;
    turned_over_ = true;
    for (std::size_t i = 1; i + 1 < polygon.size(); ++i)
      triangles_.push_back({polygon[0], polygon[i], polygon[i + 1]});
  }

  // Not much thicker than what counts as one place, seen from above: rounding may fold its pieces.
  bool is_thin(std::uint32_t t) const {
    double longest_m = 0, reach_m = 0;
    for (std::uint32_t k = 0; k < 3; ++k) {
      const PlanEdge edge = edge_of(tin_.triangles[t], k);
      longest_m = std::max(longest_m, plan_length_m(tin_, edge));
      reach_m = std::max(reach_m, rounding_reach_m(tin_, edge));
    }
    return 2 * plan_area_m2(tin_, t) <= 4 * reach_m * longest_m;
  }

  void split_wall(std::uint32_t t) {
    std::vector<WallPoint> border;
    for (const std::uint32_t v : border_of(t))
      border.push_back({vertex_m(v), crossings_.side[v], v});
    const auto new_vertex = [&](const Vec3& at) {
      crossings_.new_vertices_m.push_back(at);
      crossings_.side.push_back(0);
      return static_cast<std::uint32_t>(crossings_.side.size() - 1);
    };
    for (const Triangle& piece : cut_wall(space_, std::move(border), is_turned(t), new_vertex))
      triangles_.push_back(piece);
  }

  // Against cut_wall's: whether the corners run forth, up and back.
  bool is_turned(std::uint32_t t) const {
    const auto& [i, j, k] = tin_.triangles[t];
    const Vec3 &a = tin_.vertices_m[i], &b = tin_.vertices_m[j], &c = tin_.vertices_m[k];
    const bool by_x = a.x != b.x || b.x != c.x;
    const auto along = [&](const Vec3& p) { return Vec2{by_x ? p.x : p.y, p.z}; };
    return orientation(along(a), along(b), along(c)) < 0;
  }

  Tin finish() {
    Tin out;
    std::vector<std::uint32_t> number(crossings_.side.size(), kNoTriangle);
    for (const Triangle& triangle : triangles_)
      for (const std::uint32_t v : triangle) number[v] = 0;
    std::uint32_t count = 0;
    for (std::uint32_t& n : number)
      if (n == 0) n = count++;
    out.vertices_m.reserve(count);
    for (std::uint32_t v = 0; v < number.size(); ++v)
      if (number[v] != kNoTriangle) out.vertices_m.push_back(vertex_m(v));
    out.triangles = std::move(triangles_);
    for (Triangle& triangle : out.triangles)
      for (std::uint32_t& v : triangle) v = number[v];
    out.neighbours = find_neighbours(out.triangles, out.vertices_m.size()).of;
    if (!turned_over_ && !(has_thin_ && first_overlap(out))) return out;
    if (std::all_of(out.triangles.begin(), out.triangles.end(), [&](const Triangle& t) {
          return on_one_line(out.vertices_m[t[0]], out.vertices_m[t[1]], out.vertices_m[t[2]]);
        }))
      return {};
    return tin_from_triangles({std::move(out.vertices_m), std::move(out.triangles)}, true,
                              "the surface cut at a plane")
        .tin;
  }

  const Tin& tin_;
  const HalfSpace& space_;
  PlaneCrossings crossings_;
  std::vector<Triangle> triangles_;
  bool turned_over_ = false, has_thin_ = false; ///< pieces, and triangles that were split
};

} // namespace

Tin cut_at_plane(const Tin& tin, const HalfSpace& space) {
  return Cutter(tin, space).cut();
}

} // namespace orograph
