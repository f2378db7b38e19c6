// SPDX-License-Identifier: GPL-3.0-or-later
// From a CRS as GDAL knows it to a MapFrame, for rasters, vectors and all others alike.
#pragma once

#include "dem/terrain.hpp"

#include <memory>
#include <optional>
#include <string>

class OGRCoordinateTransformation;
class OGRSpatialReference;

namespace orograph {

struct ReleaseCrs {
  void operator()(OGRSpatialReference* crs) const;
};
using Crs = std::unique_ptr<OGRSpatialReference, ReleaseCrs>;

/// From WKT, "EPSG:32632" and the like; null if it can't be understood.
Crs crs_from_text(const std::string& text);

/// A CRS as its plane alone, with its axes in the order that files have. Null stays null.
Crs plane_of(Crs crs);

/// False where there is none, or one of heights only, or one that only says that none is known.
bool tells_place(const OGRSpatialReference* crs);

/// What would bring a file into a projected CRS, for the hint.
enum class FileKind { raster, vector, other };

/// Sets the CRS, its names and the unit of eastings and northings; heights stay in metres.
/// `centre`, in the CRS's own coordinates, is where a raster in degrees has the origin of its
/// ground frame, and otherwise only serves to name a fitting projection. REQUIRES tells_place.
/// Throws Error for a geocentric CRS and, except for rasters, for a geographic one.
void set_crs(MapFrame& map, const OGRSpatialReference& crs, const std::string& path, FileKind kind,
             Vec2 centre);

/// Sets the unit of height if the CRS has a vertical part, and tells whether it has.
bool set_height_unit(MapFrame& map, const OGRSpatialReference& crs);

/// Whether two CRSs (WKT) have the same eastings and northings, whatever their heights.
bool same_place(const std::string& wkt, const std::string& other_wkt);

/// A whole turn of longitude in the units of a CRS that counts longitudes, 360 for degrees; none
/// for all others.
std::optional<double> whole_turn(const std::string& wkt);

/// Says where the terrain's middle is, in the CRS's own coordinates: there it has its radii, and
/// its frame, if that is on the earth, has its origin. Nothing happens without a CRS.
void set_centre(MapFrame& map, Vec2 centre);

/// A place in another CRS, by GDAL. Empty where it has none there, or is a hundred million
/// kilometres away: from the coordinates of web maps GDAL takes whole turns about the earth away
/// one by one, and does so for ever at 1e98.
std::optional<Vec2> moved(OGRCoordinateTransformation& way, Vec2 place);

/// "EPSG:32632", or the name if it has no code: as a command line takes it.
std::string crs_for_command(const std::string& wkt);

} // namespace orograph
