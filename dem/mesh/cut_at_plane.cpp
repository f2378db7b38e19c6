// SPDX-License-Identifier: GPL-3.0-or-later
// Triangles wholly within are copied, those with new vertices on their edges are split. Both sides
// of an edge have the same new vertices on it, so the pieces fit; and the two pieces of neighbours
// cover together what their triangles did, whichever way a vertex between them was rounded.
#include "dem/mesh/cut_at_plane.hpp"

#include "dem/mesh/cut_wall.hpp"
#include "dem/mesh/edge_points.hpp"
#include "dem/mesh/neighbours.hpp"
#include "dem/mesh/orientation.hpp"
#include "dem/mesh/overlap.hpp"
#include "dem/mesh/plane_crossings.hpp"
#include "dem/mesh/split_polygon.hpp"
#include "dem/mesh/tin_from_triangles.hpp"
#include "dem/plan_area.hpp"

#include <algorithm>
#include <utility>

namespace orograph {
namespace {

using Triangle = std::array<std::uint32_t, 3>;

class Cutter {
public:
  Cutter(const Tin& tin, const HalfSpace& space)
      : tin_(tin), space_(space), crossings_(find_crossings(tin, space)) {}

  Tin cut() {
    auto touched = crossings_.touched.begin();
    for (std::uint32_t t = 0; t < tin_.triangles.size(); ++t) {
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
