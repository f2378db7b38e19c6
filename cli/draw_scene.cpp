// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/draw_scene.hpp"

#include "cli/line_layer.hpp"
#include "cli/tie_tolerance.hpp"
#include "draw/round_drawing.hpp"
#include "horizon/clip.hpp"
#include "profiles/cut_grid.hpp"
#include "profiles/project_profile.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <limits>

namespace orograph {
namespace {

// Beside the profiles' pen: shores a little heavier, the border lighter.
constexpr double kShoreWeight = 1.4, kBorderWeight = 0.8, kBorderGrey = 0.45;

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

} // namespace

DrawnScene draw_scene(const Terrain& terrain, const Scene& scene, const RenderSettings& settings,
                      const std::function<void(double)>& progress) {
  DrawnScene drawn;
  CountsReport& counts = drawn.counts;
  SecondsReport& seconds = drawn.seconds;
  seconds.cut = seconds.project = seconds.clip = seconds.layout = 0;
  const View& view = scene.view;
  const MapFrame& map = terrain.map;

  StrokeSettings strokes{
      scene.to_page, scene.page.inner_mm(), settings.simplify_mm, view.is_perspective(), {}};
  if (is_tied_to_ground(settings.write.format))
    strokes.to_map = [&](ProfilePoint p) { return map.to_map(to_ground_m(view, p)); };

  Layer profiles = empty_layer("profiles", settings.pen_width_mm, 0);
  Layer shores = empty_layer("shores", kShoreWeight * settings.pen_width_mm, 0);
  Layer border = empty_layer("border", kBorderWeight * settings.pen_width_mm, kBorderGrey);
  StrokeBuilder profile_builder(strokes, profiles);
  const bool draws_profiles = asks_for(settings, "profiles");
  ProfileStrokes profile_strokes(view, settings.flat == FlatGround::draw, profile_builder);

  const double from_m =
      view.is_perspective() ? view.near_m : -std::numeric_limits<double>::infinity();
  std::vector<GridEdge> border_edges, shore_edges;
  if (asks_for(settings, "border"))
    for (const BorderEdge& edge : scene.border) border_edges.push_back(edge.edge);
  if (asks_for(settings, "shores")) shore_edges = scene.level.shores;
  LineLayer shore_lines(terrain.grid, view, std::move(shore_edges), from_m);
  LineLayer border_lines(terrain.grid, view, std::move(border_edges), from_m);

  const GridCutter cutter(terrain.grid, view, scene.level.triangles);
  const ClipOptions clip_options{Role::drawn_occluder,
                                 tie_tolerance(scene, settings.visibility_tolerance_mm), true};
  Horizon horizon = initial_horizon();
  Profile profile;
  std::vector<Segment> segments;
  ClipWorkspace workspace;
  Stopwatch watch;
  for (std::size_t i = 0; i < scene.depths_m.size(); ++i) {
    cutter.cut(scene.depths_m[i], profile);
    watch.mark(seconds.cut);
    project_profile(profile, static_cast<std::uint32_t>(i), view, segments);
    watch.mark(seconds.project);
    shore_lines.take_slab(profile.depth_m, horizon);
    border_lines.take_slab(profile.depth_m, horizon);
    clip(segments, horizon, clip_options, workspace);
    watch.mark(seconds.clip);
    if (draws_profiles)
      profile_strokes.add(profile, static_cast<std::int32_t>(i), segments, workspace.visible);
    watch.mark(seconds.layout);

    counts.cut_vertices += profile.size();
    counts.segments += segments.size();
    counts.largest_horizon = std::max<std::uint64_t>(counts.largest_horizon, horizon.size());
    progress(static_cast<double>(i + 1) / static_cast<double>(scene.depths_m.size()));
  }
  shore_lines.take_slab(std::numeric_limits<double>::infinity(), horizon);
  border_lines.take_slab(std::numeric_limits<double>::infinity(), horizon);
  watch.mark(seconds.clip);

  StrokeBuilder shore_builder(strokes, shores), border_builder(strokes, border);
  shore_lines.draw(shore_builder);
  border_lines.draw(border_builder);
  Drawing& drawing = drawn.drawing;
  drawing.page = scene.page;
  drawing.crs_wkt = map.crs_wkt;
  for (Layer* layer : {&profiles, &shores, &border})
    if (asks_for(settings, layer->name)) drawing.layers.push_back(std::move(*layer));
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
