// SPDX-License-Identifier: GPL-3.0-or-later
// What a drawing is for the pens that draw it: ink, ways through the air, minutes.
#pragma once

#include "draw/drawing.hpp"
#include "map/map_facts.hpp"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace orograph {

/// Of pens that have no speed of their own.
struct PenSpeeds {
  std::optional<double> down_mm_s; ///< none: no minutes are known
  std::optional<double> up_mm_s;   ///< none: as fast as down
  std::optional<double> lift_s;    ///< none: no time

  /// Of a layer drawn by a pen, or by any; none without a speed.
  std::optional<PenSpeed> of(const std::optional<Pen>& pen) const;
};

/// How many minutes each layer takes: by its pen's own speed, else by these; none where neither is
/// told. What shows a pen's way takes none of them.
std::vector<std::optional<double>> minutes_by_layer(const Drawing& drawing,
                                                    const PenSpeeds& speeds);

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
PenWork pen_work(std::span<const Drawing> pages, const PenSpeeds& speeds);

} // namespace orograph
