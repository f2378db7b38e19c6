// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/exponent.hpp"
#include "tests/catch.hpp"
#include "tests/support/random.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

using namespace orograph;

namespace {

// What is left of the logarithms beside the power law of this exponent that fits best.
double squares(const std::vector<SizeAndTime>& measured, double exponent) {
  double mean = 0, sum = 0;
  const auto rest = [&](const SizeAndTime& m) {
    return std::log(m.seconds) - exponent * std::log(m.cells);
  };
  for (const SizeAndTime& m : measured) mean += rest(m) / static_cast<double>(measured.size());
  for (const SizeAndTime& m : measured) sum += (rest(m) - mean) * (rest(m) - mean);
  return sum;
}

} // namespace

TEST_CASE("a power law has its own exponent", "[bench]") {
  for (const double exponent : {0.0, 0.5, 1.0, 1.05, 2.0}) {
    std::vector<SizeAndTime> measured;
    for (const double side : {500., 1000., 2000., 4000., 8000.})
      measured.push_back({side * side, 3e-9 * std::pow(side * side, exponent)});
    CHECK(growth_exponent(measured) == Approx(exponent).margin(1e-12));
  }
}

TEST_CASE("no other exponent leaves less of what was measured", "[bench]") {
  Random random(11);
  for (int scene = 0; scene < 200; ++scene) {
    std::vector<SizeAndTime> measured;
    for (int i = random.whole(2, 8); i > 0; --i)
      measured.push_back({std::exp(random.between(1, 20)), std::exp(random.between(-9, 3))});
    const double found = growth_exponent(measured);
    for (const double off : {-1.0, -1e-3, 1e-3, 1.0})
      CHECK(squares(measured, found) <= squares(measured, found + off));
  }
}

TEST_CASE("one size has no exponent", "[bench]") {
  CHECK(std::isnan(growth_exponent(std::vector<SizeAndTime>{})));
  CHECK(std::isnan(growth_exponent(std::vector<SizeAndTime>{{100, 1}})));
  CHECK(std::isnan(growth_exponent(std::vector<SizeAndTime>{{100, 1}, {100, 2}})));
}
