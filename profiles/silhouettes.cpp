// SPDX-License-Identifier: GPL-3.0-or-later
// In cell coordinates (c to the east, r to the south, in steps of the grid) a triangle's height is
// h = h0 + gc * (c - c0) + gr * (r - r0). The eye sees it where the eye is above that plane; in a
// parallel view, where walking away along F raises Y. Both are one expression of gc and gr. That
// decides nearly all triangles; the few signs within its rounding are asked of `facing_of`.
#include "profiles/silhouettes.hpp"

#include "profiles/facing.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace orograph {
namespace {

// Where the eye is on the ground, in cell coordinates; in a parallel view a direction to it.
struct EyeInCells {
  double column, row, height;
};

// `exaggeration` is what the heights that it is compared with still have to be multiplied by.
EyeInCells eye_in_cells(const Grid& grid, const View& view, double exaggeration) {
  const double area = cross(grid.column_step_m, grid.row_step_m);
  const auto solve = [&](Vec2 v) {
    return Vec2{cross(v, grid.row_step_m) / area, cross(grid.column_step_m, v) / area};
  };
  if (!view.is_perspective()) {
    const Vec2 back = solve(view.x_per_v * view.right - view.forward);
    return {back.x, back.y, 0};
  }
  const Vec2 at = solve(view.depth_origin_m - grid.first_vertex_m);
  return {at.x, at.y, view.eye_z_m / exaggeration};
}

// The facing of a row of cells. Loops over a row are plain arithmetic without branches, for the
// vector units, and the rounding bound is one for the row, from its greatest height and gradients.
template <class Height>
class RowFacing {
public:
  RowFacing(const Grid& grid, const std::vector<Height>& heights, const View& view)
      : lower(static_cast<std::size_t>(grid.columns) - 1), upper(lower.size()), grid_(grid),
        heights_(heights), view_(view), exaggeration_(view.drop.any() ? 1 : view.exaggeration),
        eye_(eye_in_cells(grid, view, exaggeration_)),
        mirrored_(cross(grid.column_step_m, grid.row_step_m) > 0), lower_sign_(lower.size()),
        upper_sign_(lower.size()) {
    // Vertices are rounded to metres, which moves them, in cells, by ulps of how far they are from
    // the origin; a gradient is off by as much, and counts as far as the eye is away.
    cells_away_ = 4.0 * (grid.columns + grid.rows);
    if (view.is_perspective()) cells_away_ += 4 * (std::abs(eye_.column) + std::abs(eye_.row));
  }

  std::vector<std::uint8_t> lower, upper; ///< bits, a cell each

  ProfilePoint vertex(int column, int row) const {
    const Vec2 at = grid_.position_m(column, row);
    return to_profile_frame(view_,
                            {at.x, at.y, static_cast<double>(heights_[grid_.index(column, row)])});
  }

  void reckon(int row) {
    if (!view_.drop.any()) {
      reckon(row, &heights_[grid_.index(0, row)], &heights_[grid_.index(0, row + 1)], 0);
      return;
    }
    // What sinks is not a plane over cells any more: heights as the profile frame has them.
    if (row != next_row_) take_row(row, south_z_);
    std::swap(north_z_, south_z_);
    take_row(row + 1, south_z_);
    next_row_ = row + 1;
    // The drop grows with the square of the distance: along a row it is greatest at one of its
    // ends.
    double greatest_drop = 0;
    for (const int c : {0, grid_.columns - 1})
      for (const int r : {row, row + 1}) {
        const ProfilePoint p = vertex(c, r);
        greatest_drop = std::max(greatest_drop, std::abs(view_.drop.at(p.u, p.v)));
      }
    reckon(row, north_z_.data(), south_z_.data(), greatest_drop);
  }

private:
  void take_row(int row, std::vector<double>& z) const {
    const Height* heights = &heights_[grid_.index(0, row)];
    z.resize(static_cast<std::size_t>(grid_.columns));
    for (int c = 0; c < grid_.columns; ++c) {
      const Vec2 at = grid_.position_m(c, row);
      z[static_cast<std::size_t>(c)] =
          to_profile_frame(view_, {at.x, at.y, static_cast<double>(heights[c])}).z;
    }
  }

