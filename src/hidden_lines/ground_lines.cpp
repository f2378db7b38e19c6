// SPDX-License-Identifier: GPL-3.0-or-later
#include "hidden_lines/ground_lines.hpp"

#include "geometry/on_all_cores.hpp"
#include "hidden_lines/contour_ticks.hpp"
#include "placing/contours.hpp"
#include "placing/coordinate_lines.hpp"
#include "placing/place_waterlines.hpp"
#include "placing/vertex_values.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace orograph {
namespace {

constexpr std::size_t kOfTask = std::size_t{1} << 16U;

// Vertices in the profile frame, the last few thousand of which are kept: as many as two rows of a
// large grid, so that of each vertex most edges find it there.
class KeptVertices {
public:
  /// REQUIRES that both outlive it.
  KeptVertices(const Surface& surface, const View& view) : ends_(surface, view) {}

  ProfilePoint operator()(std::uint32_t vertex) {
    Kept& kept = kept_[vertex % kept_.size()];
    if (kept.vertex != vertex) kept = {vertex, ends_.vertex(vertex)};
    return kept.at;
  }

private:
  struct Kept {
    std::uint32_t vertex = kNoVertex;
    ProfilePoint at;
  };
  static constexpr std::uint32_t kNoVertex = std::numeric_limits<std::uint32_t>::max();
  EdgeEnds ends_;
  std::vector<Kept> kept_ = std::vector<Kept>(std::size_t{1} << 13U);
};

// Adds lines whose levels are the features from number `first_feature` on. There is to be room for
// `more` lines after them, so that they aren't copied.
void add(const Surface& surface, const View& view, const Isolines& found, std::size_t first_feature,
         GroundLines& out, std::size_t more = 0) {
  const auto vertices = static_cast<std::uint32_t>(vertex_count(surface));
  const std::size_t points = out.points.size(), lines = out.lines.size();
  out.points.reserve(points + found.points.size() + more);
  out.lines.reserve(lines + found.lines.size() + more);
  out.points.resize(points + found.points.size());
  out.lines.resize(lines + found.lines.size());
  const std::size_t most = std::max(found.points.size(), found.lines.size());
  on_all_cores((most + kOfTask - 1) / kOfTask, [&](std::size_t task) {
    const auto end = [&](std::size_t size) { return std::min(size, (task + 1) * kOfTask); };
    KeptVertices vertex(surface, view);
    for (std::size_t i = task * kOfTask; i < end(found.points.size()); ++i) {
      const auto& [edge, t] = found.points[i];
      out.points[points + i] = point_between(vertex(edge.from), vertex(edge.to), t);
    }
    const auto number = [&](std::uint32_t of_end) {
      return of_end < vertices ? of_end : of_end + static_cast<std::uint32_t>(points);
    };
    for (std::size_t i = task * kOfTask; i < end(found.lines.size()); ++i) {
      const auto& [from, to, triangle, level] = found.lines[i];
      out.lines[lines + i] = {
          {number(from), number(to)}, triangle, static_cast<std::uint32_t>(first_feature + level)};
    }
  });
}

void add_coordinate_lines(const TerrainData& terrain, const PlacedView& placed,
                          const SeenGround* ground, LineKind kind,
                          const std::vector<CoordinateLines>& wanted, GroundLines& out) {
  for (const auto& [coordinate, values, levels, exact] : wanted) {
    const std::size_t first = out.features.size();
    for (const double level : exact) out.features.push_back({kind, {{coordinate, level}}});
    add(terrain.surface, placed.view, isolines(terrain.surface, values, levels, {.seen = ground}),
        first, out);
  }
}

// On a map plane what places the view has seen the heights already.
ContourLevels levels_of(const TerrainData& terrain, const PlacedView& placed,
                        const ContourSpec& spec) {
  const Grid* grid = std::get_if<Grid>(&terrain.surface);
  if (!grid || grid->is_on_earth()) return contour_levels(terrain, spec);
  const Box3& box = placed.extent.box;
  return contour_levels(terrain, {box.low.z, box.high.z}, spec);
}

} // namespace

GroundLines ground_lines_of(const TerrainData& terrain, const PlacedView& placed,
                            const Style& style, const SeenGround* ground, bool lists_contours,
                            std::size_t most_draped) {
  GroundLines out;
  const Surface& surface = terrain.surface;
  if (style.draws_waterlines()) {
    const Isolines lines = place_waterlines(placed, surface, style.pen_width_mm);
    // A feature for all of them, whatever the distance.
    out.features.push_back({LineKind::waterline, {}});
    add(surface, placed.view, lines, 0, out);
    for (GroundLine& line : out.lines) line.feature = 0;
  }
  if (style.asks_for("contours") || style.draws_index_contours()) {
    const ContourLevels levels = levels_of(terrain, placed, style.contours);
    const std::size_t first = out.features.size();
    for (std::size_t i = 0; i < levels.heights.size(); ++i)
      out.features.push_back({levels.is_index[i] ? LineKind::index_contour : LineKind::contour,
                              {{"elevation", levels.heights[i]}}});
    out.first_contour = first;
    if (lists_contours) {
      // About as many as walls have, of which few are seen from top to bottom.
      const std::size_t of_block = style.asks_for("block") ? 5 * placed.border.size() : 0;
      add(surface, placed.view,
          isolines(surface, heights_of(terrain), levels.heights_m, {.seen = ground}), first, out,
          of_block);
    } else {
      out.levels_to_find_m = levels.heights_m;
    }
    if (style.contours.ticks) add_contour_ticks(terrain, placed, levels, out);
  }
  if (style.asks_for("mesh"))
    add_coordinate_lines(terrain, placed, ground, LineKind::mesh,
                         mesh_lines(terrain, placed.view, style.mesh), out);
  if (style.asks_for("graticule"))
    add_coordinate_lines(terrain, placed, ground, LineKind::graticule,
                         graticule_lines(terrain, style.graticule_deg), out);
  if (style.asks_for("grid"))
    add_coordinate_lines(terrain, placed, ground, LineKind::grid,
                         map_grid_lines(terrain, style.grid_m), out);
  if (style.asks_for("hachures")) add_hachures(terrain, placed, style, out);
  if (style.asks_for("block")) add_block(terrain, placed, style, ground, out);
  if (style.asks_for("drape"))
    add_overlays(terrain, placed, style.overlay_above_m, out, 0, most_draped);
  return out;
}

double mm_a_metre_at(const PlacedView& placed, ProfilePoint at) {
  if (!placed.panorama) return placed.mm_per_step(at, {1, 0, 0});
  const Vec2 across = (1 / std::hypot(at.u, at.v)) * Vec2{at.v, -at.u};
  return placed.mm_per_step(at, {across.x, across.y, 0});
}

void append_to(std::vector<EdgeLine>& lines, const GroundLines& on_ground) {
  lines.reserve(lines.size() + on_ground.lines.size());
  for (const GroundLine& line : on_ground.lines) {
    throw_if_stopped(lines.size());
    lines.push_back({line.ends, on_ground.features[line.feature].kind, false, true, false});
  }
}

} // namespace orograph
