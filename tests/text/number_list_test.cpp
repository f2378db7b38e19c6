// SPDX-License-Identifier: GPL-3.0-or-later
// Lists and ranges of numbers against counting in whole numbers.
#include "geometry/error.hpp"
#include "tests/catch.hpp"
#include "tests/support/random.hpp"
#include "text/number_list.hpp"

#include <fmt/format.h>

#include <cstdlib>

using namespace orograph;

namespace {

// A whole number of steps of 10^-decimals, written out digit by digit.
std::string decimal_text(long number, int decimals) {
  std::string digits = std::to_string(std::abs(number));
  const auto after = static_cast<std::size_t>(decimals);
  if (digits.size() <= after) digits.insert(0, after + 1 - digits.size(), '0');
  if (decimals > 0) digits.insert(digits.size() - after, ".");
  return (number < 0 ? "-" : "") + digits;
}

double decimal(long number, int decimals) {
  return std::strtod(decimal_text(number, decimals).c_str(), nullptr);
}

std::string fault_in(const std::string& text) {
  try {
    parse_number_list("--azimuth", text);
    return "";
  } catch (const UsageError& error) {
    return error.what();
  }
}

} // namespace

TEST_CASE("ranges hold what counting in whole numbers holds", "[slow]") {
  Random random(1);
  for (int i = 0; i < 4000; ++i) {
    const int decimals = random.whole(0, 4);
    const long from = random.whole(-5000, 5000), to = random.whole(-5000, 5000);
    long step = random.whole(1, random.pick({2, 10, 300, 20000}));
    if (to < from) step = -step;
    std::vector<double> expected;
    for (long at = from; step > 0 ? at <= to : at >= to; at += step)
      expected.push_back(decimal(at, decimals));
    const std::string text = fmt::format("{}:{}:{}", decimal_text(from, decimals),
                                         decimal_text(to, decimals), decimal_text(step, decimals));
    INFO(text);
    REQUIRE((parse_number_list("--azimuth", text) == expected));
    // The other way round it leads away, but where it has nowhere to go.
    const std::string wrong =
        fmt::format("{}:{}:{}", decimal_text(from, decimals), decimal_text(to, decimals),
                    decimal_text(-step, decimals));
    if (from == to)
      REQUIRE(parse_number_list("--azimuth", wrong) == expected);
    else
      REQUIRE(fault_in(wrong).find("lead away from") != std::string::npos);
  }
}

TEST_CASE("lists hold their parts, in their order") {
  Random random(2);
  for (int i = 0; i < 2000; ++i) {
    std::string text;
    std::vector<double> expected;
    for (int parts = random.whole(1, 6); parts > 0; --parts) {
      if (!text.empty()) text += ',';
      const int decimals = random.whole(0, 3);
      if (random.chance(0.5)) {
        const long number = random.whole(-99999, 99999);
        text += decimal_text(number, decimals);
        expected.push_back(decimal(number, decimals));
        continue;
      }
      const long from = random.whole(-99, 99), count = random.whole(1, 5),
                 step = random.pick({-7, -1, 1, 3});
      const long beyond = random.whole(0, std::abs(static_cast<int>(step)) - 1);
      const long to = from + (count - 1) * step + (step > 0 ? beyond : -beyond);
      text += decimal_text(from, decimals) + ":" + decimal_text(to, decimals) + ":" +
              decimal_text(step, decimals);
      for (long k = 0; k < count; ++k) expected.push_back(decimal(from + k * step, decimals));
    }
    INFO(text);
    REQUIRE(parse_number_list("--fov", text) == expected);
  }
}

TEST_CASE("ends of ranges, and large counts") {
  CHECK(parse_number_list("--fov", "0:1:0.1") ==
        std::vector<double>{0, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 1});
  CHECK(parse_number_list("--fov", "0:360:7").back() == 357);
  CHECK(parse_number_list("--fov", "5:5:1") == std::vector<double>{5});
  CHECK(parse_number_list("--fov", "5:6:1000") == std::vector<double>{5});
  CHECK(parse_number_list("--fov", "+5") == std::vector<double>{5});
  CHECK(parse_number_list("--fov", "1e2:3e2:1e2") == std::vector<double>{100, 200, 300});
  const auto many = parse_number_list("--fov", "0:99999.9:0.1");
  REQUIRE(many.size() == 1'000'000);
  CHECK(many[123456] == 12345.6);
  CHECK(many.back() == 99999.9);
}

TEST_CASE("what is no list of numbers is told in one line that names the option") {
  for (const auto& [text, words] : std::vector<std::pair<std::string, std::string>>{
           {"", "a value is empty"},
           {",", "a value is empty"},
           {"1,,2", "a value is empty"},
           {"1,2,", "a value is empty"},
           {"north", "'north' is no number"},
           {"1 2", "'1 2' is no number"},
           {"1,5", ""},
           {"nan", "is no number"},
           {"inf", "is no number"},
           {":", "a range is FROM:TO:STEP"},
           {"0:10", "a range is FROM:TO:STEP"},
           {"0:10:1:2", "a range is FROM:TO:STEP"},
           {"::", "'' is no number"},
           {"0:10:", "'' is no number"},
           {"0:inf:1", "'inf' is no number"},
           {"0:10:x", "'x' is no number"},
           {"0:10:0", "its step is zero"},
           {"0:10:-0.0", "its step is zero"},
           {"0:10:-1", "steps of -1 lead away from 10"},
           {"10:0:1", "steps of 1 lead away from 0"},
           {"0:1e300:1e-300", "values"},
           {"-1e308:1e308:1", "values"},
           {"0:10000000:1", "10000001 values"},
           {"0:99999:1,0:999999:1", "0:999999:1' can't be used: 1000000 values are too many"}}) {
    const std::string fault = fault_in(text);
    INFO(text << ": " << fault);
    if (words.empty()) {
      CHECK(fault.empty());
      continue;
    }
    CHECK(fault.find(words) != std::string::npos);
    CHECK(fault.find("--azimuth '") == 0);
    CHECK(fault.find('\n') == std::string::npos);
  }
}
