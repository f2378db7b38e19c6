// SPDX-License-Identifier: GPL-3.0-or-later
#include "profiles/plan_triangles.hpp"

#include "dem/extent.hpp"
#include "profiles/mesh.hpp"

#include <algorithm>
#include <limits>
#include <optional>
#include <variant>

namespace orograph {

PlanTriangles::PlanTriangles(const Surface& surface, const VertexValues& values)
    : grid_(std::get_if<Grid>(&surface)), tin_(std::get_if<Tin>(&surface)), values_(values) {
  if (!grid_) return;
  const GridSteps steps = steps_of(*grid_);
  column_m_ = steps.column_m;
  row_m_ = steps.row_m;
}

std::array<std::uint32_t, 3> PlanTriangles::corners(std::uint32_t triangle) const {
  if (tin_) return tin_->triangles[triangle];
  const auto cells = static_cast<std::uint32_t>(grid_->columns) - 1;
  const std::uint32_t cell = triangle / 2;
  std::array<std::uint32_t, 3> out;
  for (std::size_t k = 0; k < 3; ++k) {
    const grid_mesh::Offset offset = grid_mesh::kCorners[triangle % 2][k];
    out[k] = static_cast<std::uint32_t>(grid_->index(static_cast<int>(cell % cells) + offset.column,
                                                     static_cast<int>(cell / cells) + offset.row));
  }
  return out;
}

std::uint32_t PlanTriangles::across(std::uint32_t triangle, std::size_t k) const {
  if (tin_) return tin_->neighbours[triangle][k];
  const auto cells = static_cast<std::uint32_t>(grid_->columns) - 1;
  const std::uint32_t cell = triangle / 2;
  const grid_mesh::Offset step = grid_mesh::kBeyond[triangle % 2][k].cell;
  const int column = static_cast<int>(cell % cells) + step.column,
            row = static_cast<int>(cell / cells) + step.row;
  if (column < 0 || row < 0 || column + 1 >= grid_->columns || row + 1 >= grid_->rows)
    return kNoTriangle;
  return static_cast<std::uint32_t>(
      grid_triangle(*grid_, column, row, triangle % 2 == 0 ? Half::upper : Half::lower));
}

Vec2 PlanTriangles::place_m(std::uint32_t vertex) const {
  if (tin_) return plan_m(*tin_, vertex);
  const auto columns = static_cast<std::uint32_t>(grid_->columns);
  return static_cast<double>(vertex % columns) * column_m_ +
         static_cast<double>(vertex / columns) * row_m_;
}

double PlanTriangles::value(std::uint32_t vertex) const {
  double out = 0;
  values_(vertex, std::span(&out, 1));
  return out;
}

namespace {

// A triangle with the shares of its corners as linear functions of a place.
class Shares {
public:
  Shares(const PlanTriangles& triangles, std::uint32_t triangle) {
    const auto corners = triangles.corners(triangle);
    for (std::size_t k = 0; k < 3; ++k) {
      at_[k] = triangles.place_m(corners[k]);
      value_[k] = triangles.value(corners[k]);
    }
    area_ = cross(at_[1] - at_[0], at_[2] - at_[0]);
  }
  bool has_area() const { return area_ != 0 && !std::isnan(value_[0] + value_[1] + value_[2]); }
  std::array<double, 3> at(Vec2 place) const {
    std::array<double, 3> out;
    for (std::size_t k = 0; k < 3; ++k)
      out[k] = cross(at_[(k + 2) % 3] - at_[(k + 1) % 3], place - at_[(k + 1) % 3]) / area_;
    return out;
  }
  // By which the share of a corner grows along a way.
  double growth(std::size_t k, Vec2 way) const {
    return cross(at_[(k + 2) % 3] - at_[(k + 1) % 3], way) / area_;
  }
  double value_growth(Vec2 way) const {
    return growth(0, way) * value_[0] + growth(1, way) * value_[1] + growth(2, way) * value_[2];
  }
  double value_at(Vec2 place) const {
    const auto shares = at(place);
    return shares[0] * value_[0] + shares[1] * value_[1] + shares[2] * value_[2];
  }

private:
  std::array<Vec2, 3> at_;
  std::array<double, 3> value_;
  double area_;
};

} // namespace

std::vector<DownhillPiece> downhill(const PlanTriangles& triangles, std::uint32_t triangle,
                                    Vec2 place_m, double most_m, double lowest) {
  std::vector<DownhillPiece> out;
  const Shares first(triangles, triangle);
  if (!first.has_area()) return out;
  const Vec2 slope{first.value_growth({1, 0}), first.value_growth({0, 1})};
  if (!(length(slope) > 0)) return out;
  const Vec2 way = (-1 / length(slope)) * slope;
  constexpr int kMost = 1000; // triangles of a tick
  std::optional<std::uint32_t> from;
  double left_m = most_m;
  for (int i = 0; i < kMost && left_m > 0; ++i) {
    const Shares shares(triangles, triangle);
    if (!shares.has_area()) break;
    const double fall = -shares.value_growth(way);
    if (!(fall > 0)) break;
    // Out across the side opposite to the corner whose share ends first.
    double step_m = std::numeric_limits<double>::infinity();
    std::size_t side = 3;
    const std::array<double, 3> here = shares.at(place_m);
    for (std::size_t k = 0; k < 3; ++k) {
      const double growth = shares.growth(k, way);
      if (!(growth < 0) || (from && triangles.across(triangle, k) == *from)) continue;
      const double at_m = std::max(0.0, here[k]) / -growth;
      if (at_m < step_m) {
        step_m = at_m;
        side = k;
      }
    }
    const double rest_m =
        std::min(left_m, std::max(0.0, (shares.value_at(place_m) - lowest) / fall));
    const bool ends = side == 3 || rest_m <= step_m;
    const Vec2 next_m = place_m + (ends ? rest_m : step_m) * way;
    if (next_m != place_m) out.push_back({here, shares.at(next_m), triangle});
    if (ends) break;
    left_m -= step_m;
    place_m = next_m;
    from = triangle;
    triangle = triangles.across(triangle, side);
    if (triangle == kNoTriangle) break;
  }
  return out;
}

} // namespace orograph
