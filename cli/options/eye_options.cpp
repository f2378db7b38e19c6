// SPDX-License-Identifier: GPL-3.0-or-later
// Where the eye is, and where it looks.
#include "cli/options/option_groups.hpp"
#include "cli/options/option_kinds.hpp"
#include "cli/options/option_values.hpp"
#include "geometry/error.hpp"

#include <fmt/format.h>

#include <cmath>
#include <utility>

namespace orograph {
namespace {

constexpr auto kGroup = "View";
constexpr auto kMapPlace = "coordinates of the terrain's CRS; Z, above the datum of the file's "
                           "heights in their unit, may be left out";
constexpr auto kLonLatPlace =
    "degrees on WGS 84, longitude first, LON from -180 to 360, LAT from -90 to 90; H, above the "
    "datum of the file's heights in their unit and not converted, may be left out";

Option with_lonlat(Option option, std::optional<GivenPlace>& into) {
  option.group = kGroup;
  option.value = "LON,LAT[,H]";
  option.allowed = kLonLatPlace;
  option.take = [name = option.name, &into](const std::string& text) {
    const auto place = parse_place(text);
    if (!place) return false;
    if (std::abs(place->y) > 90)
      throw UsageError(
          fmt::format("{} '{}' can't be used: {} is no latitude", name, text, place->y),
          std::abs(place->x) <= 90
              ? fmt::format("longitude comes first: {},{}", place->y, place->x)
              : std::string("latitudes are from -90 to 90, and longitude comes first"));
    if (place->x < -180 || place->x > 360) return false;
    into = place;
    return true;
  };
  return option;
}

} // namespace

void add_eye_options(std::vector<Option>& options, RenderSettings& s) {
  options.push_back({.group = kGroup,
                     .name = "--eye",
                     .value = "X,Y[,Z]",
                     .help = "Stand at this point, without Z on the ground there; perspective only",
                     .allowed = kMapPlace,
                     .take = stored(parse_place, s.map.view.eye_map)});
  options.push_back(
      with_lonlat({.name = "--eye-lonlat",
                   .help = "The same by longitude and latitude, without H on the ground there"},
                  s.map.view.eye_lonlat));
  options.push_back(
      with_number({.group = kGroup,
                   .name = "--eye-height",
                   .value = "M",
                   .help = "Of an eye without Z or H: how high above the ground it is",
                   .by_default = fmt::format("{}", kEyeHeight_m)},
                  {.unit = "metres", .low = 0, .low_excluded = true},
                  [&s](double m) { s.map.view.eye_height_m = m; }));
  options.push_back({.group = kGroup,
                     .name = "--look-at",
                     .value = "X,Y[,Z]",
                     .help = "Look at this point, without Z at the ground there",
                     .allowed = kMapPlace,
                     .by_default = "the terrain's centre",
                     .take = stored(parse_place, s.map.view.look_at_map)});
  options.push_back(
      with_lonlat({.name = "--look-at-lonlat",
                   .help = "The same by longitude and latitude, without H at the ground there"},
                  s.map.view.look_at_lonlat));
  options.push_back(with_number(
      {.group = kGroup,
       .name = "--look-azimuth",
       .value = "DEG",
       .help = "With an eye, look in this direction instead of at a point: clockwise "
               "from true north, as a compass rose has it, which differs from the "
               "map's by the convergence of meridians (from the map's own north where "
               "the terrain has no CRS, or a local one)"},
      {.unit = "degrees"}, [&s](double deg) { s.map.view.look_azimuth = Angle::degrees(deg); }));
  options.push_back(
      with_number({.group = kGroup,
                   .name = "--pitch",
                   .value = "DEG",
                   .help = "With --look-azimuth, look up by this, or down where it is "
                           "negative",
                   .by_default = "0"},
                  {.unit = "degrees", .low = -90, .high = 90},
                  [&s](double deg) { s.map.view.pitch = Angle::degrees(deg); }));
}

} // namespace orograph
