// SPDX-License-Identifier: GPL-3.0-or-later
// GeoJSON and GeoPackage give back what was drawn, to the last bit.
#include "geometry/error.hpp"
#include "tests/catch.hpp"
#include "tests/draw/made_drawing.hpp"
#include "write/write_drawing.hpp"
#include "write/writers.hpp"

#include <ogrsf_frmts.h>

#include <cmath>
#include <memory>
#include <random>

using namespace orograph;

namespace {

using Dataset = std::unique_ptr<GDALDataset>;

Dataset open(const std::string& path) {
  GDALAllRegister();
  return Dataset(GDALDataset::Open(path.c_str(), GDAL_OF_VECTOR));
}

// Points that differ from the drawing's in any bit.
int different_points(const OGRLineString& line, const Layer& layer, const Stroke& stroke) {
  int different = 0;
  for (int i = 0; i < line.getNumPoints(); ++i) {
    const Vec3 read{line.getX(i), line.getY(i), line.getZ(i)};
    different += read != layer.map[stroke.first_point + static_cast<std::size_t>(i)];
  }
  return different;
}

void check_strokes(OGRLayer& read, const Drawing& drawing) {
  read.ResetReading();
  for (const Layer& layer : drawing.layers)
    for (const Stroke& stroke : layer.strokes) {
      const OGRFeatureUniquePtr feature(read.GetNextFeature());
      REQUIRE(feature);
      CHECK(feature->GetFieldAsString("layer") == layer.name);
      CHECK(feature->GetFieldAsInteger("profile") == stroke.profile);
      CHECK(feature->GetFieldAsInteger("visible") == 1);
      const int depth = feature->GetFieldIndex("depth");
      CHECK(feature->IsFieldSetAndNotNull(depth) == !std::isnan(stroke.depth_m));
      if (!std::isnan(stroke.depth_m)) CHECK(feature->GetFieldAsDouble(depth) == stroke.depth_m);
      const int level = feature->GetFieldIndex("level"),
                darkness = feature->GetFieldIndex("darkness");
      CHECK(feature->IsFieldSetAndNotNull(level) == (stroke.profile >= 0));
      CHECK(feature->IsFieldSetAndNotNull(darkness) == !std::isnan(stroke.darkness));
      if (stroke.profile >= 0) CHECK(feature->GetFieldAsInteger(level) == stroke.level);
      if (!std::isnan(stroke.darkness)) // to four decimals
        CHECK(std::abs(feature->GetFieldAsDouble(darkness) - stroke.darkness) < 0.51e-4);
      REQUIRE(feature->GetGeometryRef()->getGeometryType() == wkbLineString25D);
      const OGRLineString& line = *feature->GetGeometryRef()->toLineString();
      REQUIRE(line.getNumPoints() == static_cast<int>(stroke.point_count));
      CHECK(different_points(line, layer, stroke) == 0);
    }
  CHECK(OGRFeatureUniquePtr(read.GetNextFeature()) == nullptr);
}

} // namespace

TEST_CASE("strokes tied to the ground read back bit for bit") {
  Drawing drawing = made_drawing();
  std::mt19937_64 random(11);
  drawing.layers.front().strokes.front().darkness = 0.25371F;
  drawing.layers.front().strokes.front().level = 3;
  for (Vec3& point : drawing.layers[1].map) { // degrees and metres with all their bits
    point = {std::uniform_real_distribution(-180.0, 180.0)(random),
             std::uniform_real_distribution(4e6, 9e6)(random),
             std::uniform_real_distribution(-400.0, 8848.0)(random)};
  }
  for (const char* name : {"map.geojson", "map.gpkg"}) {
    INFO(name);
    const TemporaryFolder folder;
    write_drawing(drawing, folder.file(name), {.format = format_of_path(name)});
    const Dataset dataset = open(folder.file(name));
    REQUIRE(dataset);
    REQUIRE(dataset->GetLayerCount() == 1);
    OGRLayer& layer = *dataset->GetLayer(0);
    CHECK(std::string(layer.GetName()) == "strokes");
    CHECK(layer.GetLayerDefn()->GetFieldCount() == 6);
    REQUIRE(layer.GetSpatialRef() != nullptr);
    CHECK(layer.GetSpatialRef()->GetAuthorityCode(nullptr) == std::string("32632"));
    check_strokes(layer, drawing);
  }
}

TEST_CASE("a terrain without a CRS gives lines without one") {
  Drawing drawing = made_drawing();
  drawing.crs_wkt.clear();
  for (const char* name : {"map.geojson", "map.gpkg"}) {
    INFO(name);
    const TemporaryFolder folder;
    write_drawing(drawing, folder.file(name), {.format = format_of_path(name)});
    const Dataset dataset = open(folder.file(name));
    REQUIRE(dataset);
    check_strokes(*dataset->GetLayer(0), drawing);
  }
}

TEST_CASE("a CRS that is none is an error") {
  Drawing drawing = made_drawing();
  drawing.crs_wkt = "PROJCRS[nonsense";
  const TemporaryFolder folder;
  for (const char* name : {"map.geojson", "map.gpkg"})
    CHECK_THROWS_AS(write_drawing(drawing, folder.file(name), {.format = format_of_path(name)}),
                    Error);
  CHECK(folder.names().empty());
}

TEST_CASE("the proof sees missing strokes and damaged files") {
  const TemporaryFolder folder;
  const std::string path = folder.file("map.gpkg");
  const Drawing drawing = made_drawing(200, 100);
  write_drawing(drawing, path, {.format = Format::gpkg});
  CHECK_NOTHROW(prove_geopackage(drawing, path, "map"));
  Drawing longer = drawing;
  longer.layers[0].strokes.push_back(longer.layers[0].strokes[0]);
  CHECK_THROWS_AS(prove_geopackage(longer, path, "map"), Error);

  const std::string whole = content_of(path);
  {
    const Dataset dataset(GDALDataset::Open(path.c_str(), GDAL_OF_VECTOR | GDAL_OF_UPDATE));
    REQUIRE(dataset);
    dataset->ExecuteSQL("DROP TRIGGER trigger_insert_feature_count_strokes", nullptr, nullptr);
  }
  CHECK_THROWS_AS(prove_geopackage(drawing, path, "map"), Error);

  fill_file(path, whole.substr(0, whole.size() - 3)); // half a last page
  CHECK_THROWS_AS(prove_geopackage(drawing, path, "map"), Error);
  fill_file(path, whole.substr(0, whole.size() / 2));
  CHECK_THROWS_AS(prove_geopackage(drawing, path, "map"), Error);
  std::string holed = whole; // as where a block never reached the disk
  holed.replace(holed.size() / 2, 4096, 4096, '\0');
  fill_file(path, holed);
  CHECK_THROWS_AS(prove_geopackage(drawing, path, "map"), Error);
}
