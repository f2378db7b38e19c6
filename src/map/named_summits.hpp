// SPDX-License-Identifier: GPL-3.0-or-later
// The summits of places with names, as a view shows them.
#pragma once

#include "dem/terrain.hpp"
#include "map/name_facts.hpp"
#include "placing/map_spec.hpp"
#include "placing/placed_view.hpp"

#include <vector>

#include "naming/place_names.hpp"
#include "naming/rank_names.hpp"

namespace orograph {

/// A place's summit on the page.
struct SummitOnPage {
  NameFacts facts;   ///< hidden, or crowded out until it has its place
  Vec2 page_mm;      ///< of a panorama before it is cut into strips
  NameWeight weight; ///< of one that is seen; above 0
};

struct SummitsOnPage {
  std::vector<SummitOnPage>
      summits; ///< those that are seen, by rank; then hidden ones, the higher first
  std::size_t elsewhere = 0;
};

/// Places go to the highest vertex within two cells, or 150 m. Those beyond the range or the
/// picture are elsewhere. Throws Error where a terrain in degrees is cut by the view's planes.
SummitsOnPage named_summits(const TerrainData& terrain, const PlacedView& placed,
                            const MapSpec& spec, const std::vector<PlaceName>& places);

} // namespace orograph
