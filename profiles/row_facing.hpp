// SPDX-License-Identifier: GPL-3.0-or-later
// Which triangles of a grid the eye sees, a row of cells at a time.
#pragma once

#include "dem/grid.hpp"
#include "profiles/facing.hpp"
#include "profiles/lattice_order.hpp"
#include "profiles/mesh.hpp"
#include "view/view.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <type_traits>
#include <utility>
#include <vector>

namespace orograph {

// Whether of the cells from `begin` to `past` any triangle may be turned either way. A loop of its
// own, over bytes alone.
inline bool any_in_doubt(const std::vector<std::uint8_t>& lower,
                         const std::vector<std::uint8_t>& upper, std::size_t begin,
                         std::size_t past) {
  static_assert(kMayFace == 1 && kMayTurn == 2);
  std::uint8_t doubt = 0;
  for (std::size_t c = begin; c < past; ++c)
    doubt |=
        static_cast<std::uint8_t>((lower[c] & (lower[c] >> 1U)) | (upper[c] & (upper[c] >> 1U)));
  return (doubt & 1U) != 0;
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
    if (view.is_perspective()) cells_away_ += 4 * (std::abs(eye_.column) + std::abs(eye_.row));
    if (view.drop.any()) bend_m_ = bend_of_drop_m();
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
    if (any_in_doubt(lower, upper, static_cast<std::size_t>(first), static_cast<std::size_t>(end)))
      settle(row, first, end);
  }

  // The two triangles at an edge make a parallelogram: it is a ridge where its middle is higher
  // than the middle between the other two vertices.
  bool may_be_ridge(CellVertex from, CellVertex to, CellVertex left, CellVertex right) const {
    const double a = height(from), b = height(to), c = height(left), d = height(right);
    const double above = (a - c) + (b - d);
    if (std::abs(above) >
        bend_m_ + rounding() * (std::abs(a) + std::abs(b) + std::abs(c) + std::abs(d)))
      return above > 0;
    const auto at = [&](CellVertex v) { return vertex(v.column, v.row); };
    return mirrored_ ? orograph::may_be_ridge(at(from), at(to), at(right), at(left))
                     : orograph::may_be_ridge(at(from), at(to), at(left), at(right));
  }

private:
  double height(CellVertex v) const { return heights_[grid_.index(v.column, v.row)]; }
  // Twice 16 ulp of four heights, as far as positions are off in cells.
  double rounding() const {
    return 32 * std::numeric_limits<double>::epsilon() * 4 * (grid_.columns + grid_.rows);
  }
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
    return 2 * most * (across_m * across_m + 8 * rounding() * away_m * away_m) / view_.exaggeration;
  }

  // k0 + k1 * x + k2 * x * x, where x is counted from a range's first cell.
  struct Parabola {
    double k0 = 0, k1 = 0, k2 = 0;
    double bound(double x) const { return std::abs(k0) + std::abs(k1) * x + std::abs(k2) * x * x; }
  };
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
    struct Sunk {
      Real k0, k1, k2;
      explicit Sunk(const Parabola& p)
          : k0(static_cast<Real>(p.k0)), k1(static_cast<Real>(p.k1)), k2(static_cast<Real>(p.k2)) {}
      Real at(Real x) const { return k0 + x * (k1 + k2 * x); }
    };
    const Sunk sunk_lower(terms.lower), sunk_upper(terms.upper);
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
      lower[c] = bits(below, of_below, nw + sw + se);
      upper[c] = bits(above, of_above, nw + ne + se);
    }
  }
  // None where the heights' sum isn't a number; both where the sign isn't, since it is beyond what
  // a float can be. Without branches.
  template <class Real>
  static std::uint8_t bits(Real sign, Real bound, Real heights) {
    const int may_face = !(sign < -bound), may_turn = !(sign > bound),
              is_there = heights == heights;
    static_assert(kMayFace == 1 && kMayTurn == 2);
    return static_cast<std::uint8_t>((may_face | (may_turn << 1)) & (0 - is_there));
  }

  // Asks again of the triangles in doubt.
  void settle(int row, int first, int end) {
    for (int c = first; c < end; ++c) {
      std::uint8_t &below = lower[static_cast<std::size_t>(c)],
                   &above = upper[static_cast<std::size_t>(c)];
      if (below == (kMayFace | kMayTurn))
        below = facing(vertex(c, row), vertex(c, row + 1), vertex(c + 1, row + 1));
      if (above == (kMayFace | kMayTurn))
        above = facing(vertex(c, row), vertex(c + 1, row + 1), vertex(c + 1, row));
    }
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
  double cells_away_;
  double bend_m_ = 0; ///< heights that make more than this decide what is a ridge
};

// Of a grid on the ellipsoid, rows of vertices go to the profile frame as a whole; then the sign of
// N . (E - P) is plain arithmetic without branches, for the vector units, with one rounding bound
// for the row, from its farthest vertices: on an SRTM tile a twenty-millionth of what signs mostly
// are. The few within it are asked of `facing_of`.

template <class Height>
class EarthRowFacing {
public:
  EarthRowFacing(const Grid& grid, const Heights<Height>& heights, const View& view)
      : lower(static_cast<std::size_t>(grid.columns) - 1), upper(lower.size()), grid_(grid),
        heights_(heights), view_(view), north_(lower.size() + 1), south_(lower.size() + 1),
        lower_sign_(lower.size()), upper_sign_(lower.size()) {}

  std::vector<std::uint8_t> lower, upper; ///< bits, a cell each

