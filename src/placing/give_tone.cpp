// SPDX-License-Identifier: GPL-3.0-or-later
#include "placing/give_tone.hpp"

#include "view/sectors.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "tone/tone.hpp"

namespace orograph {
namespace {

bool may_have_tone(const PlacedView& placed, const MapSpec& spec) {
  return placed.sectors.size() == 1 && !shows_beside(placed.view) &&
         spec.style.occluder == Occluder::surface && !spec.ground_points &&
         spec.style.asks_for("profiles") && !placed.depths_m.empty();
}

Vec3 towards_light(const LightSpec& light, const View& view) {
  const double level = cos(light.altitude);
  const double east = level * sin(light.azimuth), north = level * cos(light.azimuth);
  if (light.of_picture) return {east, north, sin(light.altitude)};
  return {dot(Vec2{east, north}, view.right), dot(Vec2{east, north}, view.forward),
          sin(light.altitude)};
}

// Level ground is as dark as ever, whatever the contrast.
GroundLight ground_light(const LightSpec& light, const LineWidths& widths, double spacing_mm,
                         const View& view) {
  GroundLight out;
  out.towards = towards_light(light, view);
  out.least = widths.least_mm / spacing_mm;
  out.greatest = widths.greatest_mm / spacing_mm;
  out.contrast = light.contrast;
  out.smooth_mm = light.smooth_mm;
  out.by_density = light.by_density;
  return out;
}

} // namespace

void give_tone(PlacedView& placed, const Surface& surface, const MapSpec& spec) {
  const Style& style = spec.style;
  const auto* spacing = std::get_if<PageSpacing>(&placed.plan);
  const bool is_even = spacing && style.spread == Spread::even;
  if (!may_have_tone(placed, spec) || !(is_even || style.light)) return;
  Sector& sector = placed.sectors.front();
  const View& view = sector.view;
  ToneRequest request;
  request.is_even = is_even;
  request.pen_width_mm = style.pen_width_mm;
  request.spacing_mm = spacing ? spacing->mm : kPenWidthsApart * style.pen_width_mm;
  const LineWidths widths =
      style.light_widths.value_or(LineWidths{0.5 * style.pen_width_mm, 2 * style.pen_width_mm});
  request.least_width_mm = widths.least_mm;
  request.greatest_width_mm = widths.greatest_mm;
  if (style.light) request.light = ground_light(*style.light, widths, request.spacing_mm, view);
  request.haze = style.haze_in(view.is_perspective());
  request.draws_level = style.flat == FlatGround::draw;
  const SurfaceCutter cutter(surface, view, placed.level.triangles, placed.border);
  const TonePage page{view, sector.to_page, page_range(sector), placed.frame_mm};
  std::vector<TonedProfile> toned = toned_profiles(
      cutter, page, placed.depths_m, std::max(sector.nearest_m, view.near_m), request);
  placed.depths_m.clear();
  sector.profiles.clear();
  for (TonedProfile& profile : toned) {
    sector.profiles.push_back({profile.depth_m, static_cast<std::int32_t>(placed.depths_m.size()),
                               std::move(profile.runs)});
    placed.depths_m.push_back(profile.depth_m);
  }
}

} // namespace orograph
