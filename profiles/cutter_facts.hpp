// SPDX-License-Identifier: GPL-3.0-or-later
// What is found once for all cutters of a surface.
#pragma once

#include "dem/mesh/tin_index.hpp"
#include "profiles/border_places.hpp"
#include "profiles/tin_places.hpp"

#include <memory>

namespace orograph {

/// Of a surface's kind what its cutters ask for; a grid on a map plane needs nothing.
struct CutterFacts {
  std::shared_ptr<const BorderPlaces> of_earth_grid;
  std::shared_ptr<const TinPlaces> of_tin;
  /// Of a TIN, if parts of its profiles are to be cheap: that costs more than a few whole ones.
  std::shared_ptr<const TinIndex> tin_index;
  bool both_sides = false; ///< whether walls that are turned away from the eye are crossed
};

} // namespace orograph
