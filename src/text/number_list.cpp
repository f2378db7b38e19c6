// SPDX-License-Identifier: GPL-3.0-or-later
#include "text/number_list.hpp"

#include "geometry/error.hpp"
#include "text/words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace orograph {
namespace {

constexpr double kMostValues = 1e6; // which take half a second

// The nearest number of so many decimals: what a sum of steps of 0.1 should be, also where it comes
// close to 0.
double with_decimals(double number, int decimals) {
  return std::strtod(fmt::format("{:.{}f}", number, decimals).c_str(), nullptr) + 0.0; // never -0
}

[[noreturn]] void refuse(const std::string& name, const std::string& text,
                         const std::string& what) {
  throw UsageError(fmt::format("{} '{}' can't be used: {}", name, text, what),
                   fmt::format("give numbers, ranges or both, as in {} 0:90:15,120", name));
}

void append_range(const std::string& name, const std::string& range, std::vector<double>& values) {
  const std::vector<std::string> parts = split(range, ':');
  if (parts.size() != 3) refuse(name, range, "a range is FROM:TO:STEP");
  std::vector<double> numbers;
  for (const std::string& part : parts) {
    const auto number = parse_number(part);
    if (!number) refuse(name, range, fmt::format("'{}' is no number", part));
    numbers.push_back(*number);
  }
  const double from = numbers[0], to = numbers[1], step = numbers[2];
  if (step == 0) refuse(name, range, "its step is zero");
  const double steps = (to - from) / step;
  if (steps < 0)
    refuse(name, range,
           fmt::format("steps of {} lead away from {}", number_text(step), number_text(to)));
  constexpr double kRounding = 1e-9; // of a step: 0:1:0.1 reaches 1
  const double count = std::floor(steps + kRounding) + 1;
  if (!(static_cast<double>(values.size()) + count <= kMostValues))
    refuse(name, range, fmt::format("{:.8g} values are too many", count));
  // Twelve digits of the largest.
  const double largest = std::max({std::abs(from), std::abs(to), std::abs(step)});
  const int decimals = std::max(11 - static_cast<int>(std::floor(std::log10(largest))), 0);
  for (double i = 0; i < count; ++i) values.push_back(with_decimals(from + i * step, decimals));
}

} // namespace

std::vector<double> parse_number_list(const std::string& name, const std::string& text,
                                      std::optional<double> (*parse)(std::string_view)) {
  std::vector<double> values;
  for (const std::string& part : split(text, ',')) {
    if (part.find(':') != std::string::npos) {
      append_range(name, part, values);
      continue;
    }
    const auto number = parse(part);
    if (!number)
      refuse(name, text,
             part.empty() ? "a value is empty" : fmt::format("'{}' is no number", part));
    values.push_back(*number);
  }
  return values;
}

std::string number_text(double number) {
  return fmt::format("{:.12g}", number);
}

} // namespace orograph
