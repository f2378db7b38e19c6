// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace orograph {

enum class Orientation { as_given, by_picture, portrait, landscape };

/// The paper that a map goes on.
struct PageRequest {
  double width_mm = 210, height_mm = 297;
  Orientation orientation = Orientation::by_picture; ///< the one in which the picture is larger
  double margin_mm = 10;
};

} // namespace orograph
