// SPDX-License-Identifier: GPL-3.0-or-later
#include "hidden_lines/ground_lines.hpp"
#include "placing/hachures.hpp"
#include "profiles/drape.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <vector>

namespace orograph {
namespace {

// From the view's profile frame to coordinates as a surface is laid out (profiles/drape.hpp).
Vec2 place_on(const Surface& surface, const View& view, Vec2 place) {
  const Vec2 ground = view.depth_origin_m + place.x * view.right + place.y * view.forward;
  const Grid* grid = std::get_if<Grid>(&surface);
  if (!grid) return ground;
  if (grid->is_on_earth()) return grid->earth().column_row_at({ground.x, ground.y, 0});
  const auto& [first_m, column_step_m, row_step_m] = grid->plane();
  const Vec2 from_first = ground - first_m;
  const double area = cross(column_step_m, row_step_m);
  return {cross(from_first, row_step_m) / area, cross(column_step_m, from_first) / area};
}

} // namespace

void add_hachures(const TerrainData& terrain, const PlacedView& placed, const Style& style,
                  GroundLines& out) {
  const Surface& surface = terrain.surface;
  const auto first_point = static_cast<std::uint32_t>(vertex_count(surface));
  Draper draper(surface, placed.view);
  DrapedLine draped;
  std::vector<Vec2> given;
  for (const HachureRun& run : hachures(surface, placed, style.hachures, style.pen_width_mm)) {
    throw_if_stopped(out.features.size());
    given.clear();
    std::ranges::transform(run.places, std::back_inserter(given),
                           [&](Vec2 place) { return place_on(surface, placed.view, place); });
    draper.drape(given, 0, draped);
    const auto number = first_point + static_cast<std::uint32_t>(out.points.size());
    out.points.insert(out.points.end(), draped.points.begin(), draped.points.end());
    for (const auto& [from, to, triangle] : draped.pieces)
      out.lines.push_back({{number + from, number + to},
                           triangle,
                           static_cast<std::uint32_t>(out.features.size())});
    constexpr double kTenths = 10;
    out.features.push_back({LineKind::hachure,
                            {{"slope", std::round(run.slope_deg * kTenths) / kTenths}},
                            false,
                            run.width_mm});
  }
}

} // namespace orograph
