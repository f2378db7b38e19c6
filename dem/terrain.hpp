// SPDX-License-Identifier: GPL-3.0-or-later
// What a reader brings: a surface, and how its metres are tied to the file's coordinates.
#pragma once

#include "dem/frame/local_frame.hpp"
#include "dem/levels/larger_cells.hpp"
#include "dem/surface.hpp"
#include "dem/triangulate/triangulation_counts.hpp"
#include "geometry/vec.hpp"

#include <cmath>
#include <optional>
#include <string>
#include <vector>

namespace orograph {

/// Of the ellipsoid at a place: along the meridian (M) and across it (N).
struct CurvatureRadii {
  double meridian_m, prime_vertical_m;
};

/// The ground frame of a terrain in degrees.
struct EarthFrame {
  LocalFrame local; ///< counts longitudes from the CRS's own prime meridian
  double unit_deg = 1;
  double exaggeration = 1; ///< of heights, before they go to their place
  /// Of the terrain, wherever `local` is put: its longitudes are counted within half a turn of it.
  /// Around a pole the eye's may be in another turn than the terrain's farther parts.
  double middle_lon_deg = local.origin_lon_deg();
};

/// Between ground metres and the terrain's own coordinates (its CRS's axes and units, heights in
/// the file's unit).
struct MapFrame {
  Vec2 origin;                     ///< map coordinates of the ground frame's origin, in CRS units
  double unit_m = 1;               ///< metres in one CRS unit; of no use where `earth` is
  std::optional<EarthFrame> earth; ///< where the CRS counts in degrees, or other angles
  double height_unit_m = 1;        ///< metres in one unit of the file's heights
  std::string crs_wkt;             ///< empty where the file has none
  std::string crs_name;            ///< for people; "none" where the file has none
  std::optional<CurvatureRadii> radii; ///< at the terrain's middle; none where the CRS has no place
  std::string
      vertical_crs_name; ///< what heights are above, for people; empty: the file doesn't say
  std::string unit_name = "metre";
  std::string height_unit_name = "metre";

  Vec3 to_map(Vec3 ground_m) const {
    if (earth) {
      const GeoPoint at = earth->local.to_geodetic(ground_m);
      const double turns = std::round((at.lon_deg - earth->middle_lon_deg) / 360);
      return {(at.lon_deg - 360 * turns) / earth->unit_deg, at.lat_deg / earth->unit_deg,
              at.h_m / earth->exaggeration / height_unit_m};
    }
    return {origin.x + ground_m.x / unit_m, origin.y + ground_m.y / unit_m,
            ground_m.z / height_unit_m};
  }
  Vec3 to_ground_m(Vec3 map) const {
    if (earth)
      return earth->local.to_frame(map.x * earth->unit_deg, map.y * earth->unit_deg,
                                   map.z * height_unit_m * earth->exaggeration);
    return {(map.x - origin.x) * unit_m, (map.y - origin.y) * unit_m, map.z * height_unit_m};
  }
};

struct TerrainData {
  Surface surface;
  MapFrame map;
  std::string source;             ///< what it was read from, in brief
  std::vector<std::string> paths; ///< the files it was read from, as given
  std::vector<std::string> notes; ///< what the reader assumed, a sentence each, for the report
  std::optional<TriangulationCounts> triangulation; ///< where it was made of points
  /// How far the surface may be, in height, from what it was made to stand for; 0 where it stands
  /// for itself.
  double surface_error_m = 0;
  /// Of a raster of which larger cells were read (`ReadOptions::large`).
  std::optional<LargerCells> larger_cells = {};
  /// Whether it is an overview of the file's heights, whose distance from them nobody knows.
  bool is_overview = false;
  /// Those of the notes that leave its place, its CRS or its heights in doubt.
  std::vector<std::string> doubts = {};
};

/// Puts the origin of the ground frame to a place (longitude and latitude in degrees, as the
/// terrain's CRS counts them), so that there up is the frame's z, and gives every vertex its place
/// there with its height times `exaggeration`. REQUIRES a grid in degrees. Throws Error where the
/// place is none, and where the terrain reaches farther from it than a sixth of the earth's way
/// round, where it would fold over itself. Cost: tables a column and a row; heights aren't touched.
void reframe(TerrainData& terrain, double lon_deg, double lat_deg, double exaggeration);

} // namespace orograph
