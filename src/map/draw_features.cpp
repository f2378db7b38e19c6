// SPDX-License-Identifier: GPL-3.0-or-later
#include "map/draw_features.hpp"

#include "geometry/on_all_cores.hpp"
#include "geometry/sort_by_number.hpp"
#include "hidden_lines/line_pass.hpp"

#include <algorithm>
#include <cstdint>
#include <span>

namespace orograph {
namespace {

// A feature is never parted.
constexpr std::size_t kPartsOfTask = std::size_t{1} << 14U;

struct Drawn {
  Layer layer;
  double left_out_mm = 0;
};

} // namespace

double draw_features(const Surface& surface, const View& view, const std::vector<EdgeLine>& lines,
                     const GroundLines& on_ground, std::size_t first_line,
                     std::vector<LinePart> parts, const StrokeSettings& settings,
                     const StrokeSettings& of_ticks, Layer& layer) {
  const auto feature_of = [&](const LinePart& part) {
    return on_ground.lines[part.line - first_line].feature;
  };
  sort_by_number(parts, feature_of);
  const auto end_of_feature = [&](std::size_t at) {
    const std::uint32_t feature = feature_of(parts[at]);
    while (at < parts.size() && feature_of(parts[at]) == feature) ++at;
    return at;
  };
  std::vector<std::size_t> bounds{0}; // of tasks
  for (std::size_t at = 0; at < parts.size();) {
    throw_if_stopped();
    at = end_of_feature(at);
    if (at - bounds.back() >= kPartsOfTask || at == parts.size()) bounds.push_back(at);
  }
  std::vector<Drawn> drawn(bounds.size() - 1);
  on_all_cores(drawn.size(), [&](std::size_t task) {
    Layer& own = drawn[task].layer;
    StrokeBuilder builder(settings, own), tick_builder(of_ticks, own);
    std::vector<LinePart> of_feature;
    for (std::size_t first = bounds[task]; first < bounds[task + 1];) {
      const std::size_t end = end_of_feature(first);
      const auto& [kind, attributes, is_tick, width_mm] =
          on_ground.features[feature_of(parts[first])];
      const std::span<const LinePart> these = std::span(parts).subspan(first, end - first);
      of_feature.assign(these.begin(), these.end());
      first = end;
      const std::size_t before = own.strokes.size();
      draw_parts(surface, on_ground.points, view, lines, of_feature,
                 is_tick ? tick_builder : builder);
      for (std::size_t i = before; i < own.strokes.size(); ++i) own.strokes[i].width_mm = width_mm;
      if (own.strokes.size() == before || attributes.empty()) continue;
      for (std::size_t i = before; i < own.strokes.size(); ++i)
        own.strokes[i].feature = static_cast<std::int32_t>(own.features.size());
      own.features.push_back(attributes);
    }
    drawn[task].left_out_mm = builder.left_out_mm() + tick_builder.left_out_mm();
  });
  double left_out_mm = 0;
  for (Drawn& of_task : drawn) {
    throw_if_stopped();
    append(layer, of_task.layer);
    of_task.layer = {};
    left_out_mm += of_task.left_out_mm;
  }
  return left_out_mm;
}

} // namespace orograph
