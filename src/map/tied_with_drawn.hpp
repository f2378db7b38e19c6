// SPDX-License-Identifier: GPL-3.0-or-later
// Which of the places that are visible and not drawn have a line drawn there already: by the rule
// of ties (docs/how-it-works.md) it isn't drawn once more.
#pragma once

#include "geometry/vec.hpp"
#include "hidden_lines/instruments.hpp"

#include <cstdint>
#include <vector>

namespace orograph {

class TiedWithDrawn {
public:
  /// A place of the visibility plane, and the tolerance there, as a difference of Y.
  void add(Vec2 place, double within_y) { places_.push_back({place, within_y}); }
  /// Of the places added how many are within their tolerance of a drawn edge of the surface or of a
  /// block. Forgets them all. REQUIRES that they are of the sector seen. Cost: all that is visible
  /// for each.
  std::uint64_t count(const SeenLines& seen);

private:
  struct Place {
    Vec2 at;
    double within_y;
  };
  std::vector<Place> places_;
};

} // namespace orograph
