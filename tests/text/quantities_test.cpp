// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers and quantities as people write them.
#include "tests/catch.hpp"
#include "text/quantities.hpp"
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

TEST_CASE("a compass rose's names, in any letter case") {
  const std::vector<std::string> rose{"N", "NNE", "NE", "ENE", "E", "ESE", "SE", "SSE",
                                      "S", "SSW", "SW", "WSW", "W", "WNW", "NW", "NNW"};
  for (std::size_t i = 0; i < rose.size(); ++i) {
    const double deg = 22.5 * static_cast<double>(i);
    CHECK(parse_compass_deg(rose[i]) == deg);
    CHECK(parse_compass_deg(in_lower_case(rose[i])) == deg);
    CHECK(parse_azimuth_deg(rose[i]) == deg);
  }
  CHECK(parse_compass_deg("nNw") == 337.5);
  CHECK(parse_azimuth_deg("-12.5") == -12.5);
  for (const char* text : {"", "NN", "NWN", "north", "N ", "O", "12", "NS"})
    CHECK_FALSE(parse_compass_deg(text));
}

TEST_CASE("a scale") {
  CHECK(parse_scale("1:25000") == 25000);
  CHECK(parse_scale("25000") == 25000);
  CHECK(parse_scale("1:2.5e4") == 25000);
  for (const char* text :
       {"", "1:", "2:100", "1:0", "0", "-5", "1:-5", "1:nan", "1:2:3", "1/25000"})
    CHECK_FALSE(parse_scale(text));
}