  /// Of the cells from column `first` to `end`.
  void reckon(int row, int first, int end) {
    take_rows(row);
    const auto begin = static_cast<std::size_t>(first), past = static_cast<std::size_t>(end);
    const double bound =
        view_.is_perspective() ? reckon_signs<true>(begin, past) : reckon_signs<false>(begin, past);
    for (std::size_t c = begin; c < past; ++c) {
      lower[c] = bits(lower_sign_[c], bound);
      upper[c] = bits(upper_sign_[c], bound);
    }
    if (any_in_doubt(lower, upper, begin, past)) settle(row, first, end);
  }

  bool may_be_ridge(CellVertex from, CellVertex to, CellVertex left, CellVertex right) const {
    const auto at = [&](CellVertex v) { return vertex(v.column, v.row); };
    return orograph::may_be_ridge(at(from), at(to), at(left), at(right));
  }

private:
  struct Row {
    std::vector<double> u, v, z;
    ProfilePoint most{}; // of their sizes
    explicit Row(std::size_t count) : u(count), v(count), z(count) {}
  };

  ProfilePoint vertex(int column, int row) const {
    const double height = heights_[grid_.index(column, row)];
    return to_profile_frame(view_, grid_.earth().vertex_m(column, row, height));
  }

  // Asks again of the triangles in doubt.
  void settle(int row, int first, int end) {
    for (int column = first; column < end; ++column) {
      const auto at = [&](int right, int down) { return vertex(column + right, row + down); };
      std::uint8_t &below = lower[static_cast<std::size_t>(column)],
                   &above = upper[static_cast<std::size_t>(column)];
      if (below == (kMayFace | kMayTurn)) below = facing_of(view_, at(0, 0), at(0, 1), at(1, 1));
      if (above == (kMayFace | kMayTurn)) above = facing_of(view_, at(0, 0), at(1, 1), at(1, 0));
    }
  }

  void take_rows(int row) {
    if (next_row_ == row + 1) return;
    if (next_row_ != row) take_row(row, south_);
    std::swap(north_, south_);
    take_row(row + 1, south_);
    next_row_ = row + 1;
  }
  void take_row(int row, Row& out) const {
    const std::size_t count = out.u.size();
    grid_.earth().row_vertices_m(row, {&heights_[grid_.index(0, row)], count}, out.u, out.v, out.z);
    double* __restrict u = out.u.data();
    double* __restrict v = out.v.data();
    double* __restrict z = out.z.data();
    const auto take = [](double& most, double value) {
      value = std::abs(value);
      most = value > most ? value : most; // a missing vertex is never farther
    };
    ProfilePoint most{};
    for (std::size_t c = 0; c < count; ++c) {
      const ProfilePoint p = to_profile_frame(view_, {u[c], v[c], z[c]});
      u[c] = p.u;
      v[c] = p.v;
      z[c] = p.z;
      take(most.u, p.u);
      take(most.v, p.v);
      take(most.z, p.z);
    }
    out.most = most;
  }

  // Returns the bound on their rounding.
  template <bool is_perspective>
  double reckon_signs(std::size_t begin, std::size_t past) {
    const double *nu = north_.u.data(), *nv = north_.v.data(), *nz = north_.z.data();
    const double *su = south_.u.data(), *sv = south_.v.data(), *sz = south_.z.data();
    double* __restrict lower_sign = lower_sign_.data();
    double* __restrict upper_sign = upper_sign_.data();
    const ProfilePoint to_viewer{view_.x_per_v * view_.y_per_z, -view_.y_per_z, view_.y_per_v};
    const double eye_z = view_.eye_z_m;
    for (std::size_t c = begin; c < past; ++c) {
      const ProfilePoint eye =
          is_perspective ? ProfilePoint{-nu[c], -nv[c], eye_z - nz[c]} : to_viewer;
      const ProfilePoint down{su[c] - nu[c], sv[c] - nv[c], sz[c] - nz[c]};
      const ProfilePoint across{su[c + 1] - nu[c], sv[c + 1] - nv[c], sz[c + 1] - nz[c]};
      const ProfilePoint right{nu[c + 1] - nu[c], nv[c + 1] - nv[c], nz[c + 1] - nz[c]};
      lower_sign[c] = product(eye, down, across);
      upper_sign[c] = product(eye, across, right);
    }
    // That of triple_product, were all factors the greatest.
    const auto most = [&](double ProfilePoint::*of) {
      return std::max(north_.most.*of, south_.most.*of);
    };
    const ProfilePoint edge{2 * most(&ProfilePoint::u), 2 * most(&ProfilePoint::v),
                            2 * most(&ProfilePoint::z)};
    const ProfilePoint eye =
        is_perspective
            ? ProfilePoint{edge.u, edge.v, std::abs(eye_z) + edge.z}
            : ProfilePoint{std::abs(to_viewer.u), std::abs(to_viewer.v), std::abs(to_viewer.z)};
    return 8 * std::numeric_limits<double>::epsilon() *
           (eye.u * edge.v * edge.z + eye.v * edge.z * edge.u + eye.z * edge.u * edge.v);
  }

  static double product(ProfilePoint a, ProfilePoint b, ProfilePoint c) {
    return a.u * (b.v * c.z - b.z * c.v) + a.v * (b.z * c.u - b.u * c.z) +
           a.z * (b.u * c.v - b.v * c.u);
  }

  // A missing height makes both comparisons false.
  static std::uint8_t bits(double sign, double bound) {
    return static_cast<std::uint8_t>((sign >= -bound ? kMayFace : 0) |
                                     (sign <= bound ? kMayTurn : 0));
  }

  const Grid& grid_;
  const Heights<Height>& heights_;
  const View& view_;
  Row north_, south_; ///< of the present row of cells, in the profile frame
  std::vector<double> lower_sign_, upper_sign_;
  int next_row_ = -1; ///< whose vertices `south_` holds
};

} // namespace orograph
