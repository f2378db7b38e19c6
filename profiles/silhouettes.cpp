// SPDX-License-Identifier: GPL-3.0-or-later
// In cell coordinates (c to the east, r to the south, in steps of the grid) a triangle's height is
// h = h0 + gc * (c - c0) + gr * (r - r0). The eye sees it where the eye is above that plane; in a
// parallel view, where walking away along F raises Y. Both are one expression of gc and gr.
#include "profiles/silhouettes.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace orograph {
namespace {

// Bits of a triangle: what its facing may be. A missing one has none.
constexpr std::uint8_t kMayFace = 1, kMayTurn = 2;

// Where the eye is on the ground, in cell coordinates; in a parallel view a direction to it.
struct EyeInCells {
  double column, row, height;
  double slack; ///< rounding of column and row
};

EyeInCells eye_in_cells(const Grid& grid, const View& view) {
  const double area = cross(grid.column_step_m, grid.row_step_m);
  const auto solve = [&](Vec2 v) {
    return Vec2{cross(v, grid.row_step_m) / area, cross(grid.column_step_m, v) / area};
  };
  if (!view.is_perspective()) {
    const Vec2 back = solve(-1.0 * view.forward);
    return {back.x, back.y, 0, 1e-12 * (std::abs(back.x) + std::abs(back.y))};
  }
  const Vec2 at = solve(view.depth_origin_m - grid.first_vertex_m);
  return {at.x, at.y, view.eye_z_m / view.exaggeration,
          1e-12 * (std::abs(at.x) + std::abs(at.y) + grid.columns + grid.rows)};
}

// Which sides of a line, on which `eye` - `line` has a sign, may be the nearer one.
struct Nearer {
  bool lower, higher; ///< the side of smaller, of greater coordinates
};
Nearer nearer_side(double eye_beyond_line, double slack) {
  return {eye_beyond_line <= slack, eye_beyond_line >= -slack};
}

// The facing of a row of cells. Loops over a row are plain arithmetic without branches, for the
// vector units, and the rounding bound is one for the row, from its greatest height and gradients.
class RowFacing {
public:
  RowFacing(const EyeInCells& eye, const View& view, std::size_t cells)
      : lower(cells), upper(cells), eye_(eye), perspective_(view.is_perspective()),
        sin_elevation_(view.sin_elevation), cos_elevation_(view.cos_elevation * view.exaggeration),
        lower_sign_(cells), upper_sign_(cells) {}

  std::vector<std::uint8_t> lower, upper; ///< bits, a cell each

  // Heights of the row of vertices to the north of the cells and of that to the south.
  template <class Height>
  void reckon(const Height* north, const Height* south, int row) {
    // A sign is constant + per_height * h0 + per_c * gc + per_r * gr, where per_c grows along the
    // row in perspective.
    const double scale = perspective_ ? 1 : -cos_elevation_;
    const double constant = perspective_ ? eye_.height : sin_elevation_;
    const double per_height = perspective_ ? -1 : 0;
    const double per_r = perspective_ ? row - eye_.row : scale * eye_.row;
    const double first_per_c = perspective_ ? -eye_.column : scale * eye_.column;
    const double step_per_c = perspective_ ? 1 : 0;
    const auto cells = static_cast<int>(lower.size());
    double greatest_height = 0, greatest_gc = 0, greatest_gr = 0;
    const auto take = [](double& greatest, double value) {
      value = std::abs(value);
      greatest = value > greatest ? value : greatest; // a missing height is never greater
    };
    for (int c = 0; c < cells; ++c) {
      const double nw = north[c], ne = north[c + 1], sw = south[c], se = south[c + 1];
      const double per_c = first_per_c + step_per_c * c, level = constant + per_height * nw;
      lower_sign_[static_cast<std::size_t>(c)] = level + per_c * (se - sw) + per_r * (sw - nw);
      upper_sign_[static_cast<std::size_t>(c)] = level + per_c * (ne - nw) + per_r * (se - ne);
      take(greatest_height, nw);
      take(greatest_gc, ne - nw);
      take(greatest_gc, se - sw);
      take(greatest_gr, sw - nw);
      take(greatest_gr, se - ne);
    }
    // 16 ulp for some eight roundings, of the terms and of the eye's own place.
    const double reach_c = std::abs(first_per_c) + step_per_c * cells;
    const double reach_r = std::abs(per_r) + std::abs(eye_.row);
    const double bound =
        16 * std::numeric_limits<double>::epsilon() *
        (std::abs(constant) + greatest_height + greatest_gc * reach_c + greatest_gr * reach_r);
    for (std::size_t c = 0; c < lower.size(); ++c) {
      lower[c] = bits(lower_sign_[c], bound);
      upper[c] = bits(upper_sign_[c], bound);
    }
  }

private:
  // A missing height makes both comparisons false.
  static std::uint8_t bits(double sign, double bound) {
    return static_cast<std::uint8_t>((sign > -bound ? kMayFace : 0) |
                                     (sign <= bound ? kMayTurn : 0));
  }

