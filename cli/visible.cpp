// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/visible.hpp"

#include "cli/report/skyline_table.hpp"
#include "cli/say.hpp"
#include "cli/tell_map.hpp"
#include "dem/read/read_terrain.hpp"
#include "map/look_around.hpp"
#include "placing/observer.hpp"
#include "placing/overlay_points.hpp"
#include "placing/read_overlays.hpp"
#include "placing/terrain_facts.hpp"
#include "placing/terrain_of_view.hpp"
#include "text/words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace orograph {
namespace {

constexpr const char* kResults[] = {"state",        "hidden_m",   "hidden_deg", "azimuth_deg",
                                    "altitude_deg", "distance_m", "height"};

double rounded(double value, double steps) {
  return std::round(value * steps) / steps;
}
double rounded_m(double m) {
  return rounded(m, 1e3);
}
double rounded_deg(double deg) {
  return rounded(deg, 1e9);
}

// What the points' own fields are called: one that is called as a result, or as another in other
// letters, gets a mark.
std::map<std::string, std::string> own_names(const std::vector<std::string>& fields) {
  std::set<std::string> taken{"x", "y"};
  taken.insert(std::begin(kResults), std::end(kResults));
  std::map<std::string, std::string> out;
  for (const std::string& field : fields) {
    std::string name = field;
    while (!taken.insert(in_lower_case(name)).second) name += '_';
    out[field] = name;
  }
  return out;
}

Attributes results_of(const PlaceSight& sight) {
  const auto& [azimuth_deg, altitude_deg, distance_m] = sight.bearing;
  Attributes out{{"state", std::string(name_of(sight.state))},
                 {"azimuth_deg", rounded_deg(azimuth_deg)},
                 {"distance_m", rounded_m(distance_m)}};
  if (sight.state == PlaceState::gap || sight.state == PlaceState::outside) return out;
  out.push_back({"hidden_m", rounded_m(sight.hidden_m)});
  out.push_back({"hidden_deg", rounded_deg(sight.hidden_deg)});
  out.push_back({"altitude_deg", rounded_deg(altitude_deg)});
  out.push_back({"height", rounded_m(sight.height)});
  return out;
}

PointTable table_of(const Overlay& overlay, const OverlayPoints& points,
                    const std::vector<PlaceSight>& sights, const MapFrame& map) {
  PointTable out;
  out.name = "visible";
  out.crs_wkt = map.crs_wkt;
  const auto names = own_names(overlay.fields);
  for (const std::string& field : overlay.fields) out.fields.push_back(names.at(field));
  for (const char* result : kResults) out.fields.emplace_back(result);
  for (std::size_t i = 0; i < points.feature_of.size(); ++i) {
    PointTable::Row& row = out.rows.emplace_back();
    for (const Attribute& own : overlay.features[points.feature_of[i]].attributes)
      row.values.push_back({names.at(own.name), own.value});
    const std::size_t place = points.place_of[i];
    if (place == OverlayPoints::kNone) {
      row.values.push_back({"state", std::string("outside")});
      continue;
    }
    row.place = points.places[place];
    for (Attribute& result : results_of(sights[place])) row.values.push_back(std::move(result));
  }
  return out;
}

void tell(const std::vector<PlaceSight>& sights, std::size_t points, const std::string& output) {
  const auto count = [&](PlaceState state) {
    return std::ranges::count(sights, state, &PlaceSight::state);
  };
  const auto beside = static_cast<std::ptrdiff_t>(points) - count(PlaceState::seen) -
                      count(PlaceState::hidden) - count(PlaceState::gap);
  std::string line = fmt::format("{}{} points, {} seen", output == "-" ? "" : output + ": ", points,
                                 count(PlaceState::seen));
  if (const auto gaps = count(PlaceState::gap); gaps > 0)
    line += fmt::format(", {} where the terrain has no heights", gaps);
  if (beside > 0) line += fmt::format(", {} outside of the terrain", beside);
  say_line(line);
}

} // namespace

const char* name_of(PlaceState state) {
  switch (state) {
  case PlaceState::seen:
    return "seen";
  case PlaceState::hidden:
    return "hidden";
  case PlaceState::gap:
    return "gap";
  case PlaceState::outside:
    return "outside";
  }
  return "outside";
}

void visible(const VisibleSettings& settings) {
  const RenderSettings& render = settings.render;
  const ViewSpec& view = render.map.view;
  if (settings.output != "-") check_writable(settings.output, render.write);
  if (!render.skyline_table.empty()) check_writable(render.skyline_table, render.write);
  const TerrainData whole = read_terrain(render.inputs, render.reading);
  if (!render.quiet) tell_doubts(whole);
  const std::vector<Overlay> overlays = read_overlays({&settings.points, 1}, whole);
  const OverlayPoints points = points_of(overlays.front());
  if (!render.quiet) {
    tell_notes(overlays);
    tell_eye_move(view, whole);
  }
  const TerrainOfView terrain(whole, view);
  const LookAround around(*terrain, border_of(terrain->surface), observer_of(view, *terrain));
  const std::vector<PlaceSight> sights = around.sights(points.places, settings.target_height_m);
  write_points(table_of(overlays.front(), points, sights, whole.map), settings.format,
               settings.output, render.write.overwrite);
  if (!render.skyline_table.empty()) {
    const Skyline skyline = around.skyline(render.skyline_step_deg);
    write_skyline(skyline, render);
    if (!render.quiet) tell_skyline(skyline, render);
  }
  if (!render.quiet) tell(sights, points.feature_of.size(), settings.output);
}

} // namespace orograph
