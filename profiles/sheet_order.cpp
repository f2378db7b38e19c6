// SPDX-License-Identifier: GPL-3.0-or-later
#include "profiles/sheet_order.hpp"

#include "dem/tin.hpp"
#include "geometry/on_all_cores.hpp"
#include "profiles/slab_lines.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <set>
#include <tuple>
#include <utility>

namespace orograph {
namespace {

// An edge of the border over X, with the triangle that it belongs to.
struct Rim {
  double x_begin, x_end, nearness_begin, nearness_end; // nearness is linear in X
  double rounding_begin, rounding_end;                 // of X
  std::uint32_t triangle;                              ///< its place in the part
  bool is_behind;                                      // the triangle is

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
    if (of_a != of_b) return of_a > of_b;
    // Of two at one place, as above a crack, the ground in front ends before the other begins.
    return a.is_behind != b.is_behind ? b.is_behind : i < j;
  }
};

std::vector<Rim> rims_of(const SheetTriangles& triangles, const SheetPart& part,
                         const PartVertices& vertices, const std::vector<BorderEdge>& border,
                         const View& view, double from_m) {
  std::vector<Rim> rims;
  std::size_t step = 0;
  for (const BorderEdge& of : border) {
    throw_if_stopped(step++);
    const auto [left, right] = triangles.sides_of(of.edge);
    const std::uint32_t place = part.place_of(of.left ? left : right);
    if (place == kNoTriangle) continue;
    ProfilePoint from = vertices[of.edge.from], to = vertices[of.edge.to];
    const int side = eye_side(view, from, to);
    if (side == 0 || std::max(from.v, to.v) <= from_m) continue;
    if (std::min(from.v, to.v) < from_m)
      (from.v < to.v ? from : to) = point_between(from, to, (from_m - from.v) / (to.v - from.v));
    const auto nearness = [&](ProfilePoint p) { return view.is_perspective() ? 1 / p.v : -p.v; };
    const auto rounding = [&](ProfilePoint p, double x) {
      return 16 * std::numeric_limits<double>::epsilon() *
             (std::hypot(p.u, p.v) + 2 * length(view.depth_origin_m)) *
             (view.is_perspective() ? (1 + std::abs(x)) / p.v : 1 + std::abs(view.x_per_v));
    };
    const double x_from = project(view, from).x, x_to = project(view, to).x;
    Rim rim{x_from, x_to, nearness(from), nearness(to), rounding(from, x_from), rounding(to, x_to),
            0,      false};
    if (rim.x_begin > rim.x_end) {
      std::swap(rim.x_begin, rim.x_end);
      std::swap(rim.nearness_begin, rim.nearness_end);
      std::swap(rim.rounding_begin, rim.rounding_end);
    }
    rim.triangle = place;
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
    double x, rounding;
    bool begins;
    std::uint32_t rim;
    std::uint32_t place = 0; ///< over X; the same of what is nearer than rounding
  };
  std::vector<Event> events;
  for (std::uint32_t i = 0; i < rims.size(); ++i) {
    events.push_back({rims[i].x_begin, rims[i].rounding_begin, true, i});
    events.push_back({rims[i].x_end, rims[i].rounding_end, false, i});
  }
  std::ranges::sort(events, {}, &Event::x);
  // Edges that end at one vertex, and others that begin there, share no X but by rounding, at which
  // nothing would tell which of them is nearer.
  std::vector<std::uint32_t> begins_at(rims.size()), ends_at(rims.size());
  for (std::size_t i = 0; i < events.size(); ++i) {
    Event& event = events[i];
    if (i > 0) {
      const Event& before = events[i - 1];
      event.place =
          before.place + (event.x - before.x > std::max(event.rounding, before.rounding) ? 1 : 0);
    }
    (event.begins ? begins_at : ends_at)[event.rim] = event.place;
  }
  std::ranges::sort(events, {}, [](const Event& event) {
    return std::tuple(event.place, event.begins, event.rim);
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
    if (begins_at[event.rim] == ends_at[event.rim]) continue; // no width
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

std::vector<std::uint32_t> sorted_places(const SheetTriangles& triangles, const SheetPart& part,
                                         const PartVertices& vertices,
                                         const std::vector<BorderEdge>& border, const View& view,
                                         double from_m) {
  const std::vector<Relation> gaps =
      across_gaps(rims_of(triangles, part, vertices, border, view, from_m));
  // All by their places in the part.
  const std::uint32_t count = part.count();
  std::vector<std::uint32_t> numbers(count, kNoTriangle); // of those that are there
  part.for_each(0, count, [&](std::uint32_t t, std::uint32_t place) {
    if (triangles.is_there(t)) numbers[place] = t;
  });
  // Calls take(triangle behind) for each that a triangle is in front of.
  const auto for_each_behind = [&](std::uint32_t place, const auto& take) {
    const std::uint32_t t = numbers[place];
    const auto corners = triangles.corners(t);
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t other = triangles.across(t, k);
      if (other == kNoTriangle) continue;
      const std::uint32_t a = corners[(k + 1) % 3], b = corners[(k + 2) % 3];
      const ProfilePoint from = vertices[std::min(a, b)], to = vertices[std::max(a, b)];
      if (std::max(from.v, to.v) <= from_m) continue;
      if (eye_side(view, from, to) * (a < b ? 1 : -1) <= 0) continue;
      if (const std::uint32_t behind = part.place_of(other); behind != kNoTriangle) take(behind);
    }
    for (auto gap = std::lower_bound(gaps.begin(), gaps.end(), Relation{place, 0});
         gap != gaps.end() && gap->first == place; ++gap)
      take(gap->second);
  };
  std::vector<std::uint32_t> in_front(count, 0), ready, places(count, 0);
  const auto for_each_there = [&](const auto& take) {
    for (std::uint32_t i = 0; i < count; ++i) {
      throw_if_stopped(i);
      if (numbers[i] != kNoTriangle) take(i);
    }
  };
  for_each_there([&](std::uint32_t i) {
    for_each_behind(i, [&](std::uint32_t behind) { ++in_front[behind]; });
  });
  std::uint32_t there = 0;
  for_each_there([&](std::uint32_t i) {
    ++there;
    if (in_front[i] == 0) ready.push_back(i);
  });
  constexpr std::uint32_t kTaken = std::numeric_limits<std::uint32_t>::max();
  std::vector<std::uint32_t> nearest; // all, where there is a cycle
  std::size_t next = 0, next_nearest = 0;
  for (std::uint32_t place = 0; place < there; ++place) {
    throw_if_stopped(place);
    if (next == ready.size()) { // a cycle
      if (nearest.empty()) {
        for_each_there([&](std::uint32_t i) { nearest.push_back(i); });
        const auto depth = [&](std::uint32_t i) {
          const auto [a, b, c] = triangles.corners(numbers[i]);
          return vertices[a].v + vertices[b].v + vertices[c].v;
        };
        std::ranges::sort(nearest, {}, depth);
      }
      while (in_front[nearest[next_nearest]] == kTaken) ++next_nearest;
      ready.push_back(nearest[next_nearest]);
    }
    const std::uint32_t taken = ready[next++];
    places[taken] = place;
    in_front[taken] = kTaken;
    for_each_behind(taken, [&](std::uint32_t behind) {
      if (in_front[behind] != kTaken && --in_front[behind] == 0) ready.push_back(behind);
    });
  }
  return places;
}

// Cells k - 1 and k of a strip on either side of an edge. `side`: above 0 where k is in front.
void take_edge(int k, int side, int cells, std::vector<FallingRun>& runs) {
  if (side <= 0 || k == 0 || k == cells) return;
  if (!runs.empty() && runs.back().last + 1 == k)
    runs.back().last = k;
  else
    runs.push_back({k - 1, k});
}

// Whether the triangles of the cells between two rows lie side by side, none turned over.
bool are_apart(std::span<const ProfilePoint> above, std::span<const ProfilePoint> below,
               const SheetPart::Cells& cells) {
  const auto turn = [](ProfilePoint a, ProfilePoint b, ProfilePoint c) {
    return (b.u - a.u) * (c.v - a.v) - (b.v - a.v) * (c.u - a.u);
  };
  for (std::size_t i = cells.first; i < cells.behind; ++i)
    if (!(turn(above[i], below[i], below[i + 1]) > 0) ||
        !(turn(above[i], below[i + 1], above[i + 1]) > 0))
      return false;
  return true;
}

// What is on either side of the lines between strips of cells.
struct SidesOfLines {
  bool any_in_front = false, any_behind = false; // the strip of the higher number
  void take(int side) {
    any_in_front = any_in_front || side > 0;
    any_behind = any_behind || side < 0;
  }
  bool is_one() const { return !any_in_front || !any_behind; }
};

} // namespace

std::optional<StripsOfCells> StripsOfCells::of(const Grid& grid, const SheetVertices& vertices,
                                               const SheetPart& part, const View& view,
                                               double from_m) {
  const auto columns = static_cast<std::uint32_t>(grid.columns),
             rows = static_cast<std::uint32_t>(grid.rows);
  std::vector<std::vector<FallingRun>> in_row(rows - 1), in_column(columns - 1);
  SidesOfLines of_rows, of_columns;
  FilledRows filled(grid, view, vertices);
  std::vector<std::uint8_t> upper_is_near(part.count() / 2);
  std::vector<ProfilePoint> above, row;
  bool was_filled = false;
  SheetPart::Cells north; // of the row
  for (std::uint32_t r = 0; r < rows; ++r) {
    throw_if_stopped();
    SheetPart::Cells south{0, 0, 0};
    if (r + 1 < rows)
      south = part.is_all() ? SheetPart::Cells{0, columns - 1, r * (columns - 1)} : part.rows()[r];
    SheetPart::Cells both = north.behind == 0 ? south : north; // all that is asked for
    if (north.behind > 0 && south.behind > 0) {
      both.first = std::min(north.first, south.first);
      both.behind = std::max(north.behind, south.behind);
    }
    bool is_filled = false;
    if (both.behind > 0) is_filled = filled.read(r, both.first, both.behind + 1, row);
    // Of edges those count whose cells are all looked at.
    if (part.is_all())
      for (std::uint32_t c = 0; c < columns; ++c)
        if (!(row[c].v > from_m)) return std::nullopt;
    for (std::uint32_t c = both.first; c < both.behind; ++c) {
      if ((r > 0 && !north.has(c)) || (r + 1 < rows && !south.has(c))) continue;
      // The eye is north of it where the row before is in front.
      const int side = -eye_side(view, row[c], row[c + 1]);
      of_rows.take(side);
      if (of_columns.is_one()) take_edge(static_cast<int>(r), side, grid.rows - 1, in_column[c]);
    }
    for (std::uint32_t c = north.first; c <= north.behind && north.behind > 0; ++c) {
      if ((c > 0 && !north.has(c - 1)) || (c + 1 < columns && !north.has(c))) continue;
      const int side = eye_side(view, above[c], row[c]);
      of_columns.take(side);
      if (of_rows.is_one()) take_edge(static_cast<int>(c), side, grid.columns - 1, in_row[r - 1]);
    }
    for (std::uint32_t c = north.first; c < north.behind; ++c)
      upper_is_near[north.place + c - north.first] = eye_side(view, above[c], row[c + 1]) > 0;
    if (north.behind > 0 && (is_filled || was_filled) && !are_apart(above, row, north))
      return std::nullopt;
    was_filled = is_filled;
    above.swap(row);
    north = south;
  }
  const auto made = [&](bool are_rows, const SidesOfLines& lines,
                        const std::vector<std::vector<FallingRun>>& in_strip, std::uint32_t cells) {
    StripsOfCells out{are_rows, !lines.any_in_front, cells, {}, std::move(upper_is_near)};
    for (const std::vector<FallingRun>& runs : in_strip) {
      out.falling.begin_strip();
      for (const FallingRun run : runs) out.falling.add(run);
    }
    return out;
  };
  if (of_rows.is_one()) return made(true, of_rows, in_row, columns - 1);
  if (of_columns.is_one()) return made(false, of_columns, in_column, rows - 1);
  return std::nullopt;
}

std::uint32_t StripsOfCells::place(std::uint32_t column, std::uint32_t row) const {
  const std::uint32_t cell = are_rows ? column : row;
  const auto strip = static_cast<int>(are_rows ? row : column);
  const int before = rises ? strip : falling.strips() - 1 - strip;
  return static_cast<std::uint32_t>(before) * cells + falling.place(strip, static_cast<int>(cell));
}

SheetOrder::SheetOrder(const Surface& surface, const SheetTriangles& triangles,
                       const SheetPart& part, const std::vector<BorderEdge>& border,
                       const View& view, double from_m)
    : part_(part) {
  const Grid* const grid = std::get_if<Grid>(&surface);
  if (grid) cells_ = static_cast<std::uint32_t>(grid->columns - 1);
  if (grid && !grid->is_on_earth()) {
    lattice_.emplace(*grid, view);
    return;
  }
  if (grid) strips_ = StripsOfCells::of(*grid, SheetVertices(surface, view), part, view, from_m);
  if (strips_) return;
  const PartVertices vertices(surface, view, part);
  places_ = sorted_places(triangles, part, vertices, border, view, from_m);
}

std::uint64_t SheetOrder::place(std::uint32_t t) const {
  const std::uint32_t row = t / 2 / cells_, column = t / 2 - row * cells_;
  if (lattice_)
    return lattice_->turn(static_cast<int>(column), static_cast<int>(row),
                          t % 2 == 0 ? Half::lower : Half::upper);
  const std::uint32_t place = part_.place_of(t);
  if (place == kNoTriangle) return 0;
  if (!strips_) return places_[place];
  const bool upper_is_near = strips_->upper_is_near[place / 2] != 0;
  return std::uint64_t{2} * strips_->place(column, row) + (upper_is_near == (t % 2 == 0) ? 1 : 0);
}

} // namespace orograph
