// SPDX-License-Identifier: GPL-3.0-or-later
// A surface's vertices in a view's profile frame, by number.
#pragma once

#include "dem/surface.hpp"
#include "geometry/profile_point.hpp"
#include "view/view.hpp"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <variant>
#include <vector>

namespace orograph {

/// Reckoned whenever they are asked for, and always the same: memory to keep a million of them
/// takes the system longer to hand out than they take.
class SheetVertices {
public:
  /// REQUIRES that both outlive it.
  SheetVertices(const Surface& surface, const View& view)
      : surface_(&surface), view_(&view), grid_(std::get_if<Grid>(&surface)) {
    if (!grid_) return;
    columns_ = static_cast<std::uint32_t>(grid_->columns);
    rows_a_vertex_ = 1.0 / columns_;
    plane_ = std::get_if<PlaneLattice>(&grid_->lattice);
    earth_ = std::get_if<EarthLattice>(&grid_->lattice);
    if (const auto* heights = std::get_if<Heights<float>>(&grid_->heights_m))
      floats_ = heights->data();
    else
      doubles_ = std::get<Heights<double>>(grid_->heights_m).data();
  }

  ProfilePoint operator[](std::uint32_t vertex) const {
    if (!grid_) return to_profile_frame(*view_, std::get<Tin>(*surface_).vertices_m[vertex]);
    auto row = static_cast<std::uint32_t>(vertex * rows_a_vertex_);
    // The product is rounded.
    if (row * columns_ > vertex) --row;
    if (vertex - row * columns_ >= columns_) ++row;
    return at(vertex - row * columns_, row);
  }

  /// Of a grid: those of a row from column `first` on, each at its column in `out`.
  void read(std::uint32_t row, std::uint32_t first, std::uint32_t behind,
            std::vector<ProfilePoint>& out) const {
    out.resize(behind);
    if (earth_ && behind - first == columns_) {
      floats_ ? read_whole(row, floats_, out) : read_whole(row, doubles_, out);
      return;
    }
    for (std::uint32_t column = first; column < behind; ++column) out[column] = at(column, row);
  }

private:
  template <class Height>
  void read_whole(std::uint32_t row, const Height* heights, std::vector<ProfilePoint>& out) const {
    thread_local std::vector<double> x_m, y_m, z_m;
    for (std::vector<double>* of : {&x_m, &y_m, &z_m}) of->resize(columns_);
    earth_->row_vertices_m(static_cast<int>(row), 0,
                           std::span(heights + std::size_t{row} * columns_, columns_), x_m, y_m,
                           z_m);
    const double *x = x_m.data(), *y = y_m.data(), *z = z_m.data();
    for (std::uint32_t c = 0; c < columns_; ++c)
      out[c] = to_profile_frame(*view_, {x[c], y[c], z[c]});
  }
  ProfilePoint at(std::uint32_t column, std::uint32_t row) const {
    const std::size_t vertex = std::size_t{row} * columns_ + column;
    const double height_m = floats_ ? static_cast<double>(floats_[vertex]) : doubles_[vertex];
    const int c = static_cast<int>(column), r = static_cast<int>(row);
    return to_profile_frame(*view_, plane_ ? plane_->vertex_m(c, r, height_m)
                                           : earth_->vertex_m(c, r, height_m));
  }

  const Surface* surface_;
  const View* view_;
  const Grid* grid_;
  std::uint32_t columns_ = 1;
  double rows_a_vertex_ = 1;
  const PlaneLattice* plane_ = nullptr; ///< one of the two
  const EarthLattice* earth_ = nullptr;
  const float* floats_ = nullptr; ///< one of the two
  const double* doubles_ = nullptr;
};

/// Vertices of a lattice on the earth, row by row. Where one isn't there the ground goes on as high
/// as before it.
class FilledRows {
public:
  /// REQUIRES that all outlive it.
  FilledRows(const Grid& grid, const View& view, const SheetVertices& vertices)
      : grid_(grid), view_(view), vertices_(vertices) {}

  /// Columns from `first` on of a row. Tells whether any was filled.
  bool read(std::uint32_t row, std::uint32_t first, std::uint32_t behind,
            std::vector<ProfilePoint>& out) {
    vertices_.read(row, first, behind, out);
    bool is_filled = false, was_there = false;
    for (std::uint32_t column = first; column < behind; ++column) {
      const bool is_there = !std::isnan(out[column].z);
      if (!is_there) {
        const int c = static_cast<int>(column), r = static_cast<int>(row);
        if (was_there)
          height_m_ = grid_.earth().leaning_height_m(c - 1, r, grid_.height_m(c - 1, r));
        out[column] = to_profile_frame(view_, grid_.earth().vertex_m(c, r, height_m_));
        is_filled = true;
      }
      was_there = is_there;
    }
    return is_filled;
  }

private:
  const Grid& grid_;
  const View& view_;
  const SheetVertices& vertices_;
  double height_m_ = 0;
};

} // namespace orograph
