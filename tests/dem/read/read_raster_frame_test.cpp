// SPDX-License-Identifier: GPL-3.0-or-later
// Where a raster lies, and in which units.
#include "dem/read/crs_frame.hpp"
#include "geometry/error.hpp"
#include "tests/catch.hpp"
#include "tests/dem/read/raster_file.hpp"
#include "tests/dem/read/read_back.hpp"
#include "tests/dem/temp_folder.hpp"
#include "tests/support/grid_of.hpp"

#include <ogr_spatialref.h>

#include <cmath>
#include <fstream>

namespace orograph::read_raster_frame_test {
namespace {

constexpr double us_foot_m = 1200. / 3937., foot_m = 0.3048;

} // namespace

TEST_CASE("the vertex is the cell's centre in both pixel conventions") {
  RasterFile raster = counting_raster(4, 3);
  const TerrainData area = read_back(raster);
  raster.area_or_point = "Point";
  const TerrainData point = read_back(raster);
  CHECK(area.map.origin == Vec2{500005, 4999995});
  CHECK(point.map.origin == area.map.origin);
  CHECK(grid_of(point).plane().column_step_m == grid_of(area).plane().column_step_m);
}

TEST_CASE("US survey feet across and feet up come to metres and back") {
  RasterFile raster = counting_raster(4, 3);
  raster.crs = "EPSG:2229";
  raster.geotransform = {6457000, 100, 0, 1971000, 0, -100};
  raster.unit = "ft";
  const TerrainData terrain = read_back(raster);
  // The CRS data base writes the unit with 15 digits.
  CHECK(std::abs(terrain.map.unit_m - us_foot_m) <= 1e-15);
  CHECK(terrain.map.unit_name == "US survey foot");
  CHECK(terrain.map.height_unit_m == foot_m);
  CHECK(terrain.map.height_unit_name == "foot");
  CHECK(grid_of(terrain).plane().column_step_m == Vec2{100 * terrain.map.unit_m, 0});
  CHECK(std::abs(grid_of(terrain).height_m(3, 2) - 11 * foot_m) <= 1e-6);
  const Vec2 last = grid_of(terrain).plane().position_m(3, 2);
  const Vec3 map = terrain.map.to_map({last.x, last.y, grid_of(terrain).height_m(3, 2)});
  CHECK(std::abs(map.x - 6457350) <= 1e-8);
  CHECK(std::abs(map.y - 1970750) <= 1e-8);
  CHECK(std::abs(map.z - 11) <= 1e-5);
  CHECK(!has_note(terrain, "no unit"));
}

TEST_CASE("units of height") {
  RasterFile raster = counting_raster(4, 3);
  const auto unit_m = [&](const char* unit) {
    raster.unit = unit;
    return read_back(raster).map.height_unit_m;
  };
  CHECK(unit_m("m") == 1);
  CHECK(unit_m("Metre") == 1);
  CHECK(unit_m("us-ft") == us_foot_m);
  CHECK(unit_m("US survey foot") == us_foot_m);
  CHECK(unit_m("FEET") == foot_m);
  CHECK(unit_m("cm") == 0.01);
  raster.unit = "";
  CHECK(has_note(read_back(raster), "no unit of height"));
  raster.crs = "EPSG:2229"; // US survey feet
  const TempFolder folder;
  write_raster(raster, folder.file("feet.tif"));
  std::string refused;
  try {
    read_raster(folder.file("feet.tif"));
  } catch (const Error& error) {
    refused = error.what();
  }
  for (const char* words : {"no unit of height", "US survey foot", "`height_unit` m, ft"})
    CHECK(refused.find(words) != std::string::npos);
  ReadOptions in_feet;
  in_feet.height_unit = "ft";
  const TerrainData told = read_raster(folder.file("feet.tif"), in_feet);
  CHECK(told.map.height_unit_m == foot_m);
  CHECK(!has_note(told, "though the file says"));
  raster.unit = "m";
  write_raster(raster, folder.file("metres.tif"));
  const TerrainData corrected = read_raster(folder.file("metres.tif"), in_feet);
  CHECK(corrected.map.height_unit_m == foot_m);
  CHECK(has_note(corrected, "taken as ft, though the file says m"));
  raster.unit = "";
  raster.crs = "EPSG:32610+6360"; // with NAVD88 heights in US survey feet
  const TerrainData compound = read_back(raster);
  CHECK(compound.map.height_unit_m == us_foot_m);
  CHECK(!has_note(compound, "no unit of height"));
}

TEST_CASE("what heights are above, as far as the CRS says it") {
  RasterFile raster = counting_raster(4, 3);
  CHECK(read_back(raster).map.vertical_crs_name.empty());
  raster.crs = "EPSG:32632+5773";
  CHECK(read_back(raster).map.vertical_crs_name == "EGM96 height (EPSG:5773)");
  raster.crs = "EPSG:32610+6360";
  CHECK(read_back(raster).map.vertical_crs_name == "NAVD88 height (ftUS) (EPSG:6360)");
  MapFrame map;
  const Crs solid = crs_from_text("EPSG:32632");
  solid->PromoteTo3D(nullptr);
  set_crs(map, *solid, "a.tif", FileKind::raster, {});
  CHECK(map.vertical_crs_name == "ellipsoid of WGS 84 / UTM zone 32N");
}

TEST_CASE("the CRS is kept by name and text") {
  const TerrainData with = read_back(counting_raster(4, 3));
  CHECK(with.map.crs_name == "WGS 84 / UTM zone 32N (EPSG:32632)");
  CHECK(with.map.crs_wkt.find("UTM zone 32N") != std::string::npos);
  CHECK(with.notes.empty());
  RasterFile raster = counting_raster(4, 3);
  raster.crs = "";
  const TerrainData without = read_back(raster);
  CHECK(without.map.crs_name == "none");
  CHECK(without.map.crs_wkt.empty());
  CHECK(has_note(without, "no CRS"));
}

TEST_CASE("without georeference cells are 1 m and the first row is in the north") {
  RasterFile raster = counting_raster(4, 3);
  raster.geotransform.reset();
  raster.crs = "";
  const TerrainData terrain = read_back(raster);
  CHECK(grid_of(terrain).plane().column_step_m == Vec2{1, 0});
  CHECK(grid_of(terrain).plane().row_step_m == Vec2{0, -1});
  CHECK(grid_of(terrain).height_m(1, 0) == 1);
  CHECK(grid_of(terrain).height_m(0, 1) == 4);
  CHECK(has_note(terrain, "no georeference"));
}

TEST_CASE("the geotransform that GDAL tells where there is none counts as none") {
  const TempFolder folder;
  RasterFile raster = counting_raster(4, 3);
  raster.geotransform.reset();
  write_raster(raster, folder.file("dem.tif"));
  std::ofstream(folder.file("dem.vrt"))
      << "<VRTDataset rasterXSize='4' rasterYSize='3'>"
         "<GeoTransform>0, 1, 0, 0, 0, 1</GeoTransform>"
         "<VRTRasterBand dataType='Float32' band='1'><SimpleSource>"
         "<SourceFilename relativeToVRT='1'>dem.tif</SourceFilename>"
         "</SimpleSource></VRTRasterBand></VRTDataset>";
  const TerrainData terrain = read_raster(folder.file("dem.vrt"));
  CHECK(grid_of(terrain).height_m(0, 0) == 0);
  CHECK(has_note(terrain, "no georeference"));
}

} // namespace orograph::read_raster_frame_test
