// SPDX-License-Identifier: GPL-3.0-or-later
// A strip's cells have an upright at each end, a diagonal, and an edge along the lines on both
// sides. Rows are strips, or columns are; either way a cell's diagonal leads from its first vertex
// to its last.
#include "hidden_lines/place_contours.hpp"

#include "geometry/for_each_marked.hpp"
#include "view/view.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <ranges>
#include <type_traits>
#include <utility>
#include <variant>

namespace orograph {
namespace {

// Of vertices that have so many levels at them or below: whether the ground falls from the last of
// those to the other vertex, if it is there.
bool falls(std::int32_t levels, std::int32_t to) {
  return to != LevelStanding::kNowhere && to < levels;
}

} // namespace

PlaceContours::PlaceContours(const LatticeInWork& lattice, std::span<const double> levels_m,
                             const LinePictures& pictures)
    : lattice_(lattice), pictures_(pictures), levels_(levels_m),
      rows_(lattice.order.rows_are_strips()),
      columns_(static_cast<std::uint64_t>(lattice.grid.columns)), vertices_(lattice.grid.size()) {}

void PlaceContours::find(const LatticeOrder::Place& place, const ShownOfPlace& shown,
                         const BlockedHorizon& horizon) {
  for (auto& found : found_) found.clear();
  if (shown.empty()) return;
  // They stay where they are for some places, and in the cache.
  constexpr std::size_t kMostPoints = 512;
  const bool moves_points = points_.size() > kMostPoints;
  if (moves_points) {
    points_.swap(points_before_);
    points_.clear();
  }
  constexpr int kNowhere = LatticeOrder::Place::kNone;
  if (place.strip == kNowhere) {
    take_line(near_, place.line, shown, moves_points);
    far_.number = -1;
    cells_.clear();
    add_edges_along(near_, shown);
    return;
  }
  if (far_.number == place.strip || near_.number == place.strip + 1) std::swap(near_, far_);
  take_line(near_, place.strip, shown, moves_points);
  take_line(far_, place.strip + 1, shown, moves_points);
  if (place.line != kNowhere) add_edges_along(place.line == place.strip ? near_ : far_, shown);
  find_cells(shown, horizon);
  add_points_of_cells();
  if (const EarthStrips* earth = lattice_.order.earth()) {
    earth->for_each_in_order(
        place.strip, std::span(std::as_const(cells_)), [](const Cell& cell) { return cell.number; },
        [&](const Cell& cell) { add_pieces(PlacePart::outwards, cell); });
  } else {
    const int own = lattice_.order.first_outwards();
    for (const Cell& cell : cells_)
      if (cell.number >= own) add_pieces(PlacePart::outwards, cell);
    for (const Cell& cell : std::views::reverse(cells_))
      if (cell.number < own) add_pieces(PlacePart::backwards, cell);
  }
  if (!near_.on_level.empty() && !far_.on_level.empty()) add_edges_within();
}

// Which holds the vertices of all cells that are shown: it is the one that it was, or is read.
void PlaceContours::take_line(Line& line, int number, const ShownOfPlace& shown,
                              bool moves_points) {
  if (line.number == number && line.holds(shown.first_cell, shown.end_cell)) {
    if (!moves_points) return;
    for (const Cell& cell : cells_) { // of the place before
      std::uint32_t& first = line.points[line.index(cell.number)];
      const auto begin = points_before_.begin() + static_cast<std::ptrdiff_t>(first);
      const auto count =
          crossed_within(standing(line, cell.number), standing(line, cell.number + 1)).count();
      first = static_cast<std::uint32_t>(points_.size());
      points_.insert(points_.end(), begin, begin + static_cast<std::ptrdiff_t>(count));
    }
    return;
  }
  // The next places of the order show about the same.
  constexpr int kBeside = 16;
  const int last = (rows_ ? lattice_.grid.columns : lattice_.grid.rows) - 1;
  line.number = number;
  line.first = std::max(shown.first_cell - kBeside, 0);
  read(line, static_cast<std::size_t>(std::min(shown.end_cell + kBeside, last) - line.first) + 1);
}

void PlaceContours::find_levels(Line& line) {
  levels_.count_most(line.heights_m, line.levels, near_level_);
  std::ranges::fill(line.is_level, 0);
  line.on_level.clear();
  for (const std::uint32_t i : near_level_) {
    const LevelStanding standing = levels_.standing_of(line.heights_m[i]);
    line.levels[i] = standing.levels;
    if (!standing.on_level) continue;
    line.is_level[i] = 1;
    line.on_level.push_back(line.first + static_cast<int>(i));
  }
}

void PlaceContours::read(Line& line, std::size_t count) {
  for (std::vector<double>* of : {&line.heights_m, &line.u, &line.v, &line.z, &line.x, &line.y})
    of->resize(count);
  line.levels.resize(count);
  line.is_level.resize(count);
  line.points.assign(count, kNone);
  std::visit(
      [&](const auto& heights) {
        const std::size_t step = rows_ ? 1 : static_cast<std::size_t>(columns_);
        const auto* const from = heights.data() + vertex(line.number, line.first);
        for (std::size_t i = 0; i < count; ++i)
          line.heights_m[i] = static_cast<double>(from[i * step]);
      },
      lattice_.grid.heights_m);
  find_levels(line);
  std::visit([&](const auto& lattice) { put_in_place(lattice, line); }, lattice_.grid.lattice);
  const View view = lattice_.view;
  for (std::size_t i = 0; i < count; ++i) {
    const Vec2 picture = project(view, {line.u[i], line.v[i], line.z[i]});
    line.x[i] = picture.x;
    line.y[i] = picture.y;
  }
}

// Loops that the compiler turns into vector instructions.
template <class Lattice>
void PlaceContours::put_in_place(const Lattice& of_grid, Line& line) const {
  const View view = lattice_.view;
  // A small one is copied, so that it is known to stay what it is.
  const std::conditional_t<std::is_trivially_copyable_v<Lattice>, Lattice, const Lattice&> lattice =
      of_grid;
  const auto place = [&](const auto& place_of) {
    const double* const height_m = line.heights_m.data();
    double *const u = line.u.data(), *const v = line.v.data(), *const z = line.z.data();
    for (int i = 0; i < static_cast<int>(line.u.size()); ++i) {
      const ProfilePoint at = to_profile_frame(view, place_of(i, height_m[i]));
      u[i] = at.u;
      v[i] = at.v;
      z[i] = at.z;
    }
  };
  const int first = line.first, number = line.number;
  if (rows_)
    place([&](int i, double height_m) { return lattice.vertex_m(first + i, number, height_m); });
  else
    place([&](int i, double height_m) { return lattice.vertex_m(number, first + i, height_m); });
}

void PlaceContours::find_cells(const ShownOfPlace& shown, const BlockedHorizon& horizon) {
  cells_.clear();
  const int count = shown.end_cell - shown.first_cell;
  is_crossed_.resize(static_cast<std::size_t>(count));
  // A loop that the compiler turns into vector instructions.
  const std::int32_t *const near = &near_.levels[near_.index(shown.first_cell)],
                            *const far = &far_.levels[far_.index(shown.first_cell)];
  std::uint8_t* const is_crossed = is_crossed_.data();
  for (int i = 0; i < count; ++i) {
    const std::int32_t level = near[i];
    is_crossed[i] = ((level ^ near[i + 1]) | (level ^ far[i]) | (level ^ far[i + 1])) != 0 ? 1 : 0;
  }
  for_each_marked(is_crossed_, 0, count, 1, [&](int i) {
    const int cell = shown.first_cell + i;
    if (!is_looked_at(near_.number, cell)) return;
    if (!is_ahead(cell) || !is_hidden(cell, horizon)) cells_.push_back({cell, kNone, kNone, kNone});
  });
}

bool PlaceContours::is_ahead(int cell) const {
  const std::size_t near = near_.index(cell), far = far_.index(cell);
  // On the earth what isn't there has no place.
  return std::min({near_.v[near], near_.v[near + 1], far_.v[far], far_.v[far + 1]}) >
             lattice_.work.from_m &&
         !std::isnan(near_.v[near] + near_.v[near + 1] + far_.v[far] + far_.v[far + 1]);
}

// By bounds of all of the cell.
bool PlaceContours::is_hidden(int cell, const BlockedHorizon& horizon) const {
  const std::size_t near = near_.index(cell), far = far_.index(cell);
  const auto [x_begin, x_end] =
      std::minmax({near_.x[near], near_.x[near + 1], far_.x[far], far_.x[far + 1]});
  double highest = -std::numeric_limits<double>::infinity(); // of the vertices that are there
  for (const double y : {near_.y[near], near_.y[near + 1], far_.y[far], far_.y[far + 1]})
    highest = std::max(highest, y);
  const XRange looked_at = pictures_.looked_at();
  constexpr double kRounding = 1e-12;
  return x_end < looked_at.begin || x_begin > looked_at.end ||
         is_below_blocks(horizon, std::max(x_begin, looked_at.begin),
                         std::min(x_end, looked_at.end), highest + kRounding * std::abs(highest));
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

void PlaceContours::add_crossings(EdgeOfCell edge, const Line& line_from, int from,
                                  const Line& line_to, int to) {
  const std::size_t i = line_from.index(from), k = line_to.index(to);
  const LevelStanding a = standing(line_from, from), b = standing(line_to, to);
  const CrossedLevels crossed = crossed_within(a, b);
  if (crossed.first >= crossed.last) return;
  const ProfilePoint at_a{line_from.u[i], line_from.v[i], line_from.z[i]},
      at_b{line_to.u[k], line_to.v[k], line_to.z[k]};
  // Row by row, those along a row before those between it and the next.
  const auto column = static_cast<std::uint64_t>(this->column(line_from.number, from)),
             row = static_cast<std::uint64_t>(this->row(line_from.number, from));
  const bool is_along_row = edge == (rows_ ? EdgeOfCell::along : EdgeOfCell::upright);
  const std::uint64_t number =
      vertices_ + 3 * row * columns_ +
      (is_along_row ? column : columns_ + 2 * column + (edge == EdgeOfCell::diagonal ? 1 : 0));
  for (std::int32_t level = crossed.first; level < crossed.last; ++level)
    add_point(number, point_between(at_a, at_b, (levels_[level] - a.value) / (b.value - a.value)));
}

void PlaceContours::add_points_of_cells() {
  const Cell* last = nullptr;
  for (Cell& cell : cells_) {
    const int at = cell.number;
    const bool follows = last && last->number + 1 == at;
    cell.upright =
        follows ? last->upright_behind : add_points(EdgeOfCell::upright, near_, at, far_, at);
    cell.diagonal = add_points(EdgeOfCell::diagonal, near_, at, far_, at + 1);
    cell.upright_behind = add_points(EdgeOfCell::upright, near_, at + 1, far_, at + 1);
    add_points_along(near_, at);
    add_points_along(far_, at);
    last = &cell;
  }
}

void PlaceContours::add_points_along(Line& line, int cell) {
  std::uint32_t& first = line.points[line.index(cell)];
  if (first == kNone) first = add_points(EdgeOfCell::along, line, cell, line, cell + 1);
}

// The nearer triangle's first.
void PlaceContours::add_pieces(PlacePart part, const Cell& cell) {
  const int column = this->column(near_.number, cell.number),
            row = this->row(near_.number, cell.number);
  const std::size_t near = near_.index(cell.number), far = far_.index(cell.number);
  const EarthStrips* const earth = lattice_.order.earth();
  const bool is_lower_near =
      earth ? earth->is_lower_near(place_of(near_, near), place_of(far_, far + 1))
            : lattice_.order.is_lower_near(column, row);
  const bool far_first = is_lower_near == rows_;
  const std::int32_t first = near_.levels[near], last = far_.levels[far + 1];
  const bool is_plain = (near_.is_level[near] | near_.is_level[near + 1] | far_.is_level[far] |
                         far_.is_level[far + 1]) == 0;
  LatticeOrder::Turn turn = lattice_.order.turn_of_nearer(near_.number, cell.number);
  for (const bool with_far : {far_first, !far_first}) {
    if (first != last || first != (with_far ? far_.levels[far] : near_.levels[near + 1])) {
      if (is_plain)
        add_plain_pieces(found_[static_cast<std::size_t>(part)], cell, with_far, turn);
      else
        add_pieces(part, cell, with_far, turn);
    }
    turn = LatticeOrder::turn_of_farther(turn);
  }
}

// The same where no corner is on a level, as in nearly all triangles: two sides are crossed.
void PlaceContours::add_plain_pieces(std::vector<Piece>& found, const Cell& cell, bool with_far,
                                     LatticeOrder::Turn turn) const {
  const std::size_t near = near_.index(cell.number), far = far_.index(cell.number);
  const std::int32_t a = near_.levels[near],
                     b = with_far ? far_.levels[far] : near_.levels[near + 1],
                     c = far_.levels[far + 1];
  const auto [low, high] = std::minmax({a, b, c});
  if (low == LevelStanding::kNowhere) return;
  const auto node = [](std::uint32_t first_point, std::int32_t lower, std::int32_t level) {
    return first_point + static_cast<std::uint32_t>(level - lower);
  };
  const std::uint32_t on_ab = with_far ? cell.upright : near_.points[near],
                      on_bc = with_far ? far_.points[far] : cell.upright_behind;
  for (std::int32_t level = low; level < high; ++level) {
    const bool above_a = a > level, above_b = b > level, above_c = c > level;
    const std::uint32_t one = above_a != above_b ? node(on_ab, std::min(a, b), level)
                                                 : node(on_bc, std::min(b, c), level),
                        other = above_a != above_c ? node(cell.diagonal, std::min(a, c), level)
                                                   : node(on_bc, std::min(b, c), level);
    found.push_back(
        {turn, std::min(one, other), std::max(one, other), static_cast<std::uint32_t>(level)});
  }
}

void PlaceContours::add_pieces(PlacePart part, const Cell& cell, bool with_far,
                               LatticeOrder::Turn turn) {
  const auto corner = [&](const Line& line, int at) {
    return IsolineEnd{vertex(line.number, at), standing(line, at)};
  };
  const auto point = [&](std::uint32_t number) {
    return static_cast<std::uint32_t>(vertices_) + number;
  };
  const int at = cell.number;
  const IsolineTriangle triangle{
      {corner(near_, at), with_far ? corner(far_, at) : corner(near_, at + 1),
       corner(far_, at + 1)},
      {point(with_far ? far_.points[far_.index(at)] : cell.upright_behind), point(cell.diagonal),
       point(with_far ? cell.upright : near_.points[near_.index(at)])}};
  for_each_isoline(triangle, 0, [&](const Isoline& line) {
    if (line.to < vertices_) return; // an edge
    const auto number = [&](std::uint32_t of_end) {
      return of_end < vertices_ ? add_vertex(of_end)
                                : of_end - static_cast<std::uint32_t>(vertices_);
    };
    found_[static_cast<std::size_t>(part)].push_back(
        {turn, number(line.from), number(line.to), line.level});
  });
}

std::uint32_t PlaceContours::add_vertex(std::uint32_t vertex) {
  add_point(vertex, to_profile_frame(lattice_.view, lattice_.grid.vertex_m(std::size_t{vertex})));
  return static_cast<std::uint32_t>(points_.size() - 1);
}

// An edge that a level runs along is a piece just if one of its triangles falls from it.
void PlaceContours::add_edges_within() {
  auto &outwards = found_[static_cast<std::size_t>(PlacePart::outwards)],
       &backwards = found_[static_cast<std::size_t>(PlacePart::backwards)];
  const std::size_t before = outwards.size() + backwards.size();
  const int near = near_.number, far = far_.number;
  for (const Cell& of : cells_) {
    const int cell = of.number;
    const std::size_t i = near_.index(cell), k = far_.index(cell);
    const std::int32_t first = near_.levels[i], on_near = near_.levels[i + 1],
                       on_far = far_.levels[k], last = far_.levels[k + 1];
    if (is_level(near_, i, far_, k + 1) && (falls(first, on_far) || falls(first, on_near)))
      add_edge(vertex(near, cell), vertex(far, cell + 1), first - 1);
    if (is_level(near_, i, far_, k) && falls(first, last))
      add_edge(vertex(near, cell), vertex(far, cell), first - 1);
    // The cell behind it, if it is one that falls, has that edge.
    if (is_level(near_, i + 1, far_, k + 1) && falls(on_near, first) &&
        !cell_falls(on_near, near, cell + 1, far, cell + 2))
      add_edge(vertex(near, cell + 1), vertex(far, cell + 1), on_near - 1);
  }
  if (outwards.size() + backwards.size() == before) return;
  std::ranges::stable_sort(outwards, {}, &Piece::turn);
  std::ranges::stable_sort(backwards, {}, &Piece::turn);
}

void PlaceContours::add_edges_along(const Line& line, const ShownOfPlace& shown) {
  const int number = line.number;
  for (const int cell : line.on_level) {
    if (cell < shown.first_cell || cell >= shown.end_cell) continue;
    const std::size_t i = line.index(cell);
    if (is_level(line, i, line, i + 1) &&
        (cell_falls(line.levels[i], number, cell, number + 1, cell + 1) ||
         cell_falls(line.levels[i], number - 1, cell, number - 1, cell)))
      add_edge(vertex(number, cell), vertex(number, cell + 1), line.levels[i] - 1);
  }
  std::ranges::sort(found_[static_cast<std::size_t>(PlacePart::line)], {}, &Piece::turn);
}

// Whether both ends of an edge are on one level.
bool PlaceContours::is_level(const Line& line_a, std::size_t a, const Line& line_b,
                             std::size_t b) const {
  return line_a.is_level[a] != 0 && line_a.heights_m[a] == line_b.heights_m[b];
}

// Whether a cell is there, and its triangle with a vertex falls to that from a level.
bool PlaceContours::cell_falls(std::int32_t levels, int strip, int cell, int line, int at) const {
  const int last_line = rows_ ? lattice_.grid.rows - 1 : lattice_.grid.columns - 1,
            last_cell = rows_ ? lattice_.grid.columns - 1 : lattice_.grid.rows - 1;
  return strip >= 0 && strip < last_line && cell < last_cell && is_looked_at(strip, cell) &&
         falls(levels,
               levels_.count_up_to(lattice_.grid.height_m(column(line, at), row(line, at))));
}

void PlaceContours::add_edge(std::uint32_t from, std::uint32_t to, std::int32_t level) {
  const LatticeOrder::Turn turn = lattice_.order.turn(SurfaceEdge{from, to});
  const std::uint32_t first = add_vertex(from);
  found_[static_cast<std::size_t>(part_of(lattice_.order, turn))].push_back(
      {turn, first, add_vertex(to), static_cast<std::uint32_t>(level)});
}

} // namespace orograph
