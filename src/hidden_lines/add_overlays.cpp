// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/error.hpp"
#include "geometry/on_all_cores.hpp"
#include "hidden_lines/ground_lines.hpp"
#include "profiles/drape.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <optional>
#include <span>
#include <utility>
#include <vector>

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
    if (!(placed_.on_page(at).z > 0)) return;
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

// Some features of an overlay.
struct SomeFeatures {
  const Overlay* overlay;
  std::size_t first, end;
};

// On a grid of about so many places each, some milliseconds of work. On a TIN all together: an
// index of it isn't made twice.
constexpr std::size_t kPlacesOfTask = 1 << 13;

std::vector<SomeFeatures> tasks_of(std::span<const Overlay> overlays, const Surface& surface) {
  const std::size_t most = std::holds_alternative<Grid>(surface)
                               ? kPlacesOfTask
                               : std::numeric_limits<std::size_t>::max();
  std::vector<SomeFeatures> tasks;
  for (const Overlay& overlay : overlays) {
    std::size_t places = most;
    for (std::size_t i = 0; i < overlay.features.size(); ++i) {
      if (places >= most) {
        tasks.push_back({&overlay, i, i});
        places = 0;
      }
      tasks.back().end = i + 1;
      const Overlay::Feature& feature = overlay.features[i];
      for (std::size_t k = 0; k < feature.line_count; ++k)
        places += overlay.lines[feature.first_line + k].place_count;
    }
  }
  return tasks;
}

// What was draped by itself, behind all else.
void append(const TerrainData& terrain, GroundLines&& part, GroundLines& out) {
  const auto vertices = static_cast<std::uint32_t>(vertex_count(terrain.surface));
  const auto points = static_cast<std::uint32_t>(out.points.size()),
             features = static_cast<std::uint32_t>(out.features.size());
  out.points.insert(out.points.end(), part.points.begin(), part.points.end());
  for (GroundLine& line : part.lines) {
    for (std::uint32_t* end : {&line.ends.from, &line.ends.to})
      if (*end >= vertices) *end += points;
    line.feature += features;
  }
  out.lines.insert(out.lines.end(), part.lines.begin(), part.lines.end());
  std::ranges::move(part.features, std::back_inserter(out.features));
  out.draped_in_part += part.draped_in_part;
  out.not_draped += part.not_draped;
}

} // namespace

void add_overlays(const TerrainData& terrain, const PlacedView& placed, double above_m,
                  GroundLines& out, std::size_t first, std::size_t most) {
  const std::vector<SomeFeatures> tasks = tasks_of(placed.overlays, terrain.surface);
  out.overlays_are_lifted = above_m > 0;
  // As many as leave no core without work; their number doesn't depend on how many there are.
  constexpr std::size_t kAtOnce = 64;
  const std::size_t lines_before = out.lines.size();
  std::vector<GroundLines> parts;
  std::size_t done = first;
  for (; done < tasks.size() && out.lines.size() - lines_before < most; done += parts.size()) {
    parts.resize(std::min({kAtOnce, tasks.size() - done, most}));
    on_all_cores(parts.size(), [&](std::size_t i) {
      OverlayLines lines(terrain, placed, above_m, parts[i]);
      const auto& [overlay, first_feature, end] = tasks[done + i];
      for (std::size_t k = first_feature; k < end; ++k) {
        throw_if_stopped();
        lines.add(*overlay, overlay->features[k]);
      }
    });
    std::size_t points = 0, lines = 0;
    for (const GroundLines& part : parts) {
      points += part.points.size();
      lines += part.lines.size();
    }
    if (done == first) { // the others have about as many
      const double times =
          std::min(static_cast<double>(tasks.size() - done) / static_cast<double>(parts.size()),
                   1 + static_cast<double>(most) / static_cast<double>(lines + 1));
      const auto all = [&](std::size_t of_these) {
        return static_cast<std::size_t>(1.1 * times * static_cast<double>(of_these));
      };
      out.points.reserve(out.points.size() + all(points));
      out.lines.reserve(out.lines.size() + all(lines));
    }
    for (GroundLines& part : parts) {
      throw_if_stopped();
      append(terrain, std::exchange(part, {}), out);
    }
  }
  if (done < tasks.size()) out.overlays_done = done;
}

} // namespace orograph
