// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/draw_scene.hpp"

#include "cli/check.hpp"
#include "cli/line_sweep.hpp"
#include "cli/profile_strokes.hpp"
#include "cli/scene_lines.hpp"
#include "cli/tie_tolerance.hpp"
#include "draw/round_drawing.hpp"
#include "horizon/clip.hpp"
#include "horizon/upright.hpp"
#include "profiles/cut_surface.hpp"
#include "profiles/project_profile.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <optional>

namespace orograph {
namespace {

// Beside the profiles' pen: ridges and shores a little heavier, the border lighter.
constexpr double kSilhouetteWeight = 1.6, kSkylineWeight = 2, kShoreWeight = 1.2;
constexpr double kBorderWeight = 0.8, kBorderGrey = 0.45;
constexpr double kEdgeWeight = 0.6, kEdgeGrey = 0.45;

// What is that close in X to a profile's way along a wall counts as being at it.
double beside_walls(const std::vector<Segment>& uprights, const View& view, double depth_m,
                    double rounding_m) {
  if (!view.is_perspective()) return rounding_m;
  double greatest_x = 0;
  for (const Segment& s : uprights) greatest_x = std::max(greatest_x, std::abs(s.x0));
  return rounding_m * (1 + greatest_x) / depth_m;
}

// Adds the time since the last mark to a stage.
class Stopwatch {
public:
  void mark(double& stage_s) {
    const auto now = std::chrono::steady_clock::now();
    stage_s += std::chrono::duration<double>(now - last_).count();
    last_ = now;
  }

private:
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

Layer empty_layer(const std::string& name, double pen_width_mm, double grey) {
  Layer layer;
  layer.name = name;
  layer.pen_width_mm = pen_width_mm;
  layer.grey = grey;
  return layer;
}

// Where the near plane cuts the terrain, a section begins: the cut hides.
void raise_near_cut(const SurfaceCutter& cutter, const View& view, Horizon& horizon,
                    ClipWorkspace& workspace) {
  Profile cut;
  std::vector<Segment> segments, uprights;
  cutter.cut(view.near_m, cut);
  constexpr std::uint32_t kNearCut = 0x7fffffff; // no profile has this number
  project_profile(cut, kNearCut, view, segments, uprights);
  clip(segments, horizon, {Role::occluder, {}, true}, workspace);
}

double length_mm(const Layer& layer) {
  double sum = 0;
  for (const Stroke& stroke : layer.strokes) {
    const auto points = layer.points(stroke);
    for (std::size_t i = 1; i < points.size(); ++i) sum += length(points[i] - points[i - 1]);
  }
  return sum;
}

std::vector<LinePart> of_kind(const LineSweep& sweep, const std::vector<LinePart>& parts,
                              LineKind kind) {
  std::vector<LinePart> out;
  for (const LinePart& part : parts)
    if (sweep.line(part.line).kind == kind) out.push_back(part);
  return out;
}

} // namespace

DrawnScene draw_scene(const Terrain& terrain, const Scene& scene, const RenderSettings& settings,
                      const std::function<void(double)>& progress, const Instruments& instruments) {
  DrawnScene drawn;
  CountsReport& counts = drawn.counts;
  SecondsReport& seconds = drawn.seconds;
  seconds.facing = seconds.cut = seconds.project = seconds.clip = seconds.check = seconds.layout =
      0;
  const View& view = scene.view;
  const MapFrame& map = terrain.map;
  const bool surface = settings.occluder == Occluder::surface;
  Stopwatch watch;

  StrokeSettings strokes;
  strokes.to_page = scene.to_page;
  strokes.frame_mm = scene.page.inner_mm();
  strokes.simplify_mm = settings.simplify_mm;
  strokes.min_stroke_mm = settings.min_stroke_mm;
  strokes.perspective = view.is_perspective();
  if (is_tied_to_ground(settings.write.format))
    strokes.to_map = [&](ProfilePoint p) { return map.to_map(to_ground_m(view, p)); };

  const double pen_mm = settings.pen_width_mm;
  Layer profiles = empty_layer("profiles", pen_mm, 0);
  StrokeBuilder profile_builder(strokes, profiles);
  const bool draws_profiles = asks_for(settings, "profiles");
  ProfileStrokes profile_strokes(view, settings.flat == FlatGround::draw, profile_builder);

  const SurfaceCutter cutter(terrain.surface, view, scene.level.triangles);
  const double from_m =
      view.is_perspective() ? view.near_m : -std::numeric_limits<double>::infinity();
  const TieTolerance tolerance = tie_tolerance(scene, settings.visibility_tolerance_mm);
  LineSweep lines(terrain.surface, view, lines_of(terrain, scene, settings), from_m, tolerance);
  watch.mark(seconds.facing);

  const ClipOptions clip_options{surface ? Role::compared : Role::drawn_occluder, tolerance,
                                 instruments.collapse};
  // Half of the points of a check are asked of profiles, half of the other lines.
  std::optional<Check> check;
  if (settings.check > 0) check.emplace(terrain.surface, view, tolerance);
  const std::uint64_t asked_a_profile = settings.check / 2 / scene.depths_m.size() + 1;
  Horizon horizon = initial_horizon();
  Profile profile;
  std::vector<Segment> segments, uprights;
  ClipWorkspace workspace;
  if (surface && view.is_perspective()) raise_near_cut(cutter, view, horizon, workspace);

  // Slabs are about a cell thick, so that few lines meet in one.
  double plane = std::max(scene.nearest_m, from_m);
  const double thickness = scene.cell_m;
  const auto take_slabs = [&](double to_m) {
    const double count = surface ? std::ceil((to_m - plane) / thickness) : 1;
    for (int i = 1; i < count; ++i)
      lines.take_slab(plane + (to_m - plane) * (i / count), horizon, workspace);
    lines.take_slab(to_m, horizon, workspace);
    plane = to_m;
  };
  for (std::size_t i = 0; i < scene.depths_m.size(); ++i) {
    take_slabs(scene.depths_m[i]);
    watch.mark(seconds.clip);
    cutter.cut(scene.depths_m[i], profile);
    watch.mark(seconds.cut);
    project_profile(profile, static_cast<std::uint32_t>(i), view, segments, uprights);
    if (instruments.single_precision) round_to_float(segments);
    watch.mark(seconds.project);
    const std::vector<Piece> on_walls = visible_uprights(
        uprights, horizon, beside_walls(uprights, view, scene.depths_m[i], lines.rounding_m()));
    clip(segments, horizon, clip_options, workspace);
    if (!uprights.empty()) insert_uprights(uprights, on_walls, segments, workspace.visible);
    watch.mark(seconds.clip);
    if (draws_profiles)
      profile_strokes.add(profile, static_cast<std::int32_t>(i), segments, workspace.visible);
    watch.mark(seconds.layout);
    if (check) check->ask(profile, segments, workspace.visible, asked_a_profile);
    if (instruments.observer) instruments.observer->see(profile, segments, workspace.visible);
    watch.mark(seconds.check);

    counts.cut_vertices += profile.size();
    counts.segments += segments.size();
    counts.largest_horizon = std::max<std::uint64_t>(counts.largest_horizon, horizon.size());
    progress(static_cast<double>(i + 1) / static_cast<double>(scene.depths_m.size()));
  }
  if (plane < scene.farthest_m) take_slabs(scene.farthest_m);
  lines.take_slab(std::numeric_limits<double>::infinity(), horizon, workspace);
  watch.mark(seconds.clip);

  lines.finish();
  const std::vector<LinePart> skyline = lines.skyline(horizon);
  std::vector<LinePart> visible = without(lines.visible_parts(), skyline);
  const std::vector<LinePart> folded =
      folds(lines, visible, terrain.surface, view, settings.silhouette_jump,
            scene.farthest_m - scene.nearest_m);
  visible = without(visible, folded);
  watch.mark(seconds.layout);
  if (instruments.observer) instruments.observer->see(lines, lines.visible_parts());
  if (check) {
    check->ask(lines, lines.visible_parts(), settings.check / 2);
    drawn.check = check->counts();
  }
  watch.mark(seconds.check);
  Drawing& drawing = drawn.drawing;
  drawing.page = scene.page;
  drawing.crs_wkt = map.crs_wkt;
  const auto add_lines = [&](const std::vector<LinePart>& parts, const std::string& name,
                             double weight, double grey) {
    if (!asks_for(settings, name)) return;
    Layer layer = empty_layer(name, weight * pen_mm, grey);
    StrokeBuilder builder(strokes, layer);
    draw_parts(lines, parts, view, builder);
    drawn.left_out.min_stroke_mm += builder.left_out_mm();
    drawing.layers.push_back(std::move(layer));
  };
  Layer left_out;
  StrokeBuilder left_out_builder(strokes, left_out);
  draw_parts(lines, folded, view, left_out_builder);
  drawn.left_out.silhouette_jump_mm = length_mm(left_out);
  drawn.left_out.min_stroke_mm = profile_builder.left_out_mm();
  if (draws_profiles) drawing.layers.push_back(std::move(profiles));
  add_lines(of_kind(lines, visible, LineKind::edge), "edges", kEdgeWeight, kEdgeGrey);
  add_lines(of_kind(lines, visible, LineKind::shore), "shores", kShoreWeight, 0);
  add_lines(of_kind(lines, visible, LineKind::border), "border", kBorderWeight, kBorderGrey);
  add_lines(of_kind(lines, visible, LineKind::silhouette), "silhouettes", kSilhouetteWeight, 0);
  add_lines(skyline, "skyline", kSkylineWeight, 0);
  for (Layer& layer : drawing.layers) {
    const RoundingCounts dropped = round_to_page_step(layer);
    counts.dropped_strokes += dropped.empty_strokes + dropped.repeated_strokes;
    counts.strokes += layer.strokes.size();
    counts.points += layer.page_mm.size();
  }
  watch.mark(seconds.layout);
  counts.ties = workspace.ties;
  counts.pieces_before_collapse = workspace.pieces_uncollapsed;
  counts.pieces_after_collapse = workspace.pieces_collapsed;
  return drawn;
}

} // namespace orograph
