// SPDX-License-Identifier: GPL-3.0-or-later
// DXF as GDAL reads it: the page's lines in millimetres, y up, with their layers and colours.
#include "tests/catch.hpp"
#include "tests/draw/made_drawing.hpp"
#include "write/write_drawing.hpp"

#include <ogrsf_frmts.h>

#include <memory>
#include <sstream>
#include <string>
#include <vector>

using namespace orograph;

TEST_CASE("DXF keeps points, layers and colours") {
  Drawing drawing = made_drawing();
  drawing.layers[1].pen = Pen{.number = 2, .name = "red", .colour = {255, 0, 0}};
  drawing.layers[0].grey = 0;
  const TemporaryFolder folder;
  write_drawing(drawing, folder.file("map.dxf"), {.format = Format::dxf});
  CHECK(content_of(folder.file("map.dxf")).find("$INSUNITS\n 70\n     4\n") != std::string::npos);
  GDALAllRegister();
  const std::unique_ptr<GDALDataset> dataset(
      GDALDataset::Open(folder.file("map.dxf").c_str(), GDAL_OF_VECTOR));
  REQUIRE(dataset);
  OGRLayer& read = *dataset->GetLayer(0);
  for (const Layer& layer : drawing.layers)
    for (const Stroke& stroke : layer.strokes) {
      const OGRFeatureUniquePtr feature(read.GetNextFeature());
      REQUIRE(feature);
      CHECK(feature->GetFieldAsString("Layer") == layer.name);
      CHECK(std::string(feature->GetStyleString()).find(layer.pen ? "#ff0000" : "#000000") !=
            std::string::npos);
      const OGRLineString& line = *feature->GetGeometryRef()->toLineString();
      REQUIRE(line.getNumPoints() == static_cast<int>(stroke.point_count));
      int different = 0;
      for (int i = 0; i < line.getNumPoints(); ++i) {
        const Vec2 p = layer.points(stroke)[static_cast<std::size_t>(i)];
        different +=
            std::abs(line.getX(i) - p.x) > 1e-9 || std::abs(line.getY(i) - (297 - p.y)) > 1e-9;
      }
      CHECK(different == 0);
    }
  CHECK(OGRFeatureUniquePtr(read.GetNextFeature()) == nullptr);
}

// GDAL loses 32 bytes when its template ends early.
TEST_CASE("DXF without its end is refused", "[unsanitized]") {
  // GDAL looks for the end of its template there first, and finds nothing in it.
  const TemporaryFolder gdal_files, folder;
  fill_file(gdal_files.file("trailer.dxf"), "");
  const WriteOptions options{.format = Format::dxf};
  CPLPushFinderLocation(gdal_files.file("").c_str());
  CHECK_THROWS_AS(write_drawing(made_drawing(), folder.file("map.dxf"), options), Error);
  CPLPopFinderLocation();
  CHECK(folder.names().empty());
  CHECK_NOTHROW(write_drawing(made_drawing(), folder.file("map.dxf"), options));
}

TEST_CASE("DXF has the nearest of its line weights") {
  Drawing drawing;
  drawing.layers.resize(3);
  for (std::size_t i = 0; i < 3; ++i) {
    drawing.layers[i].name = "pen " + std::to_string(i);
    drawing.layers[i].pen_width_mm = std::vector{0.1, 0.3, 3.0}[i];
    add_stroke(drawing.layers[i], {{10, 20}, {30, 40}});
    add_stroke(drawing.layers[i], {{10, 30}, {30, 50}});
    drawing.layers[i].strokes.back().width_mm = std::vector{0.44, 0.01, 0.46}[i];
  }
  const TemporaryFolder folder;
  write_drawing(drawing, folder.file("map.dxf"), {.format = Format::dxf});
  // A line with the group's code, and one with its value, from the entities on.
  std::istringstream lines(content_of(folder.file("map.dxf")));
  std::vector<int> weights;
  bool is_entity = false;
  for (std::string code, value; std::getline(lines, code) && std::getline(lines, value);) {
    is_entity = is_entity || value == "ENTITIES";
    if (is_entity && std::stoi(code) == 370) weights.push_back(std::stoi(value));
  }
  CHECK(weights == std::vector{9, 40, 30, 5, 211, 50});
}
