// SPDX-License-Identifier: GPL-3.0-or-later
// A lattice of longitudes and latitudes in the ground frame: every vertex at its true place on the
// ellipsoid for seven multiplications, no trigonometry, nothing resampled.
#pragma once

#include "dem/frame/lean_limits.hpp"
#include "dem/frame/local_frame.hpp"
#include "geometry/vec.hpp"

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

namespace orograph {

/// Vertices at first + number * step, in double precision, steps of either sign. Longitudes may
/// pass 180 or 360 degrees.
struct DegreeLattice {
  double first_lon_deg = 0, lon_step_deg = 0;
  int columns = 0;
  double first_lat_deg = 0, lat_step_deg = 0;
  int rows = 0;

  double lon_deg(int column) const { return first_lon_deg + column * lon_step_deg; }
  double lat_deg(int row) const { return first_lat_deg + row * lat_step_deg; }
  double middle_lon_deg() const { return first_lon_deg + 0.5 * (columns - 1) * lon_step_deg; }
};

/// The place of each vertex of a lattice at its exaggerated height: that of LocalFrame::to_frame,
/// and closer to the true one, within 6e-16 of the distance from the origin (measured on the earth
/// up to 300 km away: 2e-10 m). Heights are exaggerated before they go to their place, so that the
/// earth's curvature never is; a NaN height gives a NaN place. Vertices with a limit to their lean
/// stand as high, but not as far aside.
///
/// Tables a column and a row, from the coordinates about the earth's axis, in which longitude and
/// latitude come apart: a vertex is (N + h) cos(lat) from the axis and (N (1 - e^2) + h) sin(lat)
/// along it, N the radius of curvature in the prime vertical.
class EarthLattice {
public:
  /// Throws Error where a row is beyond a pole.
  EarthLattice(const DegreeLattice& lattice, const LocalFrame& frame, double exaggeration = 1);

  const DegreeLattice& degrees() const { return degrees_; }
  const LocalFrame& frame() const { return frame_; }
  double exaggeration() const { return exaggeration_; }

  Vec3 vertex_m(int column, int row, double height_m) const {
    const Vec3 at = leaning_vertex_m(column, row, height_m);
    if (limits_) [[unlikely]]
      return limited(at, column, row, height_m);
    return at;
  }

  /// The same of a vertex without a limit: linear in its height.
  Vec3 leaning_vertex_m(int column, int row, double height_m) const {
    const auto c = static_cast<std::size_t>(column);
    return place(rows_[static_cast<std::size_t>(row)], sine_[c], versine_[c],
                 exaggeration_ * height_m);
  }

  /// The places of a row's vertices from column `first` on, one for each of the heights, bit for
  /// bit those of vertex_m. REQUIRES four spans of one length that don't overlap.
  void row_vertices_m(int row, int first, std::span<const float> heights_m, std::span<double> x_m,
                      std::span<double> y_m, std::span<double> z_m) const;
  void row_vertices_m(int row, int first, std::span<const double> heights_m, std::span<double> x_m,
                      std::span<double> y_m, std::span<double> z_m) const;

  /// None where all vertices lean by their height.
  const LeanLimits* lean_limits() const { return limits_.get(); }
  /// From now on. REQUIRES limits of this lattice's rows.
  void limit_lean(LeanLimits limits) {
    limits_ = std::make_shared<const LeanLimits>(std::move(limits));
  }
  /// Whether no triangle of the grid is turned over seen from above, as far as anybody has found
  /// out: `limit_lean` does.
  bool is_upright() const { return is_upright_; }
  /// From now on. REQUIRES that it is so, and that the grid's heights stay as they are.
  void set_upright() { is_upright_ = true; }
  /// By which height a vertex at a height leans.
  double leaning_height_m(int column, int row, double height_m) const {
    const LeanLimit* const limit = limits_ ? limits_->of(column, row) : nullptr;
    return limit ? limit->of(height_m) : height_m;
  }

  /// Column and row, whole at a vertex, of the place below a point of the ground frame, in the
  /// lattice's own turn of longitudes as far as it can be told.
  Vec2 column_row_at(Vec3 ground_m) const { return column_row_of(frame_.to_geodetic(ground_m)); }
  Vec2 column_row_of(const GeoPoint& place) const; ///< whatever its height

private:
  /// Of a vertex on the origin's meridian, in this row: its distance from the earth's axis, and
  /// its place north and up; each at height 0 and what a metre of height adds to it.
  struct Row {
    double axis_m, axis_a_metre;
    double north_m, north_a_metre;
    double up_m, up_a_metre;
  };

  static Row row_at(double lat_deg, double origin_lat_deg, const Ellipsoid& ellipsoid);

  // From the meridian to its longitude a vertex goes round the axis: by axis * sin(d) east, and by
  // axis * (1 - cos(d)) towards the axis, which is partly north and partly down at the origin.
  Vec3 place(const Row& row, double sine, double versine, double h_m) const {
    const double axis_m = row.axis_m + h_m * row.axis_a_metre;
    const double inward_m = axis_m * versine;
    return {axis_m * sine, row.north_m + h_m * row.north_a_metre + inward_m * origin_sine_,
            row.up_m + h_m * row.up_a_metre - inward_m * origin_cosine_};
  }

  Vec3 limited(Vec3 at, int column, int row, double height_m) const;
  template <class Height>
  void place_row(int row, int first, std::span<const Height> heights_m, double* x_m, double* y_m,
                 double* z_m) const;

  DegreeLattice degrees_;
  LocalFrame frame_;
  double exaggeration_;
  double origin_sine_, origin_cosine_; ///< of the origin's latitude
  std::vector<double> sine_, versine_; ///< sin(d), 1 - cos(d) of longitudes from the origin's
  std::vector<Row> rows_;
  std::shared_ptr<const LeanLimits> limits_;
  bool is_upright_ = false;
};

} // namespace orograph
