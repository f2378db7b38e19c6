// SPDX-License-Identifier: GPL-3.0-or-later
// The earth is round: what that moves on paper, and how much of it is drawn.
#pragma once

#include "dem/terrain.hpp"
#include "placing/map_spec.hpp"
#include "placing/placed_view.hpp"

#include <optional>
#include <vector>

namespace orograph {

/// Mean radius (IUGG), where the terrain has no CRS to tell of its ellipsoid.
constexpr double kMeanEarthRadius_m = 6371008.8;

/// Drops of (1 - K) d^2 / (2 R), with Euler's radius R in the azimuth: 1 / R is cos^2 / M + sin^2 /
/// N, so along north and east it is M and N. K is the refraction coefficient; grid north is taken
/// for north, which R hardly depends on. Of a terrain in degrees the ellipsoid has curved away
/// already, and the drop is the lift of refraction, -K d^2 / (2 R), with the mean radius at the
/// frame's origin. There d is the horizontal distance in the frame of the eye: of a place at
/// elevation b the straight one is longer by 1 / cos b, a hundredth of the lift at 6 degrees, and K
/// isn't known to a tenth.
EarthDrop earth_drop(const MapFrame& map, double refraction);

/// The most that a drop moves what the page shows: the farthest ground, less what the nearest moves
/// by too, since that only moves the picture. mm on the page.
double drop_mm(const PlacedView& placed, const EarthDrop& drop);

/// What the map plane itself moves: how far its directions and distances from the eye are off those
/// of the geodesics to the sides, corners and middle of the terrain, and how much wider the earth
/// is where the ground is high. What stretches all of it alike counts only from a given eye: one
/// that was placed to frame the terrain would stand elsewhere. None where eye or terrain are at no
/// place on the earth. mm on the page.
std::optional<double> map_plane_mm(const PlacedView& placed, const MapFrame& map,
                                   bool eye_is_given);

/// From the eye to the nearest ground there may be, no less than the near plane. REQUIRES a
/// perspective view.
double least_distance_m(const PlacedView& placed);

/// What is left of the earth's curvature when a drop is drawn: a sphere sinks more than the
/// parabola far away, by d^4 / 8 R^3, and is shorter on the level by d^2 / 6 R^2. mm on the page.
double parabola_mm(const PlacedView& placed);
/// Between vertices, which alone sink, edges of `longest_edge_m` stay straight. mm on the page.
double sag_mm(const PlacedView& placed, const EarthDrop& drop, double longest_edge_m);

/// Directions over the window, its corners among them, in the homogeneous coordinates of the
/// visibility plane.
std::vector<Vec3> shown_rays(const View& view);

/// Length on the page, in mm, by which a step of 1 m of height moves a ray's point at its end. In a
/// parallel view all points of a ray move alike.
double mm_per_height(const PlacedView& placed, Vec3 ray);

} // namespace orograph
