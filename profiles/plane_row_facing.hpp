// SPDX-License-Identifier: GPL-3.0-or-later
// Which triangles of a grid on a map plane the eye sees, a row of cells at a time.
//
// In cell coordinates (c to the east, r to the south, in steps of the grid) a triangle's height is
// h = h0 + gc * (c - c0) + gr * (r - r0). The eye sees it where the eye is above that plane; in a
// parallel view, where walking away along F raises Y. Both are one expression of gc and gr. That
// decides nearly all triangles; the few signs within its rounding are asked of `facing_of`.
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

// Where the eye is on the ground, in cell coordinates; in a parallel view a direction to it.
struct EyeInCells {
  double column, row, height;
};

// `exaggeration` is what the heights that it is compared with still have to be multiplied by.
inline EyeInCells eye_in_cells(const Grid& grid, const View& view, double exaggeration) {
  const auto& [first_vertex_m, column_step_m, row_step_m] = grid.plane();
  const double area = cross(column_step_m, row_step_m);
  const auto solve = [&](Vec2 v) {
    return Vec2{cross(v, row_step_m) / area, cross(column_step_m, v) / area};
  };
  if (!view.is_perspective()) {
    const Vec2 back = solve(view.x_per_v * view.right - view.forward);
    return {back.x, back.y, 0};
  }
  const Vec2 at = solve(view.depth_origin_m - first_vertex_m);
  return {at.x, at.y, view.eye_z_m / exaggeration};
}

// The facing of a row of cells. Loops over a row are plain arithmetic without branches, for the
// vector units, and the rounding bound is one for the row, from its greatest height and gradients.
template <class Height>
class PlaneRowFacing {
public:
  PlaneRowFacing(const Grid& grid, const Heights<Height>& heights, const View& view)
      : lower(static_cast<std::size_t>(grid.columns) - 1), upper(lower.size()), grid_(grid),
        lattice_(grid.plane()), heights_(heights), view_(view),
        exaggeration_(view.drop.any() ? 1 : view.exaggeration),
        eye_(eye_in_cells(grid, view, exaggeration_)), mirrored_(grid.plane().is_mirrored()),
        lower_sign_(lower.size()), upper_sign_(lower.size()) {
    // Vertices are rounded to metres, which moves them, in cells, by ulps of how far they are from
    // the origin; a gradient is off by as much, and counts as far as the eye is away.
    cells_away_ = 4.0 * (grid.columns + grid.rows);
    if (view.is_perspective()) cells_away_ += 4 * (std::abs(eye_.column) + std::abs(eye_.row));
  }

  std::vector<std::uint8_t> lower, upper; ///< bits, a cell each

  ProfilePoint vertex(int column, int row) const {
    const double height = heights_[grid_.index(column, row)];
    return to_profile_frame(view_, lattice_.vertex_m(column, row, height));
  }

  /// Of the cells from column `first` to `end`.
  void reckon(int row, int first, int end) {
    if (!view_.drop.any()) {
      reckon(row, first, end, &heights_[grid_.index(0, row)], &heights_[grid_.index(0, row + 1)],
             0);
      return;
    }
    // What sinks is not a plane over cells any more: heights as the profile frame has them.
    take_rows(row);
    // The drop grows with the square of the distance: along a row it is greatest at one of its
    // ends.
    double greatest_drop = 0;
    for (const int c : {first, end})
      for (const int r : {row, row + 1}) {
        const ProfilePoint p = vertex(c, r);
        greatest_drop = std::max(greatest_drop, std::abs(view_.drop.at(p.u, p.v)));
      }
    reckon(row, first, end, north_z_.data(), south_z_.data(), greatest_drop);
  }

  // The two triangles at an edge make a parallelogram: it is a ridge where its middle is higher
  // than the middle between the other two vertices.
  bool may_be_ridge(CellVertex from, CellVertex to, CellVertex left, CellVertex right) const {
    // Twice 16 ulp of the four heights, as far as positions are off in cells.
    const double rounding =
        32 * std::numeric_limits<double>::epsilon() * 4 * (grid_.columns + grid_.rows);
    const double a = height(from), b = height(to), c = height(left), d = height(right);
    const double above = (a - c) + (b - d);
    if (std::abs(above) >
        rounding * (std::abs(a) + std::abs(b) + std::abs(c) + std::abs(d) + drop_at(from)))
      return above > 0;
    const auto at = [&](CellVertex v) { return vertex(v.column, v.row); };
    return mirrored_ ? orograph::may_be_ridge(at(from), at(to), at(right), at(left))
                     : orograph::may_be_ridge(at(from), at(to), at(left), at(right));
  }

private:
  double height(CellVertex v) const {
    return view_.drop.any() ? vertex(v.column, v.row).z
                            : static_cast<double>(heights_[grid_.index(v.column, v.row)]);
  }
  double drop_at(CellVertex v) const {
    if (!view_.drop.any()) return 0;
    const ProfilePoint p = vertex(v.column, v.row);
    return 8 * std::abs(view_.drop.at(p.u, p.v));
  }

