// SPDX-License-Identifier: GPL-3.0-or-later
#include "map/draw_map.hpp"

#include "dem/overlay.hpp"
#include "draw/close_outline.hpp"
#include "draw/drawing.hpp"
#include "draw/join_strokes.hpp"
#include "draw/pen_order.hpp"
#include "draw/round_drawing.hpp"
#include "draw/shade_strokes.hpp"
#include "draw/smooth_strokes.hpp"
#include "draw/stroke_builder.hpp"
#include "geometry/on_all_cores.hpp"
#include "hidden_lines/instruments.hpp"
#include "hidden_lines/sector_ground.hpp"
#include "hidden_lines/sector_pass.hpp"
#include "hidden_lines/surface_lines.hpp"
#include "map/check.hpp"
#include "map/describe_map.hpp"
#include "map/draw_contours.hpp"
#include "map/draw_features.hpp"
#include "map/draw_overlays.hpp"
#include "map/draw_solids.hpp"
#include "map/finish_panorama.hpp"
#include "map/found_parts.hpp"
#include "map/layer_table.hpp"
#include "map/letter_map.hpp"
#include "map/stroke_darkness.hpp"

#include <algorithm>
#include <optional>
#include <string_view>
#include <utility>

namespace orograph {
namespace {

constexpr double kDash_mm = 0.8, kDashGap_mm = 0.5;

// Where an outline turns back under itself, longer ways are no wrinkle of it any more.
constexpr double kLongestWayBack_mm = 5;

// A layer on its way to the page: what is still to be drawn in it, and what was left out.
struct LineLayer {
  Layer layer;
  LineKind kind{};
  std::vector<LinePart> parts;
  std::vector<std::uint8_t> whole; ///< of contours: marks of what is seen from end to end
  bool of_solids = false;          ///< the parts
  bool is_on_ground = false;       ///< its lines
  bool is_rounded = false;         ///< stroke by stroke
  bool is_joined = false;          ///< across small gaps
  bool is_skyline = false;         ///< which is drawn whole
  bool is_shore = false;           ///< which is drawn smoothly, on paper
  std::optional<LineShade> shade;  ///< light and haze on its lines
  Layer to_label;                  ///< its lines again, with places in the view's profile frame
  double left_out_mm = 0;
  RoundingCounts dropped = {};
};

// The lines on the ground that are asked for with labels.
bool has_labels(const LineLayer& layer, const LabelSpec& labels) {
  switch (layer.is_on_ground && !layer.layer.is_hidden ? layer.kind : LineKind::mesh) {
  case LineKind::index_contour:
    return labels.contours;
  case LineKind::graticule:
  case LineKind::grid:
    return labels.coordinates;
  default:
    return false;
  }
}

// In an order that doesn't depend on whether a line was listed or found.
std::vector<LinePart> by_edge(const std::vector<EdgeLine>& lines, std::vector<LinePart> parts) {
  std::sort(parts.begin(), parts.end(), [&](const LinePart& a, const LinePart& b) {
    const SurfaceEdge &of_a = lines[a.line].edge, &of_b = lines[b.line].edge;
    return of_a != of_b ? of_a < of_b : a.t_begin < b.t_begin;
  });
  return parts;
}

StrokeSettings stroke_settings(const TerrainData& terrain, const PlacedView& placed,
                               const MapSpec& spec) {
  StrokeSettings strokes;
  if (placed.panorama) {
    strokes.panorama = placed.panorama->page;
    strokes.bend_mm = panorama_bend_mm(spec.style.simplify_mm);
  } else {
    strokes.to_page = placed.to_page;
  }
  strokes.frame_mm = placed.frame_mm;
  strokes.depth = placed.depth;
  strokes.simplify_mm = spec.style.simplify_mm;
  strokes.min_stroke_mm = spec.min_stroke_mm();
  if (spec.ground_points)
    strokes.to_map = [&map = terrain.map, &view = placed.view](ProfilePoint p) {
      return map.to_map(to_ground_m(view, p));
    };
  return strokes;
}

// Of lines that may have ground on either side.
std::optional<LineShade> haze_alone(std::optional<LineShade> shade) {
  if (!shade || shade->haze == 0) return std::nullopt;
  shade->contrast = 0;
  return shade;
}

// With the skyline goes what leads from one of its ends to another.
void close_outlines(std::vector<LineLayer>& layers) {
  const auto skyline = std::ranges::find(layers, true, &LineLayer::is_skyline);
  if (skyline == layers.end()) return;
  for (const std::string_view name : {"border", "silhouettes"}) {
    const auto other =
        std::ranges::find(layers, name, [](const LineLayer& of) { return of.layer.name; });
    if (other != layers.end()) close_outline(skyline->layer, other->layer, kLongestWayBack_mm);
  }
}

// All layers that are asked for, in drawing order; `profiles` is drawn already.
std::vector<LineLayer> layers_of(const FoundParts& found, const PlacedView& placed,
                                 const Style& style, const std::optional<LineShade>& shade,
                                 Layer profiles, Layer hidden_profiles, Layer underside) {
  const std::vector<LinePart> visible = found.of(&SectorLines::visible);
  const std::vector<LinePart> hidden = found.hidden();
  const auto solids = [&](std::vector<LinePart> SolidParts::*kind,
                          const std::vector<LinePart>& beneath) {
    std::vector<LinePart> parts = found.of(kind);
    drop_repeated(placed, beneath, parts);
    return parts;
  };
  std::vector<LineLayer> layers;
  for (const LayerRow& row : layer_table()) {
    std::optional<Layer> layer = layer_of(row, style);
    const bool of_solids =
        row.source == LineSource::solids || row.source == LineSource::hidden_solids;
    if (!layer || (of_solids && placed.solids.empty()) || row.source == LineSource::lettering)
      continue;
    LineLayer& added = layers.emplace_back();
    added.layer = std::move(*layer);
    added.kind = row.kind;
    added.of_solids = of_solids;
    switch (row.source) {
    case LineSource::profiles:
      added.layer = std::move(row.is_hidden() ? hidden_profiles : profiles);
      added.is_rounded = !row.is_hidden() && !placed.panorama;
      tell_darkness(added.layer, placed);
      break;
    case LineSource::underside:
      added.layer = std::move(underside);
      break;
    case LineSource::edges:
      added.parts = row.is_hidden() ? of_kind(found.lines(), hidden, row.kind)
                                    : found.visible_of(row.kind, visible);
      added.is_joined = row.kind != LineKind::edge;
      if (row.kind == LineKind::silhouette) added.shade = shade;
      if (row.kind == LineKind::border || row.kind == LineKind::void_edge)
        added.shade = haze_alone(shade);
      added.is_shore = row.kind == LineKind::shore || row.kind == LineKind::waterline;
      break;
    case LineSource::ground:
      added.parts = row.is_hidden()        ? of_kind(found.lines(), hidden, row.kind)
                    : is_contour(row.kind) ? of_kind(found.lines(), visible, row.kind)
                                           : found.visible_of(row.kind, visible);
      if (is_contour(row.kind) && !row.is_hidden()) added.whole = found.whole_of(row.kind);
      added.is_on_ground = true;
      if (row.kind == LineKind::drape)
        for (const Overlay& overlay : placed.overlays)
          added.layer.fields.insert(added.layer.fields.end(), overlay.fields.begin(),
                                    overlay.fields.end());
      added.shade = haze_alone(shade);
      break;
    case LineSource::skyline:
      added.parts = by_edge(found.lines(), found.of(&SectorLines::skyline));
      added.is_joined = added.is_skyline = true;
      added.shade = shade;
      break;
    case LineSource::solids:
      added.parts = solids(&SolidParts::visible, {});
      break;
    case LineSource::hidden_solids: // hidden edges lie under visible ones
      added.parts = solids(&SolidParts::hidden, solids(&SolidParts::visible, {}));
      break;
    case LineSource::lettering: // stands around what is drawn
    case LineSource::pen_way:   // known when all strokes are in order
      break;
    }
    if (row.is_hidden()) added.shade.reset(); // which would break the dashes' rhythm
  }
  return layers;
}

} // namespace

Map draw_map(const TerrainData& terrain, const PlacedView& placed, const MapSpec& spec,
             const std::function<void(double)>& progress, Instruments instruments) {
  Map map;
  Counts& counts = map.facts.counts;
  StageSeconds& seconds = map.facts.seconds;
  seconds.facing = seconds.cut = seconds.project = seconds.clip = seconds.check = seconds.layout =
      0;
  counts.turned_over = placed.extent.turned_over;
  if (const Grid* grid = std::get_if<Grid>(&terrain.surface); grid && grid->is_on_earth())
    if (const LeanLimits* limits = grid->earth().lean_limits())
      counts.turned_over += limits->turned_over();
  counts.solids = placed.solids.size();
  for (const StandingSolid& solid : placed.solids) counts.solid_edges += solid.solid->edges.size();
  const Style& style = spec.style;
  const bool on_ground = has_ground(terrain.surface);
  Stopwatch watch;

  std::optional<Check> check;
  if (spec.check > 0 && on_ground) {
    check.emplace(terrain, placed, style.visibility_tolerance_mm, spec.check,
                  style.underside == Underside::draw);
    instruments.observers.insert(instruments.observers.begin(), &*check);
    instruments.hidden_ground = true; // points are asked of it as well
  }
  const StrokeSettings strokes = stroke_settings(terrain, placed, spec);
  std::optional<Layer> profiles = layer_of(layer_row("profiles"), style),
                       hidden_profiles = layer_of(layer_row("hidden-profiles"), style),
                       underside = layer_of(layer_row("underside"), style);
  std::optional<ProfileLayer> profile_layer;
  if (profiles)
    profile_layer.emplace(strokes, *profiles, hidden_profiles ? &*hidden_profiles : nullptr,
                          underside ? &*underside : nullptr);
  const HiddenKinds hidden = hidden_kinds(style);
  if (hidden.any() || hidden_profiles || style.underside == Underside::draw)
    instruments.hidden_ground = true;
  const std::vector<SeenGround> ground = ground_of_sectors(terrain, placed, style, instruments);
  const std::optional<SeenGround> all_ground = looked_at_by_any(ground);
  LinesOfView lines;
  if (on_ground)
    lines = lines_of_view(terrain, placed, style, instruments, all_ground ? &*all_ground : nullptr,
                          hidden);
  if (all_ground) counts.looked_at = all_ground->share();
  count_draped(lines.on_ground, counts);
  watch.mark(seconds.facing);

  double profiles_done = 0;
  std::size_t profile_count = 0;
  for (const Sector& sector : placed.sectors) profile_count += sector.profiles.size();
  const auto profile_done = [&] {
    if (progress) progress(++profiles_done / static_cast<double>(profile_count));
  };
  std::vector<SectorLines> sectors;
  for (std::size_t i = 0; i < placed.sectors.size(); ++i)
    sectors.push_back(!on_ground
                          ? solids_alone(placed, placed.sectors[i])
                          : sector_pass(terrain, placed, placed.sectors[i], lines,
                                        ground.empty() ? nullptr : &ground[i], style, instruments,
                                        profile_layer ? &*profile_layer : nullptr,
                                        {counts, seconds}, profile_done));
  if (check) map.facts.check = check->counts();
  if (placed.panorama && profile_layer) {
    join_at_borders(*profiles, placed.sectors, strokes.min_stroke_mm, profile_layer->left_out_mm);
    double of_hidden_mm = 0; // which aren't counted
    if (hidden_profiles)
      join_at_borders(*hidden_profiles, placed.sectors, strokes.min_stroke_mm, of_hidden_mm);
    if (underside) join_at_borders(*underside, placed.sectors, strokes.min_stroke_mm, of_hidden_mm);
  }

  watch = {};
  SeenContours contours; // which only a view of one sector finds
  for (SectorLines& sector : sectors)
    if (!sector.contours.by_level.empty()) contours = std::move(sector.contours);
  const std::size_t first_on_ground = lines.listed.size() - lines.on_ground.lines.size();
  const FoundParts found(terrain, placed, lines.on_ground.points, std::move(lines.listed),
                         std::move(sectors));
  const std::optional<LineShade> shade =
      spec.ground_points ? std::nullopt : placed.ridge_shade; // shading cuts strokes
  std::vector<LineLayer> layers =
      layers_of(found, placed, style, shade, profiles ? std::move(*profiles) : Layer{},
                hidden_profiles ? std::move(*hidden_profiles) : Layer{},
                underside ? std::move(*underside) : Layer{});
  const auto settings_of = [&](const LineLayer& layer) {
    // What is joined is simplified and judged afterwards.
    StrokeSettings own = strokes;
    if (layer.is_joined) own.simplify_mm = own.min_stroke_mm = 0;
    own.keeps_depths = (layer.is_joined || layer.is_on_ground) && !layer.is_shore && shade;
    return own;
  };
  on_all_cores(layers.size(), [&](std::size_t i) {
    LineLayer& task = layers[i];
    const StrokeSettings own = settings_of(task);
    if (task.is_on_ground) {
      const auto draw = [&](const StrokeSettings& settings, std::vector<LinePart> parts,
                            Layer& to) {
        StrokeSettings of_ticks = settings; // a tick that is longer than it is wide is no crumb
        of_ticks.min_stroke_mm = std::min(settings.min_stroke_mm, to.pen_width_mm);
        double left_out_mm = 0;
        if (is_contour(task.kind) && !to.is_hidden) {
          const SeenContours listed =
              take_contours(terrain.surface, placed.view, found.lines(), lines.on_ground,
                            first_on_ground, task.whole, parts);
          left_out_mm = draw_contours(placed.view,
                                      lines.on_ground.levels_to_find_m.empty() ? listed : contours,
                                      lines.on_ground, task.kind, settings, to);
        }
        return left_out_mm + draw_features(terrain.surface, placed.view, found.lines(),
                                           lines.on_ground, first_on_ground, std::move(parts),
                                           settings, of_ticks, to);
      };
      if (!spec.ground_points && has_labels(task, spec.labels)) {
        StrokeSettings with_places = own;
        with_places.keeps_depths = false;
        with_places.to_map = [](ProfilePoint p) { return Vec3{p.u, p.v, p.z}; };
        draw(with_places, task.parts, task.to_label);
      }
      task.left_out_mm = draw(own, std::move(task.parts), task.layer);
      return;
    }
    StrokeBuilder builder(own, task.layer);
    if (task.of_solids)
      draw_edges(placed.solids, placed.view, task.parts, builder);
    else
      draw_parts(terrain.surface, lines.on_ground.points, placed.view, found.lines(), task.parts,
                 builder);
    task.left_out_mm = builder.left_out_mm();
  });
  if (lines.on_ground.overlays_done) {
    const auto draped = [&](bool is_hidden) {
      const auto layer = std::ranges::find_if(layers, [&](const LineLayer& of) {
        return of.kind == LineKind::drape && of.layer.is_hidden == is_hidden;
      });
      return layer == layers.end() ? nullptr : &*layer;
    };
    lines.listed.assign(found.lines().begin(),
                        found.lines().begin() + static_cast<std::ptrdiff_t>(first_on_ground) +
                            static_cast<std::ptrdiff_t>(lines.on_ground.lines.size()));
    LineLayer &seen = *draped(false), *hidden_lines = draped(true);
    watch.mark(seconds.layout);
    seen.left_out_mm += draw_more_overlays(
        terrain, placed, style, ground, instruments, settings_of(seen), lines, seen.layer,
        hidden_lines ? &hidden_lines->layer : nullptr, {counts, seconds});
    watch = {};
  }
  if (outlines_terrain(style, placed.view)) close_outlines(layers);
  on_all_cores(layers.size(), [&](std::size_t i) {
    LineLayer& task = layers[i];
    if (task.is_joined) {
      // Of the skyline nothing is a crumb but what leaves no gap that would be seen.
      const double least_mm =
          task.is_skyline ? std::min(style.join_mm, strokes.min_stroke_mm) : strokes.min_stroke_mm;
      const bool smooths = task.is_shore && !spec.ground_points && style.shore_smooth_mm > 0;
      task.layer = joined(task.layer, {style.join_mm, least_mm, smooths ? 0 : strokes.simplify_mm},
                          task.left_out_mm);
      if (smooths)
        task.layer =
            smoothed(task.layer, {style.shore_smooth_mm, strokes.simplify_mm, strokes.frame_mm});
    }
    if (task.shade) task.layer = shaded(task.layer, *task.shade);
    task.layer.depths_m.clear();
    if (task.layer.is_hidden && !spec.ground_points)
      task.layer = dashed(task.layer, kDash_mm, kDashGap_mm);
    if (placed.panorama && !placed.panorama->strips.empty())
      task.layer = in_strips(task.layer, placed.panorama->strips);
    task.dropped =
        task.is_rounded ? drop_repeated_strokes(task.layer) : round_to_page_step(task.layer);
  });

  Drawing& drawing = map.drawing;
  drawing.page = placed.page;
  drawing.crs_wkt = terrain.map.crs_wkt;
  InkLeftOut& left_out = map.facts.left_out;
  left_out.silhouette_jump_mm = found.folded_mm();
  if (profile_layer) {
    left_out.min_stroke_mm = profile_layer->left_out_mm;
    counts.dropped_strokes += profile_layer->dropped_strokes;
  }
  for (LineLayer& of_lines : layers) {
    const bool is_unseen = of_lines.layer.is_hidden && !of_lines.of_solids;
    if (!is_unseen) left_out.min_stroke_mm += of_lines.left_out_mm;
    const RoundingCounts& dropped = of_lines.dropped;
    counts.dropped_strokes += dropped.empty_strokes + dropped.repeated_strokes;
    drawing.layers.push_back(std::move(of_lines.layer));
  }
  LinesToLabel to_label;
  for (LineLayer& of_lines : layers) {
    if (of_lines.kind == LineKind::index_contour) append(to_label.contours, of_lines.to_label);
    if (of_lines.kind == LineKind::graticule) append(to_label.graticule, of_lines.to_label);
    if (of_lines.kind == LineKind::grid) append(to_label.grid, of_lines.to_label);
  }
  letter_map(map, terrain, placed, spec, to_label);
  order_for_pen(drawing, spec.pen_order);
  show_pen_way(drawing);
  for (const Layer& layer : drawing.layers) {
    if (layer.is_pen_way) continue;
    counts.strokes += layer.strokes.size();
    counts.points += layer.page_mm.size();
  }
  entitle(drawing, terrain, placed, spec.title);
  watch.mark(seconds.layout);
  return map;
}

} // namespace orograph
