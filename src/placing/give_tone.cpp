// SPDX-License-Identifier: GPL-3.0-or-later
#include "placing/give_tone.hpp"

#include "view/sectors.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

#include "tone/tone.hpp"

namespace orograph {
namespace {

bool may_have_tone(const PlacedView& placed, const MapSpec& spec) {
  return spec.style.occluder == Occluder::surface && spec.style.asks_for("profiles") &&
         !placed.depths_m.empty();
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
                         const View& view, bool ground_points) {
  GroundLight out;
  out.towards = towards_light(light, view);
  out.least = widths.least_mm / spacing_mm;
  out.greatest = widths.greatest_mm / spacing_mm;
  out.contrast = light.contrast;
  out.smooth_mm = light.smooth_mm;
  out.shown_by = light.by_density ? LightShownBy::density
                 : ground_points  ? LightShownBy::nothing
                                  : LightShownBy::width;
  return out;
}

// What of u the page shows of a sector on any side of which rays are shown. The terrain's width, or
// what of its lowest ground is between the page's corners.
XRange u_range(const Sector& sector, const Box3& box) {
  constexpr double kNone = std::numeric_limits<double>::infinity();
  XRange ground{kNone, -kNone}, page{kNone, -kNone};
  const View& view = sector.view;
  const auto include = [](XRange& range, double u_m) {
    range.begin = std::min(range.begin, u_m);
    range.end = std::max(range.end, u_m);
  };
  for (const double x : {box.low.x, box.high.x})
    for (const double y : {box.low.y, box.high.y})
      include(ground, to_profile_frame(view, {x, y, box.low.z}).u);
  for (const Vec3& ray : corner_rays(view)) {
    if (!(ray.y < 0)) return ground; // it never comes down
    include(page, (view.eye_z_m - box.low.z * view.exaggeration) * ray.x / -ray.y);
  }
  const XRange both{std::max(ground.begin, page.begin), std::min(ground.end, page.end)};
  return both.begin < both.end ? both : ground;
}

void tone_sector(Sector& sector, const PlacedView& placed, const Surface& surface,
                 const ToneRequest& request) {
  const View& view = sector.view;
  const SurfaceCutter cutter(surface, view, placed.level.triangles, placed.for_cutters,
                             &placed.extent.box);
  const bool beside = shows_beside(view);
  const TonePage page{view, sector.to_page,
                      beside ? u_range(sector, placed.extent.box) : page_range(sector),
                      placed.frame_mm, beside};
  std::vector<double> depths_m;
  for (const PlannedProfile& planned : sector.profiles) depths_m.push_back(planned.depth_m);
  std::vector<TonedProfile> toned =
      toned_profiles(cutter, page, depths_m, std::max(sector.nearest_m, view.near_m), request);
  sector.profiles.clear();
  sector.columns = columns_of(page);
  for (TonedProfile& profile : toned) {
    PlannedProfile planned{profile.depth_m, 0};
    planned.level = profile.level;
    planned.darkness = std::move(profile.darkness);
    // Whole profiles need no runs for one pen.
    if (request.is_even || request.is_shown_by(LightShownBy::width))
      planned.runs = std::move(profile.runs);
    if (planned.runs && !request.is_shown_by(LightShownBy::width))
      for (ToneRun& run : *planned.runs) run.width_mm = 0;
    sector.profiles.push_back(std::move(planned));
  }
}

// Columns of a whole sector half a millimetre wide; of one that the page shows in part those that
// are on it. So they lie in the same directions wherever the page begins.
PageColumns columns_of(const Sector& sector, const Panorama& panorama) {
  constexpr double kColumn_mm = 0.5, kMost = 512;
  const double half = whole_sector_half_width(), width_mm = panorama.whole_sector_mm();
  const double whole = std::clamp(std::round(width_mm / kColumn_mm), 1.0, kMost);
  const double width = 2 * half / whole;
  const auto at = [&](double x) { return (x + half) / width; };
  constexpr double kRounding = 1e-6;
  const double first = std::max(0.0, std::floor(at(sector.view.window.low.x) + kRounding)),
               end = std::min(whole, std::ceil(at(sector.view.window.high.x) - kRounding));
  PageColumns columns;
  columns.begin = -half + first * width;
  columns.width = width;
  columns.count = static_cast<std::size_t>(end - first);
  columns.mm = width_mm / whole;
  const double forward = sector.azimuth;
  for (std::size_t i = 0; i < columns.count; ++i) {
    const double x = columns.middle(i), aside = std::atan(x);
    columns.fan.push_back({x, width, forward + aside, aside});
  }
  return columns;
}

// All of a panorama at once: lines go on from sector to sector, and so do their runs and widths.
void tone_panorama(PlacedView& placed, const Surface& surface, const ToneRequest& request) {
  std::vector<Sector>& sectors = placed.sectors;
  std::vector<std::unique_ptr<SurfaceCutter>> cutters;
  std::vector<SampledSector> sampled;
  PageColumns all;
  std::vector<std::size_t> firsts;
  for (const Sector& sector : sectors) {
    const PageColumns columns = columns_of(sector, *placed.panorama);
    cutters.push_back(std::make_unique<SurfaceCutter>(surface, sector.view, placed.level.triangles,
                                                      placed.for_cutters, &placed.extent.box));
    sampled.push_back({*cutters.back(), sector.view, sector.to_page, columns});
    firsts.push_back(all.fan.size());
    all.mm = columns.mm;
    all.fan.insert(all.fan.end(), columns.fan.begin(), columns.fan.end());
  }
  all.count = all.fan.size();
  const std::vector<SampledSector> own = sampled;
  const ProfileSampler sampler(std::move(sampled), placed.panorama->page);
  std::vector<TonedProfile> toned =
      toned_profiles(sampler, all, placed.view, placed.frame_mm, placed.depths_m,
                     std::max(placed.nearest_m, placed.view.near_m), request);
  placed.depths_m.clear();
  for (Sector& sector : sectors) sector.profiles.clear();
  for (TonedProfile& profile : toned) {
    const auto number = static_cast<std::int32_t>(placed.depths_m.size());
    placed.depths_m.push_back(profile.depth_m);
    for (std::size_t k = 0; k < sectors.size(); ++k) {
      PlannedProfile planned{profile.depth_m, number};
      planned.level = profile.level;
      const PageColumns& columns = own[k].columns;
      const auto first = static_cast<double>(firsts[k]), count = static_cast<double>(columns.count);
      if (!profile.darkness.empty()) {
        const auto begin = profile.darkness.begin() + static_cast<std::ptrdiff_t>(firsts[k]);
        planned.darkness.assign(begin, begin + static_cast<std::ptrdiff_t>(columns.count));
      }
      if (request.is_even || request.is_shown_by(LightShownBy::width)) {
        planned.runs.emplace();
        for (const ToneRun& run : profile.runs) {
          const double from = std::max(run.x_begin - first, 0.0),
                       to = std::min(run.x_end - first, count);
          if (!(from < to)) continue;
          // What goes on in the next sector goes on a column beyond this one's side.
          planned.runs->push_back({columns.begin + columns.width * (from > 0 ? from : -1),
                                   columns.begin + columns.width * (to < count ? to : count + 1),
                                   request.is_shown_by(LightShownBy::width) ? run.width_mm : 0});
        }
        if (request.is_even && planned.runs->empty() &&
            !(request.keeps_unseen && profile.level >= 0))
          continue;
      }
      if (profile.depth_m < sectors[k].farthest_m)
        sectors[k].profiles.push_back(std::move(planned));
    }
  }
  for (std::size_t k = 0; k < sectors.size(); ++k) sectors[k].columns = own[k].columns;
}

} // namespace

std::optional<LineShade> ridge_shade(const PlacedView& placed, const MapSpec& spec) {
  const Style& style = spec.style;
  if (!style.light || style.light->by_density || spec.ground_points) return std::nullopt;
  const Sector& sector = placed.sectors.front();
  const auto direction = [](Vec2 way, Vec2 otherwise) {
    const double size = plain_length(way);
    return size > 0 ? (1 / size) * way : otherwise;
  };
  LineShade shade;
  const Vec2 middle = placed.frame_mm.centre();
  const Vec3 ray = inverse(sector.to_page).of({middle.x, middle.y, 1}),
             step = sector.to_page.of({0, 1, 0}), image = sector.to_page.of(ray);
  // What a step of Y is on the page: the derivative of the image over its last coordinate.
  shade.up = direction({step.x - image.x / image.z * step.z, step.y - image.y / image.z * step.z},
                       {0, -1});
  if (ray.z < 0) shade.up = -1.0 * shade.up;
  const Vec3 light = towards_light(*style.light, placed.view);
  const double upwards =
      light.z * cos(sector.view.elevation) + light.y * sin(sector.view.elevation);
  const Vec2 right{-shade.up.y, shade.up.x};
  shade.towards_light = direction(light.x * right + upwards * shade.up, shade.up);
  shade.contrast = style.light->contrast;
  if (placed.panorama && !style.light->of_picture) {
    const PanoramaPage& page = placed.panorama->page;
    shade.standing = StandingLight{light, page.ahead_mm.x, page.radius_mm};
  }
  if (!shows_beside(placed.view)) { // else depth isn't how far something is
    shade.haze = style.haze_in(sector.view.is_perspective());
    shade.nearest_m = std::max(placed.nearest_m, sector.view.near_m);
    shade.farthest_m = placed.farthest_m;
  }
  return shade;
}

void give_tone(PlacedView& placed, const Surface& surface, const MapSpec& spec) {
  const Style& style = spec.style;
  const auto* spacing = std::get_if<PageSpacing>(&placed.plan);
  const bool is_even = spacing && style.spread == Spread::even;
  if (!may_have_tone(placed, spec) || !(is_even || style.light)) return;
  ToneRequest request;
  request.is_even = is_even;
  request.pen_width_mm = style.pen_width_mm;
  request.spacing_mm = spacing ? spacing->mm : kPenWidthsApart * style.pen_width_mm;
  const LineWidths widths =
      style.light_widths.value_or(LineWidths{0.5 * style.pen_width_mm, 2 * style.pen_width_mm});
  request.least_width_mm = widths.least_mm;
  request.greatest_width_mm = widths.greatest_mm;
  request.haze = shows_beside(placed.view) ? 0 : style.haze_in(placed.view.is_perspective());
  request.draws_level = style.flat == FlatGround::draw;
  request.both_sides = style.underside == Underside::draw && !placed.block_base_m;
  request.keeps_unseen = style.asks_for("hidden-profiles");
  if (placed.panorama) {
    if (style.light) {
      request.light =
          ground_light(*style.light, widths, request.spacing_mm, placed.view, spec.ground_points);
      request.light->stands = !style.light->of_picture;
    }
    tone_panorama(placed, surface, request);
    return;
  }
  std::vector<double> depths_m;
  // What is behind the eye has depths below 0, and comes first.
  for (std::size_t i = placed.sectors.size(); i-- > 0;) {
    Sector& sector = placed.sectors[i];
    if (style.light) {
      request.light =
          ground_light(*style.light, widths, request.spacing_mm, placed.view, spec.ground_points);
      Vec3& towards = request.light->towards; // of the view, from which the sector is turned
      if (sector.behind) towards = {-towards.x, -towards.y, towards.z};
    }
    tone_sector(sector, placed, surface, request);
    const std::size_t count = sector.profiles.size();
    for (std::size_t k = 0; k < count; ++k) {
      PlannedProfile& profile = sector.profiles[sector.behind ? count - 1 - k : k];
      profile.number = static_cast<std::int32_t>(depths_m.size());
      depths_m.push_back(sector.behind ? -profile.depth_m : profile.depth_m);
    }
  }
  placed.depths_m = std::move(depths_m);
}

} // namespace orograph
