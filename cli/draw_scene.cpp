// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/draw_scene.hpp"

#include "cli/check.hpp"
#include "cli/line_sweep.hpp"
#include "cli/tie_tolerance.hpp"
#include "draw/round_drawing.hpp"
#include "horizon/clip.hpp"
#include "profiles/cut_grid.hpp"
#include "profiles/project_profile.hpp"
#include "profiles/silhouettes.hpp"

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

bool asks_for(const RenderSettings& settings, std::string_view layer) {
  return std::find(settings.layers.begin(), settings.layers.end(), layer) != settings.layers.end();
}

// Feeds the visible pieces of one profile to a builder: pieces that meet are one stroke, and level
// ground is left out where its shores are drawn instead.
class ProfileStrokes {
public:
  ProfileStrokes(const View& view, bool draws_level, StrokeBuilder& builder)
      : view_(view), draws_level_(draws_level), builder_(builder) {}

  void add(const Profile& profile, std::int32_t number, const std::vector<Segment>& segments,
           const std::vector<Piece>& visible) {
    bool open = false;
    std::uint32_t open_vertex = 0; // where the open stroke ends, if it ends at a vertex
    bool at_vertex = false;
    for (const Piece& piece : visible) {
      const std::uint32_t left = left_vertex(segments[piece.segment]);
      if (profile.after[left] == Span::level && !draws_level_) continue;
      if (!(open && at_vertex && piece.t_begin <= 0 && joined(profile, open_vertex, left))) {
        if (open) builder_.end();
        builder_.begin(number, profile.depth_m);
        builder_.add(point(profile, left, piece.t_begin));
        open = true;
      }
      builder_.add(point(profile, left, piece.t_end));
      at_vertex = piece.t_end >= 1;
      open_vertex = left + 1;
    }
    if (open) builder_.end();
  }

private:
  // Whether vertex `from` and a later one are one point of the profile: only spans without any
  // extent in X, which have no segment, lie between them.
  static bool joined(const Profile& profile, std::uint32_t from, std::uint32_t to) {
    if (from > to) return false;
    for (std::uint32_t i = from; i < to; ++i)
      if (profile.after[i] == Span::gap || profile.u_m[i] < profile.u_m[i + 1]) return false;
    return true;
  }

  StrokePoint point(const Profile& profile, std::uint32_t left, double t) const {
    const auto at = [&](std::uint32_t i) {
      return ProfilePoint{profile.u_m[i], profile.depth_m, profile.z_m[i]};
    };
    const ProfilePoint scene = point_between(at(left), at(left + 1), t);
    return {project(view_, scene), scene};
  }

  const View& view_;
  bool draws_level_;
  StrokeBuilder& builder_;
};

// All lines but the profiles. With the seed's occluders only what is drawn of the profiles hides.
std::vector<SweptLine> lines_of(const Terrain& terrain, const Scene& scene,
                                const RenderSettings& settings) {
  const bool surface = settings.occluder == Occluder::surface;
  const bool silhouettes = asks_for(settings, "silhouettes") || asks_for(settings, "skyline");
  const bool border = asks_for(settings, "border");
  std::vector<SweptLine> lines;
  std::vector<GridEdge> edges;
  if (surface || silhouettes) edges = silhouette_edges(terrain.grid, scene.view);
  for (const GridEdge& edge : edges)
    lines.push_back({edge, LineKind::silhouette, surface, silhouettes});
  if (surface || border)
    for (const BorderEdge& edge : scene.border)
      lines.push_back({edge.edge, LineKind::border, surface, border});
  if (asks_for(settings, "shores")) {
    // A shore that is a silhouette as well is drawn as such, once.
    const auto before = [](const GridEdge& a, const GridEdge& b) {
      return a.from != b.from ? a.from < b.from : a.to < b.to;
    };
    if (!silhouettes) edges.clear();
    std::sort(edges.begin(), edges.end(), before);
    for (const GridEdge& edge : scene.level.shores)
      if (!std::binary_search(edges.begin(), edges.end(), edge, before))
        lines.push_back({edge, LineKind::shore, false, true});
  }
  return lines;
}

