// SPDX-License-Identifier: GPL-3.0-or-later
#include "map/pen_work.hpp"

#include <cstddef>

namespace orograph {

std::optional<PenSpeed> PenSpeeds::of(const std::optional<Pen>& pen) const {
  const std::optional<double> own_mm_s = pen && pen->speed_mm_s ? pen->speed_mm_s : down_mm_s;
  if (!own_mm_s) return std::nullopt;
  return PenSpeed{*own_mm_s, up_mm_s.value_or(down_mm_s.value_or(*own_mm_s)), lift_s.value_or(0)};
}

std::vector<std::optional<double>> minutes_by_layer(const Drawing& drawing,
                                                    const PenSpeeds& speeds) {
  const std::vector<PenTravel> travel = pen_travels(drawing).by_layer;
  std::vector<std::optional<double>> minutes;
  for (std::size_t i = 0; i < drawing.layers.size(); ++i) {
    const auto speed = speeds.of(drawing.layers[i].pen);
    minutes.push_back(speed ? std::optional(pen_minutes(travel[i], *speed)) : std::nullopt);
    if (drawing.layers[i].is_pen_way) minutes.back() = 0;
  }
  return minutes;
}

std::optional<double> sum_of(const std::vector<std::optional<double>>& minutes) {
  if (minutes.empty()) return std::nullopt;
  double sum = 0;
  for (const std::optional<double>& one : minutes) {
    if (!one) return std::nullopt;
    sum += *one;
  }
  return sum;
}

PenTravel PenWork::travel() const {
  PenTravel sum;
  for (const LayerFacts& layer : layers) {
    sum.down_mm += layer.ink_mm;
    sum.up_mm += layer.pen_up_mm;
    sum.lifts += layer.pen_lifts;
  }
  return sum;
}

PenWork pen_work(std::span<const Drawing> pages, const PenSpeeds& speeds) {
  PenWork work;
  for (const Drawing& page : pages) {
    const std::vector<PenTravel> travel = pen_travels(page).by_layer;
    const std::vector<std::optional<double>> minutes = minutes_by_layer(page, speeds);
    work.layers.resize(travel.size());
    work.minutes.resize(travel.size(), 0.0);
    for (std::size_t i = 0; i < travel.size(); ++i) {
      const Layer& layer = page.layers[i];
      LayerFacts& sum = work.layers[i];
      sum.name = layer.name;
      sum.strokes += layer.strokes.size();
      sum.ink_mm += travel[i].down_mm;
      sum.pen_up_mm += travel[i].up_mm;
      sum.pen_lifts += travel[i].lifts;
      if (work.minutes[i] && minutes[i])
        *work.minutes[i] += *minutes[i];
      else
        work.minutes[i].reset();
      if (layer.is_pen_way) continue;
      work.strokes += layer.strokes.size();
      work.points += layer.page_mm.size();
    }
  }
  return work;
}

} // namespace orograph
