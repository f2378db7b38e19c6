// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

namespace orograph {

enum class Orientation { as_given, by_picture, portrait, landscape };

/// Paper on the sides of something.
struct Sides {
  double left = 0, top = 0, right = 0, bottom = 0;
};

/// The paper that a map goes on.
struct PageRequest {
  double width_mm = 210;
  std::optional<double> height_mm = 297; ///< none: as high as the picture and its margins
  Orientation orientation = Orientation::by_picture; ///< the one in which the picture is larger
  double margin_mm = 10;
  bool crop = false; ///< the paper ends where the picture and its margins do
  /// Of a parallel view: 25000 for 1:25000, metres in the picture plane for millimetres on the
  /// page. None: the picture is as large as fits.
  std::optional<double> scale = std::nullopt;

  int strips = 1; ///< of a panorama: it is cut into so many, one beneath the other

  Sides room_mm = {};       ///< inside of the margins, that the picture leaves to what is around it
  Sides strip_room_mm = {}; ///< of a panorama: the same around each strip

  bool ends_with_picture() const { return crop || !height_mm; }
};

} // namespace orograph
