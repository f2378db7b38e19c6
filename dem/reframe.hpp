// SPDX-License-Identifier: GPL-3.0-or-later
// A terrain in degrees about another origin.
#pragma once

#include "dem/terrain.hpp"

namespace orograph {

/// Puts the origin of the ground frame to a place (longitude and latitude in degrees, as the
/// terrain's CRS counts them), so that there up is the frame's z, and gives every vertex its place
/// there with its height times `exaggeration`. REQUIRES a grid in degrees. Throws Error where the
/// place is none, and where the terrain reaches farther from it than a sixth of the earth's way
/// round, where it would fold over itself. Cost: tables a column and a row; heights aren't touched.
void reframe(Terrain& terrain, double lon_deg, double lat_deg, double exaggeration);

} // namespace orograph
