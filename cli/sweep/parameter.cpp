// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/sweep/parameter.hpp"

namespace orograph {

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

} // namespace orograph