// Where the near plane cuts the terrain, a section begins: the cut hides.
void raise_near_cut(const GridCutter& cutter, const View& view, Horizon& horizon,
                    ClipWorkspace& workspace) {
  Profile cut;
  std::vector<Segment> segments;
  cutter.cut(view.near_m, cut);
  constexpr std::uint32_t kNearCut = 0x7fffffff; // no profile has this number
  project_profile(cut, kNearCut, view, segments);
  clip(segments, horizon, {Role::occluder, {}, true}, workspace);
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
                      const std::function<void(double)>& progress) {
  DrawnScene drawn;
  CountsReport& counts = drawn.counts;
  SecondsReport& seconds = drawn.seconds;
  seconds.facing = seconds.cut = seconds.project = seconds.clip = seconds.check = seconds.layout =
      0;
  const View& view = scene.view;
  const MapFrame& map = terrain.map;
  const bool surface = settings.occluder == Occluder::surface;
  Stopwatch watch;

  StrokeSettings strokes{
      scene.to_page, scene.page.inner_mm(), settings.simplify_mm, view.is_perspective(), {}};
  if (is_tied_to_ground(settings.write.format))
    strokes.to_map = [&](ProfilePoint p) { return map.to_map(to_ground_m(view, p)); };

  const double pen_mm = settings.pen_width_mm;
  Layer profiles = empty_layer("profiles", pen_mm, 0);
  StrokeBuilder profile_builder(strokes, profiles);
  const bool draws_profiles = asks_for(settings, "profiles");
  ProfileStrokes profile_strokes(view, settings.flat == FlatGround::draw, profile_builder);

  const GridCutter cutter(terrain.grid, view, scene.level.triangles);
  const double from_m =
      view.is_perspective() ? view.near_m : -std::numeric_limits<double>::infinity();
  LineSweep lines(terrain.grid, view, lines_of(terrain, scene, settings), from_m);
  watch.mark(seconds.facing);

  const TieTolerance tolerance = tie_tolerance(scene, settings.visibility_tolerance_mm);
  const ClipOptions clip_options{surface ? Role::compared : Role::drawn_occluder, tolerance, true};
  // Half of the points of a check are asked of profiles, half of the other lines.
  std::optional<Check> check;
  if (settings.check > 0) check.emplace(terrain.grid, view, tolerance);
  const std::uint64_t asked_a_profile = settings.check / 2 / scene.depths_m.size() + 1;
  Horizon horizon = initial_horizon();
  Profile profile;
  std::vector<Segment> segments;
  ClipWorkspace workspace;
  if (surface && view.is_perspective()) raise_near_cut(cutter, view, horizon, workspace);

  // Slabs are about a cell thick, so that few lines meet in one.
  double plane = std::max(cutter.nearest_m(), from_m);
  const double thickness = cell_size_m(terrain.grid);
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
    project_profile(profile, static_cast<std::uint32_t>(i), view, segments);
    watch.mark(seconds.project);
    clip(segments, horizon, clip_options, workspace);
    watch.mark(seconds.clip);
    if (draws_profiles)
      profile_strokes.add(profile, static_cast<std::int32_t>(i), segments, workspace.visible);
    watch.mark(seconds.layout);
    if (check) check->ask(profile, segments, workspace.visible, asked_a_profile);
    watch.mark(seconds.check);

    counts.cut_vertices += profile.size();
    counts.segments += segments.size();
    counts.largest_horizon = std::max<std::uint64_t>(counts.largest_horizon, horizon.size());
    progress(static_cast<double>(i + 1) / static_cast<double>(scene.depths_m.size()));
  }
  if (plane < cutter.farthest_m()) take_slabs(cutter.farthest_m());
  lines.take_slab(std::numeric_limits<double>::infinity(), horizon, workspace);
  watch.mark(seconds.clip);

  lines.finish();
  const std::vector<LinePart> skyline = lines.skyline(horizon);
  const std::vector<LinePart> visible = without(lines.visible_parts(), skyline);
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
    drawing.layers.push_back(std::move(layer));
  };
  if (draws_profiles) drawing.layers.push_back(std::move(profiles));
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
