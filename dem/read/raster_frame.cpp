// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/read/raster_frame.hpp"

#include "dem/read/crs_frame.hpp"
#include "dem/read/length_units.hpp"
#include "geometry/error.hpp"

#include <fmt/format.h>
#include <gdal_priv.h>
#include <ogr_spatialref.h>

#include <array>
#include <cmath>

namespace orograph {
namespace {

void set_horizontal(MapFrame& map, const OGRSpatialReference* crs, const std::string& path,
                    Vec2 centre, std::vector<std::string>& notes) {
  map.crs_name = "none";
  if (!tells_place(crs)) {
    notes.push_back("The file has no CRS: its coordinates are taken as metres.");
    return;
  }
  set_crs(map, *crs, path, FileKind::raster, centre);
}

// What is given goes before what the file says. Where eastings are in feet, heights of no unit may
// be either: a guess would be wrong by a factor of three.
void set_vertical(MapFrame& map, const OGRSpatialReference* crs, const std::string& given,
                  const std::string& in_file, const std::string& path,
                  std::vector<std::string>& notes) {
  const std::string& written = given.empty() ? in_file : given;
  if (written.empty() && crs && set_height_unit(map, *crs)) return;
  if (written.empty()) {
    if (map.unit_m != 1)
      throw Error(fmt::format("{} names no unit of height, and its coordinates are in units of "
                              "{:.6g} m ({})",
                              path, map.unit_m, map.unit_name),
                  "say which: --height-unit m, ft or us-ft");
    notes.push_back("The file names no unit of height: metres are taken.");
    return;
  }
  if (!given.empty() && !in_file.empty() && given != in_file)
    notes.push_back(
        fmt::format("Heights are taken as {}, though the file says {}.", given, in_file));
  const auto unit = length_unit(written);
  if (!unit)
    throw Error(
        fmt::format("{}: heights in '{}' can't be brought to metres", path, written),
        "units known are m, ft, us-ft, km, dm, cm and mm; 'gdal_edit.py -units m' sets one");
  map.height_unit_m = unit->metres;
  map.height_unit_name = unit->name;
}

[[noreturn]] void refuse_place(const std::string& path, const char* told_by, const char* option) {
  throw Error(fmt::format("{}: its place is told by {} only", path, told_by),
              fmt::format("bring it to a grid first: gdalwarp {}{} grid.tif", option, path));
}

} // namespace

bool has_georeference(GDALDataset& dataset) {
  std::array<double, 6> gt{};
  const std::array<double, 6> unset{0, 1, 0, 0, 0, 1};
  return dataset.GetGeoTransform(gt.data()) == CE_None && gt != unset;
}

RasterLattice raster_lattice(GDALDataset& dataset, const std::string& path,
                             std::vector<std::string>& notes) {
  std::array<double, 6> gt{};
  dataset.GetGeoTransform(gt.data());
  if (!has_georeference(dataset)) {
    if (dataset.GetGCPCount() > 0) refuse_place(path, "ground control points", "-tps ");
    if (dataset.GetMetadata("RPC")) refuse_place(path, "rational polynomials (RPC)", "-rpc ");
    if (dataset.GetMetadata("GEOLOCATION")) refuse_place(path, "geolocation arrays", "-geoloc ");
    notes.push_back(
        "The file has no georeference: cells are taken as 1 m, with the first row in the north.");
    gt = {0, 1, 0, 0, 0, -1};
  }
  RasterLattice lattice;
  lattice.pixels = dataset.GetRasterXSize();
  lattice.lines = dataset.GetRasterYSize();
  lattice.pixel_step = {gt[1], gt[4]};
  lattice.line_step = {gt[2], gt[5]};
  lattice.first = Vec2{gt[0], gt[3]} + 0.5 * lattice.pixel_step + 0.5 * lattice.line_step;
  if (!spans_a_plane(lattice))
    throw Error(fmt::format("{}: its geotransform has no area", path),
                "pixel and line steps must be finite and span a cell; see gdalinfo");
  return lattice;
}

MapFrame raster_map_frame(GDALDataset& dataset, GDALRasterBand& band, const std::string& path,
                          Vec2 centre, const std::string& height_unit,
                          std::vector<std::string>& notes) {
  const OGRSpatialReference* crs = dataset.GetSpatialRef();
  MapFrame map;
  set_horizontal(map, crs, path, centre, notes);
  set_vertical(map, crs, height_unit, band.GetUnitType(), path, notes);
  return map;
}

} // namespace orograph
