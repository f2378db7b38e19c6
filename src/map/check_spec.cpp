// SPDX-License-Identifier: GPL-3.0-or-later
#include "map/check_spec.hpp"

#include "geometry/error.hpp"
#include "map/layer_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <type_traits>
#include <variant>

namespace orograph {
namespace {

constexpr double kMostSummit_m = 100000;
constexpr double kNone = std::numeric_limits<double>::infinity();

// From `low` to `high`, both included.
void check_range(const char* field, double value, double low, double high, const char* unit = "") {
  if (!std::isfinite(value) || value < low || value > high)
    throw UsageError(fmt::format("`{}` is {}{}", field, value, unit),
                     high == kNone ? fmt::format("at least {}{}", low, unit)
                                   : fmt::format("{} to {}{}", low, high, unit));
}
void check_above_0(const char* field, double value, double high, const char* unit = "") {
  if (!(value > 0 && value <= high) || !std::isfinite(value))
    throw UsageError(fmt::format("`{}` is {}{}", field, value, unit),
                     high == kNone ? fmt::format("above 0{}", unit)
                                   : fmt::format("above 0 and at most {}{}", high, unit));
}

void check_finite(const char* field, const std::optional<GivenPlace>& place) {
  if (place &&
      !(std::isfinite(place->x) && std::isfinite(place->y) && std::isfinite(place->z.value_or(0))))
    throw UsageError(fmt::format("`{}` is {},{}", field, place->x, place->y), "finite numbers");
}

void check_panorama(const ViewSpec& view) {
  if (!view.has_eye()) throw UsageError("a panorama needs an eye", "`eye_map` or `eye_lonlat`");
  for (const auto& [is_given, field] :
       {std::pair{view.distance_m.has_value(), "distance_m"},
        std::pair{view.from_auto, "from_auto"}, std::pair{view.pitch.has_value(), "pitch"},
        std::pair{view.roll != Angle(), "roll"}})
    if (is_given)
      throw UsageError(fmt::format("`{}` has no meaning in a panorama", field), "leave it out");
  if (view.azimuth_range) {
    const auto& [from, to] = *view.azimuth_range;
    const double width_deg = to.in_degrees() - from.in_degrees();
    check_range("azimuth_range.from", from.in_degrees(), -1e6, 1e6, " degrees");
    if (!(width_deg > 0 && width_deg <= 360))
      throw UsageError(fmt::format("`azimuth_range` is {} degrees wide", width_deg),
                       "above 0 and at most 360 degrees, from less to more");
    if (view.field_of_view || view.look_azimuth || view.look_at_map || view.look_at_lonlat)
      throw UsageError("`azimuth_range` stands beside a field of view or a direction",
                       "one of them");
  }
  if (view.altitude_range) {
    const auto& [low, high] = *view.altitude_range;
    check_range("altitude_range.low", low.in_degrees(), -80, 80, " degrees");
    check_range("altitude_range.high", high.in_degrees(), -80, 80, " degrees");
    if (!(low < high)) throw UsageError("`altitude_range` doesn't rise", "the lower one first");
  }
}

void check_view(const ViewSpec& view) {
  const bool is_round = is_panorama(view.projection);
  if (is_round) {
    check_panorama(view);
  } else if (view.azimuth_range || view.altitude_range) {
    throw UsageError("`azimuth_range` and `altitude_range` have no meaning but in a panorama",
                     "leave them out, or ask for Projection::cylindrical");
  }
  if (view.projection != Projection::perspective && !is_round)
    for (const auto& [is_given, field] :
         {std::pair{view.eye_map.has_value(), "eye_map"},
          std::pair{view.eye_lonlat.has_value(), "eye_lonlat"},
          std::pair{view.distance_m.has_value(), "distance_m"},
          std::pair{view.field_of_view.has_value(), "field_of_view"},
          std::pair{view.look_azimuth.has_value(), "look_azimuth"}})
      if (is_given)
        throw UsageError(fmt::format("`{}` has no meaning in a parallel view", field),
                         "leave it out, or ask for Projection::perspective");
  for (const auto& [field, place] :
       {std::pair{"eye_map", view.eye_map}, std::pair{"eye_lonlat", view.eye_lonlat},
        std::pair{"look_at_map", view.look_at_map},
        std::pair{"look_at_lonlat", view.look_at_lonlat}})
    check_finite(field, place);
  check_range("from_azimuth", view.from_azimuth.in_degrees(), -1e6, 1e6, " degrees");
  check_range("from_elevation", view.from_elevation.in_degrees(), -90, 90, " degrees");
  if (view.field_of_view) {
    const double field_deg = view.field_of_view->in_degrees();
    if (!(field_deg > 0 && (is_round ? field_deg <= 360 : field_deg < 180)))
      throw UsageError(fmt::format("`field_of_view` is {} degrees", field_deg),
                       is_round ? "above 0 and at most 360 degrees"
                                : "above 0 and below 180 degrees");
  }
  if (view.distance_m) check_above_0("distance_m", *view.distance_m, kNone, " m");
  if (view.eye_height_m) check_above_0("eye_height_m", *view.eye_height_m, kNone, " m");
  if (view.eye_summit_m) check_above_0("eye_summit_m", *view.eye_summit_m, kMostSummit_m, " m");
  if (view.look_azimuth)
    check_range("look_azimuth", view.look_azimuth->in_degrees(), -1e6, 1e6, " degrees");
  if (view.pitch) check_range("pitch", view.pitch->in_degrees(), -90, 90, " degrees");
  check_range("roll", view.roll.in_degrees(), -1e6, 1e6, " degrees");
  check_range("refraction", view.refraction, -1, 1);
  if (view.exaggeration) check_above_0("exaggeration", *view.exaggeration, 1000);
  check_above_0("oblique.length", view.oblique.length, kNone);
  check_range("oblique.rise", view.oblique.rise.in_degrees(), 0, 180, " degrees");
}

void check_plan(const PlanRequest& plan) {
  std::visit(
      [](const auto& asked) {
        using Asked = std::decay_t<decltype(asked)>;
        if constexpr (std::is_same_v<Asked, ProfileCount>)
          check_range("plan", asked.count, 1, 100000, " profiles");
        else if constexpr (std::is_same_v<Asked, PageSpacing>)
          check_above_0("plan", asked.mm, kNone, " mm");
        else
          check_above_0("plan", asked.m, kNone, " m");
      },
      plan);
}

void check_layers(const Style& style) {
  const std::vector<LayerSpec>& layers = style.layers;
  for (const LayerSpec& spec : layers) {
    const auto is_named = [&](const auto& other) { return other.name == spec.name; };
    if (std::none_of(layer_table().begin(), layer_table().end(), is_named)) {
      std::string names;
      for (const LayerRow& row : layer_table())
        names += (names.empty() ? "" : ", ") + std::string(row.name);
      throw UsageError(fmt::format("there is no layer '{}'", spec.name), "one of " + names);
    }
    if (std::count_if(layers.begin(), layers.end(), is_named) > 1)
      throw UsageError(fmt::format("the layer '{}' is asked for twice", spec.name), "once");
    const LayerRow& row = layer_row(spec.name);
    if (row.is_hidden() && row.source != LineSource::hidden_solids &&
        !layer_of(layer_row(row.hidden_of), style))
      throw UsageError(
          fmt::format("the layer '{}' has no meaning without '{}'", spec.name, row.hidden_of),
          "both");
    if (spec.weight) check_above_0("weight", *spec.weight, kNone);
    if (spec.grey) check_range("grey", *spec.grey, 0, 1);
  }
}

void check_ground_lines(const Style& style) {
  const ContourSpec& contours = style.contours;
  if (contours.interval) check_above_0("contours.interval", *contours.interval, kNone);
  if (contours.unit_m) check_above_0("contours.unit_m", *contours.unit_m, kNone, " m");
  check_range("contours.offset", contours.offset, -1e9, 1e9);
  check_range("contours.index_every", contours.index_every, 0, 1000);
  for (std::size_t i = 0; i < contours.levels.size(); ++i) {
    check_range("contours.levels", contours.levels[i], -1e9, 1e9);
    if (i > 0 && !(contours.levels[i - 1] < contours.levels[i]))
      throw UsageError("`contours.levels` don't rise", "each above the one before it");
  }
  if (style.mesh.spacing_m) check_above_0("mesh.spacing_m", *style.mesh.spacing_m, kNone, " m");
  check_range("mesh.count", style.mesh.count, 1, 10000);
  if (style.graticule_deg) check_above_0("graticule_deg", *style.graticule_deg, 180, " degrees");
  if (style.grid_m) check_above_0("grid_m", *style.grid_m, kNone, " m");
  check_range("overlay_above_m", style.overlay_above_m, 0, 10000, " m");
}

void check_style(const Style& style, bool has_solids) {
  if (style.plan) check_plan(*style.plan);
  check_range("visibility_tolerance_mm", style.visibility_tolerance_mm, 0, 10);
  check_range("simplify_mm", style.simplify_mm, 0, 10);
  check_range("silhouette_jump", style.silhouette_jump, 0, 10);
  check_range("join_mm", style.join_mm, 0, 10);
  check_range("shore_smooth_mm", style.shore_smooth_mm, 0, 10);
  check_range("min_stroke_mm", style.min_stroke_mm.value_or(0), 0, 1000);
  check_range("pen_width_mm", style.pen_width_mm, 0.01, 10);
  if (style.light_widths) {
    check_range("light_widths.greatest_mm", style.light_widths->greatest_mm, 0.01, 10);
    check_range("light_widths.least_mm", style.light_widths->least_mm, 0.01,
                style.light_widths->greatest_mm);
  }
  if (style.light) {
    check_range("light.altitude", style.light->altitude.in_degrees(), 0, 90);
    check_range("light.contrast", style.light->contrast, 0, 10);
    check_range("light.smooth_mm", style.light->smooth_mm, 0, 100);
  }
  check_range("haze", style.haze.value_or(0), 0, 1);
  check_layers(style);
  check_ground_lines(style);
  if (has_solids && style.occluder == Occluder::profiles)
    throw UsageError("solids stand in front of the surface and behind it, not of profiles",
                     "Occluder::surface");
}

// Margins are checked where the page is laid out (draw/page.hpp).
void check_page(const PageRequest& page) {
  check_range("width_mm", page.width_mm, 1, 10000);
  if (page.height_mm) check_range("height_mm", *page.height_mm, 1, 10000);
  check_range("strips", page.strips, 1, 20);
  if (page.scale) check_above_0("scale", *page.scale, kNone);
}

} // namespace

void check_underside(const MapSpec& spec) {
  const Style& style = spec.style;
  if (style.underside == Underside::omit) {
    const double elevation_deg = spec.view.from_elevation.in_degrees();
    if (!spec.view.file && elevation_deg < 0)
      throw UsageError(fmt::format("`from_elevation` is {} degrees", elevation_deg),
                       "0 to 90 degrees, or from -90 with `underside`");
    for (const LayerSpec& layer : style.layers)
      if (is_of_underside(layer_row(layer.name)))
        throw UsageError(
            fmt::format("the layer '{}' has no meaning where no underside is drawn", layer.name),
            "give `underside`");
    return;
  }
  if (style.occluder == Occluder::profiles)
    throw UsageError("profiles that hide have no underside", "leave out `underside`");
  if (spec.check_of_file > 0)
    throw UsageError("what is seen from below isn't asked of the file's surface",
                     "leave out `check_of_file`, or `underside`");
  if (!style.asks_for("block")) return;
  for (const LayerSpec& layer : style.layers)
    if (is_of_underside(layer_row(layer.name)))
      throw UsageError(
          fmt::format("the layer '{}' has no meaning where a block is closed below", layer.name),
          "leave out `block`, or the layer");
}

void check_furniture(const MapSpec& spec) {
  const FurnitureSpec& furniture = spec.furniture;
  check_range("title_mm", furniture.title_mm, 0.5, 100);
  check_range("subtitle_mm", furniture.subtitle_mm, 0.5, 100);
  check_range("text_mm", furniture.text_mm, 0.5, 100);
  check_range("gap_mm", furniture.gap_mm, 0, 100);
  const bool is_round = !spec.view.file && is_panorama(spec.view.projection);
  for (const Furniture piece : {Furniture::azimuths, Furniture::altitudes})
    if (furniture.has(piece) && !is_round)
      throw UsageError("`furniture` with azimuths or altitudes has no meaning but in a panorama",
                       "that of a map, or a panorama's `projection`");
  for (const Furniture piece : {Furniture::north, Furniture::scale})
    if (furniture.has(piece) && is_round)
      throw UsageError("`furniture` with north or scale has no meaning in a panorama",
                       "that of a panorama");
  if (furniture.has(Furniture::viewpoint) && !spec.view.has_eye())
    throw UsageError("`furniture` with a viewpoint has no meaning without an eye",
                     "it without, or an eye");
}

void check_eye_spec(const ViewSpec& view) {
  if (!view.has_eye())
    throw UsageError("there is no eye to look from", "`eye_map` or `eye_lonlat`");
  if (view.file)
    throw UsageError("a view in a file has no eye to look around from",
                     "`eye_map` or `eye_lonlat` without it");
  ViewSpec eye = view; // in what picture doesn't matter
  eye.projection = Projection::perspective;
  check_view(eye);
}

namespace {

void check_labels(const LabelSpec& labels) {
  const double deg = labels.angle.in_degrees();
  if (deg != 0) check_range("labels.angle", deg, 15, 90, " degrees");
  check_range("labels.rows", labels.rows, 1, 20);
  if (labels.most) check_range("labels.most", *labels.most, 0, kNone);
  if (labels.range_m) check_above_0("labels.range_m", *labels.range_m, kNone, " m");
  check_above_0("labels.haze_m", labels.haze_m, kNone, " m");
  check_range("labels.size_mm", labels.size_mm, 0.5, 50, " mm");
  check_range("labels.halo_mm", labels.halo_mm, 0, 20, " mm");
}

} // namespace

void check_sights(const std::vector<Vec2>& places, double above_m) {
  check_range("above_m", above_m, 0, kNone, " m");
  for (const Vec2 place : places)
    if (!std::isfinite(place.x) || !std::isfinite(place.y))
      throw UsageError(fmt::format("a place is {},{}", place.x, place.y), "finite numbers");
}

void check_skyline_step(double step_deg) {
  check_range("step_deg", step_deg, 0.001, 90, " degrees");
}

void check_spec(const MapSpec& spec, bool has_solids) {
  if (!spec.view.file) check_view(spec.view);
  if (spec.page.strips > 1 && (spec.view.file || !is_panorama(spec.view.projection)))
    throw UsageError("`strips` has no meaning but in a panorama", "1");
  check_style(spec.style, has_solids);
  check_page(spec.page);
  check_furniture(spec);
  check_labels(spec.labels);
  check_underside(spec);
  if (spec.ground_points && spec.style.asks_for("pen-up"))
    throw UsageError(
        "the layer 'pen-up' has no meaning where lines keep their places on the ground",
        "`layers` without it");
  if (spec.ground_points && spec.pen_order != PenOrder::drawing)
    throw UsageError("`pen_order` has no meaning where lines keep their places on the ground",
                     "PenOrder::drawing");
}

} // namespace orograph
