// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/sweep/parameter.hpp"

#include "cli/options/option_values.hpp"
#include "geometry/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace orograph {
namespace {

constexpr double kMostValues = 1e7;

// The nearest number of so many decimals: what a sum of steps of 0.1 should be, also where it comes
// close to 0.
double with_decimals(double number, int decimals) {
  return std::strtod(fmt::format("{:.{}f}", number, decimals).c_str(), nullptr) + 0.0; // never -0
}

[[noreturn]] void refuse(const std::string& option, const std::string& text,
                         const std::string& what) {
  throw UsageError(fmt::format("{} '{}' can't be used: {}", option, text, what),
                   fmt::format("give numbers, ranges or both, as in {} 0:90:15,120", option));
}

void append_range(const std::string& option, const std::string& range,
                  std::vector<double>& values) {
  const std::vector<std::string> parts = split(range, ':');
  if (parts.size() != 3) refuse(option, range, "a range is FROM:TO:STEP");
  std::vector<double> numbers;
  for (const std::string& part : parts) {
    const auto number = parse_number(part);
    if (!number) refuse(option, range, fmt::format("'{}' is no number", part));
    numbers.push_back(*number);
  }
  const double from = numbers[0], to = numbers[1], step = numbers[2];
  if (step == 0) refuse(option, range, "its step is zero");
  const double steps = (to - from) / step;
  if (steps < 0)
    refuse(option, range,
           fmt::format("steps of {} lead away from {}", number_text(step), number_text(to)));
  constexpr double kRounding = 1e-9; // of a step: 0:1:0.1 reaches 1
  const double count = std::floor(steps + kRounding) + 1;
  if (!(static_cast<double>(values.size()) + count <= kMostValues))
    refuse(option, range, fmt::format("{:.8g} values are too many", count));
  // Twelve digits of the largest.
  const double largest = std::max({std::abs(from), std::abs(to), std::abs(step)});
  const int decimals = std::max(11 - static_cast<int>(std::floor(std::log10(largest))), 0);
  for (double i = 0; i < count; ++i) values.push_back(with_decimals(from + i * step, decimals));
}

} // namespace

const std::array<ParameterNames, 10>& all_parameters() {
  static constexpr std::array<ParameterNames, 10> names{{
      {Parameter::view, "--views", "view", "list_view", "", "view of the list, from 0"},
      {Parameter::eye, "--eye-path", "eye", "eye", "", "number of the eye along the path, from 0"},
      {Parameter::azimuth, "--azimuth", "azimuth", "azimuth_deg", "deg",
       "where the viewer stands, clockwise from the map's north"},
      {Parameter::elevation, "--elevation", "elevation", "elevation_deg", "deg",
       "of the viewer above the horizontal"},
      {Parameter::look_azimuth, "--look-azimuth", "look-azimuth", "look_azimuth_deg", "deg",
       "where the eye looks, clockwise from true north"},
      {Parameter::pitch, "--pitch", "pitch", "pitch_deg", "deg", "by which the eye looks up"},
      {Parameter::distance, "--distance", "distance", "distance_m", "m",
       "from the eye to the point looked at"},
      {Parameter::fov, "--fov", "fov", "fov_deg", "deg", "horizontal field of view"},
      {Parameter::exaggeration, "--exaggeration", "exaggeration", "exaggeration", "",
       "of all heights"},
      {Parameter::profiles, "--profiles", "profiles", "profiles", "",
       "planes that cut the terrain"},
  }};
  return names;
}

const ParameterNames& names_of(Parameter parameter) {
  return all_parameters()[static_cast<std::size_t>(parameter)];
}

void set_parameter(RenderSettings& settings, Parameter parameter, double value) {
  switch (parameter) {
  case Parameter::view:
  case Parameter::eye:
    return;
  case Parameter::azimuth:
    settings.map.view.from_azimuth = Angle::degrees(value);
    return;
  case Parameter::elevation:
    settings.map.view.from_elevation = Angle::degrees(value);
    return;
  case Parameter::look_azimuth:
    settings.map.view.look_azimuth = Angle::degrees(value);
    return;
  case Parameter::pitch:
    settings.map.view.pitch = Angle::degrees(value);
    return;
  case Parameter::distance:
    settings.map.view.distance_m = value;
    return;
  case Parameter::fov:
    settings.map.view.field_of_view = Angle::degrees(value);
    return;
  case Parameter::exaggeration:
    settings.map.view.exaggeration = value;
    return;
  case Parameter::profiles:
    settings.map.style.plan = ProfileCount{static_cast<int>(value)};
    return;
  }
}

std::vector<double> parse_number_list(const std::string& option, const std::string& text) {
  std::vector<double> values;
  for (const std::string& part : split(text, ',')) {
    if (part.find(':') != std::string::npos) {
      append_range(option, part, values);
      continue;
    }
    const bool by_name = option == names_of(Parameter::azimuth).option; // N, NNE, …
    const auto number = by_name ? parse_azimuth_deg(part) : parse_number(part);
    if (!number)
      refuse(option, text,
             part.empty() ? "a value is empty" : fmt::format("'{}' is no number", part));
    values.push_back(*number);
  }
  return values;
}

std::string number_text(double number) {
  return fmt::format("{:.12g}", number);
}

} // namespace orograph
