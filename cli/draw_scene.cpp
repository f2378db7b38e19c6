// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/draw_scene.hpp"

#include "cli/read_ground.hpp"
#include "cli/scene_lines.hpp"
#include "cli/sector_ground.hpp"
#include "cli/solids/draw_solids.hpp"
#include "cli/stopwatch.hpp"
#include "cli/sweep_sector.hpp"
#include "draw/dash.hpp"
#include "draw/round_drawing.hpp"
#include "draw/stroke_builder.hpp"
#include "geometry/error.hpp"
#include "geometry/on_all_cores.hpp"

#include <fmt/format.h>

#include <utility>

namespace orograph {
namespace {

// Beside the profiles' pen: ridges and shores a little heavier, border and voids lighter.
constexpr double kSilhouetteWeight = 1.6, kSkylineWeight = 2, kShoreWeight = 1.2;
constexpr double kBorderWeight = 0.8, kBorderGrey = 0.45;
constexpr double kEdgeWeight = 0.6, kEdgeGrey = 0.45;
constexpr double kSolidWeight = 1.4, kHiddenWeight = 0.8, kHiddenGrey = 0.45;
constexpr double kDash_mm = 0.8, kDashGap_mm = 0.5;

Layer empty_layer(const std::string& name, double pen_width_mm, double grey) {
  Layer layer;
  layer.name = name;
  layer.pen_width_mm = pen_width_mm;
  layer.grey = grey;
  return layer;
}

double length_mm(const Layer& layer) {
  double sum = 0;
  for (const Stroke& stroke : layer.strokes) {
    const auto points = layer.points(stroke);
    for (std::size_t i = 1; i < points.size(); ++i) sum += length(points[i] - points[i - 1]);
  }
  return sum;
}

// A layer on its way to the page: what is still to be drawn in it, and what was left out.
struct LineLayer {
  Layer layer;
  std::vector<LinePart> parts;
  bool of_solids = false;  ///< the parts
  bool is_rounded = false; ///< stroke by stroke
  double left_out_mm = 0;
  RoundingCounts dropped = {};
};

std::vector<LinePart> of_kind(const std::vector<SweptLine>& lines,
                              const std::vector<LinePart>& parts, LineKind kind) {
  std::vector<LinePart> out;
  for (const LinePart& part : parts)
    if (lines[part.line].kind == kind) out.push_back(part);
  return out;
}

// Hidden edges under visible ones.
void add_solids(const Scene& scene, const RenderSettings& settings,
                const std::vector<SectorLines>& found, std::vector<LineLayer>& layers) {
  const auto of_all_sectors = [&](std::vector<LinePart> SolidParts::*kind) {
    std::vector<LinePart> parts;
    for (const SectorLines& sector : found) {
      const std::vector<LinePart>& of_sector = sector.solids.*kind;
      parts.insert(parts.end(), of_sector.begin(), of_sector.end());
    }
    join(parts);
    return parts;
  };
  const auto add = [&](const std::string& name, double weight, double grey,
                       std::vector<LinePart> parts) {
    layers.push_back({.layer = empty_layer(name, weight * settings.pen_width_mm, grey),
                      .parts = std::move(parts),
                      .of_solids = true});
  };
  std::vector<LinePart> seen = of_all_sectors(&SolidParts::visible);
  drop_repeated(scene.solids, scene.view, scene.to_page, {}, seen);
  if (settings.dashes_hidden) {
    std::vector<LinePart> unseen = of_all_sectors(&SolidParts::hidden);
    drop_repeated(scene.solids, scene.view, scene.to_page, seen, unseen);
    add("hidden", kHiddenWeight, kHiddenGrey, std::move(unseen));
    layers.back().layer.is_hidden = true;
  }
  if (asks_for(settings, "solids")) add("solids", kSolidWeight, 0, std::move(seen));
}

} // namespace

DrawnScene draw_scene(const Terrain& terrain, const Scene& scene, const RenderSettings& settings,
                      const std::function<void(double)>& progress, const Instruments& instruments) {
  DrawnScene drawn;
  CountsReport& counts = drawn.counts;
  SecondsReport& seconds = drawn.seconds;
  seconds.facing = seconds.cut = seconds.project = seconds.clip = seconds.check = seconds.layout =
      0;
  counts.turned_over = scene.extent.turned_over;
  counts.solids = scene.solids.size();
  for (const StandingSolid& solid : scene.solids) counts.solid_edges += solid.solid->edges.size();
  const View& view = scene.view;
  const MapFrame& map = terrain.map;
  Stopwatch watch;

  StrokeSettings strokes;
  strokes.to_page = scene.to_page;
  strokes.frame_mm = scene.frame_mm;
  strokes.depth = scene.depth;
  strokes.simplify_mm = settings.simplify_mm;
  strokes.min_stroke_mm = settings.min_stroke_mm;
  if (is_tied_to_ground(settings.write.format))
    strokes.to_map = [&](ProfilePoint p) { return map.to_map(to_ground_m(view, p)); };

  const double pen_mm = settings.pen_width_mm;
  Layer profiles = empty_layer("profiles", pen_mm, 0);
  ProfileLayer profile_layer{strokes, profiles};
  const bool draws_profiles = asks_for(settings, "profiles");
  const std::vector<SeenGround> ground = ground_of_sectors(terrain, scene, settings, instruments);
  const std::optional<SeenGround> all_ground = looked_at_by_any(ground);
  const bool on_ground = has_ground(terrain.surface);
  std::vector<SweptLine> lines;
  if (on_ground) lines = lines_of(terrain, scene, settings, all_ground ? &*all_ground : nullptr);
  if (all_ground) counts.looked_at = all_ground->share();
  watch.mark(seconds.facing);

  double profiles_done = 0;
  std::vector<SectorLines> found;
  for (std::size_t i = 0; i < scene.sectors.size(); ++i)
    found.push_back(!on_ground
                        ? solids_alone(scene, scene.sectors[i])
                        : sweep_sector(terrain, scene, scene.sectors[i], lines,
                                       ground.empty() ? nullptr : &ground[i], settings, instruments,
                                       draws_profiles ? &profile_layer : nullptr,
                                       {counts, seconds, drawn.check}, [&] {
                                         progress(++profiles_done /
                                                  static_cast<double>(scene.depths_m.size()));
                                       }));

  watch = {};
  const auto of_all_sectors = [&](std::vector<LinePart> SectorLines::*parts) {
    std::vector<LinePart> all;
    for (const SectorLines& sector : found)
      all.insert(all.end(), (sector.*parts).begin(), (sector.*parts).end());
    if (found.size() > 1 && on_ground)
      join_sectors(terrain.surface, view, lines,
                   scene.sectors.front().keeps_strip ? view.near_m : 0, all);
    return all;
  };
  std::vector<LineLayer> layers; // in drawing order
  if (draws_profiles) {
    layers.push_back({.layer = std::move(profiles), .parts = {}, .is_rounded = true});
    counts.dropped_strokes += profile_layer.dropped_strokes;
  }
  const std::vector<LinePart> visible = of_all_sectors(&SectorLines::visible);
  const auto add_visible = [&](const std::string& name, double weight, double grey, LineKind kind) {
    if (asks_for(settings, name))
      layers.push_back({.layer = empty_layer(name, weight * pen_mm, grey),
                        .parts = of_kind(lines, visible, kind)});
  };
  add_visible("edges", kEdgeWeight, kEdgeGrey, LineKind::edge);
  add_visible("shores", kShoreWeight, 0, LineKind::shore);
  add_visible("border", kBorderWeight, kBorderGrey, LineKind::border);
  add_visible("voids", kBorderWeight, kBorderGrey, LineKind::void_edge);
  add_visible("silhouettes", kSilhouetteWeight, 0, LineKind::silhouette);
  if (asks_for(settings, "skyline"))
    layers.push_back({.layer = empty_layer("skyline", kSkylineWeight * pen_mm, 0),
                      .parts = of_all_sectors(&SectorLines::skyline)});
  if (!scene.solids.empty()) add_solids(scene, settings, found, layers);
  LineLayer folded{{}, of_all_sectors(&SectorLines::folded)};
  on_all_cores(layers.size() + 1, [&](std::size_t i) {
    LineLayer& task = i < layers.size() ? layers[i] : folded;
    StrokeBuilder builder(strokes, task.layer);
    if (task.of_solids)
      draw_edges(scene.solids, view, task.parts, builder);
    else
      draw_parts(terrain.surface, view, lines, task.parts, builder);
    if (task.layer.is_hidden && !strokes.to_map)
      task.layer = dashed(task.layer, kDash_mm, kDashGap_mm);
    task.left_out_mm = builder.left_out_mm();
    if (&task != &folded)
      task.dropped =
          task.is_rounded ? drop_repeated_strokes(task.layer) : round_to_page_step(task.layer);
  });
  drawn.left_out.silhouette_jump_mm = length_mm(folded.layer);

  Drawing& drawing = drawn.drawing;
  drawing.page = scene.page;
  drawing.crs_wkt = map.crs_wkt;
  drawn.left_out.min_stroke_mm = profile_layer.left_out_mm;
  for (LineLayer& of_lines : layers) {
    drawn.left_out.min_stroke_mm += of_lines.left_out_mm;
    const RoundingCounts& dropped = of_lines.dropped;
    counts.dropped_strokes += dropped.empty_strokes + dropped.repeated_strokes;
    counts.strokes += of_lines.layer.strokes.size();
    counts.points += of_lines.layer.page_mm.size();
    drawing.layers.push_back(std::move(of_lines.layer));
  }
  watch.mark(seconds.layout);
  return drawn;
}

void check_not_empty(const DrawnScene& drawn, const RenderSettings& settings) {
  if (drawn.counts.strokes == 0)
    throw Error(fmt::format("nothing of the {} is on the page",
                            is_scene(settings.inputs.front()) ? "scene" : "terrain"),
                settings.view
                    ? "turn the view towards it, or widen its window"
                    : "turn the view towards it, widen --fov, or raise an eye that faces a slope");
}

} // namespace orograph
