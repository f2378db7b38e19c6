// SPDX-License-Identifier: GPL-3.0-or-later
#include "map/stroke_darkness.hpp"

#include "geometry/on_all_cores.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>
#include <vector>

namespace orograph {
namespace {

// What is known of a profile in one sector.
struct Place {
  const Sector* sector;
  const PlannedProfile* planned;
  Homography to_plane;

  float darkness_at(Vec2 page_mm, const std::optional<Panorama>& panorama) const {
    const PageColumns& columns = sector->columns;
    const double x =
        panorama ? std::tan((page_mm.x - panorama->page.ahead_mm.x) / panorama->page.radius_mm -
                            sector->azimuth)
                 : to_plane.at({page_mm.x, page_mm.y, 1}).x;
    const double column = columns.column_of(x, planned->depth_m);
    if (!(column >= 0 && column < static_cast<double>(columns.count)))
      return std::numeric_limits<float>::quiet_NaN();
    return planned->darkness[static_cast<std::size_t>(column)];
  }
};

// The mean over a stroke's length of the columns that its segments' middles lie in; NaN where no
// ground is known. `places`: of its profile, left to right.
float mean_darkness(std::span<const Vec2> points, std::span<const Place> places,
                    const std::optional<Panorama>& panorama) {
  double sum = 0, length_mm = 0;
  for (std::size_t i = 1; i < points.size(); ++i) {
    const double mm = plain_length(points[i] - points[i - 1]);
    const auto steps = static_cast<std::size_t>(std::ceil(mm / places.front().sector->columns.mm));
    for (std::size_t k = 0; k < steps; ++k) {
      const double share = (static_cast<double>(k) + 0.5) / static_cast<double>(steps);
      const Vec2 p = points[i - 1] + share * (points[i] - points[i - 1]);
      const auto place = std::ranges::find_if(
          places, [&](const Place& at) { return !panorama || p.x <= at.sector->frame_mm->high.x; });
      if (place == places.end() || place->planned->darkness.empty()) continue;
      const float darkness = place->darkness_at(p, panorama);
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
  std::vector<std::vector<Place>> places(placed.depths_m.size()); // by a profile's number
  for (const Sector& sector : placed.sectors) {
    const Homography to_plane = inverse(sector.to_page);
    for (const PlannedProfile& planned : sector.profiles)
      places[static_cast<std::size_t>(planned.number)].push_back({&sector, &planned, to_plane});
  }
  for (std::size_t i = 0; i < profiles.strokes.size(); ++i) {
    throw_if_stopped(i);
    Stroke& stroke = profiles.strokes[i];
    const std::vector<Place>& of_profile = places[static_cast<std::size_t>(stroke.profile)];
    stroke.level = of_profile.front().planned->level;
    if (!of_profile.front().planned->darkness.empty())
      stroke.darkness = mean_darkness(profiles.points(stroke), of_profile, placed.panorama);
  }
}

} // namespace orograph
