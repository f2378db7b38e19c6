// SPDX-License-Identifier: GPL-3.0-or-later
#include "profiles/drape.hpp"

#include "geometry/on_all_cores.hpp"
#include "profiles/triangles.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace orograph {
namespace {

// Shorter pieces are rounding. A share of the way.
constexpr double kSlit = 1e-12;

// The part of the way on which a value that is linear along it isn't negative, less what was cut
// away already.
void cut(double at_from, double at_to, double& begin, double& end) {
  if (at_from >= 0 && at_to >= 0) return;
  if (at_from < 0 && at_to < 0) {
    end = begin;
    return;
  }
  const double share = at_from / (at_from - at_to);
  (at_from < 0 ? begin : end) = at_from < 0 ? std::max(begin, share) : std::min(end, share);
}

} // namespace

Draper::Draper(const Surface& surface, const View& view) : surface_(surface), ends_(surface, view) {
  if (const Tin* tin = std::get_if<Tin>(&surface)) index_.emplace(*tin);
}

void Draper::drape(std::span<const Vec2> places, double above_m, DrapedLine& out) {
  out.points.clear();
  out.pieces.clear();
  out.is_whole = true;
  const auto add = [&](std::uint32_t triangle, Vec2 place) {
    ProfilePoint point = at(triangle, place);
    point.z += above_m;
    out.points.push_back(point);
    return static_cast<std::uint32_t>(out.points.size() - 1);
  };
  bool goes_on = false; // from the last point
  for (std::size_t i = 0; i + 1 < places.size(); ++i) {
    throw_if_stopped(i);
    const Vec2 from = places[i], to = places[i + 1];
    if (from == to) continue;
    find(from, to);
    double done = 0;
    for (const auto& [begin, end, triangle] : found_) {
      if (begin > done + kSlit) goes_on = out.is_whole = false;
      if (!goes_on) add(triangle, from + begin * (to - from));
      const auto first = static_cast<std::uint32_t>(out.points.size() - 1);
      const std::uint32_t last = add(triangle, end >= 1 ? to : from + end * (to - from));
      out.pieces.push_back({first, last, triangle});
      goes_on = true;
      done = end;
    }
    if (done < 1 - kSlit) goes_on = out.is_whole = false;
  }
}

void Draper::find(Vec2 from, Vec2 to) {
  found_.clear();
  if (const Grid* grid = std::get_if<Grid>(&surface_))
    find_on_grid(*grid, from, to);
  else
    find_on_tin(std::get<Tin>(surface_), from, to);
}

void Draper::find_on_grid(const Grid& grid, Vec2 from, Vec2 to) {
  double begin = 0, end = 1;
  cut(from.x, to.x, begin, end);
  cut(from.y, to.y, begin, end);
  cut(grid.columns - 1 - from.x, grid.columns - 1 - to.x, begin, end);
  cut(grid.rows - 1 - from.y, grid.rows - 1 - to.y, begin, end);
  if (!(begin < end)) return;
  const Vec2 way = to - from;
  shares_.assign({begin, end});
  // Columns, rows and diagonals, which are whole numbers of what is counted.
  const auto cross_lines = [&](double at_from, double by) {
    if (by == 0) return;
    const auto [low, high] = std::minmax({at_from + begin * by, at_from + end * by});
    for (double line = std::floor(low) + 1; line < high; ++line)
      shares_.push_back((line - at_from) / by);
  };
  cross_lines(from.x, way.x);
  cross_lines(from.y, way.y);
  cross_lines(from.x - from.y, way.x - way.y);
  std::sort(shares_.begin(), shares_.end());
  double first = begin;
  for (std::size_t i = 1; i < shares_.size(); ++i) {
    throw_if_stopped(i);
    if (shares_[i] - first <= kSlit && i + 1 < shares_.size()) continue;
    const Vec2 middle = from + 0.5 * (first + shares_[i]) * way;
    const int column = std::clamp(static_cast<int>(middle.x), 0, grid.columns - 2),
              row = std::clamp(static_cast<int>(middle.y), 0, grid.rows - 2);
    const bool lower = middle.y - row > middle.x - column;
    const double apex = lower ? grid.height_m(column, row + 1) : grid.height_m(column + 1, row);
    if (!std::isnan(grid.height_m(column, row) + grid.height_m(column + 1, row + 1) + apex))
      found_.push_back({first, shares_[i],
                        static_cast<std::uint32_t>(
                            grid_triangle(grid, column, row, lower ? Half::lower : Half::upper))});
    first = shares_[i];
  }
}

