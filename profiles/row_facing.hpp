// SPDX-License-Identifier: GPL-3.0-or-later
// Which triangles of a grid on a map plane the eye sees, a row of cells at a time; and what rows of
// grids have in common.
#pragma once

#include "dem/grid.hpp"
#include "profiles/facing.hpp"
#include "profiles/lattice_order.hpp"
#include "profiles/mesh.hpp"
#include "view/view.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <type_traits>
#include <utility>
#include <vector>

namespace orograph {

// A cell's edges at its north-western vertex: where they lead, and what else their two triangles
// have; in columns and rows from that vertex on. By bit of SilhouetteMarks, where rows are strips.
struct EdgeOfCell {
  CellVertex to, left, right;
};
inline constexpr std::array<EdgeOfCell, 3> kEdgesOfCell{
    {{{1, 0}, {0, -1}, {1, 1}}, {{0, 1}, {1, 1}, {-1, 0}}, {{1, 1}, {1, 0}, {0, 1}}}};

// Calls take(column) with each of a row's cells, from column `first` to `end`, of which a triangle
// may be turned either way: with few of a thousand.
template <class Take>
void for_each_in_doubt(const std::vector<std::uint8_t>& lower,
                       const std::vector<std::uint8_t>& upper, int first, int end,
                       const Take& take) {
  static_assert(kMayFace == 1 && kMayTurn == 2);
  const auto doubt = [&](int column) {
    const auto c = static_cast<std::size_t>(column);
    return static_cast<std::uint8_t>(
        ((lower[c] & (lower[c] >> 1U)) | (upper[c] & (upper[c] >> 1U))) & 1U);
  };
  constexpr int kAtOnce = 64;
  for (int begin = first; begin < end; begin += kAtOnce) {
    const int past = std::min(begin + kAtOnce, end);
    std::uint8_t any = 0;
    for (int c = begin; c < past; ++c) any |= doubt(c);
    if (any == 0) continue;
    for (int c = begin; c < past; ++c)
      if (doubt(c) != 0) take(c);
  }
}

// k0 + k1 * x + k2 * x * x, where x is counted from a range's first cell.
struct Parabola {
  double k0 = 0, k1 = 0, k2 = 0;
  /// Of what it is, and of its terms, from 0 to x.
  double bound(double x) const { return std::abs(k0) + std::abs(k1) * x + std::abs(k2) * x * x; }
};
template <class Real>
struct ParabolaIn {
  Real k0, k1, k2;
  explicit ParabolaIn(const Parabola& p)
      : k0(static_cast<Real>(p.k0)), k1(static_cast<Real>(p.k1)), k2(static_cast<Real>(p.k2)) {}
  Real at(Real x) const { return k0 + x * (k1 + k2 * x); }
};

// What a triangle may be, by its sign and a bound on what that may be off. None where the heights'
// sum isn't a number; both where the sign isn't, since it is beyond what a Real can be. Without
// branches.
template <class Real, class Height>
std::uint8_t bits_of_sign(Real sign, Real bound, Height heights) {
  const int may_face = !(sign < -bound), may_turn = !(sign > bound), is_there = heights == heights;
  static_assert(kMayFace == 1 && kMayTurn == 2);
  return static_cast<std::uint8_t>((may_face | (may_turn << 1)) & (0 - is_there));
}

// On a map plane, in cell coordinates (c to the east, r to the south, in steps of the grid), a
// triangle's height is h = h0 + gc * (c - c0) + gr * (r - r0). The eye sees it where the eye is
// above that plane; in a parallel view, where walking away along F raises Y. Both are one
// expression of gc and gr. That decides nearly all triangles; the few signs within its rounding are
// asked of `facing_of`.

// The facing of a row of cells. The loop over a row is plain arithmetic without branches, for the
// vector units; in float, where heights are.
template <class Height>
class PlaneRowFacing {
public:
  PlaneRowFacing(const Grid& grid, const Heights<Height>& heights, const View& view)
      : lower(static_cast<std::size_t>(grid.columns) - 1), upper(lower.size()), grid_(grid),
        lattice_(grid.plane()), heights_(heights), view_(view), eye_(eye_in_cells(grid, view)),
        mirrored_(grid.plane().is_mirrored()) {
    // Vertices are rounded to metres, which moves them, in cells, by ulps of how far they are from
    // the origin; a gradient is off by as much, and counts as far as the eye is away.
    cells_away_ = 4.0 * (grid.columns + grid.rows);
    rounding_ = 32 * std::numeric_limits<double>::epsilon() * cells_away_;
    if (view.is_perspective()) cells_away_ += 4 * (std::abs(eye_.column) + std::abs(eye_.row));
    if (view.drop.any()) bend_m_ = bend_of_drop_m();
    const auto step = [&](CellVertex v) {
      return static_cast<std::ptrdiff_t>(v.row) * grid.columns + v.column;
    };
    for (std::size_t i = 0; i < kEdgesOfCell.size(); ++i) {
      const auto& [to, left, right] = kEdgesOfCell[i];
      others_[i] = {step(to), step(left), step(right)};
    }
  }

