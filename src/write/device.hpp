// SPDX-License-Identifier: GPL-3.0-or-later
// Plotters and machines that hold a pen, as data: what they speak, where they reach.
#pragma once

#include "geometry/api.hpp"
#include "geometry/box.hpp"
#include "geometry/vec.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace orograph {

/// Paper as it lies in a device.
struct DevicePaper {
  std::string name;
  Vec2 size_mm;   ///< along the device's x and y
  Vec2 origin_mm; ///< of its 0, 0 from the paper's corner of least x and y
  Box2 window;    ///< that the pen reaches, in the device's units
  std::string choose;
  std::optional<Vec2> park; ///< where the pen goes in the end, in the device's units
};

/// Words of HPGL and lines of G-code may hold {x}, {y}, {feed}, {height}, {pen} and {name}, as far
/// as the place where they stand knows them.
struct Device {
  enum class Language { hpgl, gcode };

  Language language = Language::hpgl;
  std::string name;
  double unit_mm = 0.025; ///< of its coordinates
  int decimals = 0;       ///< of its coordinates
  bool y_up = true;
  std::optional<int> pens;         ///< that it changes itself; none: a hand puts each in
  std::size_t longest = 250;       ///< instruction, or line, in bytes
  std::vector<DevicePaper> papers; ///< none: any page, whose corner of least x and y is at 0, 0
  std::optional<Box2> window;      ///< where there are no papers; none: the page

  std::vector<std::string> start, wait, end;

  // HPGL
  bool relative = true;              ///< draws by differences of coordinates
  std::optional<Vec2> speeds_cm_s{}; ///< the least and the greatest; none: pens keep its own

  // G-code
  double feed_mm_min = 3000; ///< with the pen down
  Vec2 heights{0, 100};      ///< of a pen at 0 and at 100 percent
  double height_percent = 0; ///< of a pen that says nothing
  std::string travel, draw;  ///< to a point, with the pen up or down
  std::vector<std::string> pen_up, pen_down;

  /// Of its coordinates, on paper.
  double step_mm() const;
};

/// A device of ours by name, or one of the user's by the name of a TOML file. Throws UsageError for
/// another name, and Error of one line that begins with the file's name, and line where there is
/// one, for a file that can't be read, isn't TOML, has other keys than those in docs/plotters.md or
/// values that make no device.
OROGRAPH_API Device read_device(const std::string& name_or_path);

/// Whether that is the name of a file.
OROGRAPH_API bool is_device_file(const std::string& name_or_path);

/// Of our own devices, in the order in which they are to be told.
OROGRAPH_API const std::vector<std::string>& device_names();

} // namespace orograph
