// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/read/crs_frame.hpp"

#include "dem/frame/local_frame.hpp"
#include "geometry/angle.hpp"
#include "geometry/error.hpp"
#include "text/printable.hpp"

#include <cpl_conv.h>
#include <fmt/format.h>
#include <ogr_spatialref.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string_view>

#include "gdal/gdal.hpp"

namespace orograph {
namespace {

// A fitting projected CRS for a place in degrees: its UTM zone, beyond them the polar ones.
int projected_epsg(double longitude_deg, double latitude_deg) {
  if (latitude_deg > 84) return 32661;
  if (latitude_deg < -80) return 32761;
  const double turned = std::remainder(longitude_deg, 360); // from -180; NaN of what is no place
  const int zone =
      std::isnan(turned) ? 1 : std::min(static_cast<int>(std::floor((turned + 180) / 6)) + 1, 60);
  return (latitude_deg >= 0 ? 32600 : 32700) + zone;
}

[[noreturn]] void refuse_degrees(const OGRSpatialReference& crs, const std::string& path,
                                 FileKind kind, Vec2 centre) {
  const double to_deg = crs.GetAngularUnits() * 180 / M_PI;
  const int epsg = projected_epsg(centre.x * to_deg, centre.y * to_deg);
  const std::string hint =
      kind == FileKind::vector
          ? fmt::format("project it first: ogr2ogr -t_srs EPSG:{} projected.gpkg {}", epsg, path)
          : fmt::format("give eastings and northings, in EPSG:{} for example", epsg);
  throw Error(
      fmt::format("{} is in degrees ({}), in which rasters only are read", path, crs.GetName()),
      hint);
}

std::string name_for_people(const OGRSpatialReference& crs) {
  const char* name = crs.GetName();
  const char *authority = crs.GetAuthorityName(nullptr), *code = crs.GetAuthorityCode(nullptr);
  std::string text = name ? name : "unnamed";
  if (authority && code) text += fmt::format(" ({}:{})", authority, code);
  return text;
}

// What heights are above, as far as the CRS says it.
std::string vertical_name(const OGRSpatialReference& crs) {
  if (!crs.IsCompound())
    return crs.GetAxesCount() == 3 ? fmt::format("ellipsoid of {}", crs.GetName()) : "";
  const char* name = crs.GetAttrValue("VERT_CS");
  const char *authority = crs.GetAuthorityName("VERT_CS"), *code = crs.GetAuthorityCode("VERT_CS");
  std::string text = name ? name : "unnamed";
  if (authority && code) text += fmt::format(" ({}:{})", authority, code);
  return text;
}

std::string well_known_text(const OGRSpatialReference& crs) {
  char* text = nullptr;
  const std::array<const char*, 2> options{"FORMAT=WKT2_2018", nullptr};
  crs.exportToWkt(&text, options.data());
  const std::string wkt = text ? text : "";
  CPLFree(text);
  return wkt;
}

// By the latitude of a place in the CRS's own coordinates, easting first.
std::optional<CurvatureRadii> radii_at(const OGRSpatialReference& crs, Vec2 place) {
  const Crs geographic(crs.CloneGeogCS());
  if (!geographic) return std::nullopt;
  geographic->SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  const Crs projected(crs.Clone());
  projected->SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  const std::unique_ptr<OGRCoordinateTransformation> to_degrees(
      OGRCreateCoordinateTransformation(projected.get(), geographic.get()));
  const std::optional<Vec2> there = to_degrees ? moved(*to_degrees, place) : std::nullopt;
  if (!there) return std::nullopt;
  const double latitude_deg = there->y * geographic->GetAngularUnits() * 180 / std::numbers::pi;
  const Ellipsoid ellipsoid{geographic->GetSemiMajor(), geographic->GetInvFlattening()};
  return CurvatureRadii{euler_radius_m(ellipsoid, latitude_deg, Angle()),
                        euler_radius_m(ellipsoid, latitude_deg, Angle::degrees(90))};
}

} // namespace

void ReleaseCrs::operator()(OGRSpatialReference* crs) const {
  crs->Release();
}

Crs crs_from_text(const std::string& text) {
  // A name of bytes that are no text PROJ would look for among all its names: half a second for 4
  // kB of them. In WKT names may be in another encoding.
  if (text.find('[') == std::string::npos && printable(text) != text) return nullptr;
  const GdalMessages unheard;
  Crs crs(new OGRSpatialReference);
  // Never from a file or an address that the text might name.
  const char* const options[] = {"ALLOW_NETWORK_ACCESS=NO", "ALLOW_FILE_ACCESS=NO", nullptr};
  if (crs->SetFromUserInput(text.c_str(), options) != OGRERR_NONE) return nullptr;
  return crs;
}

Crs plane_of(Crs crs) {
  if (!crs) return nullptr;
  crs->StripVertical();
  crs->DemoteTo2D(nullptr);
  crs->SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  return crs;
}

bool tells_place(const OGRSpatialReference* crs) {
  if (!crs || crs->IsEmpty() || (crs->IsVertical() && !crs->IsCompound())) return false;
  const char* name = crs->GetName(); // GeoPackage's rows for "none"
  return !name || !std::string_view(name).starts_with("Undefined ");
}

void set_crs(MapFrame& map, const OGRSpatialReference& crs, const std::string& path, FileKind kind,
             Vec2 centre) {
  if (crs.IsDerivedGeographic())
    throw Error(
        fmt::format("{} counts longitudes about a pole of its own ({})", path, crs.GetName()),
        fmt::format("bring it to one of the earth's first: gdalwarp -t_srs EPSG:4326 {} "
                    "degrees.tif",
                    path));
  if (crs.IsGeographic() && kind != FileKind::raster) refuse_degrees(crs, path, kind, centre);
  if (crs.IsGeocentric())
    throw Error(fmt::format("{} is in a geocentric CRS", path),
                fmt::format("project it with {} first",
                            kind == FileKind::raster ? "gdalwarp" : "ogr2ogr -t_srs"));
  map.crs_name = name_for_people(crs);
  map.vertical_crs_name = vertical_name(crs);
  map.crs_wkt = well_known_text(crs);
  const char* unit = nullptr;
  if (crs.IsGeographic()) {
    const double unit_deg = crs.GetAngularUnits(&unit) * 180 / std::numbers::pi;
    map.earth = EarthFrame{LocalFrame(centre.x * unit_deg, centre.y * unit_deg,
                                      {crs.GetSemiMajor(), crs.GetInvFlattening()}),
                           // of degrees themselves, without the rounding of their radians
                           std::abs(unit_deg - 1) < 1e-12 ? 1 : unit_deg, 1};
    map.unit_name = unit && *unit ? unit : "degree";
    return;
  }
  map.unit_m = crs.GetLinearUnits(&unit);
  if (map.unit_m != 1 && unit) map.unit_name = unit;
}

bool set_height_unit(MapFrame& map, const OGRSpatialReference& crs) {
  if (!crs.IsCompound()) return false;
  const char* unit = nullptr;
  map.height_unit_m = crs.GetTargetLinearUnits("VERT_CS", &unit);
  if (map.height_unit_m != 1 && unit) map.height_unit_name = unit;
  return true;
}

bool same_place(const std::string& wkt, const std::string& other_wkt) {
  if (wkt == other_wkt) return true;
  const Crs one = crs_from_text(wkt), other = crs_from_text(other_wkt);
  if (!one || !other) return false;
  const GdalMessages unheard;
  one->StripVertical();
  other->StripVertical();
  // Files hold their coordinates in the same order, whatever order the CRS has for its axes.
  const char* const options[] = {"CRITERION=EQUIVALENT", "IGNORE_DATA_AXIS_TO_SRS_AXIS_MAPPING=YES",
                                 nullptr};
  return one->IsSame(other.get(), options);
}

std::optional<double> whole_turn(const std::string& wkt) {
  const Crs crs = wkt.empty() ? nullptr : crs_from_text(wkt);
  if (!crs || !crs->IsGeographic()) return std::nullopt;
  const double turn = 2 * M_PI / crs->GetAngularUnits();
  const double whole = std::round(turn); // units are written with 15 digits
  return std::abs(turn - whole) < 1e-9 * turn ? whole : turn;
}

void set_centre(MapFrame& map, Vec2 centre) {
  const GdalMessages unheard;
  const Crs crs = map.crs_wkt.empty() ? nullptr : crs_from_text(map.crs_wkt);
  if (crs) map.radii = radii_at(*crs, centre);
  if (!map.earth) return;
  const double unit_deg = map.earth->unit_deg;
  const LocalFrame local(centre.x * unit_deg, centre.y * unit_deg, map.earth->local.ellipsoid());
  map.earth = EarthFrame{local, unit_deg};
}

std::optional<Vec2> moved(OGRCoordinateTransformation& way, Vec2 place) {
  constexpr double kFarthest = 1e11; // also in millimetres
  if (!(std::abs(place.x) <= kFarthest && std::abs(place.y) <= kFarthest)) return std::nullopt;
  if (!way.Transform(1, &place.x, &place.y) || !std::isfinite(place.x) || !std::isfinite(place.y))
    return std::nullopt;
  return place;
}

std::string crs_for_command(const std::string& wkt) {
  const Crs crs = crs_from_text(wkt);
  if (!crs) return "CRS";
  const char *authority = crs->GetAuthorityName(nullptr), *code = crs->GetAuthorityCode(nullptr);
  if (authority && code) return fmt::format("{}:{}", authority, code);
  return fmt::format("'{}'", crs->GetName());
}

} // namespace orograph
