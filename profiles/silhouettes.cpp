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

// Facing of a triangle through (c0, r0, h0) with gradients gc, gr a cell, in perspective or
// parallel.
struct Facing {
  const EyeInCells eye;
  bool perspective;
  double sin_elevation, cos_elevation; ///< the latter with exaggeration

  std::uint8_t operator()(double column, double row, double height, double gc, double gr) const {
    // 16 ulp for some eight roundings, of the terms and of the eye's own place.
    constexpr double kBound = 16 * std::numeric_limits<double>::epsilon();
    double sign, size;
    if (perspective) {
      const double along_c = gc * (eye.column - column), along_r = gr * (eye.row - row);
      sign = eye.height - height - along_c - along_r;
      size = std::abs(eye.height) + std::abs(height) +
             std::abs(gc) * (std::abs(eye.column) + column) +
             std::abs(gr) * (std::abs(eye.row) + row);
    } else {
      // (eye.column, eye.row) is one metre back towards the viewer.
      const double rise_c = -gc * eye.column, rise_r = -gr * eye.row;
      sign = sin_elevation + cos_elevation * (rise_c + rise_r);
      size = sin_elevation + cos_elevation * (std::abs(rise_c) + std::abs(rise_r));
    }
    const double bound = kBound * size;
    // A missing height makes both comparisons false.
    return static_cast<std::uint8_t>((sign > -bound ? kMayFace : 0) |
                                     (sign <= bound ? kMayTurn : 0));
  }
};

bool is_silhouette(std::uint8_t lower_side, std::uint8_t higher_side, Nearer nearer) {
  return (nearer.lower && (lower_side & kMayFace) && (higher_side & kMayTurn)) ||
         (nearer.higher && (higher_side & kMayFace) && (lower_side & kMayTurn));
}

template <class Height>
std::vector<GridEdge> find(const Grid& grid, const std::vector<Height>& heights, const View& view) {
  const EyeInCells eye = eye_in_cells(grid, view);
  const Facing facing{eye, view.is_perspective(), view.sin_elevation,
                      view.cos_elevation * view.exaggeration};
  const bool perspective = view.is_perspective();
  const auto side = [&](double eye_coordinate, double line) {
    return nearer_side(perspective ? eye_coordinate - line : eye_coordinate, eye.slack);
  };
  const auto cells = static_cast<std::size_t>(grid.columns) - 1;
  std::vector<std::uint8_t> lower(cells), upper(cells), north_lower(cells, 0);
  std::vector<GridEdge> edges;
  const auto add = [&](int c0, int r0, int c1, int r1) {
    edges.push_back({static_cast<std::uint32_t>(grid.index(c0, r0)),
                     static_cast<std::uint32_t>(grid.index(c1, r1))});
  };
  for (int row = 0; row + 1 < grid.rows; ++row) {
    const Height* north = &heights[grid.index(0, row)];
    const Height* south = &heights[grid.index(0, row + 1)];
    for (std::size_t c = 0; c < cells; ++c) {
      const double nw = north[c], ne = north[c + 1], sw = south[c], se = south[c + 1];
      const auto column = static_cast<double>(c);
      lower[c] = facing(column, row, nw, se - sw, sw - nw);
      upper[c] = facing(column, row, nw, ne - nw, se - ne);
    }
    const Nearer by_row = side(eye.row, row);
    for (std::size_t c = 0; c < cells; ++c) {
      const int column = static_cast<int>(c);
      if (north_lower[c] != 0 && upper[c] != 0 && is_silhouette(north_lower[c], upper[c], by_row))
        add(column, row, column + 1, row);
      if (c > 0 && upper[c - 1] != 0 && lower[c] != 0 &&
          is_silhouette(upper[c - 1], lower[c], side(eye.column, column)))
        add(column, row, column, row + 1);
      // East of the diagonal c - r = column - row lies the upper triangle.
      if (lower[c] != 0 && upper[c] != 0 &&
          is_silhouette(lower[c], upper[c], side(eye.column - eye.row, column - row)))
        add(column, row, column + 1, row + 1);
    }
    std::swap(north_lower, lower);
  }
  return edges;
}

} // namespace

std::vector<GridEdge> silhouette_edges(const Grid& grid, const View& view) {
  return std::visit([&](const auto& heights) { return find(grid, heights, view); }, grid.heights_m);
}

} // namespace orograph