  std::vector<std::uint8_t> lower, upper; ///< bits, a cell each

  ProfilePoint vertex(int column, int row) const {
    const double height = heights_[grid_.index(column, row)];
    return to_profile_frame(view_, lattice_.vertex_m(column, row, height));
  }

  /// Of the cells from column `first` to `end`.
  void reckon(int row, int first, int end) {
    const SignTerms terms = terms_of(row, first, end);
    const Height* const north = &heights_[grid_.index(0, row)];
    const Height* const south = &heights_[grid_.index(0, row + 1)];
    // More roundings than those below, of what is rounded to float first; and ulps of the
    // vertices' places count for nothing in float.
    constexpr double kOfFloat = 32.0 * std::numeric_limits<float>::epsilon();
    const double of_double = 16 * std::numeric_limits<double>::epsilon() * cells_away_;
    if (std::is_same_v<Height, float> && 100 * of_double < kOfFloat)
      sign_bits<float>(north, south, first, end, terms, kOfFloat, &lower[0], &upper[0]);
    else
      sign_bits<double>(north, south, first, end, terms, of_double, &lower[0], &upper[0]);
    settle(row, first, end);
  }

  // The two triangles at an edge make a parallelogram: it is a ridge where its middle is higher
  // than the middle between the other two vertices.
  bool may_be_ridge(CellVertex from, std::size_t edge) const {
    const Height* const at_from = &heights_[grid_.index(from.column, from.row)];
    const auto [to_b, to_c, to_d] = others_[edge];
    const double a = *at_from, b = at_from[to_b], c = at_from[to_c], d = at_from[to_d];
    const double above = (a - c) + (b - d);
    if (std::abs(above) >
        bend_m_ + rounding_ * (std::abs(a) + std::abs(b) + std::abs(c) + std::abs(d)))
      return above > 0;
    const auto at = [&](CellVertex v) { return vertex(from.column + v.column, from.row + v.row); };
    const auto& [to, left, right] = kEdgesOfCell[edge];
    return orograph::may_be_ridge(at({0, 0}), at(to), at(mirrored_ ? right : left),
                                  at(mirrored_ ? left : right));
  }

private:
  // Twice as much as what the ground sinks can move one middle of an edge's parallelogram against
  // the other, by rounding as well; in metres before exaggeration. A square form's values in the
  // middle and at the ends of a line differ by its value for half the line.
  double bend_of_drop_m() const {
    const auto& [uu, uv, vv] = view_.drop;
    const double most = std::abs(uu) + std::abs(uv) + std::abs(vv);
    const double column_m = length(lattice_.column_step_m), row_m = length(lattice_.row_step_m);
    const double across_m = 2 * (column_m + row_m); // at least the parallelogram's diagonals
    const double away_m = length(lattice_.first_vertex_m) + grid_.columns * column_m +
                          grid_.rows * row_m + length(view_.depth_origin_m);
    return 2 * most * (across_m * across_m + 8 * rounding_ * away_m * away_m) / view_.exaggeration;
  }

  // A sign is constant + per_height * h0 + per_c * gc + per_r * gr, and what the ground sinks:
  // its parabola. In perspective per_c grows along the row.
  struct SignTerms {
    double constant, per_height, first_per_c, step_per_c, per_r;
    Parabola lower, upper;
    // Of the bound on rounding, before its factor: what counts always, and what gc and gr count;
    // the eye's place is rounded aslant of the grid, so that the two count alike.
    double least, reach;
  };
  SignTerms terms_of(int row, int first, int end) const {
    SignTerms terms{};
    if (view_.is_perspective()) {
      const double per_r = row - eye_.row;
      terms = {eye_.height, -1, -eye_.column, 1, per_r, {}, {}, 0, 1.0 * end};
    } else {
      const double scale = -view_.y_per_z * view_.exaggeration;
      terms = {view_.y_per_v, 0, scale * eye_.column, 0, scale * eye_.row, {}, {}, 0, 0};
    }
    terms.reach += std::abs(terms.first_per_c) + std::abs(terms.per_r) + std::abs(eye_.row);
    terms.least = std::abs(terms.constant);
    if (view_.drop.any()) {
      terms.lower = sunk(row, first, end, terms, 0, 1);
      terms.upper = sunk(row, first, end, terms, 1, 0);
      const double cells = end - first;
      terms.least += std::max(terms.lower.bound(cells), terms.upper.bound(cells));
    }
    return terms;
  }

