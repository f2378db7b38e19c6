// SPDX-License-Identifier: GPL-3.0-or-later
// Windows by longitude and latitude, against points all over them.
#include "dem/read/lonlat.hpp"
#include "tests/catch.hpp"
#include "tests/dem/read/cut_raster.hpp"
#include "tests/dem/read/read_back.hpp"
#include "tests/dem/read/refused.hpp"
#include "tests/support/grid_of.hpp"
#include "tests/support/random.hpp"

#include <ogr_spatialref.h>

#include <cmath>
#include <memory>

namespace orograph::lonlat_window_test {
namespace {

class ToMap {
public:
  explicit ToMap(const std::string& crs) {
    OGRSpatialReference earth, map;
    REQUIRE(earth.SetFromUserInput("EPSG:4326") == OGRERR_NONE);
    REQUIRE(map.SetFromUserInput(crs.c_str()) == OGRERR_NONE);
    earth.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
    map.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
    transform_.reset(OGRCreateCoordinateTransformation(&earth, &map));
  }
  Vec2 operator()(Vec2 p) const {
    REQUIRE(transform_->Transform(1, &p.x, &p.y));
    return p;
  }

private:
  std::unique_ptr<OGRCoordinateTransformation> transform_;
};

} // namespace

TEST_CASE("the box on the map holds a window's places and no more") {
  Random random(5);
  for (const char* crs : {"EPSG:32632", "EPSG:3035", "EPSG:32661", "EPSG:2056", "EPSG:32701"})
    for (int run = 0; run < 6; ++run) {
      const ToMap to_map(crs);
      const bool north = crs == std::string("EPSG:32661");
      const bool across = crs == std::string("EPSG:32701"); // UTM zone 1, at 180 degrees west
      Box2 window;
      window.low = {random.between(6, 9), random.between(46, 46.5)};
      if (north) window.low = {random.between(-180, 180), random.between(65, 75)};
      if (across) window.low = {random.between(177, 179.5), random.between(-40, -10)};
      window.high = window.low + Vec2{random.between(0.6, 3), random.between(0.1, 1)};
      if (north) window.high.x = window.low.x + random.between(10, 350);
      const auto box = map_bounds_of_lonlat(crs, window, std::nullopt);
      REQUIRE(box);
      INFO(crs << " " << window.low.x << " " << window.low.y);
      const double slack_m = north ? 30 : 0.01; // parallels bend more the wider the window
      Box2 found;
      for (int i = 0; i < 4000; ++i) {
        Vec2 p{random.between(window.low.x, window.high.x),
               random.between(window.low.y, window.high.y)};
        if (i % 2 == 0) { // on a side or a corner
          if (random.chance(0.5)) p.x = random.pick({window.low.x, window.high.x});
          if (random.chance(0.5)) p.y = random.pick({window.low.y, window.high.y});
        }
        found.include(to_map(p));
      }
      CHECK(found.low.x >= box->low.x - slack_m);
      CHECK(found.low.y >= box->low.y - slack_m);
      CHECK(found.high.x <= box->high.x + slack_m);
      CHECK(found.high.y <= box->high.y + slack_m);
      const double tight_m = 0.005 * box->width();
      CHECK(found.low.x <= box->low.x + tight_m);
      CHECK(found.low.y <= box->low.y + tight_m);
      CHECK(found.high.x >= box->high.x - tight_m);
      CHECK(found.high.y >= box->high.y - tight_m);
    }
}

TEST_CASE("in degrees the box is the window, in the map's own counting") {
  const Box2 window{{170, -20}, {190, -10}};
  const auto box = map_bounds_of_lonlat("EPSG:4326", window, 360.);
  REQUIRE(box);
  CHECK(std::remainder(box->low.x - 170, 360) == 0);
  CHECK(box->width() == 20);
  CHECK(box->low.y == -20);
  CHECK(box->high.y == -10);
  CHECK(map_bounds_of_lonlat("EPSG:4326", {{-180, -90}, {180, 90}}, 360.)->width() == 360);
  // Paris' meridian and its grads.
  const auto grads = map_bounds_of_lonlat("EPSG:4807", {{2, 45}, {2.9, 45.9}}, 400.);
  REQUIRE(grads);
  CHECK(grads->width() == Approx(1).epsilon(1e-4));
  CHECK(grads->height() == Approx(1).epsilon(1e-4));
  CHECK(grads->low.y == Approx(50).epsilon(1e-4));
  CHECK_FALSE(map_bounds_of_lonlat("", window, std::nullopt));
  CHECK_FALSE(map_bounds_of_lonlat("EPSG:32632", {{99, 0}, {100, 1}}, std::nullopt));
}

TEST_CASE("a raster's window by longitude and latitude, over the seam of two files") {
  const TempFolder folder;
  const RasterFile whole = counting_raster(40, 20);
  write_raster(cut_from(whole, 0, 0, 17, 20), folder.file("west.tif"));
  write_raster(cut_from(whole, 17, 0, 23, 20), folder.file("east.tif"));
  const std::vector<std::string> paths{folder.file("east.tif"), folder.file("west.tif")};
  ReadOptions options;
  options.bbox_lonlat = Box2{{9.0012, 45.1525}, {9.0033, 45.1531}}; // upper left is 9, 45.1535
  const ToMap to_map("EPSG:32632");
  const TerrainData window = read_terrain(paths, options);
  const Grid& grid = grid_of(window);
  const TerrainData all = read_terrain(paths);
  int low_column = 99, high_column = -1, low_row = 99, high_row = -1;
  Box2 box;
  for (int i = 0; i <= 1000; ++i)
    for (int k = 0; k <= 1; ++k) {
      const Box2& b = *options.bbox_lonlat;
      box.include(to_map({b.low.x + i * b.width() / 1000, k ? b.low.y : b.high.y}));
      box.include(to_map({k ? b.low.x : b.high.x, b.low.y + i * b.height() / 1000}));
    }
  for (int column = 0; column < 40; ++column)
    for (int row = 0; row < 20; ++row) {
      const Vec2 ground = grid_of(all).plane().position_m(column, row);
      const Vec3 at = all.map.to_map({ground.x, ground.y, 0});
      if (at.x < box.low.x || at.x > box.high.x || at.y < box.low.y || at.y > box.high.y) continue;
      low_column = std::min(low_column, column);
      high_column = std::max(high_column, column);
      low_row = std::min(low_row, row);
      high_row = std::max(high_row, row);
    }
  REQUIRE(grid.columns == high_column - low_column + 1);
  REQUIRE(grid.rows == high_row - low_row + 1);
  CHECK(grid.columns > 10);
  CHECK(low_column < 17);
  CHECK(high_column > 17);
  for (int column = 0; column < grid.columns; ++column)
    for (int row = 0; row < grid.rows; ++row)
      CHECK(grid.height_m(column, row) == 40 * (row + low_row) + column + low_column);

  options.bbox_lonlat = Box2{{12, 45}, {13, 46}};
  check_message(message_of_all(paths, options),
                {"12,45 to 13,46 holds nothing", "east.tif and 1 more", "9.0"});
  options.bbox_lonlat = Box2{{9.0012, 45.1525}, {9.0033, 45.1531}};
  RasterFile lost = whole;
  lost.crs.clear();
  write_raster(lost, folder.file("lost.tif"));
  check_message(message_of(folder.file("lost.tif"), options),
                {"`bbox_lonlat`", "lost.tif has no CRS", "give `bbox`"});
  options.bbox_lonlat = Box2{{99, 0}, {100, 1}}; // a quarter of the earth away
  check_message(message_of(paths[0], options), {"places that aren't in the CRS", "smaller window"});
}

TEST_CASE("points by longitude and latitude") {
  const TempFolder folder;
  write_text(folder.file("p.geojson"),
             R"({"type":"FeatureCollection","crs":{"type":"name","properties":{"name":)"
             R"("urn:ogc:def:crs:EPSG::32632"}},"features":[{"type":"Feature","properties":{},)"
             R"("geometry":{"type":"MultiPoint","coordinates":[[500000,5000000,1],)"
             R"([500100,5000000,2],[500000,5000100,3],[500100,5000100,4],[600000,5000000,9]]}}]})");
  ReadOptions options;
  CHECK(std::get<Tin>(read_terrain(folder.file("p.geojson")).surface).vertices_m.size() == 5);
  options.bbox_lonlat = Box2{{8.9, 45}, {9.1, 46}};
  CHECK(std::get<Tin>(read_terrain(folder.file("p.geojson"), options).surface).vertices_m.size() ==
        4);
}

} // namespace orograph::lonlat_window_test
