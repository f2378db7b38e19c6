// SPDX-License-Identifier: GPL-3.0-or-later
#include "python/views.hpp"

#include "cli/finish_drawing.hpp"
#include "cli/info.hpp"
#include "cli/options/options.hpp"
#include "dem/read/lonlat.hpp"
#include "map/draw_level.hpp"

#include <limits>
#include <utility>

namespace orograph {

NamedTerrain read_terrain_files(const std::vector<std::string>& paths, const NamedValues& options,
                                const Control& control) {
  if (paths.empty()) throw UsageError("no file is named", "name one, or several rasters");
  NamedValues all = options;
  all.emplace_back("INPUT", paths);
  const InfoSettings settings = take_reading(all);
  Control own = control;
  own.jobs = settings.jobs;
  return {Terrain::read(settings.inputs, settings.reading, own), paths};
}

RenderSettings Views::settings_for(const NamedValues& options, const std::string& output) const {
  RenderSettings settings;
  settings.inputs = terrain_.paths;
  settings.output = output;
  take_drawing(settings, options);
  return settings;
}

// A session is of one scene and the same vectors; the last one is kept.
Session Views::session_for(const RenderSettings& settings, const Control& control) {
  std::string overlays;
  for (const OverlayInput& overlay : settings.overlays)
    overlays += overlay.path + '\n' + overlay.layer + '\n' + overlay.where + '\n';
  const OverlayInput& names = settings.labels;
  overlays += '\n' + names.path + '\n' + names.layer + '\n' + names.where;
  const std::lock_guard lock(mutex_);
  if (!session_ || settings.scene_file != scene_file_ || overlays != overlays_) {
    session_.emplace(
        terrain_.terrain,
        settings.scene_file.empty() ? Solids() : Solids::read(settings.scene_file),
        settings.overlays.empty() ? Overlays()
                                  : Overlays::read(settings.overlays, terrain_.terrain, control),
        names.path.empty() ? Overlays() : Overlays::read({names}, terrain_.terrain, control));
    scene_file_ = settings.scene_file;
    overlays_ = std::move(overlays);
  }
  return *session_;
}

Drawn Views::draw(const NamedValues& options, const Control& control) {
  Drawn drawn{settings_for(options, ""), {}};
  Control own = control;
  own.jobs = drawn.settings.jobs;
  drawn.map = session_for(drawn.settings, own).draw(drawn.settings.map, own);
  check_not_empty(drawn.map, drawn.settings.map.view);
  finish_drawing(drawn.map, drawn.settings);
  return drawn;
}

// Solids and overlays hide nothing from an eye that looks around.
Session Views::session_of_ground() {
  const std::lock_guard lock(mutex_);
  if (!session_) session_.emplace(terrain_.terrain);
  return *session_;
}

std::vector<PlaceSight> Views::sights(const NamedValues& options, std::vector<Vec2> places,
                                      bool lonlat, const Control& control) {
  const VisibleSettings settings = take_sights(options);
  Control own = control;
  own.jobs = settings.render.jobs;
  const std::string& crs_wkt = terrain_.terrain.crs_wkt();
  if (lonlat && !is_on_earth(crs_wkt))
    throw UsageError("longitudes and latitudes have no place on this terrain, whose CRS isn't on "
                     "the earth",
                     "give points in its own coordinates");
  constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
  std::vector<PlaceSight> out(
      places.size(),
      PlaceSight{
          PlaceState::outside, {kUnknown, kUnknown, kUnknown}, kUnknown, kUnknown, kUnknown});
  std::vector<Vec2> known;
  std::vector<std::size_t> place_of;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const auto on_map = lonlat ? map_of_lonlat(crs_wkt, places[i]) : places[i];
    if (!on_map) continue;
    known.push_back(*on_map);
    place_of.push_back(i);
  }
  const std::vector<PlaceSight> sights =
      session_of_ground().sights(settings.render.map.view, known, settings.target_height_m, own);
  for (std::size_t i = 0; i < sights.size(); ++i) out[place_of[i]] = sights[i];
  return out;
}

Skyline Views::skyline(const NamedValues& options, const Control& control) {
  const VisibleSettings settings = take_skyline(options);
  Control own = control;
  own.jobs = settings.render.jobs;
  return session_of_ground().skyline(settings.render.map.view, settings.render.skyline_step_deg,
                                     own);
}

void Views::save(const Drawn& drawn, const std::string& path, const NamedValues& options) const {
  const RenderSettings settings = settings_for(options, path);
  write_outputs(drawn.map.drawing, sheets_and_overview(drawn.map.drawing, settings), settings);
}

bool draws_alike(Format one, Format other) {
  const auto kind = [](Format format) {
    return std::tuple(is_tied_to_ground(format), has_one_width(format), pen_order_for(format),
                      language_of(format));
  };
  return kind(one) == kind(other);
}

FlatStrokes flat_strokes(const Drawing& drawing) {
  FlatStrokes flat;
  std::int32_t number = 0;
  for (const Layer& layer : drawing.layers) {
    const bool has_map = layer.map.size() == layer.page_mm.size();
    for (const Stroke& stroke : layer.strokes) {
      flat.offsets.push_back(static_cast<std::int64_t>(flat.page_mm.size()));
      const auto from = static_cast<std::ptrdiff_t>(stroke.first_point);
      const auto to = from + static_cast<std::ptrdiff_t>(stroke.point_count);
      flat.page_mm.insert(flat.page_mm.end(), layer.page_mm.begin() + from,
                          layer.page_mm.begin() + to);
      if (has_map)
        flat.map.insert(flat.map.end(), layer.map.begin() + from, layer.map.begin() + to);
      flat.layer.push_back(number);
      flat.profile.push_back(stroke.profile);
      flat.level.push_back(stroke.profile < 0 ? -1 : stroke.level);
      flat.feature.push_back(stroke.feature);
      flat.depth_m.push_back(stroke.depth_m);
      flat.width_mm.push_back(stroke.width_mm > 0 ? stroke.width_mm : layer.pen_width_mm);
      flat.darkness.push_back(stroke.darkness);
    }
    ++number;
  }
  flat.offsets.push_back(static_cast<std::int64_t>(flat.page_mm.size()));
  if (flat.map.size() != flat.page_mm.size()) flat.map.clear();
  return flat;
}

} // namespace orograph