  template <class AnyHeight>
  void reckon(int row, const AnyHeight* north, const AnyHeight* south, double greatest_drop) {
    const bool perspective = view_.is_perspective();
    // A sign is constant + per_height * h0 + per_c * gc + per_r * gr, where per_c grows along the
    // row in perspective.
    const double scale = perspective ? 1 : -view_.y_per_z * exaggeration_;
    const double constant = perspective ? eye_.height : view_.y_per_v;
    const double per_height = perspective ? -1 : 0;
    const double per_r = perspective ? row - eye_.row : scale * eye_.row;
    const double first_per_c = perspective ? -eye_.column : scale * eye_.column;
    const double step_per_c = perspective ? 1 : 0;
    const auto cells = static_cast<int>(lower.size());
    double greatest_height = greatest_drop, greatest_gc = 0, greatest_gr = 0;
    const auto take = [](double& greatest, double value) {
      value = std::abs(value);
      greatest = value > greatest ? value : greatest; // a missing height is never greater
    };
    for (int c = 0; c < cells; ++c) {
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
    const double reach_c = std::abs(first_per_c) + step_per_c * cells;
    const double reach_r = std::abs(per_r) + std::abs(eye_.row);
    const double bound =
        16 * std::numeric_limits<double>::epsilon() * cells_away_ *
        (std::abs(constant) + greatest_height + greatest_gc * reach_c + greatest_gr * reach_r);
    for (std::size_t c = 0; c < lower.size(); ++c) {
      lower[c] = bits(lower_sign_[c], bound);
      upper[c] = bits(upper_sign_[c], bound);
    }
    std::uint8_t doubt = 0; // in a loop of its own, over bytes alone
    for (std::size_t c = 0; c < lower.size(); ++c)
      doubt |=
          static_cast<std::uint8_t>((lower[c] & (lower[c] >> 1U)) | (upper[c] & (upper[c] >> 1U)));
    if (doubt & 1U) settle(row);
  }

  // A missing height makes both comparisons false.
  static std::uint8_t bits(double sign, double bound) {
    return static_cast<std::uint8_t>((sign >= -bound ? kMayFace : 0) |
                                     (sign <= bound ? kMayTurn : 0));
  }

  // Asks again of the triangles in doubt.
  void settle(int row) {
    for (int c = 0; c < static_cast<int>(lower.size()); ++c) {
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
  const std::vector<Height>& heights_;
  const View& view_;
  double exaggeration_; ///< of the heights that are reckoned with
  EyeInCells eye_;
  bool mirrored_; ///< columns and rows turn the other way
  double cells_away_;
  std::vector<double> lower_sign_, upper_sign_;
  std::vector<double> north_z_, south_z_; ///< where the ground sinks
  int next_row_ = -1;                     ///< whose heights `south_z_` holds
};

struct CellVertex {
  int column, row;
};

template <class Height>
std::vector<SurfaceEdge> find(const Grid& grid, const std::vector<Height>& heights,
                              const View& view) {
  RowFacing facing(grid, heights, view);
  const std::vector<std::uint8_t>&lower = facing.lower, &upper = facing.upper;
  const std::size_t cells = lower.size();
  std::vector<std::uint8_t> north_lower(cells, 0);
  std::vector<SurfaceEdge> edges;
  // Twice 16 ulp of the four heights, as far as positions are off in cells.
  const double rounding =
      32 * std::numeric_limits<double>::epsilon() * 4 * (grid.columns + grid.rows);
  const auto height = [&](CellVertex v) {
    return view.drop.any() ? facing.vertex(v.column, v.row).z
                           : static_cast<double>(heights[grid.index(v.column, v.row)]);
  };
  const auto drop_at = [&](CellVertex v) {
    const ProfilePoint p = facing.vertex(v.column, v.row);
    return view.drop.any() ? 8 * std::abs(view.drop.at(p.u, p.v)) : 0;
  };
  // The two triangles at an edge make a parallelogram: it is a ridge where its middle is higher
  // than the middle between the other two vertices.
  const auto is_ridge = [&](CellVertex from, CellVertex to, CellVertex left, CellVertex right) {
    const double a = height(from), b = height(to), c = height(left), d = height(right);
    const double above = (a - c) + (b - d);
    if (std::abs(above) >
        rounding * (std::abs(a) + std::abs(b) + std::abs(c) + std::abs(d) + drop_at(from)))
      return above > 0;
    const auto at = [&](CellVertex v) { return facing.vertex(v.column, v.row); };
    return cross(grid.column_step_m, grid.row_step_m) > 0
               ? may_be_ridge(at(from), at(to), at(right), at(left))
               : may_be_ridge(at(from), at(to), at(left), at(right));
  };
  const auto add_if = [&](std::uint8_t a, std::uint8_t b, CellVertex from, CellVertex to,
                          CellVertex left, CellVertex right) {
    if (!are_seen_and_turned(a, b) || !is_ridge(from, to, left, right)) return;
    edges.push_back({static_cast<std::uint32_t>(grid.index(from.column, from.row)),
                     static_cast<std::uint32_t>(grid.index(to.column, to.row))});
  };
  for (int row = 0; row + 1 < grid.rows; ++row) {
    facing.reckon(row);
    std::uint8_t west_upper = 0;
    for (std::size_t i = 0; i < cells; ++i) {
      // Where all that meet here face one way, as nearly everywhere, there is no silhouette.
      const auto together =
          static_cast<std::uint8_t>(lower[i] | upper[i] | north_lower[i] | west_upper);
      if (together == (kMayFace | kMayTurn)) {
        const int c = static_cast<int>(i), r = row;
        add_if(north_lower[i], upper[i], {c, r}, {c + 1, r}, {c, r - 1}, {c + 1, r + 1});
        add_if(west_upper, lower[i], {c, r}, {c, r + 1}, {c + 1, r + 1}, {c - 1, r});
        add_if(lower[i], upper[i], {c, r}, {c + 1, r + 1}, {c + 1, r}, {c, r + 1});
      }
      west_upper = upper[i];
    }
    north_lower = lower;
  }
  return edges;
}

} // namespace

std::vector<SurfaceEdge> silhouette_edges(const Grid& grid, const View& view) {
  return std::visit([&](const auto& heights) { return find(grid, heights, view); }, grid.heights_m);
}

} // namespace orograph
