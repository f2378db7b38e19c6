// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/tell_placing.hpp"

#include "cli/say.hpp"
#include "dem/extent.hpp"
#include "dem/surface.hpp"
#include "placing/contours.hpp"
#include "placing/eye_summit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <string_view>

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

} // namespace

void tell_notes(const std::vector<Overlay>& overlays) {
  for (const Overlay& overlay : overlays)
    for (const std::string& note : overlay.notes) say_line(note);
}

void tell_overlays(const std::vector<Overlay>& overlays, const Counts& counts) {
  tell_notes(overlays);
  if (counts.not_draped + counts.draped_in_part > 0)
    say("of {} features to drape {} aren't on the terrain, and {} only in part",
        counts.draped + counts.not_draped, counts.not_draped, counts.draped_in_part);
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

} // namespace orograph
