// SPDX-License-Identifier: GPL-3.0-or-later
// Which triangles of a grid on the ellipsoid the eye sees, a row of cells at a time.
//
// Rows of vertices go to the profile frame as a whole; then the sign of N . (E - P) is plain
// arithmetic without branches, for the vector units, with one rounding bound for the row, from its
// longest edges. The few signs within it are asked of `facing_of`.
#pragma once

#include "dem/grid.hpp"
#include "profiles/cell_vertex.hpp"
#include "profiles/facing.hpp"
#include "view/view.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace orograph {

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
    for (std::size_t c = begin; c < past; ++c) {
      const int column = static_cast<int>(c);
      const auto at = [&](int right, int down) { return vertex(column + right, row + down); };
      if (lower[c] == (kMayFace | kMayTurn))
        lower[c] = facing_of(view_, at(0, 0), at(0, 1), at(1, 1));
      if (upper[c] == (kMayFace | kMayTurn))
        upper[c] = facing_of(view_, at(0, 0), at(1, 1), at(1, 0));
    }
  }

  bool may_be_ridge(CellVertex from, CellVertex to, CellVertex left, CellVertex right) const {
    const auto at = [&](CellVertex v) { return vertex(v.column, v.row); };
    return orograph::may_be_ridge(at(from), at(to), at(left), at(right));
  }

private:
  struct Row {
    std::vector<double> u, v, z;
    explicit Row(std::size_t count) : u(count), v(count), z(count) {}
  };

  ProfilePoint vertex(int column, int row) const {
    const double height = heights_[grid_.index(column, row)];
    return to_profile_frame(view_, grid_.earth().vertex_m(column, row, height));
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
    for (std::size_t c = 0; c < count; ++c) {
      const ProfilePoint p = to_profile_frame(view_, {u[c], v[c], z[c]});
      u[c] = p.u;
      v[c] = p.v;
      z[c] = p.z;
    }
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
    double most_u = 0, most_v = 0, most_z = 0, most_eye_u = 0, most_eye_v = 0, most_eye_z = 0;
    const auto take = [](double& most, double value) {
      value = std::abs(value);
      most = value > most ? value : most; // a missing vertex is never farther
    };
    for (std::size_t c = begin; c < past; ++c) {
      const ProfilePoint eye =
          is_perspective ? ProfilePoint{-nu[c], -nv[c], eye_z - nz[c]} : to_viewer;
      const ProfilePoint down{su[c] - nu[c], sv[c] - nv[c], sz[c] - nz[c]};
      const ProfilePoint across{su[c + 1] - nu[c], sv[c + 1] - nv[c], sz[c + 1] - nz[c]};
      const ProfilePoint right{nu[c + 1] - nu[c], nv[c + 1] - nv[c], nz[c + 1] - nz[c]};
      lower_sign[c] = product(eye, down, across);
      upper_sign[c] = product(eye, across, right);
      for (const ProfilePoint& edge : {down, across, right}) {
        take(most_u, edge.u);
        take(most_v, edge.v);
        take(most_z, edge.z);
      }
      take(most_eye_u, eye.u);
      take(most_eye_v, eye.v);
      take(most_eye_z, eye.z);
    }
    // That of triple_product, were all factors the greatest.
    return 8 * std::numeric_limits<double>::epsilon() *
           (most_eye_u * most_v * most_z + most_eye_v * most_z * most_u +
            most_eye_z * most_u * most_v);
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
