// SPDX-License-Identifier: GPL-3.0-or-later
// The description of a terrain.
#include "cli/info.hpp"
#include "tests/catch.hpp"
#include "tests/support/grid_of.hpp"

#include <limits>

using namespace orograph;

namespace {

TerrainData three_by_two() {
  TerrainData terrain;
  terrain.source = "a.tif";
  terrain.paths = {"a.tif"};
  grid_of(terrain) = {
      .columns = 3,
      .rows = 2,
      .lattice = PlaneLattice{{0, 0}, {30, 0}, {0, -20}},
      .heights_m = std::vector<float>{1, 2, 3, 4, 5, std::numeric_limits<float>::quiet_NaN()}};
  terrain.map.origin = {500000, 4000000};
  terrain.map.crs_name = "WGS 84 / UTM zone 17N";
  return terrain;
}

bool has_line(const std::string& text, const std::string& line) {
  return ("\n" + text).find("\n" + line + "\n") != std::string::npos;
}

} // namespace

TEST_CASE("a terrain's description") {
  TerrainData terrain = three_by_two();
  terrain.notes = {"the file has no height unit: metres are assumed"};
  const std::string text = describe(terrain);
  INFO(text);
  CHECK(has_line(text, "File       a.tif"));
  CHECK(has_line(text, "Size       3 x 2 vertices"));
  CHECK(has_line(text, "Cell       30 x 20 m"));
  CHECK(has_line(text, "CRS        WGS 84 / UTM zone 17N"));
  CHECK(has_line(text, "Units      metre, heights in metre"));
  CHECK(has_line(text, "Bounds     500000,3999980,500060,4000000 (xmin,ymin,xmax,ymax of the "
                       "vertices)"));
  CHECK(has_line(text, "Heights    1 to 5 m, mean 3 m"));
  CHECK(has_line(text, "No data    16.7 % (1 vertices)"));
  CHECK(has_line(text, "In memory  float32, 0.0 MB"));
  CHECK(has_line(text, "Note       the file has no height unit: metres are assumed"));
}

TEST_CASE("units other than metres, and turned rows, are told") {
  TerrainData terrain = three_by_two();
  terrain.map.unit_name = "US survey foot";
  terrain.map.unit_m = 1200.0 / 3937;
  terrain.map.height_unit_name = "foot";
  terrain.map.height_unit_m = 0.3048;
  grid_of(terrain).plane().column_step_m = {30, -30};
  grid_of(terrain).plane().row_step_m = {-20, -20};
  const std::string text = describe(terrain);
  INFO(text);
  CHECK(text.find("US survey foot (0.3048006096 m), heights in foot (0.3048 m)") !=
        std::string::npos);
  CHECK(text.find("42.4264 x 28.2843 m, rows run towards azimuth 135 degrees") !=
        std::string::npos);
  CHECK(text.find("(3.28084 to 16.4042 in the file's unit)") != std::string::npos);
  CHECK(text.find("Vertical") == std::string::npos);
  terrain.map.vertical_crs_name = "NAVD88 height (EPSG:5703)";
  CHECK(has_line(describe(terrain), "Vertical   NAVD88 height (EPSG:5703)"));
}
