// SPDX-License-Identifier: GPL-3.0-or-later
#include "profiles/sheet_order.hpp"

#include "dem/tin.hpp"
#include "geometry/on_all_cores.hpp"
#include "profiles/slab_lines.hpp"

#include <algorithm>
#include <limits>
#include <numeric>
#include <set>
#include <utility>

namespace orograph {
namespace {

// An edge of the border over X, with the triangle that it belongs to.
struct Rim {
  double x_begin, x_end, nearness_begin, nearness_end; // nearness is linear in X
  std::uint32_t triangle;
  bool is_behind; // the triangle is

  double nearness_at(double x) const {
    const double share = (x - x_begin) / (x_end - x_begin);
    return nearness_begin + share * (nearness_end - nearness_begin);
  }
};

struct IsNearer {
  const std::vector<Rim>* rims;
  bool operator()(std::uint32_t i, std::uint32_t j) const {
    if (i == j) return false;
    const Rim &a = (*rims)[i], &b = (*rims)[j];
    // Edges don't cross: where in the X that they share is a matter of rounding alone.
    const double x = 0.5 * (std::max(a.x_begin, b.x_begin) + std::min(a.x_end, b.x_end));
    const double of_a = a.nearness_at(x), of_b = b.nearness_at(x);
    return of_a != of_b ? of_a > of_b : i < j;
  }
};

std::vector<Rim> rims_of(const SheetTriangles& triangles, std::span<const ProfilePoint> vertices,
                         const std::vector<BorderEdge>& border, const View& view, double from_m) {
  std::vector<Rim> rims;
  for (const BorderEdge& of : border) {
    throw_if_stopped(rims.size());
    ProfilePoint from = vertices[of.edge.from], to = vertices[of.edge.to];
    const int side = eye_side(view, from, to);
    if (side == 0 || std::max(from.v, to.v) <= from_m) continue;
    if (std::min(from.v, to.v) < from_m)
      (from.v < to.v ? from : to) = point_between(from, to, (from_m - from.v) / (to.v - from.v));
    const auto nearness = [&](ProfilePoint p) { return view.is_perspective() ? 1 / p.v : -p.v; };
    Rim rim{project(view, from).x, project(view, to).x, nearness(from), nearness(to), 0, false};
    if (rim.x_begin == rim.x_end) continue;
    if (rim.x_begin > rim.x_end) {
      std::swap(rim.x_begin, rim.x_end);
      std::swap(rim.nearness_begin, rim.nearness_end);
    }
    const auto [left, right] = triangles.sides_of(of.edge);
    rim.triangle = of.left ? left : right;
    rim.is_behind = of.left != (side > 0);
    rims.push_back(rim);
  }
  return rims;
}

using Relation = std::pair<std::uint32_t, std::uint32_t>; // in front, behind

// Of what a ray leaves and where it comes in again: a sweep over X through the rims, which are kept
// in order of their nearness.
std::vector<Relation> across_gaps(const std::vector<Rim>& rims) {
  struct Event {
    double x;
    bool begins;
    std::uint32_t rim;
  };
  std::vector<Event> events;
  for (std::uint32_t i = 0; i < rims.size(); ++i) {
    events.push_back({rims[i].x_begin, true, i});
    events.push_back({rims[i].x_end, false, i});
  }
  std::sort(events.begin(), events.end(), [](const Event& a, const Event& b) {
    return a.x != b.x ? a.x < b.x : a.begins != b.begins ? !a.begins : a.rim < b.rim;
  });
  std::vector<Relation> out;
  std::set<std::uint32_t, IsNearer> active(IsNearer{&rims});
  std::vector<std::set<std::uint32_t, IsNearer>::iterator> places(rims.size(), active.end());
  const auto relate = [&](std::uint32_t front, std::uint32_t behind) {
    if (!rims[front].is_behind && rims[behind].is_behind)
      out.emplace_back(rims[front].triangle, rims[behind].triangle);
  };
  std::size_t step = 0;
  for (const Event& event : events) {
    throw_if_stopped(step++);
    if (event.begins) {
      const auto [at, is_new] = active.insert(event.rim);
      places[event.rim] = at;
      if (at != active.begin()) relate(*std::prev(at), event.rim);
      if (std::next(at) != active.end()) relate(event.rim, *std::next(at));
    } else {
      const auto at = places[event.rim], next = std::next(at);
      if (at != active.begin() && next != active.end()) relate(*std::prev(at), *next);
      active.erase(at);
    }
  }
  std::sort(out.begin(), out.end());
  out.erase(std::unique(out.begin(), out.end()), out.end());
  return out;
}

std::vector<std::uint32_t> sorted_places(const SheetTriangles& triangles,
                                         std::span<const ProfilePoint> vertices,
                                         const std::vector<BorderEdge>& border, const View& view,
                                         double from_m) {
  const std::vector<Relation> gaps =
      across_gaps(rims_of(triangles, vertices, border, view, from_m));
  const std::size_t count = triangles.count();
  // Calls take(triangle behind) for each that a triangle is in front of.
  const auto for_each_behind = [&](std::uint32_t t, const auto& take) {
    const auto corners = triangles.corners(t);
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t other = triangles.across(t, k);
      if (other == kNoTriangle) continue;
      const std::uint32_t a = corners[(k + 1) % 3], b = corners[(k + 2) % 3];
      const ProfilePoint &from = vertices[std::min(a, b)], &to = vertices[std::max(a, b)];
      if (std::max(from.v, to.v) <= from_m) continue;
      if (eye_side(view, from, to) * (a < b ? 1 : -1) > 0) take(other);
    }
    for (auto gap = std::lower_bound(gaps.begin(), gaps.end(), Relation{t, 0});
         gap != gaps.end() && gap->first == t; ++gap)
      take(gap->second);
  };
  std::vector<std::uint32_t> in_front(count, 0), ready, places(count, 0);
  for (std::uint32_t t = 0; t < count; ++t) {
    throw_if_stopped(t);
    if (triangles.is_there(t))
      for_each_behind(t, [&](std::uint32_t behind) { ++in_front[behind]; });
  }
  std::size_t there = 0;
  for (std::uint32_t t = 0; t < count; ++t) {
    if (!triangles.is_there(t)) continue;
    ++there;
    if (in_front[t] == 0) ready.push_back(t);
  }
  constexpr std::uint32_t kTaken = std::numeric_limits<std::uint32_t>::max();
  std::vector<std::uint32_t> nearest; // all, where there is a cycle
  std::size_t next = 0, next_nearest = 0;
  for (std::uint32_t place = 0; place < there; ++place) {
    throw_if_stopped(place);
    if (next == ready.size()) { // a cycle
      if (nearest.empty()) {
        for (std::uint32_t t = 0; t < count; ++t)
          if (triangles.is_there(t)) nearest.push_back(t);
        const auto depth = [&](std::uint32_t t) {
          const auto [a, b, c] = triangles.corners(t);
          return vertices[a].v + vertices[b].v + vertices[c].v;
        };
        std::ranges::sort(nearest, {}, depth);
      }
      while (in_front[nearest[next_nearest]] == kTaken) ++next_nearest;
      ready.push_back(nearest[next_nearest]);
    }
    const std::uint32_t t = ready[next++];
    places[t] = place;
    in_front[t] = kTaken;
    for_each_behind(t, [&](std::uint32_t behind) {
      if (in_front[behind] != kTaken && --in_front[behind] == 0) ready.push_back(behind);
    });
  }
  return places;
}

} // namespace

SheetOrder::SheetOrder(const Surface& surface, const SheetTriangles& triangles,
                       std::span<const ProfilePoint> vertices,
                       const std::vector<BorderEdge>& border, const View& view, double from_m) {
  const Grid* const grid = std::get_if<Grid>(&surface);
  if (grid && !grid->is_on_earth()) {
    lattice_.emplace(*grid, view);
    cells_ = static_cast<std::uint32_t>(grid->columns - 1);
    return;
  }
  places_ = sorted_places(triangles, vertices, border, view, from_m);
}

std::uint64_t SheetOrder::place(std::uint32_t t) const {
  if (!lattice_) return places_[t];
  return lattice_->turn(static_cast<int>(t / 2 % cells_), static_cast<int>(t / 2 / cells_),
                        t % 2 == 0 ? Half::lower : Half::upper);
}

} // namespace orograph
