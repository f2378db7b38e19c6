// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/read/landxml_frame.hpp"

#include "dem/read/crs_frame.hpp"
#include "dem/read/gdal_messages.hpp"
#include "dem/read/length_units.hpp"
#include "geometry/error.hpp"

#include <fmt/format.h>
#include <ogr_spatialref.h>

#include <cmath>

namespace orograph {
namespace {

LengthUnit unit_of(const std::string& written, const std::string& path) {
  const auto unit = length_unit(written);
  if (!unit)
    throw Error(fmt::format("{}: lengths in '{}' can't be brought to metres", path, written),
                "LandXML has meter, foot, USSurveyFoot, kilometer, centimeter, millimeter, inch "
                "and mile");
  return *unit;
}

// "feet" says no more than that the linear unit's foot is meant; it is the schema's default.
void set_height(const std::string& written, MapShapes& shapes) {
  const bool in_feet = std::abs(shapes.map.unit_m - 0.3048) < 1e-5;
  if (written.empty() || (written == "feet" && in_feet)) {
    shapes.map.height_unit_m = shapes.map.unit_m;
    shapes.map.height_unit_name = shapes.map.unit_name;
    return;
  }
  const LengthUnit unit = unit_of(written, shapes.path);
  shapes.map.height_unit_m = unit.metres;
  shapes.map.height_unit_name = unit.name;
}

Crs named_crs(const LandxmlPlace& place) {
  Crs crs;
  std::string code = place.epsg_code;
  if (code.starts_with("EPSG:")) code.erase(0, 5);
  if (!code.empty() && code.find_first_not_of("0123456789") == std::string::npos)
    crs = crs_from_text("EPSG:" + code);
  if (!crs && !place.wkt.empty()) crs = crs_from_text(place.wkt);
  return crs;
}

} // namespace

void set_landxml_frame(const LandxmlPlace& place, MapShapes& shapes) {
  const GdalMessages messages;
  MapFrame& map = shapes.map;
  if (!place.linear_unit.empty()) {
    const LengthUnit unit = unit_of(place.linear_unit, shapes.path);
    map.unit_m = unit.metres;
    map.unit_name = unit.name;
    shapes.units_known = true;
  }
  const Crs crs = named_crs(place);
  if (!crs && !(place.epsg_code.empty() && place.wkt.empty()))
    shapes.notes.push_back(fmt::format(
        "The file's CRS isn't known (epsgCode '{}'): it is left out.", place.epsg_code));
  if (tells_place(crs.get())) {
    MapFrame of_crs;
    const Vec3 centre = shapes.points.empty() ? Vec3{} : shapes.points.front();
    set_crs(of_crs, *crs, shapes.path, FileKind::other, {centre.x, centre.y});
    // Programs mistake the two feet for each other, a matter of 2 mm a kilometre.
    const bool agree = std::abs(of_crs.unit_m / map.unit_m - 1) < 1e-5;
    if (!shapes.units_known || agree) {
      map = of_crs;
      shapes.units_known = true;
    } else {
      shapes.notes.push_back(fmt::format("The file's CRS, {}, is in {} but its coordinates are in "
                                         "{}: the CRS is left out.",
                                         of_crs.crs_name, of_crs.unit_name, map.unit_name));
    }
  }
  set_height(place.elevation_unit, shapes);
}

} // namespace orograph