  EyeInCells eye_;
  bool perspective_;
  double sin_elevation_, cos_elevation_; ///< the latter with exaggeration
  std::vector<double> lower_sign_, upper_sign_;
};

bool is_silhouette(std::uint8_t lower_side, std::uint8_t higher_side, Nearer nearer) {
  return (nearer.lower && (lower_side & kMayFace) && (higher_side & kMayTurn)) ||
         (nearer.higher && (higher_side & kMayFace) && (lower_side & kMayTurn));
}

template <class Height>
std::vector<GridEdge> find(const Grid& grid, const std::vector<Height>& heights, const View& view) {
  const EyeInCells eye = eye_in_cells(grid, view);
  const auto side = [&](double eye_coordinate, double line) {
    return nearer_side(view.is_perspective() ? eye_coordinate - line : eye_coordinate, eye.slack);
  };
  const auto cells = static_cast<std::size_t>(grid.columns) - 1;
  RowFacing facing(eye, view, cells);
  const std::vector<std::uint8_t>&lower = facing.lower, &upper = facing.upper;
  std::vector<std::uint8_t> north_lower(cells, 0);
  std::vector<GridEdge> edges;
  const auto add = [&](int c0, int r0, int c1, int r1) {
    edges.push_back({static_cast<std::uint32_t>(grid.index(c0, r0)),
                     static_cast<std::uint32_t>(grid.index(c1, r1))});
  };
  for (int row = 0; row + 1 < grid.rows; ++row) {
    facing.reckon(&heights[grid.index(0, row)], &heights[grid.index(0, row + 1)], row);
    const Nearer by_row = side(eye.row, row);
    std::uint8_t west_upper = 0;
    for (std::size_t c = 0; c < cells; ++c) {
      // Where all that meet here face one way, as nearly everywhere, there is no silhouette.
      const auto together =
          static_cast<std::uint8_t>(lower[c] | upper[c] | north_lower[c] | west_upper);
      if (together == (kMayFace | kMayTurn)) {
        const int column = static_cast<int>(c);
        if (is_silhouette(north_lower[c], upper[c], by_row)) add(column, row, column + 1, row);
        if (is_silhouette(west_upper, lower[c], side(eye.column, column)))
          add(column, row, column, row + 1);
        // East of the diagonal c - r = column - row lies the upper triangle.
        if (is_silhouette(lower[c], upper[c], side(eye.column - eye.row, column - row)))
          add(column, row, column + 1, row + 1);
      }
      west_upper = upper[c];
    }
    north_lower = lower;
  }
  return edges;
}

} // namespace

std::vector<GridEdge> silhouette_edges(const Grid& grid, const View& view) {
  return std::visit([&](const auto& heights) { return find(grid, heights, view); }, grid.heights_m);
}

} // namespace orograph
