// SPDX-License-Identifier: GPL-3.0-or-later
// The options of lines on the ground, and of pens, plotters and sheets.
#include "tests/cli/given_options.hpp"

#include <vector>

namespace orograph::line_options_test {
namespace {

using namespace given_options;

} // namespace

TEST_CASE("options of pens, plotters and sheets") {
  CHECK(given({}).map.pen_order == PenOrder::sorted);
  CHECK(given({"--of", "eps"}).map.pen_order == PenOrder::sorted);
  CHECK(given({"--of", "pdf"}).map.pen_order == PenOrder::drawing);
  CHECK(given({"--of", "geojson"}).map.pen_order == PenOrder::drawing);
  CHECK(given({"--of", "geojson", "--pen-order", "drawing"}).map.pen_order == PenOrder::drawing);
  CHECK(given({"--pen-order", "drawing"}).map.pen_order == PenOrder::drawing);
  CHECK(given({"--of", "pdf", "--pen-order", "best"}).map.pen_order == PenOrder::best);
  CHECK(!given({}).pen_speeds.of({}));
  const auto speed = given({"--pen-speed", "40", "--pen-up-speed", "90", "--pen-lift-s", "0.4"});
  REQUIRE(speed.pen_speeds.of({}));
  CHECK(speed.pen_speeds.of({})->down_mm_s == 40);
  CHECK(speed.pen_speeds.of({})->up_mm_s == 90);
  CHECK(speed.pen_speeds.of({})->lift_s == 0.4);
  CHECK(given({"--pen-speed", "40"}).pen_speeds.of({})->up_mm_s == 40);
  check_refused({"--pen-speed", "0"}, "above 0");
  check_refused({"--pen-lift-s", "1"}, "--pen-speed");
  check_refused({"--of", "geojson", "--layers", "profiles,pen-up"}, "--of svg");
  check_refused({"--pen-order", "greedy"}, "drawing|sorted|best");
  check_refused({"--of", "gpkg", "--pen-order", "sorted"}, "--of svg");

  CHECK(given({"--of", "hpgl"}).map.pen_order == PenOrder::sorted);
  CHECK(given({"--of", "gcode"}).map.style.light->by_density);
  CHECK(given({"--of", "dxf"}).map.style.light->by_density);
  CHECK(!given({}).map.style.light->by_density);
  CHECK(given({"--of", "hpgl", "--device", "dxy"}).write.device->name == "Roland DXY");
  CHECK(given({"--clip-to", "100x80"}).clip_to_mm == Vec2{100, 80});
  CHECK(given({"--clip-to", "100x80"}).map.pen_order == PenOrder::drawing);
  CHECK(given({"--clip-to", "100x80"}).finishing_order == PenOrder::sorted);
  CHECK(!given({}).finishing_order);
  const auto sheets = given({"--sheets", "2x3", "--overlap", "8mm", "--landscape"});
  CHECK(sheets.sheet.width_mm == 297);
  CHECK(sheets.map.page.width_mm == 2 * 277 - 8 + 20);
  CHECK(sheets.map.page.height_mm == 3 * 190 - 2 * 8 + 20);
}

TEST_CASE("options of hidden lines") {
  const Style some = given({"--contours", "5m", "--hidden-layers", "contours,profiles"}).map.style;
  CHECK(some.asks_for("hidden-contours"));
  CHECK(some.asks_for("hidden-profiles"));
  CHECK_FALSE(some.asks_for("hidden"));
  const auto omitted = given({"--hidden", "omit"});
  CHECK(omitted.hidden_layers.empty());
  CHECK(
      given({"--hidden", "dash", "--hidden-layers", "border"}).map.style.asks_for("hidden-border"));
  // Layers that are drawn without being named have hidden lines as well.
  CHECK(given({"--flat", "waterlines", "--hidden-layers", "waterlines"})
            .map.style.asks_for("hidden-waterlines"));
  CHECK(given({"--void-edges", "--hidden-layers", "voids"}).map.style.asks_for("hidden-voids"));
  check_refused({"--hidden-layers", "mesh"}, "add mesh to --layers");
  check_refused({"--hidden-layers", "skyline"}, "each once of profiles");
  check_refused({"--hidden", "omit", "--hidden-layers", "border"}, "leave --hidden omit out");
  check_refused({"--hidden", "dash"}, "--hidden-layers for other lines");
}

TEST_CASE("options of lines on the ground") {
  CHECK_FALSE(given({}).map.style.asks_for("contours"));
  const Style every = given({"--contours", "200ft", "--contour-offset", "10"}).map.style;
  CHECK(every.asks_for("contours"));
  CHECK(every.draws_index_contours());
  CHECK(every.contours.interval == 200);
  CHECK(every.contours.unit_m == 0.3048);
  CHECK(every.contours.offset == 10);
  CHECK(every.contours.levels.empty());
  CHECK(given({"--contours", "100m"}).map.style.contours.unit_m == 1);
  CHECK_FALSE(given({"--contours", "100"}).map.style.contours.unit_m);
  const Style list = given({"--contours", "1500,500,-20m"}).map.style;
  CHECK(list.contours.levels == std::vector<double>{-20, 500, 1500});
  CHECK_FALSE(list.draws_index_contours());
  CHECK_FALSE(given({"--contours", "auto"}).map.style.contours.interval);
  CHECK(given({"--layers", "contours"}).map.style.draws_index_contours());
  CHECK_FALSE(given({"--contours", "5m", "--index-every", "0"}).map.style.draws_index_contours());
  CHECK_FALSE(given({"--contours", "5m"}).map.style.contours.ticks);
  CHECK(given({"--contours", "5m", "--contour-ticks"}).map.style.contours.ticks);
  for (const std::vector<std::string>& alone : {std::vector<std::string>{"--contour-ticks"},
                                                {"--contour-offset", "5"},
                                                {"--index-every", "4"}})
    check_refused(alone, "give --contours INTERVAL too");
  check_refused({"--contours", "0m"}, "an interval above 0");
  check_refused({"--contours", "inf"}, "an interval above 0");
  check_refused({"--contours", "5m,"}, "an interval above 0");
  check_refused({"--contours", "5km"}, "an interval above 0");

  CHECK(given({"--mesh", "12"}).map.style.mesh.count == 12);
  CHECK_FALSE(given({"--mesh", "12"}).map.style.mesh.spacing_m);
  CHECK(given({"--mesh", "12.5m"}).map.style.mesh.spacing_m == 12.5);
  CHECK(given({"--mesh", "9", "--mesh-along", "view"}).map.style.mesh.along_view);
  const MeshSpec lines = given({"--mesh", "auto", "--mesh-lines", "x"}).map.style.mesh;
  CHECK(lines.x);
  CHECK_FALSE(lines.y);
  check_refused({"--mesh-lines", "x"}, "give --mesh SPACING too");
  check_refused({"--mesh-along", "view"}, "give --mesh SPACING too");
  check_refused({"--mesh", "10001"}, "a whole number from 1 to 10000");
  check_refused({"--mesh", "-5m"}, "a length above 0");

  CHECK(given({"--graticule", "0.5"}).map.style.graticule_deg == 0.5);
  CHECK(given({"--graticule", "30'"}).map.style.graticule_deg == 0.5);
  CHECK(given({"--graticule", "1800''"}).map.style.graticule_deg == 0.5);
  CHECK(given({"--graticule", "auto"}).map.style.asks_for("graticule"));
  check_refused({"--graticule", "5'''"}, "degrees, minutes or seconds");
  check_refused({"--graticule", "0"}, "degrees, minutes or seconds");
  CHECK(given({"--grid", "1000m"}).map.style.grid_m == 1000);
  check_refused({"--grid", "1000"}, "a length above 0");

  const RenderSettings draped =
      given({"--drape", "a.gpkg", "--drape", "b.gpkg:roads", "--drape-where", "x > 1"});
  REQUIRE(draped.overlays.size() == 2);
  CHECK(draped.overlays[0].path == "a.gpkg");
  CHECK(draped.overlays[0].layer.empty());
  CHECK(draped.overlays[1].path == "b.gpkg");
  CHECK(draped.overlays[1].layer == "roads");
  CHECK(draped.overlays[1].where == "x > 1");
  CHECK(draped.map.style.asks_for("drape"));
  check_refused({"--drape", ""}, "a file that GDAL reads as vectors");
  check_refused({"--layers", "drape"}, "give --drape FILE");
  check_refused({"--drape-where", "x > 1"}, "give --drape FILE");
  check_refused({"--drape-offset", "2"}, "give --drape FILE");
  check_refused({"--drape-offset", "-1"}, "0 to 10000");
}

} // namespace orograph::line_options_test
