// SPDX-License-Identifier: GPL-3.0-or-later
// Longitude and latitude of places on a map, and back, as PROJ has them.
#pragma once

#include "geometry/angle.hpp"
#include "geometry/box.hpp"
#include "geometry/vec.hpp"

#include <optional>
#include <string>

namespace orograph {

// `crs_wkt` is that of a MapFrame, `map` a place in this CRS, in its units, easting (or longitude)
// first, whatever order the CRS has for its axes. Longitude and latitude are in degrees on WGS 84,
// longitude first. Heights take no part in any of this. Nothing is returned where the CRS isn't on
// the earth, and for places that the CRS or the earth doesn't have. Between datums places are as
// good as what PROJ knows of their shift, a metre or some.

/// Whether the CRS tells where on the earth it is: none that is local, and no empty text.
bool is_on_earth(const std::string& crs_wkt);

/// Longitude from -180 to 180.
std::optional<Vec2> lonlat_of_map(const std::string& crs_wkt, Vec2 map);
/// Longitudes that are whole turns apart are the same.
std::optional<Vec2> map_of_lonlat(const std::string& crs_wkt, Vec2 lonlat_deg);

/// Box in longitude and latitude of a box on the map, from points all along its sides and inside.
/// Where it lies across 180 degrees, longitudes go on beyond.
std::optional<Box2> lonlat_bounds(const std::string& crs_wkt, const Box2& map);

/// The smallest box on the map that holds all places between two longitudes and two latitudes, from
/// points all along its sides: a thousand a side, between which a parallel of latitude bends by
/// less than 2 cm where the box is ten degrees wide, and by 2 m where it is a hundred. Where the
/// map counts longitudes, and they go over its seam, they go on beyond; `turn` is a whole turn of
/// them.
std::optional<Box2> map_bounds_of_lonlat(const std::string& crs_wkt, const Box2& lonlat_deg,
                                         std::optional<double> turn);

// Of a direction at a place: `map_azimuth` clockwise from the map's upwards, `true_azimuth`
// clockwise from the meridian's north, which differ by the convergence of meridians, and by the
// map's distortion of angles where it has any. Within 1e-7 degrees. REQUIRES a projected CRS.
std::optional<Angle> map_azimuth(const std::string& crs_wkt, Vec2 map, Angle true_azimuth);
std::optional<Angle> true_azimuth(const std::string& crs_wkt, Vec2 map, Angle map_azimuth);

} // namespace orograph
