// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/render_settings.hpp"
#include "map/map_facts.hpp"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace orograph {

/// How many minutes each layer takes: by its pen's own speed, else by that of the settings; none
/// where neither is told. What shows a pen's way takes none of them.
std::vector<std::optional<double>> minutes_by_layer(const Drawing& drawing,
                                                    const RenderSettings& settings);

/// Of all layers; none where one isn't known, or there is none.
std::optional<double> sum_of(const std::vector<std::optional<double>>& minutes);

/// What pages take together that are drawn one after another.
struct PenWork {
  std::vector<LayerFacts> layers;
  std::vector<std::optional<double>> minutes; ///< of each layer
  std::uint64_t strokes = 0, points = 0;      ///< but those that show the pen's way

  PenTravel travel() const;
};

/// REQUIRES the same layers on all pages.
PenWork pen_work(std::span<const Drawing> pages, const RenderSettings& settings);

} // namespace orograph
