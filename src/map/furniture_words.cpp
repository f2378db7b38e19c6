// SPDX-License-Identifier: GPL-3.0-or-later
#include "map/furniture_words.hpp"

#include <fmt/format.h>

#include <cmath>
#include <optional>

namespace orograph {
namespace {

constexpr std::string_view kBetween = " · ";

double rounded_azimuth(double azimuth_deg) {
  const double deg = std::round(10 * azimuth_deg) / 10;
  return deg >= 360 ? deg - 360 : deg;
}

// An eye looks towards azimuths from true north, and what is framed is seen from one of the map's,
// as both are asked for.
std::string view_words(const PlacedView& placed, const ViewFacts& facts, const ViewSpec& asked) {
  const View& view = placed.view;
  const double look_deg = rounded_azimuth(
      asked.has_eye() && !std::isnan(facts.look_azimuth_true_deg) ? facts.look_azimuth_true_deg
                                                                  : facts.look_azimuth_deg);
  const double from_deg = rounded_azimuth(facts.view_from_azimuth_deg);
  const double high_deg = placed.chosen_view ? placed.chosen_view->elevation.in_degrees()
                          : asked.file || !view.is_perspective()
                              ? facts.elevation_deg
                              : asked.from_elevation.in_degrees();
  if (placed.panorama)
    return fmt::format("{} panorama of {:.6g}°",
                       placed.panorama->kind == PanoramaKind::cylindrical ? "Cylindrical"
                                                                          : "Equirectangular",
                       placed.panorama->width_deg);
  if (view.is_perspective() && !view.frames_terrain)
    return fmt::format("Looking towards azimuth {:.4g}°, {:.3g}° wide", look_deg,
                       facts.field_of_view_deg);
  if (view.projection == Projection::oblique)
    return fmt::format("Oblique view from azimuth {:.4g}°", from_deg);
  if (!view.is_perspective() && view.y_per_z == 0)
    return look_deg == 0 ? "Seen from straight above"
                         : fmt::format("Seen from straight above, azimuth {:.4g}° up", look_deg);
  return fmt::format("Seen from azimuth {:.4g}°, {:.3g}° high, {}", from_deg, high_deg,
                     view.is_perspective() ? "in perspective" : "orthographic");
}

std::string degrees_words(double deg, char positive, char negative) {
  return fmt::format("{:.5f}° {}", std::abs(deg), deg < 0 ? negative : positive);
}

} // namespace

std::string caption_words(const PlacedView& placed, const ViewFacts& facts, const ViewSpec& asked) {
  std::string words = view_words(placed, facts, asked);
  words += kBetween;
  words += placed.exaggeration == 1 ? "true heights"
                                    : fmt::format("heights {:.4g} times", placed.exaggeration);
  if (placed.view.is_perspective() && placed.curvature.applied) {
    words += kBetween;
    words +=
        placed.curvature.refraction != 0
            ? fmt::format("on the curved earth, refraction {:.3g}", placed.curvature.refraction)
            : "on the curved earth";
  }
  return words;
}

std::string viewpoint_words(const ViewFacts& facts, double height_unit_m) {
  std::string words = "Viewpoint ";
  if (facts.eye_lonlat)
    words += degrees_words(facts.eye_lonlat->y, 'N', 'S') + " " +
             degrees_words(facts.eye_lonlat->x, 'E', 'W');
  else
    words += fmt::format("{:.0f}, {:.0f}", facts.eye->x, facts.eye->y);
  words += kBetween;
  words += fmt::format("{:.0f} m", facts.eye->z * height_unit_m);
  if (std::isfinite(facts.eye_height_m))
    words += fmt::format(", {} m above the ground",
                         facts.eye_height_m < 10 ? fmt::format("{:.3g}", facts.eye_height_m)
                                                 : fmt::format("{:.0f}", facts.eye_height_m));
  return words;
}

std::string source_words(const FurnitureSpec& furniture) {
  std::string words = furniture.source;
  if (!words.empty() && !furniture.date.empty()) words += kBetween;
  return words + furniture.date;
}

} // namespace orograph
