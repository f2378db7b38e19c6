// SPDX-License-Identifier: GPL-3.0-or-later
#include "map/draw_features.hpp"

#include "geometry/sort_by_number.hpp"
#include "hidden_lines/line_pass.hpp"

#include <algorithm>

namespace orograph {

void draw_features(const Surface& surface, const View& view, const std::vector<EdgeLine>& lines,
                   const GroundLines& on_ground, std::size_t first_line,
                   const std::vector<LinePart>& parts, Layer& layer, StrokeBuilder& builder,
                   StrokeBuilder& tick_builder) {
  const auto feature_of = [&](const LinePart& part) {
    return on_ground.lines[part.line - first_line].feature;
  };
  std::vector<LinePart> by_feature = parts;
  sort_by_number(by_feature, feature_of);
  std::vector<LinePart> of_feature;
  for (auto first = by_feature.cbegin(); first != by_feature.cend();) {
    throw_if_stopped();
    const std::uint32_t feature = feature_of(*first);
    const auto end = std::find_if(first, by_feature.cend(), [&](const LinePart& part) {
      return feature_of(part) != feature;
    });
    of_feature.assign(first, end);
    first = end;
    const std::size_t before = layer.strokes.size();
    const auto& [kind, attributes, is_tick] = on_ground.features[feature];
    draw_parts(surface, on_ground.points, view, lines, of_feature,
               is_tick ? tick_builder : builder);
    if (layer.strokes.size() == before || attributes.empty()) continue;
    for (std::size_t i = before; i < layer.strokes.size(); ++i)
      layer.strokes[i].feature = static_cast<std::int32_t>(layer.features.size());
    layer.features.push_back(attributes);
  }
}

} // namespace orograph
