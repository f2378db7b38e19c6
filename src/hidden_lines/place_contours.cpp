// SPDX-License-Identifier: GPL-3.0-or-later
// A strip's cells have an upright at each end, a diagonal, and an edge along the lines on both
// sides. Rows are strips, or columns are; either way a cell's diagonal leads from its first vertex
// to its last.
#include "hidden_lines/place_contours.hpp"

#include "view/view.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <ranges>
#include <utility>
#include <variant>

namespace orograph {
namespace {

// Whether both ends of an edge are on one.
bool is_level(const LevelStanding& a, const LevelStanding& b) {
  return a.on_level && b.on_level && a.levels == b.levels;
}

} // namespace

PlaceContours::PlaceContours(const LatticeInWork& lattice, std::span<const double> levels_m,
                             const LinePictures& pictures)
    : lattice_(lattice), pictures_(pictures), levels_(levels_m),
      rows_(lattice.order.rows_are_strips()),
      columns_(static_cast<std::uint64_t>(lattice.grid.columns)), vertices_(lattice.grid.size()) {
}

void PlaceContours::find(const LatticeOrder::Place& place, const ShownOfPlace& shown,
                         const BlockedHorizon& horizon) {
  for (auto& found : found_) found.clear();
  if (shown.empty()) return;
  points_.swap(points_before_);
  points_.clear();
  constexpr int kNowhere = LatticeOrder::Place::kNone;
  if (place.strip == kNowhere) {
    take_line(near_, place.line, shown);
    far_.number = -1;
    add_edges_along(near_, shown);
    return;
  }
  if (far_.number == place.strip || near_.number == place.strip + 1) std::swap(near_, far_);
  take_line(near_, place.strip, shown);
  take_line(far_, place.strip + 1, shown);
  if (place.line != kNowhere) add_edges_along(place.line == place.strip ? near_ : far_, shown);
  find_cells(shown, horizon);
  add_points_of_cells();
  const int own = lattice_.order.first_outwards();
  for (const Cell& cell : cells_)
    if (cell.number >= own) add_pieces(PlacePart::outwards, cell);
  for (const Cell& cell : std::views::reverse(cells_))
    if (cell.number < own) add_pieces(PlacePart::backwards, cell);
  if (!near_.has_level || !far_.has_level) return;
  for (const Cell& cell : cells_) add_edges_within(cell.number);
  for (const PlacePart part : {PlacePart::outwards, PlacePart::backwards})
    std::ranges::stable_sort(found_[static_cast<std::size_t>(part)], {}, &Piece::turn);
}

// Which holds the vertices of all cells that are shown: it is the one that it was, or is read.
void PlaceContours::take_line(Line& line, int number, const ShownOfPlace& shown) {
  if (line.number == number && line.holds(shown.first_cell, shown.end_cell)) {
    for (std::uint32_t& first : line.points) {
      if (first == kNone) continue;
      const auto i = static_cast<std::size_t>(&first - line.points.data());
      const auto count = crossed_within(line.standings[i], line.standings[i + 1]).count();
      const auto begin = points_before_.begin() + static_cast<std::ptrdiff_t>(first);
      first = static_cast<std::uint32_t>(points_.size());
      points_.insert(points_.end(), begin, begin + static_cast<std::ptrdiff_t>(count));
    }
    return;
  }
  // The next places of the order show about the same.
  constexpr int kBeside = 16;
  const int cells = (rows_ ? lattice_.grid.columns : lattice_.grid.rows) - 1;
  const int end = std::min(shown.end_cell + kBeside, cells);
  line.number = number;
  line.first = std::max(shown.first_cell - kBeside, 0);
  line.has_level = false;
  line.standings.resize(static_cast<std::size_t>(end - line.first) + 1);
  line.points.assign(line.standings.size(), kNone);
  const std::size_t step = rows_ ? 1 : static_cast<std::size_t>(columns_);
  std::visit(
      [&](const auto& heights) {
        std::size_t at = vertex(number, line.first);
        for (LevelStanding& standing : line.standings) {
          standing = levels_.standing_of(static_cast<double>(heights[at]));
          line.has_level = line.has_level || standing.on_level;
          at += step;
        }
      },
      lattice_.grid.heights_m);
}

void PlaceContours::find_cells(const ShownOfPlace& shown, const BlockedHorizon& horizon) {
  cells_.clear();
  const LevelStanding *const near = &near_.at(shown.first_cell),
                      *const far = &far_.at(shown.first_cell);
  for (int i = 0; i < shown.end_cell - shown.first_cell; ++i) {
    const std::int32_t levels = near[i].levels;
    if (levels == near[i + 1].levels && levels == far[i].levels && levels == far[i + 1].levels)
      continue;
    const int number = shown.first_cell + i;
    if (!is_looked_at(near_.number, number)) continue;
    const bool follows = !cells_.empty() && cells_.back().number + 1 == number;
    const Cell cell{number,
                    follows ? cells_.back().on_near : corner(near_, number),
                    corner(near_, number + 1),
                    follows ? cells_.back().last : corner(far_, number),
                    corner(far_, number + 1),
                    kNone,
                    kNone,
                    kNone};
    if (may_be_seen(cell, horizon)) cells_.push_back(cell);
  }
}

PlaceContours::Corner PlaceContours::corner(const Line& line, int cell) const {
  const int column = rows_ ? cell : line.number, row = rows_ ? line.number : cell;
  const LevelStanding& standing = line.at(cell);
  return {column, row, &standing,
          to_profile_frame(lattice_.view,
                           lattice_.grid.plane().vertex_m(column, row, standing.value))};
}

// By bounds of all of the cell.
bool PlaceContours::may_be_seen(const Cell& cell, const BlockedHorizon& horizon) const {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  XRange x{kInfinity, -kInfinity};
  double highest = -kInfinity;
  for (const Corner* corner : {&cell.first, &cell.on_near, &cell.on_far, &cell.last}) {
    if (!(corner->at.v > lattice_.work.from_m)) return true;
    const Vec2 picture = project(lattice_.view, corner->at);
    x = {std::min(x.begin, picture.x), std::max(x.end, picture.x)};
    highest = std::max(highest, picture.y); // of the triangles that are there
  }
  const XRange looked_at = pictures_.looked_at();
  x = {std::max(x.begin, looked_at.begin), std::min(x.end, looked_at.end)};
  constexpr double kRounding = 1e-12;
  return x.begin <= x.end &&
         !is_below_blocks(horizon, x.begin, x.end, highest + kRounding * std::abs(highest));
}

bool PlaceContours::is_looked_at(int strip, int cell) const {
  const SeenGround* ground = lattice_.work.ground;
  return !ground || ground->seen[ground->index(column(strip, cell) / SeenGround::kSide,
                                               row(strip, cell) / SeenGround::kSide)] != 0;
}

void PlaceContours::add_point(std::uint64_t number, ProfilePoint at) {
  Vec2 picture{std::numeric_limits<double>::quiet_NaN(), 0};
  if (at.v > lattice_.work.from_m) picture = project(lattice_.view, at);
  points_.push_back({at, number, picture.x, picture.y});
}

// Tells the number of the first.
std::uint32_t PlaceContours::add_points(const Corner& from, const Corner& to) {
  const auto first = static_cast<std::uint32_t>(points_.size());
  const CrossedLevels crossed = crossed_within(*from.standing, *to.standing);
  if (crossed.first >= crossed.last) return first;
  // Row by row, those along a row before those between it and the next.
  const auto column = static_cast<std::uint64_t>(from.column);
  const std::uint64_t number = vertices_ + 3 * static_cast<std::uint64_t>(from.row) * columns_ +
                               (to.row == from.row         ? column
                                : to.column == from.column ? columns_ + 2 * column
                                                           : columns_ + 2 * column + 1);
  for (std::int32_t level = crossed.first; level < crossed.last; ++level)
    add_point(number, point_between(from.at, to.at,
                                    (levels_[level] - from.standing->value) /
                                        (to.standing->value - from.standing->value)));
  return first;
}

void PlaceContours::add_points_of_cells() {
  const Cell* last = nullptr;
  for (Cell& cell : cells_) {
    const bool follows = last && last->number + 1 == cell.number;
    cell.upright = follows ? last->upright_behind : add_points(cell.first, cell.on_far);
    cell.diagonal = add_points(cell.first, cell.last);
    cell.upright_behind = add_points(cell.on_near, cell.last);
    add_points_along(near_, cell.number, cell.first, cell.on_near);
    add_points_along(far_, cell.number, cell.on_far, cell.last);
    last = &cell;
  }
}

void PlaceContours::add_points_along(Line& line, int cell, const Corner& from, const Corner& to) {
  std::uint32_t& first = line.points[line.index(cell)];
  if (first == kNone) first = add_points(from, to);
}

// The nearer triangle's first.
void PlaceContours::add_pieces(PlacePart part, const Cell& of) {
  const int cell = of.number;
  const auto end = [&](const Line& line, int at) {
    return IsolineEnd{vertex(line.number, at), line.at(at)};
  };
  const auto point = [&](std::uint32_t number) {
    return static_cast<std::uint32_t>(vertices_) + number;
  };
  const IsolineEnd first = end(near_, cell), last = end(far_, cell + 1), //
      on_near = end(near_, cell + 1), on_far = end(far_, cell);
  const IsolineSide diagonal{first, last, point(of.diagonal)};
  const std::array<IsolineSide, 3> with_far{
      IsolineSide{first, on_far, point(of.upright)},
      {on_far, last, point(far_.points[far_.index(cell)])},
      diagonal};
  const std::array<IsolineSide, 3> with_near{
      diagonal,
      {on_near, last, point(of.upright_behind)},
      {first, on_near, point(near_.points[near_.index(cell)])}};
  const int column = of.first.column, row = of.first.row;
  for (const bool is_near : {true, false}) {
    const bool is_lower = lattice_.order.is_lower_near(column, row) == is_near;
    const LatticeOrder::Turn turn =
        lattice_.order.turn(column, row, is_lower ? Half::lower : Half::upper);
    for_each_isoline(is_lower == rows_ ? with_far : with_near, 0, [&](const Isoline& line) {
      if (line.to < vertices_) return; // an edge
      const auto number = [&](std::uint32_t of_end) {
        return of_end < vertices_ ? add_vertex(of_end)
                                  : of_end - static_cast<std::uint32_t>(vertices_);
      };
      found_[static_cast<std::size_t>(part)].push_back(
          {turn, number(line.from), number(line.to), line.level});
    });
  }
}

std::uint32_t PlaceContours::add_vertex(std::uint32_t vertex) {
  add_point(vertex,
            to_profile_frame(lattice_.view, lattice_.grid.vertex_m(std::size_t{vertex})));
  return static_cast<std::uint32_t>(points_.size() - 1);
}

// An edge that a level runs along is a piece just if one of its triangles falls from it.
void PlaceContours::add_edges_within(int cell) {
  const LevelStanding &first = near_.at(cell), &last = far_.at(cell + 1),
                      &on_near = near_.at(cell + 1), &on_far = far_.at(cell);
  const auto falls_to = [](const LevelStanding& level, const LevelStanding& third) {
    return third.is_there() && third.levels < level.levels;
  };
  const int near = near_.number, far = far_.number;
  if (is_level(first, last) && (falls_to(first, on_far) || falls_to(first, on_near)))
    add_edge(vertex(near, cell), vertex(far, cell + 1), first);
  if (is_level(first, on_far) && falls_to(first, last))
    add_edge(vertex(near, cell), vertex(far, cell), first);
  // The cell behind it, if it is one that falls, has that edge.
  if (is_level(on_near, last) && falls_to(on_near, first) &&
      !falls(on_near, near, cell + 1, far, cell + 2))
    add_edge(vertex(near, cell + 1), vertex(far, cell + 1), on_near);
}

void PlaceContours::add_edges_along(const Line& line, const ShownOfPlace& shown) {
  if (!line.has_level) return;
  const int number = line.number;
  for (int cell = shown.first_cell; cell < shown.end_cell; ++cell) {
    const LevelStanding& level = line.at(cell);
    if (is_level(level, line.at(cell + 1)) &&
        (falls(level, number, cell, number + 1, cell + 1) ||
         falls(level, number - 1, cell, number - 1, cell)))
      add_edge(vertex(number, cell), vertex(number, cell + 1), level);
  }
  std::ranges::sort(found_[static_cast<std::size_t>(PlacePart::line)], {}, &Piece::turn);
}

// Whether a cell is there, and its triangle with a vertex falls to that from a level.
bool PlaceContours::falls(const LevelStanding& level, int strip, int cell, int line,
                          int at) const {
  const int last_line = rows_ ? lattice_.grid.rows - 1 : lattice_.grid.columns - 1,
            last_cell = rows_ ? lattice_.grid.columns - 1 : lattice_.grid.rows - 1;
  if (strip < 0 || strip >= last_line || cell >= last_cell || !is_looked_at(strip, cell))
    return false;
  const LevelStanding third =
      levels_.standing_of(lattice_.grid.height_m(column(line, at), row(line, at)));
  return third.is_there() && third.levels < level.levels;
}

void PlaceContours::add_edge(std::uint32_t from, std::uint32_t to, const LevelStanding& level) {
  const LatticeOrder::Turn turn = lattice_.order.turn(SurfaceEdge{from, to});
  const std::uint32_t first = add_vertex(from);
  found_[static_cast<std::size_t>(part_of(lattice_.order, turn))].push_back(
      {turn, first, add_vertex(to), static_cast<std::uint32_t>(level.levels - 1)});
}

} // namespace orograph
