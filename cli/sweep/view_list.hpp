// SPDX-License-Identifier: GPL-3.0-or-later
// The views of a sweep: which there are, and what each is called.
#pragma once

#include "cli/sweep/parameter.hpp"
#include "cli/sweep/sweep.hpp"
#include "dem/terrain.hpp"
#include "placing/eye_path.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace orograph {

class ViewList {
public:
  /// Reads the eye path, if there is one. Throws Error as `read_eye_path` does, where axes that go
  /// together differ in length (a single value goes with all), where a name's template can't serve,
  /// and where two views would have the same name.
  ViewList(const SweepSettings& settings, const MapFrame& map);

  std::size_t size() const { return size_; }
  const std::vector<Axis>& axes() const { return axes_; }
  /// By axis, of view `number`.
  std::vector<double> values(std::size_t number) const;
  /// Of its drawing, without an extension.
  const std::string& name(std::size_t number) const { return names_[number]; }
  /// What `orograph render` would be told.
  RenderSettings settings(std::size_t number) const;
  const std::vector<PathEye>& eyes() const { return eyes_; }

private:
  std::size_t index_on(std::size_t axis, std::size_t number) const;
  std::string name_of_view(std::size_t number, const std::string& name_template) const;

  const SweepSettings& sweep_;
  std::vector<Axis> axes_;
  std::vector<PathEye> eyes_;
  std::size_t size_ = 1;
  std::vector<std::string> names_;
};

/// How many views the axes make, without making them; axes that aren't given count one.
double view_count(const std::vector<Axis>& axes, bool zipped);

} // namespace orograph
