// SPDX-License-Identifier: GPL-3.0-or-later
// Line i of the family whose depth changes most has the vertices P(i, j) = i * next + j * along, in
// columns and rows. The plane crosses its edge from P(i, J(i)) to P(i, J(i) + 1), where J(i + 1) is
// J(i) or one more; on the way from line i to i + 1 it crosses the edge between P(i, J(i + 1)) and
// P(i + 1, J(i) + 1).
#include "profiles/line_cutter.hpp"

#include "profiles/grid_lines.hpp"
#include "profiles/line_crossings.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>

namespace orograph {
namespace {

struct CellStep {
  int column, row;
};

struct Family {
  CellStep along, next;
  /// Of the edge to the next line, with J the same and one more: whether its end there has the
  /// lower index.
  bool turned_same, turned_more;
};

// Of each family the walks to either side: along columns to the east and to the west, along rows to
// the south and to the north, along diagonals to the south-west and to the north-east.
constexpr std::array<std::array<Family, 2>, 3> kFamilies{
    {{{{{0, 1}, {1, 0}, false, false}, {{0, 1}, {-1, -1}, true, true}}},
     {{{{1, 0}, {0, 1}, false, false}, {{1, 0}, {-1, -1}, true, true}}},
     {{{{1, 1}, {-1, 0}, false, true}, {{1, 1}, {0, -1}, false, true}}}}};

// Where the plane meets a vertex, its crossings are taken on the side that has an edge crossed: a
// share of a cell, above all rounding.
constexpr double kBesideVertex = 1e-7;

// Lines looked at beyond those that are crossed to rounding.
constexpr int kBesideGrid = 5;

template <class Height>
class PlaneCut {
public:
  PlaneCut(const Grid& grid, const Heights<Height>& heights, const View& view,
           const LinePlaces& places, const GridPlane& plane, double rounding_m)
      : grid_(grid), heights_(heights.data()), view_(view), places_(places), plane_(plane),
        rounding_m_(rounding_m) {
    choose_family();
  }

  bool cut(const URange& range, const TriangleSet& level, Profile& out);

private:
  int column(int i, int j) const { return i * family_.next.column + j * family_.along.column; }
  int row(int i, int j) const { return i * family_.next.row + j * family_.along.row; }
  bool has(int i, int j) const {
    const int c = column(i, j), r = row(i, j);
    return c >= 0 && r >= 0 && c < grid_.columns && r < grid_.rows;
  }
  bool is_far(int i, int j) const { return plane_.is_far(places_.v(column(i, j), row(i, j))); }

  CellStep vertex(int i, int j) const { return {column(i, j), row(i, j)}; }

  void choose_family();
  // Lines that the plane crosses in the grid, to rounding.
  struct LineRange {
    double first, last;
  };
  LineRange lines_in_grid() const;
  LineRange lines_in(const URange& range) const;
  // Which edge of a line is crossed, if it is one of the grid's.
  std::optional<int> crossed(int i) const;
  bool take(int first, int count);
  void fill(int count, double* u, double* z) const;
  bool is_missing(int count) const;
  bool meets_vertex(int count) const;
  bool in_doubt(double v) const { return std::abs(v - plane_.depth_m) <= rounding_m_; }
  void take_places(int first, int begin, int end);

  // A vertex of line i, as one end of an edge.
  struct End {
    double u, v, z;
  };
  End end(int i, int j) const;
  Point between(const End& here, const End& next, bool more) const;
  Span span(CellStep a, CellStep b, CellStep c, const TriangleSet& level) const;
  void mark_spans(int first, int count, const TriangleSet& level, Span* after) const;

