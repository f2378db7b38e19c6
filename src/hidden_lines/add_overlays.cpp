// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/error.hpp"
#include "geometry/on_all_cores.hpp"
#include "hidden_lines/ground_lines.hpp"
#include "profiles/drape.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace orograph {
namespace {

// From map coordinates to those that a surface is laid out in (profiles/drape.hpp).
class SurfacePlaces {
public:
  explicit SurfacePlaces(const TerrainData& terrain)
      : map_(terrain.map), grid_(std::get_if<Grid>(&terrain.surface)) {
    if (!grid_ && map_.earth)
      throw Error(
          "lines of a map can't be laid on a terrain in degrees that the view's planes cut",
          "leave the front and back plane out, or project the terrain: gdalwarp -t_srs CRS");
  }

  Vec2 operator()(Vec2 on_map) const {
    if (grid_ && grid_->is_on_earth()) {
      const DegreeLattice& degrees = grid_->earth().degrees();
      const double lon_deg = on_map.x * map_.earth->unit_deg;
      const double turns = std::round((lon_deg - degrees.middle_lon_deg()) / 360);
      return {(lon_deg - 360 * turns - degrees.first_lon_deg) / degrees.lon_step_deg,
              (on_map.y * map_.earth->unit_deg - degrees.first_lat_deg) / degrees.lat_step_deg};
    }
    const Vec3 ground = map_.to_ground_m({on_map.x, on_map.y, 0});
    if (!grid_) return {ground.x, ground.y};
    const auto& [first_m, column_step_m, row_step_m] = grid_->plane();
    const Vec2 from_first = Vec2{ground.x, ground.y} - first_m;
    const double area = cross(column_step_m, row_step_m);
    return {cross(from_first, row_step_m) / area, cross(column_step_m, from_first) / area};
  }

  // Of what is a metre long in both directions on the ground.
  Vec2 metre() const {
    if (!grid_) return {1, 1};
    const GridSteps steps = steps_of(*grid_);
    return {1 / length(steps.column_m), 1 / length(steps.row_m)};
  }

private:
  const MapFrame& map_;
  const Grid* grid_;
};

class OverlayLines {
public:
  OverlayLines(const TerrainData& terrain, const PlacedView& placed, double above_m,
               GroundLines& out)
      : placed_(placed), places_(terrain), draper_(terrain.surface, placed.view),
        above_m_(above_m * placed.exaggeration),
        first_point_(static_cast<std::uint32_t>(vertex_count(terrain.surface))), out_(out) {}

  void add(const Overlay& overlay, const Overlay::Feature& feature) {
    const std::size_t before = out_.lines.size();
    bool is_whole = true;
    for (std::size_t i = 0; i < feature.line_count; ++i) {
      const auto& [first, count] = overlay.lines[feature.first_line + i];
      given_.clear();
      for (std::size_t k = first; k < first + count; ++k)
        given_.push_back(places_(overlay.places[k]));
      if (count == 1) {
        add_mark(given_.front());
      } else {
        draper_.drape(given_, above_m_, draped_);
        add_draped();
        is_whole = is_whole && draped_.is_whole;
      }
    }
    if (out_.lines.size() == before) {
      ++out_.not_draped;
      return;
    }
    if (!is_whole) ++out_.draped_in_part;
    out_.features.push_back({LineKind::drape, feature.attributes});
  }

private:
  void add_draped() {
    const auto number = first_point_ + static_cast<std::uint32_t>(out_.points.size());
    out_.points.insert(out_.points.end(), draped_.points.begin(), draped_.points.end());
    for (const auto& [from, to, triangle] : draped_.pieces)
      out_.lines.push_back({{number + from, number + to},
                            triangle,
                            static_cast<std::uint32_t>(out_.features.size())});
  }

  // A cross, as large on the page wherever it is.
  void add_mark(Vec2 place) {
    const Vec2 metre = places_.metre();
    draper_.drape(std::vector<Vec2>{place, place + Vec2{metre.x, 0}}, above_m_, draped_);
    if (draped_.points.empty()) return;
    const ProfilePoint at = draped_.points.front();
    if (!(placed_.to_page.of(project_homogeneous(placed_.view, at)).z > 0)) return;
    const double mm_a_metre = mm_a_metre_at(placed_, at);
    if (!(mm_a_metre > 0)) return;
    const double half_m = 0.5 * kMark_mm / mm_a_metre;
    for (const Vec2 arm : {Vec2{half_m * metre.x, 0}, Vec2{0, half_m * metre.y}}) {
      draper_.drape(std::vector<Vec2>{place - arm, place + arm}, above_m_, draped_);
      add_draped();
    }
  }

  const PlacedView& placed_;
  SurfacePlaces places_;
  Draper draper_;
  double above_m_;
  std::uint32_t first_point_;
  GroundLines& out_;
  std::vector<Vec2> given_;
  DrapedLine draped_;
};

} // namespace

void add_overlays(const TerrainData& terrain, const PlacedView& placed, double above_m,
                  GroundLines& out) {
  if (placed.overlays.empty()) return;
  OverlayLines lines(terrain, placed, above_m, out);
  for (const Overlay& overlay : placed.overlays)
    for (const Overlay::Feature& feature : overlay.features) {
      throw_if_stopped();
      lines.add(overlay, feature);
    }
}

} // namespace orograph
