// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/mesh/plane_crossings.hpp"

#include "dem/mesh/edge_points.hpp"
#include "dem/mesh/orientation.hpp"
#include "dem/mesh/overlap.hpp"
#include "dem/mesh/wall_stack.hpp"

#include <algorithm>
#include <set>

namespace orograph {
namespace {

class Finder {
public:
  Finder(const Tin& tin, const HalfSpace& space) : tin_(tin), space_(space) {}

  PlaneCrossings find() {
    out_.side.reserve(tin_.vertices_m.size());
    for (const Vec3& vertex : tin_.vertices_m)
      out_.side.push_back(static_cast<std::int8_t>(side_of(space_, vertex)));
    std::vector<PlanEdge> near; // found before sides change
    for_each_crossing([&](std::uint32_t, std::uint32_t, const PlanEdge& e) { near.push_back(e); });
    for (const PlanEdge& edge : near) put_near_ends_on_plane(edge);

    std::vector<std::uint32_t> crossed_walls;
    for_each_crossing([&](std::uint32_t t, std::uint32_t k, const PlanEdge& edge) {
      const std::uint32_t other = tin_.neighbours[t][k];
      bool of_wall = false;
      for (const std::uint32_t triangle : {t, other})
        if (triangle != kNoTriangle && is_wall(tin_, triangle)) {
          of_wall = true;
          crossed_walls.push_back(triangle);
        }
      if (!of_wall || is_upright(tin_, edge)) cross(t, k, edge);
    });
    for (const std::uint32_t wall : crossed_walls)
      if (!stacked_.contains(wall)) cross_stack(wall);
    finish();
    return std::move(out_);
  }

private:
  // Each edge once, by its triangle of lower number.
  template <class Visit>
  void for_each_crossing(Visit visit) const {
    for (std::uint32_t t = 0; t < tin_.triangles.size(); ++t) {
      const auto& [a, b, c] = tin_.triangles[t];
      const auto [least, greatest] = std::minmax({out_.side[a], out_.side[b], out_.side[c]});
      if (least >= 0 || greatest <= 0) continue;
      for (std::uint32_t k = 0; k < 3; ++k) {
        const PlanEdge edge = edge_of(tin_.triangles[t], k);
        const std::uint32_t other = tin_.neighbours[t][k];
        if (is_crossed(edge) && (other == kNoTriangle || t < other)) visit(t, k, edge);
      }
    }
  }
  bool is_crossed(const PlanEdge& edge) const {
    return out_.side[edge[0]] * out_.side[edge[1]] < 0;
  }
  double share_at(const PlanEdge& edge) const {
    const double first = beyond(space_, tin_.vertices_m[edge[0]]),
                 last = beyond(space_, tin_.vertices_m[edge[1]]);
    return first / (first - last);
  }

  void put_near_ends_on_plane(const PlanEdge& edge) {
    if (is_upright(tin_, edge)) return;
    const double share = share_at(edge), length_m = plan_length_m(tin_, edge);
    const double reach_m = rounding_reach_m(tin_, edge);
    if (share * length_m <= reach_m) out_.side[edge[0]] = 0;
    if ((1 - share) * length_m <= reach_m) out_.side[edge[1]] = 0;
  }

  void cross(std::uint32_t t, std::uint32_t k, const PlanEdge& edge) {
    const double share = share_at(edge);
    Vec3 at = point_on(tin_, edge, share);
    if (tin_.neighbours[t][k] == kNoTriangle && !is_upright(tin_, edge)) {
      const auto [from, to] = ends_of(tin_.triangles[t], k);
      const Vec2 inner = to_inner_side(plan(tin_, from), plan(tin_, to), {at.x, at.y});
      at.x = inner.x, at.y = inner.y;
    }
    add(edge, share, at, 0);
    out_.touched.push_back(t);
    if (tin_.neighbours[t][k] != kNoTriangle) out_.touched.push_back(tin_.neighbours[t][k]);
  }

  void cross_stack(std::uint32_t wall) {
    WallStack stack = stack_of(tin_, wall);
    for (const std::uint32_t t : stack.walls) stacked_.insert(t), out_.touched.push_back(t);
    for (const BesideWall& beside : stack.grounds) out_.touched.push_back(beside.triangle);
    std::vector<double> crossing(stack.edges.size()); // the column on the plane
    for (std::size_t i = 0; i < stack.edges.size(); ++i)
      if (is_crossed(stack.edges[i]))
        crossing[i] = stack.add_column(tin_, stack.edges[i], share_at(stack.edges[i]));
    stack.round_to_ground(tin_);
    for (std::size_t i = 0; i < stack.edges.size(); ++i) {
      const PlanEdge& edge = stack.edges[i];
      const bool crossed = is_crossed(edge);
      const int first = out_.side[edge[0]], last = out_.side[edge[1]];
      const double begin = stack.along(tin_, edge[0]), end = stack.along(tin_, edge[1]);
      for (const auto& [along, place] : stack.between(begin, end)) {
        const bool on_plane = crossed && along == crossing[i];
        const double by_place = (along - begin) / (end - begin);
        const Vec3 at = point_on(tin_, edge, on_plane ? share_at(edge) : by_place);
        const bool before = crossed && (begin < end) == (along < crossing[i]);
        const int side = on_plane ? 0 : crossed ? (before ? first : last) : first + last;
        add(edge, by_place, {place.x, place.y, at.z}, std::clamp(side, -1, 1));
      }
    }
  }

  void add(const PlanEdge& edge, double along, const Vec3& at, int side) {
    out_.points.push_back({edge, along, static_cast<std::uint32_t>(out_.side.size())});
    out_.side.push_back(static_cast<std::int8_t>(side));
    out_.new_vertices_m.push_back(at);
  }

  void finish() {
    std::sort(out_.points.begin(), out_.points.end(),
              [](const PointOnEdge& a, const PointOnEdge& b) {
                return a.edge != b.edge ? a.edge < b.edge : a.along < b.along;
              });
    std::sort(out_.touched.begin(), out_.touched.end());
    out_.touched.erase(std::unique(out_.touched.begin(), out_.touched.end()), out_.touched.end());
  }

  const Tin& tin_;
  const HalfSpace& space_;
  std::set<std::uint32_t> stacked_; ///< walls that were looked at
  PlaneCrossings out_;
};

} // namespace

std::span<const PointOnEdge> PlaneCrossings::on(const PlanEdge& edge) const {
  const auto by_edge = [](const PointOnEdge& p, const PlanEdge& e) { return p.edge < e; };
  const auto begin = std::lower_bound(points.begin(), points.end(), edge, by_edge);
  auto end = begin;
  while (end != points.end() && end->edge == edge) ++end;
  return {begin, end};
}

PlaneCrossings find_crossings(const Tin& tin, const HalfSpace& space) {
  return Finder(tin, space).find();
}

} // namespace orograph