  // By how much a triangle's sign changes as its vertices sink: a square form of the place, and
  // differences of it times what is linear in the column. The triangle lies between its cell's
  // north-western vertex, the south-eastern one, and the one at (column, row_down) from the first.
  Parabola sunk(int row, int first, int end, const SignTerms& terms, int column, int down) const {
    const auto drop = [&](double c, double r) {
      const Vec2 at = lattice_.first_vertex_m + c * lattice_.column_step_m +
                      r * lattice_.row_step_m - view_.depth_origin_m;
      return view_.drop.at(dot(at, view_.right), dot(at, view_.forward)) / view_.exaggeration;
    };
    const auto at = [&](double x) {
      const double c = first + x, r = row;
      const double d = drop(c, r), across = drop(c + 1, r + 1), third = drop(c + column, r + down);
      const double d_c = column > 0 ? third - d : across - third,
                   d_r = column > 0 ? across - third : third - d;
      return -terms.per_height * d - (terms.first_per_c + terms.step_per_c * c) * d_c -
             terms.per_r * d_r;
    };
    const double cells = end - first;
    const double f0 = at(0), f1 = at(0.5 * cells), f2 = at(cells);
    return {f0, (4 * f1 - 3 * f0 - f2) / cells, 2 * (f0 - 2 * f1 + f2) / (cells * cells)};
  }

  // What the signs of a row's triangles may be, from column `first` to `end`. The bound is
  // `rounding`, for some eight roundings of the terms and of the eye's own place, times all terms
  // without their signs.
  template <class Real>
  static void sign_bits(const Height* north, const Height* south, int first, int end,
                        const SignTerms& terms, double rounding, std::uint8_t* __restrict lower,
                        std::uint8_t* __restrict upper) {
    const ParabolaIn<Real> sunk_lower(terms.lower), sunk_upper(terms.upper);
    const Real constant = static_cast<Real>(terms.constant),
               per_height = static_cast<Real>(terms.per_height),
               first_per_c = static_cast<Real>(terms.first_per_c),
               step_per_c = static_cast<Real>(terms.step_per_c),
               per_r = static_cast<Real>(terms.per_r);
    const Real reach = static_cast<Real>(rounding * terms.reach),
               least = static_cast<Real>(rounding * terms.least),
               of_height = static_cast<Real>(rounding);
    for (int c = first; c < end; ++c) {
      const Real nw = static_cast<Real>(north[c]), ne = static_cast<Real>(north[c + 1]),
                 sw = static_cast<Real>(south[c]), se = static_cast<Real>(south[c + 1]);
      const Real south_c = se - sw, north_c = ne - nw, west_r = sw - nw, east_r = se - ne;
      const Real per_c = first_per_c + step_per_c * static_cast<Real>(c);
      const Real level = constant + per_height * nw, slack = least + of_height * std::abs(nw);
      const Real x = static_cast<Real>(c - first);
      const Real below = level + per_c * south_c + per_r * west_r + sunk_lower.at(x);
      const Real above = level + per_c * north_c + per_r * east_r + sunk_upper.at(x);
      const Real of_below = slack + reach * (std::abs(south_c) + std::abs(west_r)),
                 of_above = slack + reach * (std::abs(north_c) + std::abs(east_r));
      lower[c] = bits_of_sign(below, of_below, nw + sw + se);
      upper[c] = bits_of_sign(above, of_above, nw + ne + se);
    }
  }

  // Asks again of the triangles in doubt.
  void settle(int row, int first, int end) {
    for_each_in_doubt(lower, upper, first, end, [&](int c) {
      std::uint8_t &below = lower[static_cast<std::size_t>(c)],
                   &above = upper[static_cast<std::size_t>(c)];
      if (below == (kMayFace | kMayTurn))
        below = facing(vertex(c, row), vertex(c, row + 1), vertex(c + 1, row + 1));
      if (above == (kMayFace | kMayTurn))
        above = facing(vertex(c, row), vertex(c + 1, row + 1), vertex(c + 1, row));
    });
  }
  std::uint8_t facing(ProfilePoint a, ProfilePoint b, ProfilePoint c) const {
    return mirrored_ ? facing_of(view_, a, c, b) : facing_of(view_, a, b, c);
  }

  const Grid& grid_;
  const PlaneLattice& lattice_;
  const Heights<Height>& heights_;
  const View& view_;
  EyeInCells eye_;
  bool mirrored_; ///< columns and rows turn the other way
  // From an edge's vertex to its other one, and to those beside it: what an index grows by.
  struct Others {
    std::ptrdiff_t to, left, right;
  };
  std::array<Others, kEdgesOfCell.size()> others_;
  double cells_away_;
  double rounding_;   ///< twice 16 ulp of four heights, as far as positions are off in cells
  double bend_m_ = 0; ///< heights that make more than this decide what is a ridge
};

} // namespace orograph
