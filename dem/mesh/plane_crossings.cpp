// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/mesh/cut_at_plane.hpp"
#include "dem/mesh/overlap.hpp"
#include "dem/mesh/walls.hpp"
#include "dem/triangulate/orientation.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>

namespace orograph {
namespace {

bool is_upright(const Tin& tin, const PlanEdge& edge) {
  return plan_m(tin, edge[0]) == plan_m(tin, edge[1]);
}

// Reckoned from the edge's lower vertex.
Vec3 point_on(const Tin& tin, const PlanEdge& edge, double share) {
  const Vec3 &a = tin.vertices_m[edge[0]], &b = tin.vertices_m[edge[1]];
  return a + share * (b - a);
}

// A point near the line from one point to another, moved by as few roundings of the greatest
// coordinate as put it on the line or to the left of it, exactly.
Vec2 to_inner_side(Vec2 from, Vec2 to, Vec2 p) {
  const Vec2 by = to - from;
  double step_m = std::numeric_limits<double>::epsilon() / 2 *
                  std::max({std::abs(from.x), std::abs(from.y), std::abs(to.x), std::abs(to.y)});
  for (; orientation(from, to, p) < 0; step_m *= 2) {
    if (std::abs(by.x) >= std::abs(by.y))
      p.y += by.x > 0 ? step_m : -step_m;
    else
      p.x += by.y > 0 ? -step_m : step_m;
  }
  return p;
}

// Ground beside a wall.
struct BesideWall {
  std::uint32_t triangle = 0;
  PlanEdge edge;          ///< that it shares with the wall
  std::uint32_t apex = 0; ///< its vertex off the edge
};

// Walls over one line, and the places where they are cut.
struct WallStack {
  std::vector<std::uint32_t> walls;
  std::vector<PlanEdge> edges; ///< of the walls, those that aren't upright; in order, each once
  std::vector<BesideWall> grounds;

  // Places along the line seen from above, by the coordinate that grows faster along it.
  struct Column {
    double along;
    Vec2 place;
  };
  std::map<double, Vec2> columns;
  std::vector<double> new_columns; ///< those over none of the vertices
  bool along_x = true;

  double along(const Tin& tin, std::uint32_t vertex) const {
    return along_x ? tin.vertices_m[vertex].x : tin.vertices_m[vertex].y;
  }
  // A column at a share of an edge, or the nearest within rounding that is there. Never the edge's
  // own ends. REQUIRES a place that isn't within rounding of them.
  double add_column(const Tin& tin, const PlanEdge& edge, double share);
  // Moves new columns that have ground on one side of the line only to that side, by rounding.
  void round_to_ground(const Tin& tin);
  // Columns strictly between two, whichever is the greater.
  std::vector<Column> between(double one, double other) const;
};

// The walls that can be reached over edges that aren't upright.
WallStack stack_of(const Tin& tin, std::uint32_t wall) {
  WallStack stack;
  std::set<std::uint32_t> seen{wall};
  stack.walls.push_back(wall);
  for (std::size_t i = 0; i < stack.walls.size(); ++i) {
    const std::uint32_t t = stack.walls[i];
    for (std::uint32_t k = 0; k < 3; ++k) {
      const PlanEdge edge = edge_of(tin.triangles[t], k);
      if (is_upright(tin, edge)) continue;
      stack.edges.push_back(edge);
      const std::uint32_t other = tin.neighbours[t][k];
      if (other == kNoTriangle || seen.contains(other)) continue;
      if (is_wall(tin, other)) {
        seen.insert(other);
        stack.walls.push_back(other);
        continue;
      }
      for (const std::uint32_t v : tin.triangles[other])
        if (v != edge[0] && v != edge[1]) stack.grounds.push_back({other, edge, v});
    }
  }
  std::sort(stack.edges.begin(), stack.edges.end());
  stack.edges.erase(std::unique(stack.edges.begin(), stack.edges.end()), stack.edges.end());
  const Vec2 by = plan_m(tin, stack.edges[0][1]) - plan_m(tin, stack.edges[0][0]);
  stack.along_x = std::abs(by.x) >= std::abs(by.y);
  for (const PlanEdge& edge : stack.edges)
    for (const std::uint32_t v : edge) stack.columns[stack.along(tin, v)] = plan_m(tin, v);
  return stack;
}

double WallStack::add_column(const Tin& tin, const PlanEdge& edge, double share) {
  const Vec3 at = point_on(tin, edge, share);
  const double wanted = along_x ? at.x : at.y, reach_m = rounding_reach_m(tin, edge);
  const auto not_an_end = [&](double column) {
    return column != along(tin, edge[0]) && column != along(tin, edge[1]);
  };
  const double* nearest = nullptr;
  for (auto it = columns.lower_bound(wanted - reach_m);
       it != columns.end() && it->first <= wanted + reach_m; ++it)
    if (not_an_end(it->first) &&
        (nearest == nullptr || std::abs(it->first - wanted) < std::abs(*nearest - wanted)))
      nearest = &it->first;
  if (nearest != nullptr) return *nearest;
  columns[wanted] = {at.x, at.y};
  new_columns.push_back(wanted);
  return wanted;
}

void WallStack::round_to_ground(const Tin& tin) {
  for (const double column : new_columns) {
    Vec2& place = columns[column];
    bool left = false, right = false; // of the line the way it grows
    Vec2 from, to;
    for (const BesideWall& ground : grounds) {
      Vec2 first = plan_m(tin, ground.edge[0]), last = plan_m(tin, ground.edge[1]);
      double begin = along(tin, ground.edge[0]), end = along(tin, ground.edge[1]);
      if (begin > end) std::swap(first, last), std::swap(begin, end);
      if (column <= begin || column >= end) continue;
      (orientation(first, last, plan_m(tin, ground.apex)) > 0 ? left : right) = true;
      from = first, to = last;
    }
    if (left && !right) place = to_inner_side(from, to, place);
    if (right && !left) place = to_inner_side(to, from, place);
  }
}

std::vector<WallStack::Column> WallStack::between(double one, double other) const {
  const auto [low, high] = std::minmax({one, other});
  std::vector<Column> found;
  for (auto it = columns.upper_bound(low); it != columns.end() && it->first < high; ++it)
    found.push_back({it->first, it->second});
  return found;
}

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
      const Vec2 inner = to_inner_side(plan_m(tin_, from), plan_m(tin_, to), {at.x, at.y});
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

double plan_length_m(const Tin& tin, const PlanEdge& edge) {
  const Vec2 by = plan_m(tin, edge[1]) - plan_m(tin, edge[0]);
  return std::max(std::abs(by.x), std::abs(by.y));
}

double rounding_reach_m(const Tin& tin, const PlanEdge& edge) {
  double greatest_m = 0;
  for (const std::uint32_t v : edge)
    greatest_m = std::max({greatest_m, std::abs(plan_m(tin, v).x), std::abs(plan_m(tin, v).y)});
  return kRoundingsOnPlane * std::numeric_limits<double>::epsilon() * greatest_m;
}

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
