// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/tell_map.hpp"

#include "cli/finish_drawing.hpp"
#include "cli/say.hpp"
#include "dem/extent.hpp"
#include "dem/surface.hpp"
#include "draw/drawing.hpp"
#include "geometry/angle.hpp"
#include "placing/contours.hpp"
#include "placing/eye_summit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

namespace orograph {
namespace {

void tell_chosen_view(const ChosenView& chosen) {
  say("seen from {0}/{1}, which shows most ground with most relief (--view-from "
      "{0}/{1})",
      chosen.azimuth.in_degrees(), chosen.elevation.in_degrees());
}

void tell_near_skyline(const NearSkyline& near, const ViewSpec& view) {
  const auto& eye = view.eye_lonlat ? view.eye_lonlat : view.eye_map;
  std::string right;
  if (eye && eye->z)
    right = fmt::format("with {} without a height, ", view.eye_lonlat ? "--eye-lonlat" : "--eye");
  right += near.clear_of_height_m
               ? fmt::format("--eye-height {:.3g} looks over it", *near.clear_of_height_m)
               : "a greater --eye-height, or another place, may look over it";
  say("ground within {:.3g} m hides most of what is beyond it from an eye {:.3g} "
      "m high ({})",
      near.within_m, near.eye_height_m, right);
}

std::string grouped(std::uint64_t count) {
  std::string digits = std::to_string(count);
  for (std::size_t at = digits.size(); at > 3; at -= 3) digits.insert(at - 3, ",");
  return digits;
}

// "from 180/25 in perspective", which --view-from and --projection would take.
std::string view_in_words(const PlacedView& placed, const ViewSpec& asked) {
  if (asked.file) return "by " + asked.file_name;
  const View& view = placed.view;
  const auto azimuth = [](Vec2 towards) {
    const double deg = std::round(10 * atan2_angle(towards.x, towards.y).in_degrees()) / 10;
    return deg < 0 ? deg + 360 : deg;
  };
  if (placed.panorama)
    return fmt::format("{} panorama of {:.6g} degrees",
                       asked.projection == Projection::cylindrical ? "cylindrical"
                                                                   : "equirectangular",
                       placed.panorama->width_deg);
  if (asked.has_eye()) return fmt::format("from the eye towards azimuth {}", azimuth(view.forward));
  const double from_azimuth = azimuth(-1.0 * view.forward);
  const Angle elevation = placed.chosen_view      ? placed.chosen_view->elevation
                          : view.is_perspective() ? asked.from_elevation
                                                  : view.elevation;
  const std::string from = fmt::format("from {}/{:.3g}", from_azimuth, elevation.in_degrees());
  switch (view.projection) {
  case Projection::perspective:
    return from + " in perspective";
  case Projection::orthographic:
    return from + ", orthographic";
  case Projection::oblique:
    return fmt::format("from azimuth {}, oblique", from_azimuth);
  case Projection::cylindrical: // whose view is one in perspective
  case Projection::equirectangular:
    break;
  }
  return from;
}

std::string heights_in_words(const PlacedView& placed) {
  if (placed.exaggeration == 1) return "true heights";
  return fmt::format("heights {} times{}", placed.exaggeration,
                     placed.exaggeration_chosen ? " (--exaggeration 1 draws them true)" : "");
}

// Straight down in a parallel picture heights move nothing: profiles are straight lines.
std::optional<std::string> of_plan(const PlacedView& placed, const MapSpec& spec) {
  const bool is_plan = !placed.view.is_perspective() && placed.view.y_per_z == 0;
  if (!is_plan || placed.depths_m.empty() || !spec.style.asks_for("profiles")) return std::nullopt;
  const char* what =
      spec.ground_points ? ": --view-from with less than 90 shows relief, and --contours do"
      : spec.style.light
          ? ", and only light on them (--light) and contours (--contours) show relief"
          : ": --light shows relief by their widths, --view-from with "
            "less than 90 by their shapes, --contours without them";
  return fmt::format("from straight {} profiles are straight lines{}",
                     placed.view.y_per_v < 0 ? "below" : "above", what);
}

} // namespace

void tell_notes(const std::vector<Overlay>& overlays) {
  for (const Overlay& overlay : overlays)
    for (const std::string& note : overlay.notes) say_line(note);
}

void tell_overlays(const std::vector<Overlay>& overlays, const Counts& counts) {
  tell_notes(overlays);
  std::vector<std::string> beside;
  if (counts.not_draped > 0) beside.push_back(fmt::format("{} not at all", counts.not_draped));
  if (counts.draped_in_part > 0)
    beside.push_back(fmt::format("{} only in part", counts.draped_in_part));
  if (!beside.empty())
    say("of {} features to drape the terrain has {}", counts.draped + counts.not_draped,
        fmt::join(beside, ", "));
}

void tell_contours(const Style& style, const TerrainData& terrain, const Drawing& drawing) {
  if (!style.asks_for("contours") && !style.draws_index_contours()) return;
  const bool are_drawn = std::ranges::any_of(drawing.layers, [](const Layer& layer) {
    return !layer.strokes.empty() && (layer.name == "contours" || layer.name == "index-contours");
  });
  if (are_drawn || !has_ground(terrain.surface)) return;
  const ContourSpec& spec = style.contours;
  const ContourLevels levels = contour_levels(terrain, spec);
  if (!levels.heights.empty()) return;
  const std::string_view unit = !spec.unit_m ? "" : *spec.unit_m == 1 ? " m" : " ft";
  const bool is_auto = spec.levels.empty() && !spec.interval;
  say("no contour is drawn: the ground is {:.6g} to {:.6g}{} high{}", levels.low, levels.high, unit,
      is_auto ? "" : ", and none of their heights is between (--contours auto has some that are)");
}

void tell_placing(const PlacedView& placed, const ViewSpec& view) {
  if (placed.chosen_view) tell_chosen_view(*placed.chosen_view);
  if (placed.near_skyline) tell_near_skyline(*placed.near_skyline, view);
}

void tell_eye_move(const ViewSpec& view, const TerrainData& terrain) {
  const auto move = eye_move(view, terrain);
  if (!move) return;
  const double unit_m = terrain.map.height_unit_m;
  if (const double cell_m = cell_size_m(terrain.surface); move->distance_m == 0)
    say("the eye stays where it is: no ground within {} m is higher{}", *view.eye_summit_m,
        *view.eye_summit_m < 2 * cell_m
            ? fmt::format(" (cells are {:.3g} m wide: --eye-summit {:.0f} sees some of them)",
                          cell_m, 5 * cell_m)
            : "");
  else
    say("the eye goes {:.4g} m to the highest ground within {} m, {:.10g},{:.10g} at height "
        "{:.6g}{}",
        move->distance_m, *view.eye_summit_m, move->to_map.x, move->to_map.y, move->to_m / unit_m,
        move->from_m ? fmt::format(" instead of {:.6g}", *move->from_m / unit_m) : "");
}

void tell_doubts(const TerrainData& terrain) {
  for (const std::string& doubt : terrain.doubts) say_line(doubt);
}

std::vector<std::string> closing_lines(const Map& map, std::span<const Drawing> sheets,
                                       const PlacedView& placed, const RenderSettings& settings,
                                       double seconds) {
  const PenWork work =
      pen_work(sheets.empty() ? std::span(&map.drawing, 1) : sheets, settings.pen_speeds);
  const auto known = sum_of(work.minutes);
  const std::string minutes =
      known ? fmt::format(", {:.0f} minutes for the pen", std::ceil(*known)) : "";
  const std::vector<std::string> names = output_names(settings);
  const std::string written = settings.output == "-" ? "standard output"
                              : names.size() <= 2 // a single sheet has an overview too
                                  ? names.front()
                                  : fmt::format("{} to {}", names.front(), names[names.size() - 2]);
  std::vector<std::string> lines;
  if (auto plan = of_plan(placed, settings.map)) lines.push_back(std::move(*plan));
  lines.push_back(
      fmt::format("{}: {} {}, {:.1f} m of ink{}, {}, {}, {:.1f} s", written, grouped(work.strokes),
                  work.strokes == 1 ? "stroke" : "strokes", 1e-3 * work.travel().down_mm, minutes,
                  view_in_words(placed, settings.map.view), heights_in_words(placed), seconds));
  return lines;
}

} // namespace orograph
