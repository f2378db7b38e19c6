// SPDX-License-Identifier: GPL-3.0-or-later
// Names over made ground, for tests of what is printed of them.
#pragma once

#include "orograph.hpp"
#include "tests/support/random.hpp"

#include <string>
#include <vector>

namespace orograph {

/// Places and their names, as lines of a CSV file, read for a terrain.
struct NamedPoint {
  Vec2 map;
  std::string name;
};
Overlays names_of(const std::vector<NamedPoint>& points, const Terrain& terrain);

/// Somewhere on `borrowed(…, side)`, names of any length.
std::vector<NamedPoint> random_names(Random& random, int side, int count);

/// A map or a panorama of that ground that prints names; half of them furniture and labels too.
MapSpec random_named_spec(Random& random, int side);

} // namespace orograph