  const Grid& grid_;
  const Height* heights_;
  const View& view_;
  const LinePlaces& places_;
  const GridPlane& plane_;
  double rounding_m_; ///< where it decides what is near; otherwise 0
  Family family_{};
  double first_j_ = 0, j_per_line_ = 0; ///< where the plane crosses lines, to rounding
  double first_u_ = 0, u_per_line_ = 0;
  Block block_;
};

template <class Height>
void PlaneCut<Height>::choose_family() {
  const CellStep column{1, 0}, row{0, 1};
  const auto v_of = [&](CellStep s) {
    return s.column * (places_.v(1, 0) - places_.v(0, 0)) +
           s.row * (places_.v(0, 1) - places_.v(0, 0));
  };
  const auto u_of = [&](CellStep s) {
    return s.column * (places_.u(1, 0) - places_.u(0, 0)) +
           s.row * (places_.u(0, 1) - places_.u(0, 0));
  };
  const double a = v_of(column), b = v_of(row);
  const std::size_t family = (a > 0 && b > 0) || (a < 0 && b < 0) ? 2
                             : std::abs(b) >= std::abs(a)         ? 0
                                                                  : 1;
  for (const Family& walk : kFamilies[family]) {
    family_ = walk;
    const double v_along = v_of(walk.along);
    j_per_line_ = -v_of(walk.next) / v_along;
    u_per_line_ = u_of(walk.next) + j_per_line_ * u_of(walk.along);
    if (!(u_per_line_ > 0)) continue;
    first_j_ = (plane_.depth_m - places_.v(0, 0)) / v_along;
    first_u_ = places_.u(0, 0) + first_j_ * u_of(walk.along);
    first_j_ += (v_along > 0) == plane_.far_at_plane ? -kBesideVertex : kBesideVertex;
    return;
  }
}

template <class Height>
typename PlaneCut<Height>::LineRange PlaneCut<Height>::lines_in_grid() const {
  LineRange lines{-1.0 * (grid_.columns + grid_.rows), 1.0 * (grid_.columns + grid_.rows)};
  const auto within = [&](double first, double per_line, double last) {
    if (std::abs(per_line) < 1e-9) return;
    const double a = -first / per_line, b = (last - first) / per_line;
    lines.first = std::max(lines.first, std::min(a, b));
    lines.last = std::min(lines.last, std::max(a, b));
  };
  const auto& [along, next, same, more] = family_;
  within(first_j_ * along.column, next.column + j_per_line_ * along.column, grid_.columns - 1);
  within(first_j_ * along.row, next.row + j_per_line_ * along.row, grid_.rows - 1);
  return lines;
}

template <class Height>
typename PlaneCut<Height>::LineRange PlaneCut<Height>::lines_in(const URange& range) const {
  return {(range.low_m - first_u_) / u_per_line_ - 1, (range.high_m - first_u_) / u_per_line_ + 1};
}

template <class Height>
std::optional<int> PlaneCut<Height>::crossed(int i) const {
  const int guess = static_cast<int>(std::floor(first_j_ + i * j_per_line_));
  for (const int j : {guess, guess - 1, guess + 1})
    if (has(i, j) && has(i, j + 1) && is_far(i, j) != is_far(i, j + 1)) return j;
  return std::nullopt;
}

template <class Height>
void PlaneCut<Height>::take_places(int first, int begin, int end) {
  // Numbers of their own: as members they would be asked for anew behind every store.
  const double *column_u = places_.column_u.data(), *column_v = places_.column_v.data();
  const double *row_u = places_.row_u.data(), *row_v = places_.row_v.data();
  const auto [along, next, same, more] = family_;
  Block& block = block_;
  for (int k = begin; k < end; ++k) {
    const int j = static_cast<int>(block.j[k]);
    const std::ptrdiff_t c = (first + k) * next.column + j * along.column + LinePlaces::kBeside,
                         r = (first + k) * next.row + j * along.row + LinePlaces::kBeside;
    block.u_a[k] = column_u[c] + row_u[r];
    block.v_a[k] = column_v[c] + row_v[r];
    block.u_b[k] = column_u[c + along.column] + row_u[r + along.row];
    block.v_b[k] = column_v[c + along.column] + row_v[r + along.row];
  }
}

// The crossed edges of lines first to first + count; whether they are all found, and one line's is
// that of the line before or one more.
template <class Height>
bool PlaneCut<Height>::take(int first, int count) {
  // A half less rounded to a whole number, by adding a number from which on all are whole:
  // std::floor but of whole numbers, for the vector units. What isn't crossed there is found below.
  constexpr double kWholeFrom = 0x1.8p52;
  for (int k = 0; k <= count; ++k)
    block_.j[k] = first_j_ + (first + k) * j_per_line_ - 0.5 + kWholeFrom - kWholeFrom;
  take_places(first, 0, count + 1);
  const double least_far = plane_.least_far_m();
  int not_found = 0;
  for (int k = 0; k <= count; ++k)
    if ((block_.v_a[k] >= least_far) == (block_.v_b[k] >= least_far)) ++not_found;
  if (not_found > 0)
    for (int k = 0; k <= count; ++k) {
      if (plane_.is_far(block_.v_a[k]) != plane_.is_far(block_.v_b[k])) continue;
      const std::optional<int> j = crossed(first + k);
      if (!j) return false;
      block_.j[k] = *j;
      take_places(first, k, k + 1);
    }
  int irregular = 0;
  for (int k = 0; k < count; ++k) {
    const double more = block_.j[k + 1] - block_.j[k];
    if (!(more == 0 || more == 1)) ++irregular;
  }
  if (irregular > 0 || (rounding_m_ > 0 && meets_vertex(count))) return false;
  const auto [along, next, same, more] = family_;
  const std::ptrdiff_t columns = grid_.columns, to_b = along.row * columns + along.column,
                       of_line = next.row * columns + next.column;
  const double exaggeration = view_.exaggeration;
  for (int k = 0; k <= count; ++k) {
    const Height* height =
        heights_ + (first + k) * of_line + static_cast<std::ptrdiff_t>(block_.j[k]) * to_b;
    block_.z_a[k] = *height * exaggeration;
    block_.z_b[k] = height[to_b] * exaggeration;
  }
  if (view_.drop.any())
    for (int k = 0; k <= count; ++k) {
      block_.z_a[k] -= view_.drop.at(block_.u_a[k], block_.v_a[k]);
      block_.z_b[k] -= view_.drop.at(block_.u_b[k], block_.v_b[k]);
    }
  return true;
}

template <class Height>
bool PlaneCut<Height>::meets_vertex(int count) const {
  bool meets = false;
  for (int k = 0; k <= count; ++k)
    meets = meets || in_doubt(block_.v_a[k]) || in_doubt(block_.v_b[k]);
  return meets;
}

template <class Height>
void PlaneCut<Height>::fill(int count, double* u, double* z) const {
  const double depth = plane_.depth_m;
  if (family_.turned_same)
    fill_crossings<true, true>(block_, count, depth, u, z);
  else if (family_.turned_more)
    fill_crossings<false, true>(block_, count, depth, u, z);
  else
    fill_crossings<false, false>(block_, count, depth, u, z);
}

template <class Height>
bool PlaneCut<Height>::is_missing(int count) const {
  int missing = 0;
  for (int k = 0; k <= count; ++k) {
    const double sum = block_.z_a[k] + block_.z_b[k];
    if (sum != sum) ++missing;
  }
  return missing > 0;
}

template <class Height>
typename PlaneCut<Height>::End PlaneCut<Height>::end(int i, int j) const {
  const int c = column(i, j), r = row(i, j);
  const double height = heights_[grid_.index(c, r)];
  const double u = places_.u(c, r), v = places_.v(c, r);
  return {u, v, height * view_.exaggeration - view_.drop.at(u, v)};
}

template <class Height>
Point PlaneCut<Height>::between(const End& here, const End& next, bool more) const {
  const bool turned = more ? family_.turned_more : family_.turned_same;
  const End &a = turned ? next : here, &b = turned ? here : next;
  return crossing(plane_.depth_m, a.u, a.v, a.z, b.u, b.v, b.z);
}

template <class Height>
Span PlaneCut<Height>::span(CellStep a, CellStep b, CellStep c, const TriangleSet& level) const {
  for (const CellStep& v : {a, b, c})
    if (std::isnan(heights_[grid_.index(v.column, v.row)])) return Span::gap;
  if (level.empty()) return Span::slope;
  const int column = std::min({a.column, b.column, c.column});
  const int row = std::min({a.row, b.row, c.row});
  const auto is_north_east = [&](CellStep v) { return v.column > column && v.row == row; };
  const bool upper = is_north_east(a) || is_north_east(b) || is_north_east(c);
  return level.has(grid_triangle(grid_, column, row, upper ? Half::upper : Half::lower))
             ? Span::level
             : Span::slope;
}

// Between the vertices of a block's crossings, where ground is missing or level.
template <class Height>
void PlaneCut<Height>::mark_spans(int first, int count, const TriangleSet& level,
                                  Span* after) const {
  for (int k = 0; k < count; ++k) {
    const int i = first + k, j = static_cast<int>(block_.j[k]);
    const bool more = block_.j[k + 1] != block_.j[k];
    const CellStep a = vertex(i, j), b = vertex(i, j + 1), next = vertex(i + 1, j + 1);
    after[2 * k] = span(a, b, next, level);
    after[2 * k + 1] = span(more ? b : a, next, vertex(i + 1, more ? j + 2 : j), level);
  }
}

template <class Height>
bool PlaneCut<Height>::cut(const URange& range, const TriangleSet& level, Profile& out) {
  const LineRange in_grid = lines_in_grid();
  LineRange asked = lines_in(range);
  if (asked.first > in_grid.last + 2 || asked.last < in_grid.first - 2) return true;
  // Some lines are always cut, so that the profile's ends need no cases of their own.
  asked.first = std::min(asked.first, in_grid.last - kBesideGrid);
  asked.last = std::max(asked.last, in_grid.first + kBesideGrid);
  const bool from_border = !(asked.first > in_grid.first + 2);
  const bool to_border = !(asked.last < in_grid.last - 2);
  int first = static_cast<int>(std::floor(from_border ? in_grid.first - 2 : asked.first));
  int last = static_cast<int>(std::ceil(to_border ? in_grid.last + 2 : asked.last));
  for (int tries = 0; from_border && tries < kBesideGrid && !crossed(first); ++tries) ++first;
  for (int tries = 0; to_border && tries < kBesideGrid && !crossed(last); ++tries) --last;
  const std::optional<int> first_j = crossed(first), last_j = crossed(last);
  if (first > last || !first_j || !last_j) return false;

  const bool enters = from_border && has(first - 1, *first_j);
  const bool leaves = to_border && has(last + 1, *last_j + 1);
  const std::size_t begin = enters ? 1 : 0,
                    count = begin + 2 * static_cast<std::size_t>(last - first) + 1;
  const std::size_t so_far = out.size();
  out.resize(so_far + count + (leaves ? 1 : 0));
  double *u = &out.u_m[so_far], *z = &out.z_m[so_far];
  Span* const after = &out.after[so_far];
  std::fill(after, after + count, Span::slope);
  if (enters) {
    const End here = end(first - 1, *first_j);
    if (rounding_m_ > 0 && in_doubt(here.v)) return false;
    const bool more = plane_.is_far(here.v) != is_far(first, *first_j);
    const Point p = between(here, end(first, *first_j + (more ? 0 : 1)), more);
    u[0] = p.u;
    z[0] = p.z;
    after[0] = span(vertex(first - 1, *first_j), vertex(first, *first_j),
                    vertex(first, *first_j + 1), level);
  }
  bool special = !level.empty();
  std::size_t at = begin;
  for (int i = first; i < last || at == begin;) {
    const int lines = std::min(kLines, last - i);
    if (!take(i, lines)) return false;
    fill(lines, u + at, z + at);
    if (!level.empty() || is_missing(lines)) {
      special = true;
      mark_spans(i, lines, level, after + at);
    }
    i += lines;
    at += 2 * static_cast<std::size_t>(lines);
    if (i == last) {
      const auto k = static_cast<std::size_t>(lines);
      const Point p = crossing(plane_.depth_m, block_.u_a[k], block_.v_a[k], block_.z_a[k],
                               block_.u_b[k], block_.v_b[k], block_.z_b[k]);
      u[at] = p.u;
      z[at] = p.z;
      break;
    }
  }
  if (leaves) {
    const End next = end(last + 1, *last_j + 1);
    if (rounding_m_ > 0 && in_doubt(next.v)) return false;
    const bool more = plane_.is_far(next.v) == is_far(last, *last_j);
    const Point p = between(end(last, *last_j + (more ? 1 : 0)), next, more);
    u[count] = p.u;
    z[count] = p.z;
    after[count - 1] = span(vertex(last, *last_j), vertex(last, *last_j + 1),
                            vertex(last + 1, *last_j + 1), level);
  }
  out.after.back() = Span::gap;
  return drop_repeats(special, so_far, out);
}

} // namespace

LineCutter::LineCutter(const Grid& grid, const View& view, const TriangleSet& level,
                       double rounding_m)
    : grid_(grid), view_(view), level_(level), rounding_m_(rounding_m), places_(grid, view) {}

bool LineCutter::cut(const GridPlane& plane, const URange& range, Profile& out) const {
  if (rounding_m_ == 0 && cut_row(grid_, view_, level_, places_, plane.depth_m, range, out))
    return true;
  return std::visit(
      [&]<class Height>(const Heights<Height>& heights) {
        return PlaneCut<Height>(grid_, heights, view_, places_, plane, rounding_m_)
            .cut(range, level_, out);
      },
      grid_.heights_m);
}

} // namespace orograph
