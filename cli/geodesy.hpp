// SPDX-License-Identifier: GPL-3.0-or-later
// The earth is round: what that moves on paper, and how much of it is drawn.
#pragma once

#include "cli/render_settings.hpp"
#include "cli/scene.hpp"
#include "dem/terrain.hpp"

namespace orograph {

/// Mean radius (IUGG), where the terrain has no CRS to tell of its ellipsoid.
constexpr double kMeanEarthRadius_m = 6371008.8;

/// Drops of (1 - K) d^2 / (2 R), with Euler's radius R in the azimuth: 1 / R is cos^2 / M + sin^2 /
/// N, so along north and east it is M and N. K is the refraction coefficient; grid north is taken
/// for north, which R hardly depends on.
EarthDrop earth_drop(const MapFrame& map, double refraction);

/// The most that a drop moves what the page shows: the farthest ground, less what the nearest moves
/// by too, since that only moves the picture. mm on the page.
double drop_mm(const Scene& scene, const EarthDrop& drop);

/// What remains of the map plane when the earth's curvature is drawn: directions and scale of a
/// conformal projection, not farther from its central line than half a UTM zone is wide. Over D
/// metres they are off by up to D x / R^2, x = 334 km (arc-to-chord and scale; Snyder 1987, Map
/// projections: a working manual, chapter 8). mm on the page.
double map_plane_mm(const Scene& scene);

/// Directions over the window, its corners among them, in the homogeneous coordinates of the
/// visibility plane.
std::vector<Vec3> shown_rays(const View& view);

/// Length on the page, in mm, by which a step of 1 m of height moves a ray's point at its end. In a
/// parallel view all points of a ray move alike.
double mm_per_height(const Scene& scene, Vec3 ray);

} // namespace orograph
