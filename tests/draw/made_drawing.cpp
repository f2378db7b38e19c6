// SPDX-License-Identifier: GPL-3.0-or-later
// Waves.
#include "tests/draw/made_drawing.hpp"

#include "draw/round_drawing.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <stdexcept>

namespace orograph {
namespace {

constexpr const char* kUtm32 = R"wkt(PROJCRS["WGS 84 / UTM zone 32N",
  BASEGEOGCRS["WGS 84",DATUM["World Geodetic System 1984",
    ELLIPSOID["WGS 84",6378137,298.257223563,LENGTHUNIT["metre",1]]],
    PRIMEM["Greenwich",0,ANGLEUNIT["degree",0.0174532925199433]],ID["EPSG",4326]],
  CONVERSION["UTM zone 32N",METHOD["Transverse Mercator",ID["EPSG",9807]],
    PARAMETER["Latitude of natural origin",0,ANGLEUNIT["degree",0.0174532925199433],ID["EPSG",8801]],
    PARAMETER["Longitude of natural origin",9,ANGLEUNIT["degree",0.0174532925199433],ID["EPSG",8802]],
    PARAMETER["Scale factor at natural origin",0.9996,SCALEUNIT["unity",1],ID["EPSG",8805]],
    PARAMETER["False easting",500000,LENGTHUNIT["metre",1],ID["EPSG",8806]],
    PARAMETER["False northing",0,LENGTHUNIT["metre",1],ID["EPSG",8807]]],
  CS[Cartesian,2],AXIS["(E)",east,ORDER[1],LENGTHUNIT["metre",1]],
  AXIS["(N)",north,ORDER[2],LENGTHUNIT["metre",1]],ID["EPSG",32632]])wkt";

Layer made_waves(const std::string& name, int strokes, int points_in_stroke, double shift_mm) {
  Layer layer;
  layer.name = name;
  for (int s = 0; s < strokes; ++s) {
    Stroke stroke{.first_point = static_cast<std::uint32_t>(layer.page_mm.size()),
                  .point_count = static_cast<std::uint32_t>(points_in_stroke),
                  .profile = s,
                  .depth_m = 100.0 / 3 * s};
    for (int i = 0; i < points_in_stroke; ++i) {
      const double across = static_cast<double>(i) / (points_in_stroke - 1);
      const double y = 20 + shift_mm + 250.0 * s / strokes + 3 * std::sin(9 * across + s);
      layer.page_mm.push_back({10 + 190 * across, y});
      layer.map.push_back({5e5 + 1e4 / 3 * across, 5.1e6 + 100.0 / 7 * s, 1000.0 / 3 - y});
    }
    layer.strokes.push_back(stroke);
  }
  round_to_page_step(layer);
  return layer;
}

} // namespace

TemporaryFolder::TemporaryFolder() {
  std::string name = (std::filesystem::temp_directory_path() / "orograph-test-XXXXXX").string();
  if (::mkdtemp(name.data()) == nullptr) throw std::runtime_error("no temporary folder");
  path_ = name;
}

TemporaryFolder::~TemporaryFolder() {
  std::filesystem::remove_all(path_);
}

std::vector<std::string> TemporaryFolder::names() const {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(path_))
    names.push_back(entry.path().filename().string());
  std::ranges::sort(names);
  return names;
}

std::string content_of(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

void fill_file(const std::string& path, const std::string& content) {
  std::ofstream(path, std::ios::binary) << content;
}

Layer empty_layer(const std::string& name, double pen_width_mm, double grey) {
  Layer layer;
  layer.name = name;
  layer.pen_width_mm = pen_width_mm;
  layer.grey = grey;
  return layer;
}

void add_stroke(Layer& layer, std::initializer_list<Vec2> page_mm, int profile) {
  layer.strokes.push_back({.first_point = static_cast<std::uint32_t>(layer.page_mm.size()),
                           .point_count = static_cast<std::uint32_t>(page_mm.size()),
                           .profile = profile});
  layer.page_mm.insert(layer.page_mm.end(), page_mm);
}

Drawing made_drawing(int strokes, int points_in_stroke) {
  Drawing drawing;
  drawing.title = "A map";
  drawing.description = "Two layers of waves";
  drawing.crs_wkt = kUtm32;
  drawing.layers = {made_waves("border", strokes, points_in_stroke, 0),
                    made_waves("profiles", strokes, points_in_stroke, 2)};
  drawing.layers[0].grey = 0.6;
  for (Stroke& stroke : drawing.layers[0].strokes)
    stroke = {.first_point = stroke.first_point, .point_count = stroke.point_count};
  return drawing;
}

} // namespace orograph
