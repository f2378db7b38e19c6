// SPDX-License-Identifier: GPL-3.0-or-later
// Whether a place is visible, by sight through every triangle, in long double: no horizon, no
// order, no neighbours, no walk along a lattice.
#pragma once

#include "dem/grid.hpp"
#include "geometry/profile_point.hpp"
#include "view/view.hpp"

#include <array>
#include <vector>

namespace orograph {

struct LongPlace {
  long double u = 0, v = 0, z = 0; ///< as ProfilePoint has them
};

class SightThroughTriangles {
public:
  /// Of the grid's triangles as the view sees them. REQUIRES a grid on a map plane, and a view that
  /// doesn't sink with the earth's curvature.
  SightThroughTriangles(const Grid& grid, const View& view);

  /// How far a place of the surface is above all that stands in front of it, in Y of the visibility
  /// plane; negative below it, infinite where nothing does. What leads up to the place is in front
  /// of it where it begins. What is nearer by less than `nearer_m` counts as being at the place.
  /// REQUIRES a place beyond the near plane. Cost: all triangles.
  long double above(const LongPlace& place, long double nearer_m) const;
  long double above(const LongPlace& place) const { return above(place, rounding_m_); }

  /// Bound on the rounding of a place on the ground in double precision, along any direction.
  long double rounding_m() const { return rounding_m_; }

private:
  View view_;
  std::vector<std::array<LongPlace, 3>> triangles_;
  long double rounding_m_ = 0;
};

} // namespace orograph
