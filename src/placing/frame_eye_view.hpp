// SPDX-License-Identifier: GPL-3.0-or-later
// An eye in the landscape that isn't told how steeply to look: the window goes where skyline and
// foreground fill it, as a view camera's plate is shifted, so that uprights stay upright.
#pragma once

#include "placing/ground_ahead.hpp"
#include "placing/map_spec.hpp"
#include "view/place_view.hpp"

namespace orograph {

/// Whether a view is of that kind: with an eye, but neither a pitch nor a point to look at, and not
/// rolled, which leaves no upright to shift along.
bool is_framed_by_skyline(const ViewSpec& view);

/// The page's part in it.
struct WindowShape {
  double greatest_aspect;         ///< height over width
  bool ends_with_picture = false; ///< lower where the picture is
};

/// Shares of the window's height that are sky above the highest skyline, and of its width that are
/// ground below the lowest where the page ends with the picture.
constexpr double kSkyShare = 0.06, kForegroundShare = 0.25;

/// Shifts the window of a view that looks level, so that the highest skyline over its width, and a
/// little sky, are at its top, and ground is below as far as it goes; where that ends above the
/// window's bottom, what there is (far rims of voids too, seen or not) goes to the middle. Vertices
/// of solids count as skyline as far as they are no more than half the window above the ground's.
/// Where the window ends with the picture it is a quarter of its width lower than the lowest
/// skyline, or as the ground ends. Returns false, the window unchanged, where there is no ground
/// over its width, where all of that is more than 45 degrees below the eye, which then doesn't
/// stand in the landscape but above it, and where the window would show what is beside the eye
/// (view/sectors.hpp).
///
/// The skyline is the greatest Y of all ground: what it hides is lower. It is exact: among vertices
/// by bounds of their blocks, among what crosses the window's sides by the two cuts there, the
/// first and last of `ahead`.
/// REQUIRES a perspective view of elevation and roll 0.
bool frame_eye_view(View& view, const TerrainShape& terrain, const std::vector<GroundAhead>& ahead,
                    bool stands_over_ground, const WindowShape& shape);

} // namespace orograph
