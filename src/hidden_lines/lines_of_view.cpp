// SPDX-License-Identifier: GPL-3.0-or-later
#include "hidden_lines/lines_of_view.hpp"

#include "hidden_lines/lattice_pass.hpp"
#include "hidden_lines/lines_by_sector.hpp"
#include "hidden_lines/surface_lines.hpp"
#include "placing/contours.hpp"
#include "placing/sector.hpp"
#include "profiles/lattice_order.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>

namespace orograph {

const Grid* grid_in_order(const TerrainData& terrain, const Style& style,
                          const Instruments& instruments) {
  const Grid* grid = std::get_if<Grid>(&terrain.surface);
  const bool has_order = grid && style.occluder == Occluder::surface &&
                         style.underside == Underside::omit && !instruments.needs_list();
  return has_order ? grid : nullptr;
}

namespace {

bool asks_lines(const Instruments& instruments) {
  return std::any_of(instruments.observers.begin(), instruments.observers.end(),
                     [](const LineObserver* observer) { return observer->asks_lines(); });
}

} // namespace

// A panorama's profiles turn at its sectors' borders.
XRange asked_range(const Sector& sector, bool in_list, const Instruments& instruments) {
  return !sector.frame_mm && (in_list || instruments.beyond_page) ? XRange{-kInfinity, kInfinity}
                                                                  : page_range(sector);
}

namespace {

// None where an eye before the terrain sees all of it.
std::vector<SheetPart> parts_by_sector(const Surface& surface, const Sheet& sheet,
                                       const PlacedView& placed, const Instruments& instruments) {
  const View& view = placed.view;
  if (!view.is_perspective() || (view.frames_terrain && placed.sectors.size() == 1)) return {};
  std::vector<AzimuthWedge> wedges;
  for (const Sector& sector : placed.sectors) {
    const XRange x = asked_range(sector, instruments.needs_list(), instruments);
    const double forward = sector.behind ? std::numbers::pi : sector.azimuth;
    wedges.push_back({forward + std::atan(x.begin), forward + std::atan(x.end)});
  }
  return parts_in_wedges(surface, sheet.triangles, view, wedges);
}

// Rims of a block's voids, where their edges are asked for in any case, as parts of the skyline.
void see_rims_as_edges(const TerrainData& terrain, const PlacedView& placed, const Style& style,
                       LinesOfView& out) {
  const std::vector<RimLine>& rims = out.on_ground.rims;
  if (rims.empty() || out.sheet || !std::holds_alternative<Grid>(terrain.surface) ||
      !outlines_terrain(style, placed.view))
    return;
  const auto is_of_border = [](const EdgeLine& line) {
    return line.kind == LineKind::border || line.kind == LineKind::void_edge;
  };
  const auto first = std::ranges::find_if(out.listed, is_of_border) - out.listed.begin();
  const std::size_t first_on_ground = out.listed.size() - out.on_ground.lines.size();
  for (const auto& [line, border_edge, is_turned] : rims) {
    const std::size_t of_edge = static_cast<std::size_t>(first) + border_edge;
    const EdgeLine& edge = out.listed[of_edge];
    if (!edge.drawn || edge.edge != placed.border[border_edge].edge) continue;
    EdgeLine& rim = out.listed[first_on_ground + line];
    rim.drawn = false;
    if (out.seen_with.size() <= of_edge) out.seen_with.resize(of_edge + 1);
    out.seen_with[of_edge] = {static_cast<std::uint32_t>(first_on_ground + line), is_turned};
  }
}

// Whether there are so many contours that the order pays, in which they are found and cost half. If
// hidden ones are wanted they are listed, and the order stays: what is visible is the same with
// hidden lines and without. On the earth, to find out whether there is one takes some
// nanoseconds a vertex, as much as slabs cost on smooth ground: of a smooth tile of 3601² a drawing
// with 3 contours took 1.13 times as long in order, with 100 of them half as long; a level costs it
// 40 ms in a list.
bool asks_contours(const TerrainData& terrain, const Style& style, const PlacedView& placed) {
  constexpr std::size_t kLeastLevels = 8;
  return (style.asks_for("contours") || style.draws_index_contours()) && placed.solids.empty() &&
         placed.sectors.size() == 1 &&
         contour_levels(terrain, style.contours).heights_m.size() >= kLeastLevels;
}

// Where there is a sector behind another, lines lie between the two, and have no place in the
// order. Each of a panorama's sectors would be looked through anew.
std::optional<EarthStrips> earth_strips_of(const Grid& grid, const TerrainData& terrain,
                                           const PlacedView& placed,
                                           const Instruments& instruments) {
  if (placed.extent.turned_over > 0 || placed.sectors.size() != 1) return std::nullopt;
  const Sector& sector = placed.sectors.front();
  const View& view = sector.view;
  const double from_m = view.is_perspective() ? view.near_m : -kInfinity;
  const std::vector<EdgeLine> none;
  const LinePictures pictures(terrain.surface, placed.reach_m, {}, sector, none,
                              asked_range(sector, false, instruments), from_m);
  return EarthStrips::of(grid, view, {pictures.looked_at(), from_m});
}

} // namespace

const SilhouetteMarks* LinesOfView::silhouettes_by(bool rows_are_strips) const {
  for (const std::optional<SilhouetteMarks>* marks : {&silhouettes, &turned_silhouettes})
    if (*marks && (*marks)->rows_are_strips == rows_are_strips) return &**marks;
  return nullptr;
}

LinesOfView lines_of_view(const TerrainData& terrain, const PlacedView& placed, const Style& style,
                          const Instruments& instruments, const SeenGround* ground,
                          const HiddenKinds& hidden) {
  LinesOfView out;
  out.hidden = hidden;
  const Grid* grid = grid_in_order(terrain, style, instruments);
  const LinesTaken taken{style.asks_for("profiles") || !instruments.observers.empty(),
                         grid && asks_contours(terrain, style, placed)};
  // Strips are found with a look at all ground, which an eye that sees little of it doesn't need.
  constexpr double kMost = 0.5;
  if (grid && grid->is_on_earth() && placed.sectors.size() == 1 &&
      (instruments.order_always || taken.contours ||
       ((!ground || ground->share() > kMost) &&
        may_pay_on_earth(*grid, placed.sectors.front(), taken.profiles))))
    out.earth_strips = earth_strips_of(*grid, terrain, placed, instruments);
  const EarthStrips* const strips = out.earth_strips ? &*out.earth_strips : nullptr;
  if (grid && (!grid->is_on_earth() || strips))
    for (const Sector& sector : placed.sectors)
      out.in_order.push_back(instruments.order_always ||
                             pays_in_order(*grid, sector, strips, taken));
  // Solids are hidden by all lines that hide.
  const bool finds = !out.in_order.empty() && !asks_lines(instruments) && placed.solids.empty() &&
                     std::ranges::all_of(out.in_order, std::identity());
  const bool finds_contours = finds && placed.sectors.size() == 1 &&
                              !hidden.has(LineKind::contour) &&
                              !hidden.has(LineKind::index_contour);
  // Who watches wants all lines, and with solids or undersides a pass costs more than memory.
  const bool in_batches = instruments.observers.empty() && placed.solids.empty() &&
                          style.underside == Underside::omit && !instruments.needs_list();
  out.on_ground = ground_lines_of(terrain, placed, style, ground, !finds_contours,
                                  in_batches ? instruments.most_draped
                                             : std::numeric_limits<std::size_t>::max());
  if (style.underside == Underside::draw) {
    out.sheet = sheet_of(terrain.surface, placed.view);
    out.sheet_parts = parts_by_sector(terrain.surface, *out.sheet, placed, instruments);
    out.listed = lines_of_sheet(terrain, placed, style, *out.sheet);
  } else if (!finds || hidden.has(LineKind::silhouette)) {
    out.listed = lines_of(terrain, placed, style, ground);
  } else {
    const auto by_rows = [&](const Sector& sector) {
      return strips ? strips->are_rows() : LatticeOrder(*grid, sector.view).rows_are_strips();
    };
    const bool first = by_rows(placed.sectors.front());
    out.listed = lines_but_silhouettes(terrain, placed, style);
    out.silhouettes = silhouette_marks(*grid, placed.view, first, ground);
    if (std::ranges::any_of(placed.sectors,
                            [&](const Sector& sector) { return by_rows(sector) != first; }))
      out.turned_silhouettes = silhouette_marks(*grid, placed.view, !first, ground);
  }
  append_to(out.listed, out.on_ground);
  see_rims_as_edges(terrain, placed, style, out);
  if (placed.panorama)
    out.by_sector = lines_by_sector(terrain.surface, out.on_ground.points, placed, out.listed);
  return out;
}

bool take_more_overlays(const TerrainData& terrain, const PlacedView& placed, const Style& style,
                        const Instruments& instruments, LinesOfView& lines) {
  if (!lines.on_ground.overlays_done) return false;
  const std::size_t done = *lines.on_ground.overlays_done;
  lines.listed.resize(lines.listed.size() - lines.on_ground.lines.size());
  lines.on_ground = {};
  lines.seen_with.clear();
  lines.are_more_overlays = true;
  add_overlays(terrain, placed, style.overlay_above_m, lines.on_ground, done,
               instruments.most_draped);
  append_to(lines.listed, lines.on_ground);
  if (placed.panorama)
    lines.by_sector =
        lines_by_sector(terrain.surface, lines.on_ground.points, placed, lines.listed);
  return true;
}

} // namespace orograph
