// SPDX-License-Identifier: GPL-3.0-or-later
// Where a part of a profile is asked for, walks begin as well at the sides of a few cells about its
// left end, and end beyond its right one.
#include "profiles/cut_earth_grid.hpp"

#include "profiles/mesh_walk.hpp"
#include "view/view.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace orograph {
namespace {

template <class Height>
struct CutEarthMesh : GridMesh<EarthLattice, Height> {
  const TriangleSet& level;

  bool is_wall(const CellHalf&) const { return false; }
  Span span_in(const CellHalf& t) const {
    return !level.empty() && level.has(grid_triangle(this->grid, t.column, t.row, t.half))
               ? Span::level
               : Span::slope;
  }
};

using CellBox = BorderInView::Cells;
constexpr CellBox kNoCells{0, -1, 0, -1};

// Calls take(side) with the sides about a box, by the triangles in it.
template <class Take>
void for_each_side_about(const CellBox& box, const Take& take) {
  if (box.empty()) return;
  for (int column = box.first_column; column <= box.last_column; ++column) {
    take(GridSide{{column, box.first_row, Half::upper}, 1});
    take(GridSide{{column, box.last_row, Half::lower}, 0});
  }
  for (int row = box.first_row; row <= box.last_row; ++row) {
    take(GridSide{{box.first_column, row, Half::lower}, 2});
    take(GridSide{{box.last_column, row, Half::upper}, 0});
  }
}

// Among them is any that holds a place of a profile, between two z: uprights lean against one
// another, so that the ground at a place may belong to any cell below one of its heights. A
// triangle is flat, and leaves its cell by less than a cell.
CellBox cells_about(const Grid& grid, const View& view, ProfilePoint place, double low_z_m,
                    double high_z_m) {
  const EarthLattice& lattice = grid.earth();
  const Vec2 at = view.depth_origin_m + place.u * view.right + place.v * view.forward;
  const Vec2 low = lattice.column_row_at({at.x, at.y, low_z_m}),
             high = lattice.column_row_at({at.x, at.y, high_z_m});
  const auto whole = [](double cell, int count) {
    return static_cast<int>(std::clamp(std::floor(cell), -2.0, count + 1.0));
  };
  return {std::max(whole(std::min(low.x, high.x), grid.columns) - 1, 0),
          std::min(whole(std::max(low.x, high.x), grid.columns) + 1, grid.columns - 2),
          std::max(whole(std::min(low.y, high.y), grid.rows) - 1, 0),
          std::min(whole(std::max(low.y, high.y), grid.rows) + 1, grid.rows - 2)};
}

// Whether a place has one column, and near enough a straight way from one height to the other.
bool is_plain(const DegreeLattice& degrees) {
  const double from_deg = degrees.lat_deg(0), to_deg = degrees.lat_deg(degrees.rows - 1);
  return std::abs(degrees.lon_step_deg) * degrees.columns < 180 &&
         std::max(std::abs(from_deg), std::abs(to_deg)) < 85;
}

// A part of the profile of a grid.
template <class Mesh>
void cut_part(const Mesh& mesh, const BorderInView& border, const CellBox& left_end, URange part,
              double depth_m, bool far_at_plane, Profile& out) {
  Profile found;
  std::vector<Run> runs;
  MeshWalk<Mesh> walk(mesh, depth_m, part.high_m, far_at_plane, found);
  const auto add = [&](const std::optional<Run>& run) {
    if (run) runs.push_back(*run);
  };
  for_each_side_about(left_end, [&](const GridSide& side) {
    const auto [column, row] = mesh.corner(side.triangle, (side.k + 2U) % 3);
    const bool ends = std::isnan(mesh.heights[mesh.grid.index(column, row)]);
    // Where there is nothing beyond it, it is of the border.
    if (!ends && mesh.if_there(side) && mesh.across(side)) add(walk.over(side));
  });
  std::vector<GridSide> sides;
  border.at(depth_m, part, left_end, sides);
  for (const GridSide& side : sides) add(walk.from(side));
  keep_ground_in_front(runs);
  put_in_order(found, runs, out);
}

} // namespace

EarthGridCutter::EarthGridCutter(const Grid& grid, const View& view, const TriangleSet& level,
                                 std::shared_ptr<const BorderPlaces> border, const Box3* box)
    : grid_(grid), view_(view), level_(level), border_(std::move(border), view) {
  if (box && is_plain(grid.earth().degrees())) z_m_ = {box->low.z, box->high.z};
}

void EarthGridCutter::cut(double depth_m, std::span<const URange> ranges, Profile& out) const {
  const URange part{ranges.front().low_m, ranges.back().high_m};
  if (!z_m_ || !std::isfinite(part.low_m)) {
    cut(depth_m, out);
    return;
  }
  out.clear();
  out.depth_m = depth_m;
  if (!(depth_m >= nearest_m() && depth_m <= farthest_m())) return;
  const CellBox left_end =
      cells_about(grid_, view_, {part.low_m, depth_m, 0}, z_m_->low_m, z_m_->high_m);
  std::visit(
      [&]<class Height>(const Heights<Height>& heights) {
        cut_part(CutEarthMesh<Height>{{grid_, grid_.earth(), heights, view_}, level_}, border_,
                 left_end, part, depth_m, depth_m > nearest_m(), out);
      },
      grid_.heights_m);
}

void EarthGridCutter::cut(double depth_m, Profile& out) const {
  out.clear();
  out.depth_m = depth_m;
  if (!(depth_m >= nearest_m() && depth_m <= farthest_m())) return;
  thread_local std::vector<GridSide> sides; // kept for its memory
  border_.at(depth_m, {}, kNoCells, sides);
  std::visit(
      [&]<class Height>(const Heights<Height>& heights) {
        cut_mesh(CutEarthMesh<Height>{{grid_, grid_.earth(), heights, view_}, level_}, sides,
                 depth_m, depth_m > nearest_m(), out);
      },
      grid_.heights_m);
}

} // namespace orograph
