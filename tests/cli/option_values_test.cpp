// SPDX-License-Identifier: GPL-3.0-or-later
// The values of options, from text.
#include "cli/options/option_values.hpp"
#include "tests/catch.hpp"

using namespace orograph;

TEST_CASE("points, boxes and directions have their number of parts") {
  CHECK(parse_place("-120,5,3") == Vec3{-120, 5, 3});
  CHECK(parse_place("-120,5") == GivenPlace(-120, 5));
  CHECK_FALSE(parse_place("1,2") == Vec3{1, 2, 0});
  for (const char* text : {"1", "1,2,3,4", "1,2,", ",1,2", "1;2;3", "1, 2, 3", "1,nan,3", "nan,1"})
    CHECK_FALSE(parse_place(text));

  const auto box = parse_box("-1,-2,3,4");
  REQUIRE(box);
  CHECK(box->low == Vec2{-1, -2});
  CHECK(box->high == Vec2{3, 4});
  for (const char* text : {"3,-2,-1,4", "0,0,0,1", "0,1,1,0", "0,0,1", "0,0,1,inf"})
    CHECK_FALSE(parse_box(text));

  const auto lonlat = parse_lonlat_box("-1,-2,3,4");
  REQUIRE(lonlat);
  CHECK(lonlat->low == Vec2{-1, -2});
  CHECK(lonlat->high == Vec2{3, 4});
  CHECK(parse_lonlat_box("170,-2,-170,4")->high == Vec2{190, 4});
  CHECK(parse_lonlat_box("0,-90,360,90")->high == Vec2{360, 90});
  for (const char* text :
       {"3,4,3,5", "0,1,1,0", "0,0,1,91", "0,-91,1,0", "-180,0,200,1", "0,0,1", "361,0,362,1"})
    CHECK_FALSE(parse_lonlat_box(text));

  const auto from = parse_view_from("-225.5/15");
  REQUIRE(from);
  CHECK(from->azimuth == Angle::degrees(-225.5));
  CHECK(from->elevation == Angle::degrees(15));
  CHECK(parse_view_from("720/0"));
  CHECK(parse_view_from("0/90"));
  CHECK(parse_view_from("0/-90"));
  for (const char* text : {"180", "180/", "/25", "180/91", "180/-91", "180/25/3", "nan/3", "1/nan"})
    CHECK_FALSE(parse_view_from(text));
}

TEST_CASE("a spacing has a unit") {
  const auto on_page = parse_spacing("0.6mm"), on_ground = parse_spacing("100m");
  REQUIRE(on_page);
  REQUIRE(on_ground);
  CHECK(std::get<PageSpacing>(*on_page).mm == 0.6);
  CHECK(std::get<GroundSpacing>(*on_ground).m == 100);
  for (const char* text : {"0.6", "mm", "m", "0mm", "-1m", "1km", "1 mm", "nanm", "infmm"})
    CHECK_FALSE(parse_spacing(text));
}

TEST_CASE("a page of width x height, or as high as its picture") {
  const auto given = parse_page_size("400x250.5");
  REQUIRE(given);
  CHECK(given->width_mm == 400);
  CHECK(given->height_mm == 250.5);
  for (const char* text : {"400xauto", "4e2xAUTO"}) {
    const auto free = parse_page_size(text);
    REQUIRE(free);
    CHECK(free->width_mm == 400);
    CHECK_FALSE(free->height_mm);
  }
  for (const char* text :
       {"400", "400x", "x250", "0x100", "-1x100", "1e9x100", "400x250x3", "400X250", "nanx100",
        "autox400", "autoxauto", "xauto", "0xauto", "10001xauto", "400xautos", "auto"})
    CHECK_FALSE(parse_page_size(text));
}

TEST_CASE("where the viewer stands may be told by a compass rose's names") {
  for (const char* name : {"NW", "nw"}) {
    const auto from = parse_view_from(name + std::string("/12.5"));
    REQUIRE(from);
    CHECK(from->azimuth == Angle::degrees(315));
    CHECK(from->elevation == Angle::degrees(12.5));
  }
  for (const char* text : {"NW/", "/NW", "NW/91", "NW/N", "NWN/10", "NW/10/3", "NW"})
    CHECK_FALSE(parse_view_from(text));
}
