// SPDX-License-Identifier: GPL-3.0-or-later
// From where a terrain shows most: directions tried on a coarse copy of it.
#pragma once

#include "geometry/angle.hpp"
#include "geometry/box.hpp"
#include "placing/ground_ahead.hpp"

#include <array>
#include <vector>

namespace orograph {

/// Heights at even steps east and north, row by row from the south-west; NaN where there is no
/// ground. Triangles as a grid's, split from north-west to south-east.
struct CoarseGround {
  int columns = 0, rows = 0;
  double step_m = 0;
  std::vector<double> z_m; ///< exaggerated

  double at(int column, int row) const {
    return z_m[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) +
               static_cast<std::size_t>(column)];
  }
};

/// The longer side has `kCoarseCells`, or as many as the terrain's cells are, if they are fewer.
/// Cost: as many cuts, on all cores.
constexpr int kCoarseCells = 128;
CoarseGround coarse_ground(const CutSurface& of, const Box3& box, double cell_m,
                           double exaggeration);

/// Elevations that are tried, from each of 16 azimuths. Lower ones show little of mountains, higher
/// ones little of their height.
constexpr std::array<double, 8> kTriedElevations_deg{10, 15, 20, 25, 30, 35, 40, 45};

/// Of each place the slope (tangent) above which rays in the viewer's azimuth see it: the greatest
/// slope up to any ground on the way, the place's own facet included; -infinity where there is
/// none. NaN where there is no ground. Exact along the lines of columns, rows and diagonals, where
/// all that hides is.
std::vector<double> slopes_to_see(const CoarseGround& ground, Angle azimuth);

/// The view that shows most ground with most relief. Each place that is seen counts half by itself,
/// and half by its steepness (sine of its slope, beside the mean), of which what faces the viewer
/// counts whole, what lies aside by half and what is turned away not at all; and all that times the
/// cosine of the elevation, by which heights are shown. Rays are parallel, whatever the projection.
/// Of equals the first, from the south on clockwise, low before high.
struct ChosenView {
  Angle azimuth = Angle::degrees(180), elevation = Angle::degrees(kTriedElevations_deg[0]);
  double score = 0;      ///< 1: all is steep, and faces the viewer
  double seen_share = 0; ///< of the places
};
ChosenView choose_view(const CoarseGround& ground);

} // namespace orograph
