// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/stages/stages.hpp"

#include "bench/stages/front_to_back.hpp"
#include "draw/round_drawing.hpp"
#include "draw/simplify.hpp"
#include "hidden_lines/line_pass.hpp"
#include "hidden_lines/profile_strokes.hpp"
#include "hidden_lines/surface_lines.hpp"
#include "map/draw_map.hpp"
#include "write/byte_sink.hpp"
#include "write/writers.hpp"

#include <memory>
#include <utility>

namespace orograph {
namespace {

// Which edges hide: a vertex is a height of the grid.
Stage facing(const StagedView& view) {
  return [&view](Meter& meter) {
    meter.measure([&] { lines_of(view.terrain, view.scene, view.spec.style); });
    const Grid& grid = std::get<Grid>(view.terrain.surface);
    return static_cast<std::size_t>(grid.columns) * static_cast<std::size_t>(grid.rows);
  };
}

Stage cut(const StagedView& view) {
  return [&view, profile = Profile()](Meter& meter) mutable {
    std::size_t vertices = 0;
    for (const PlannedProfile& planned : view.sector().profiles) {
      meter.measure([&] { view.cutter.cut(planned.depth_m, profile); });
      vertices += profile.size();
    }
    return vertices;
  };
}

// Each profile as soon as it is cut, while it is in the cache.
Stage project(const StagedView& view) {
  return [&view, work = ProfileInWork()](Meter& meter) mutable {
    std::size_t vertices = 0;
    for (const PlannedProfile& planned : view.sector().profiles) {
      view.cutter.cut(planned.depth_m, work.profile);
      meter.measure([&] {
        project_profile(work.profile, static_cast<std::uint32_t>(planned.number),
                        view.sector().view, work.projected, work.uprights);
      });
      vertices += work.profile.size();
    }
    return vertices;
  };
}

// One of the meters of a pass.
Stage clip(const StagedView& view, Meter PassMeters::*part) {
  return [&view, part, lines = lines_of(view.terrain, view.scene, view.spec.style)](Meter& meter) {
    PassMeters meters;
    const PassFound found = pass_front_to_back(view, lines, meters, [](const ProfileInWork&) {});
    const Meter& measured = meters.*part;
    meter.seconds += measured.seconds;
    meter.allocations.count += measured.allocations.count;
    meter.allocations.bytes += measured.allocations.bytes;
    return found.cut_vertices;
  };
}

StrokeSettings not_simplified(const StagedView& view) {
  StrokeSettings spec = view.strokes;
  spec.simplify_mm = 0;
  return spec;
}

// Visible runs joined into strokes; a vertex is a point of these.
Stage merge_profiles(const StagedView& view) {
  return [&view, spec = not_simplified(view),
          profiles = clipped_profiles(view)](Meter& meter) mutable {
    Layer layer;
    meter.measure([&] { layer = laid_out(view, spec, profiles); });
    return layer.page_mm.size();
  };
}

// Visible parts of silhouettes joined where strips and slabs have cut them, then at shared
// vertices.
Stage merge_lines(const StagedView& view) {
  Style drawing = view.spec.style;
  drawing.layers = {"silhouettes"};
  std::vector<EdgeLine> lines = lines_of(view.terrain, view.scene, drawing);
  PassMeters unused;
  std::vector<LinePart> visible =
      pass_front_to_back(view, lines, unused, [](const ProfileInWork&) {}).visible;
  return [&view, spec = not_simplified(view), lines = std::move(lines),
          visible = std::move(visible)](Meter& meter) {
    std::vector<LinePart> parts = visible;
    Layer layer;
    StrokeBuilder builder(spec, layer);
    meter.measure([&] {
      join(parts);
      draw_parts(view.terrain.surface, {}, view.scene.view, lines, parts, builder);
    });
    return layer.page_mm.size();
  };
}

// On the page; a vertex is a point before anything is left out.
Stage simplify_strokes(const StagedView& view) {
  std::vector<ProfileInWork> profiles = clipped_profiles(view);
  return [layer = laid_out(view, not_simplified(view), profiles),
          tolerance_mm = view.strokes.simplify_mm,
          kept = std::vector<std::uint32_t>()](Meter& meter) mutable {
    meter.measure([&] {
      for (const Stroke& stroke : layer.strokes) simplify(layer.points(stroke), tolerance_mm, kept);
    });
    return layer.page_mm.size();
  };
}

// To the step of the page, dropping strokes that are twice the same.
Stage round_strokes(const StagedView& view) {
  std::vector<ProfileInWork> profiles = clipped_profiles(view);
  return [layer = laid_out(view, view.strokes, profiles)](Meter& meter) {
    Layer rounded = layer;
    meter.measure([&] { round_to_page_step(rounded); });
    return layer.page_mm.size();
  };
}

// The text or file's content, which goes nowhere: no disk is measured.
Stage write(const StagedView& view, Format format) {
  MapSpec spec = view.spec;
  spec.ground_points = is_tied_to_ground(format);
  Drawing drawing = draw_map(view.terrain, view.scene, spec, [](double) {}).drawing;
  return [format, drawing = std::move(drawing)](Meter& meter) {
    meter.measure([&] {
      ByteSink out("/dev/null", "/dev/null");
      if (format == Format::svg)
        write_svg(drawing, out);
      else if (format == Format::geojson)
        write_geojson(drawing, out);
      else
        write_by_cairo(drawing, {.format = format}, out);
      out.finish();
    });
    std::size_t points = 0;
    for (const Layer& layer : drawing.layers) points += layer.page_mm.size();
    return points;
  };
}

} // namespace

std::vector<ProfileInWork> clipped_profiles(const StagedView& view) {
  std::vector<ProfileInWork> profiles;
  PassMeters unused;
  pass_front_to_back(view, lines_of(view.terrain, view.scene, view.spec.style), unused,
                     [&](const ProfileInWork& profile) { profiles.push_back(profile); });
  return profiles;
}

Layer laid_out(const StagedView& view, const StrokeSettings& spec,
               std::vector<ProfileInWork>& profiles) {
  Layer layer;
  for (ProfileInWork& profile : profiles) {
    join_strips(profile);
    profile.strokes.clear();
    StrokeBuilder builder(spec, profile.strokes);
    ProfileStrokes(view.scene.view, view.sector(), view.spec.style.flat == FlatGround::draw,
                   builder)
        .add(profile.profile, profile.planned, profile.visible);
    append(layer, profile.strokes);
  }
  return layer;
}

const std::vector<NamedStage>& all_stages() {
  static const std::vector<NamedStage> stages{
      {"facing", facing},
      {"cut", cut},
      {"project", project},
      {"clip_lines", [](const StagedView& view) { return clip(view, &PassMeters::lines); }},
      {"clip_profiles", [](const StagedView& view) { return clip(view, &PassMeters::profiles); }},
      {"merge_profiles", merge_profiles},
      {"merge_lines", merge_lines},
      {"simplify", simplify_strokes},
      {"round", round_strokes},
      {"write_svg", [](const StagedView& view) { return write(view, Format::svg); }},
      {"write_pdf", [](const StagedView& view) { return write(view, Format::pdf); }},
      {"write_geojson", [](const StagedView& view) { return write(view, Format::geojson); }}};
  return stages;
}

} // namespace orograph
