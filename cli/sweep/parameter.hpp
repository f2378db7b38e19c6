// SPDX-License-Identifier: GPL-3.0-or-later
// What a sweep can vary.
#pragma once

#include "cli/render_settings.hpp"

#include <array>
#include <vector>

namespace orograph {

/// In the order of a sweep's views: of those that are crossed, the last turns fastest.
enum class Parameter {
  view, ///< of a list in a file
  eye,  ///< along a path
  azimuth,
  elevation,
  look_azimuth,
  pitch,
  distance,
  fov,
  exaggeration,
  profiles
};

struct ParameterNames {
  Parameter parameter;
  const char* option; ///< "--look-azimuth"
  const char* label;  ///< in names of drawings: "look-azimuth"
  const char* column; ///< of the tables: "look_azimuth_deg"
  const char* unit;   ///< of its numbers; empty: none
  const char* about;  ///< a phrase
};
const std::array<ParameterNames, 10>& all_parameters();
const ParameterNames& names_of(Parameter parameter);

/// A parameter with the values that it takes; of a view or an eye its number, from 0.
struct Axis {
  Parameter parameter;
  std::vector<double> values;
};

/// Gives the parameter its value. REQUIRES neither `view` nor `eye`, which take more than a number.
void set_parameter(RenderSettings& settings, Parameter parameter, double value);

} // namespace orograph