void Draper::find_on_tin(const Tin& tin, Vec2 from, Vec2 to) {
  triangles_.clear();
  index_->along(from, to, 0, triangles_);
  for (const std::uint32_t t : triangles_) {
    double begin = 0, end = 1;
    const double area = plan_area_m2(tin, t);
    if (!(area > 0)) continue; // a wall
    for (std::size_t k = 0; k < 3 && begin < end; ++k) {
      const Vec2 a = plan_m(tin, tin.triangles[t][k]),
                 b = plan_m(tin, tin.triangles[t][(k + 1) % 3]);
      cut(cross(b - a, from - a), cross(b - a, to - a), begin, end);
    }
    if (end - begin > kSlit) found_.push_back({begin, end, t});
  }
  std::sort(found_.begin(), found_.end(), [](const InTriangle& a, const InTriangle& b) {
    return a.from != b.from ? a.from < b.from : a.to < b.to;
  });
  // Along an edge both of its triangles have the line; between neighbours rounding leaves slits.
  constexpr double kBeside = 1e-9;
  double done = -1;
  std::erase_if(found_, [&](InTriangle& piece) {
    if (piece.from < done + kBeside) piece.from = done;
    if (piece.to - piece.from <= kSlit) return true;
    done = piece.to;
    return false;
  });
}

// As a weighted mean of the corners as the view has them, since the triangle is flat there.
ProfilePoint Draper::at(std::uint32_t triangle, Vec2 place) {
  std::array<std::uint32_t, 3> corners;
  double of_second = 0, of_third = 0;
  if (const Grid* grid = std::get_if<Grid>(&surface_)) {
    const auto cells = static_cast<std::uint32_t>(grid->columns) - 1;
    const auto column = static_cast<int>(triangle / 2 % cells),
               row = static_cast<int>(triangle / 2 / cells);
    const auto number = [&](int c, int r) { return static_cast<std::uint32_t>(grid->index(c, r)); };
    const double x = place.x - column, y = place.y - row;
    const bool lower = triangle % 2 == static_cast<std::uint32_t>(Half::lower);
    corners = {number(column, row), lower ? number(column, row + 1) : number(column + 1, row),
               number(column + 1, row + 1)};
    of_second = lower ? y - x : x - y;
    of_third = lower ? x : y;
  } else {
    const Tin& tin = std::get<Tin>(surface_);
    corners = tin.triangles[triangle];
    const Vec2 a = plan_m(tin, corners[0]), ab = plan_m(tin, corners[1]) - a,
               ac = plan_m(tin, corners[2]) - a;
    of_second = cross(place - a, ac) / cross(ab, ac);
    of_third = cross(ab, place - a) / cross(ab, ac);
  }
  if (corners != corners_) { // mostly those of the point before, and else two of them
    const std::array<std::uint32_t, 3> last = std::exchange(corners_, corners);
    const std::array<ProfilePoint, 3> at_last = at_corners_;
    for (std::size_t k = 0; k < 3; ++k) {
      const auto same =
          static_cast<std::size_t>(std::ranges::find(last, corners[k]) - last.begin());
      at_corners_[k] = same < 3 ? at_last[same] : ends_.vertex(corners[k]);
    }
  }
  const auto& [a, b, c] = at_corners_;
  const auto mean = [&](double at_a, double at_b, double at_c) {
    return at_a + of_second * (at_b - at_a) + of_third * (at_c - at_a);
  };
  return {mean(a.u, b.u, c.u), mean(a.v, b.v, c.v), mean(a.z, b.z, c.z)};
}

} // namespace orograph
