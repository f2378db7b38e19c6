// SPDX-License-Identifier: GPL-3.0-or-later
#include "map/stroke_darkness.hpp"

#include "geometry/on_all_cores.hpp"

#include <cmath>
#include <cstddef>
#include <limits>
#include <span>
#include <vector>

namespace orograph {
namespace {

// The mean over a stroke's length of the columns that its segments' middles lie in; NaN where no
// ground is known.
float mean_darkness(std::span<const Vec2> points, const std::vector<float>& of_columns,
                    const PageColumns& columns, double depth_m, const Homography& to_plane) {
  double sum = 0, length_mm = 0;
  for (std::size_t i = 1; i < points.size(); ++i) {
    const double mm = plain_length(points[i] - points[i - 1]);
    const auto steps = static_cast<std::size_t>(std::ceil(mm / columns.mm));
    for (std::size_t k = 0; k < steps; ++k) {
      const double share = (static_cast<double>(k) + 0.5) / static_cast<double>(steps);
      const Vec2 p = points[i - 1] + share * (points[i] - points[i - 1]);
      const double column = columns.column_of(to_plane.at({p.x, p.y, 1}).x, depth_m);
      if (!(column >= 0 && column < static_cast<double>(columns.count))) continue;
      const float darkness = of_columns[static_cast<std::size_t>(column)];
      if (std::isnan(darkness)) continue;
      sum += static_cast<double>(darkness) * mm / static_cast<double>(steps);
      length_mm += mm / static_cast<double>(steps);
    }
  }
  return length_mm > 0 ? static_cast<float>(sum / length_mm)
                       : std::numeric_limits<float>::quiet_NaN();
}

} // namespace

void tell_darkness(Layer& profiles, const PlacedView& placed) {
  struct Place {
    const Sector* sector = nullptr;
    const PlannedProfile* planned = nullptr;
    Homography to_plane;
  };
  std::vector<Place> places(placed.depths_m.size()); // by a profile's number
  for (const Sector& sector : placed.sectors) {
    const Homography to_plane = inverse(sector.to_page);
    for (const PlannedProfile& planned : sector.profiles)
      places[static_cast<std::size_t>(planned.number)] = {&sector, &planned, to_plane};
  }
  for (std::size_t i = 0; i < profiles.strokes.size(); ++i) {
    throw_if_stopped(i);
    Stroke& stroke = profiles.strokes[i];
    const auto& [sector, planned, to_plane] = places[static_cast<std::size_t>(stroke.profile)];
    stroke.level = planned->level;
    if (!planned->darkness.empty())
      stroke.darkness = mean_darkness(profiles.points(stroke), planned->darkness, sector->columns,
                                      planned->depth_m, to_plane);
  }
}

} // namespace orograph