  void take_rows(int row) {
    if (next_row_ == row + 1) return;
    if (next_row_ != row) take_row(row, south_z_);
    std::swap(north_z_, south_z_);
    take_row(row + 1, south_z_);
    next_row_ = row + 1;
  }
  void take_row(int row, std::vector<double>& z) const {
    const Height* heights = &heights_[grid_.index(0, row)];
    z.resize(static_cast<std::size_t>(grid_.columns));
    for (int c = 0; c < grid_.columns; ++c) {
      const double height = heights[c];
      z[static_cast<std::size_t>(c)] = to_profile_frame(view_, lattice_.vertex_m(c, row, height)).z;
    }
  }

  template <class AnyHeight>
  void reckon(int row, int first, int end, const AnyHeight* north, const AnyHeight* south,
              double greatest_drop) {
    const bool perspective = view_.is_perspective();
    // A sign is constant + per_height * h0 + per_c * gc + per_r * gr, where per_c grows along the
    // row in perspective.
    const double scale = perspective ? 1 : -view_.y_per_z * exaggeration_;
    const double constant = perspective ? eye_.height : view_.y_per_v;
    const double per_height = perspective ? -1 : 0;
    const double per_r = perspective ? row - eye_.row : scale * eye_.row;
    const double first_per_c = perspective ? -eye_.column : scale * eye_.column;
    const double step_per_c = perspective ? 1 : 0;
    double greatest_height = greatest_drop, greatest_gc = 0, greatest_gr = 0;
    const auto take = [](double& greatest, double value) {
      value = std::abs(value);
      greatest = value > greatest ? value : greatest; // a missing height is never greater
    };
    for (int c = first; c < end; ++c) {
      const double nw = north[c], ne = north[c + 1], sw = south[c], se = south[c + 1];
      const double per_c = first_per_c + step_per_c * c, level = constant + per_height * nw;
      lower_sign_[static_cast<std::size_t>(c)] = level + per_c * (se - sw) + per_r * (sw - nw);
      upper_sign_[static_cast<std::size_t>(c)] = level + per_c * (ne - nw) + per_r * (se - ne);
      take(greatest_height, std::abs(nw) + greatest_drop);
      take(greatest_gc, ne - nw);
      take(greatest_gc, se - sw);
      take(greatest_gr, sw - nw);
      take(greatest_gr, se - ne);
    }
    // 16 ulp for some eight roundings, of the terms and of the eye's own place.
    const double reach_c = std::abs(first_per_c) + step_per_c * end;
    const double reach_r = std::abs(per_r) + std::abs(eye_.row);
    const double bound =
        16 * std::numeric_limits<double>::epsilon() * cells_away_ *
        (std::abs(constant) + greatest_height + greatest_gc * reach_c + greatest_gr * reach_r);
    const auto begin = static_cast<std::size_t>(first), past = static_cast<std::size_t>(end);
    for (std::size_t c = begin; c < past; ++c) {
      lower[c] = bits(lower_sign_[c], bound);
      upper[c] = bits(upper_sign_[c], bound);
    }
    std::uint8_t doubt = 0; // in a loop of its own, over bytes alone
    for (std::size_t c = begin; c < past; ++c)
      doubt |=
          static_cast<std::uint8_t>((lower[c] & (lower[c] >> 1U)) | (upper[c] & (upper[c] >> 1U)));
    if (doubt & 1U) settle(row, first, end);
  }

  // A missing height makes both comparisons false.
  static std::uint8_t bits(double sign, double bound) {
    return static_cast<std::uint8_t>((sign >= -bound ? kMayFace : 0) |
                                     (sign <= bound ? kMayTurn : 0));
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
  double exaggeration_; ///< of the heights that are reckoned with
  EyeInCells eye_;
  bool mirrored_; ///< columns and rows turn the other way
  double cells_away_;
  std::vector<double> lower_sign_, upper_sign_;
  std::vector<double> north_z_, south_z_; ///< where the ground sinks
  int next_row_ = -1;                     ///< whose heights `south_z_` holds
};

} // namespace orograph
