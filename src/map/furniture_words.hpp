// SPDX-License-Identifier: GPL-3.0-or-later
// What furniture says of a view.
#pragma once

#include "map/map_facts.hpp"
#include "placing/furniture_spec.hpp"
#include "placing/placed_view.hpp"

#include <string>

namespace orograph {

/// "Seen from azimuth 225°, 15° high, in perspective · heights 1.5 times · …".
std::string caption_words(const PlacedView& placed, const ViewFacts& facts, const ViewSpec& asked);

/// "Viewpoint 46.53672° N 7.96231° E · 3573 m, 2 m above the ground". REQUIRES an eye.
std::string viewpoint_words(const ViewFacts& facts, double height_unit_m);

/// Source and date, whichever there are.
std::string source_words(const FurnitureSpec& furniture);

} // namespace orograph
