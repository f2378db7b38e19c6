// SPDX-License-Identifier: GPL-3.0-or-later
// A grid of heights: the terrain of a DEM (docs/how-it-works.md).
#pragma once

#include "dem/frame/earth_lattice.hpp"
#include "geometry/vec.hpp"

#include <algorithm>
#include <cstddef>
#include <initializer_list>
#include <memory>
#include <span>
#include <utility>
#include <variant>
#include <vector>

namespace orograph {

/// Vertices at equal steps on a map plane, in metres east and north in the ground frame, whose
/// origin is near the terrain, so that they are small numbers.
struct PlaneLattice {
  Vec2 first_vertex_m; ///< ground position of vertex (0, 0), the north-west one
  Vec2 column_step_m;  ///< from a column to the next, eastward
  Vec2 row_step_m;     ///< from a row to the next, southward

  Vec2 position_m(int column, int row) const {
    return {first_vertex_m.x + column * column_step_m.x + row * row_step_m.x,
            first_vertex_m.y + column * column_step_m.y + row * row_step_m.y};
  }
  Vec3 vertex_m(int column, int row, double height_m) const {
    const Vec2 at = position_m(column, row);
    return {at.x, at.y, height_m};
  }
  /// Whether rows run to the left of columns, seen from above; no reader makes such a grid.
  bool is_mirrored() const { return cross(column_step_m, row_step_m) > 0; }
};

/// An array whose copies share their values until one of them is written to, so that a terrain can
/// stand in many frames at the cost of one. Reading from several threads is safe.
template <class T>
class Heights {
public:
  using value_type = T;

  Heights() : Heights(std::vector<T>{}) {}
  Heights(std::initializer_list<T> values) : Heights(std::vector<T>(values)) {}
  Heights(std::vector<T> values)
      : values_(std::make_shared<std::vector<T>>(std::move(values))), data_(values_->data()),
        size_(values_->size()) {}
  /// Borrowed: they aren't copied, and `owner` is kept for as long as anybody has them. REQUIRES
  /// that they stay where and what they are until then.
  Heights(std::span<const T> values, std::shared_ptr<const void> owner)
      : owner_(std::move(owner)), data_(values.data()), size_(values.size()) {}

  const T& operator[](std::size_t i) const { return data_[i]; }
  std::size_t size() const { return size_; }
  const T* data() const { return data_; }
  const T* begin() const { return data(); }
  const T* end() const { return data() + size(); }
  bool operator==(const Heights& other) const {
    return std::equal(begin(), end(), other.begin(), other.end());
  }

  /// To be written to: copied first, if another shares them or they are borrowed.
  std::span<T> own() {
    if (!values_ || values_.use_count() > 1) {
      values_ = std::make_shared<std::vector<T>>(begin(), end());
      data_ = values_->data();
      owner_.reset();
    }
    return *values_;
  }

private:
  std::shared_ptr<std::vector<T>> values_; ///< null where they are borrowed
  std::shared_ptr<const void> owner_;      ///< of borrowed ones
  const T* data_;
  std::size_t size_;
};

/// Vertices in rows from the north, columns from the west, with heights in metres; NaN where there
/// is none. Each cell of four vertices is split by the diagonal from (column, row) to
/// (column + 1, row + 1) into an upper triangle (with the vertex to the north-east) and a lower one
/// (with the vertex to the south-west). A triangle with a NaN vertex isn't there.
///
/// A DEM in metres lies on its map plane; one in degrees on the ellipsoid, where a vertex leans
/// with its height.
struct Grid {
  int columns = 0, rows = 0;
  std::variant<PlaneLattice, EarthLattice> lattice;
  /// Row-major, rows * columns; shared by copies. float unless the file has heights in double
  /// precision.
  std::variant<Heights<float>, Heights<double>> heights_m;

  bool is_on_earth() const { return std::holds_alternative<EarthLattice>(lattice); }
  const EarthLattice& earth() const { return std::get<EarthLattice>(lattice); }
  PlaneLattice& plane() { return std::get<PlaneLattice>(lattice); }
  const PlaneLattice& plane() const { return std::get<PlaneLattice>(lattice); }

  std::size_t index(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) +
           static_cast<std::size_t>(column);
  }
  std::size_t size() const {
    return static_cast<std::size_t>(rows) * static_cast<std::size_t>(columns);
  }
  /// Height of one vertex; for loops over many, `std::visit` the heights once instead.
  double height_m(int column, int row) const {
    return std::visit([&](const auto& h) { return static_cast<double>(h[index(column, row)]); },
                      heights_m);
  }
  /// Its place in the ground frame. Everything that needs one vertex asks here or the lattice
  /// itself, so that it is the same number everywhere. NaN where there is no height (on a map plane
  /// in z alone).
  Vec3 vertex_m(int column, int row) const {
    return std::visit([&](const auto& l) { return l.vertex_m(column, row, height_m(column, row)); },
                      lattice);
  }
  Vec3 vertex_m(std::size_t index) const {
    const auto across = static_cast<std::size_t>(columns);
    return vertex_m(static_cast<int>(index % across), static_cast<int>(index / across));
  }
};

} // namespace orograph
