// SPDX-License-Identifier: GPL-3.0-or-later
// The values of options, from text.
#include "cli/options/option_values.hpp"
#include "tests/catch.hpp"
#include "text/words.hpp"

#include <clocale>

using namespace orograph;

TEST_CASE("a number is the whole text, finite, with a point") {
  CHECK(parse_number("30") == 30.0);
  CHECK(parse_number("-1.5e3") == -1500.0);
  CHECK(parse_number("+.5") == 0.5);
  for (const char* text : {"", " 30", "30 ", "30deg", "3,5", "nan", "NaN", "-nan", "inf", "-inf",
                           "infinity", "1e999", "0x10", "+-3", "++3", "-", "."})
    CHECK_FALSE(parse_number(text));
}

TEST_CASE("numbers read alike under a locale with decimal commas") {
  // Nothing to set where no such locale is installed; the reading must not change in any.
  std::setlocale(LC_ALL, "de_DE.UTF-8");
  CHECK(parse_number("2.5") == 2.5);
  CHECK_FALSE(parse_number("2,5"));
  std::setlocale(LC_ALL, "C");
}

TEST_CASE("a whole number has no point and no overflow") {
  CHECK(parse_integer("100000") == 100000);
  CHECK(parse_integer("-3") == -3);
  for (const char* text : {"", "1.0", "1e3", "99999999999", "3 "}) CHECK_FALSE(parse_integer(text));
}

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

TEST_CASE("a compass rose's names, in any letter case") {
  const std::vector<std::string> rose{"N", "NNE", "NE", "ENE", "E", "ESE", "SE", "SSE",
                                      "S", "SSW", "SW", "WSW", "W", "WNW", "NW", "NNW"};
  for (std::size_t i = 0; i < rose.size(); ++i) {
    const double deg = 22.5 * static_cast<double>(i);
    CHECK(parse_compass_deg(rose[i]) == deg);
    CHECK(parse_compass_deg(in_lower_case(rose[i])) == deg);
    CHECK(parse_azimuth_deg(rose[i]) == deg);
    const auto from = parse_view_from(rose[i] + "/12.5");
    REQUIRE(from);
    CHECK(from->azimuth == Angle::degrees(deg));
    CHECK(from->elevation == Angle::degrees(12.5));
  }
  CHECK(parse_compass_deg("nNw") == 337.5);
  CHECK(parse_azimuth_deg("-12.5") == -12.5);
  for (const char* text : {"", "NN", "NWN", "north", "N ", "O", "12", "NS"})
    CHECK_FALSE(parse_compass_deg(text));
  for (const char* text : {"NW/", "/NW", "NW/91", "NW/N", "NWN/10", "NW/10/3", "NW"})
    CHECK_FALSE(parse_view_from(text));
}

TEST_CASE("a scale") {
  CHECK(parse_scale("1:25000") == 25000);
  CHECK(parse_scale("25000") == 25000);
  CHECK(parse_scale("1:2.5e4") == 25000);
  for (const char* text :
       {"", "1:", "2:100", "1:0", "0", "-5", "1:-5", "1:nan", "1:2:3", "1/25000"})
    CHECK_FALSE(parse_scale(text));
}
