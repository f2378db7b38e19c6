// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/read/length_units.hpp"

#include "text/words.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>

namespace orograph {
namespace {

struct Spelled {
  LengthUnit unit;
  std::array<std::string_view, 8> spellings; ///< in lower case; empty behind the last
};

// Rasters' units of height, and the units of LandXML 1.2 and 2.0.
const std::array length_units{
    Spelled{{"metre", 1}, {"m", "metre", "metres", "meter", "meters"}},
    Spelled{{"kilometre", 1000}, {"km", "kilometre", "kilometer"}},
    Spelled{{"decimetre", 0.1}, {"dm", "decimetre", "decimeter"}},
    Spelled{{"centimetre", 0.01}, {"cm", "centimetre", "centimeter"}},
    Spelled{{"millimetre", 0.001}, {"mm", "millimetre", "millimeter"}},
    Spelled{{"foot", 0.3048}, {"ft", "foot", "feet", "international foot"}},
    Spelled{{"US survey foot", 1200. / 3937.},
            {"us-ft", "us_ft", "ftus", "foot_us", "us survey foot", "us survey feet", "survey foot",
             "ussurveyfoot"}},
    Spelled{{"inch", 0.0254}, {"inch"}},
    Spelled{{"mile", 1609.344}, {"mile", "miles"}},
};

} // namespace

std::optional<LengthUnit> length_unit(std::string_view written) {
  const std::string lower = in_lower_case(written);
  for (const auto& [unit, spellings] : length_units)
    for (const std::string_view spelling : spellings)
      if (!spelling.empty() && lower == spelling) return unit;
  return std::nullopt;
}

std::string unit_name(double unit_m) {
  for (const auto& [unit, spellings] : length_units)
    if (std::abs(unit_m - unit.metres) < 1e-9) return unit.name;
  return fmt::format("{} m", unit_m);
}

} // namespace orograph
