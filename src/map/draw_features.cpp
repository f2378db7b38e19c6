// SPDX-License-Identifier: GPL-3.0-or-later
#include "map/draw_features.hpp"

#include "geometry/sort_by_number.hpp"

#include <algorithm>

namespace orograph {

void draw_features(const Surface& surface, const View& view, const GroundLines& on_ground,
                   std::size_t first_line, const std::vector<LinePart>& parts, Layer& layer,
                   StrokeBuilder& builder) {
  const EdgeEnds ends(surface, view, {on_ground.points});
  const auto line_of_part = [&](const LinePart& part) -> const GroundLine& {
    return on_ground.lines[part.line - first_line];
  };
  std::vector<LinePart> by_feature = parts;
  sort_by_number(by_feature, [&](const LinePart& part) { return line_of_part(part).feature; });
  std::vector<LinePart> of_feature;
  for (auto first = by_feature.cbegin(); first != by_feature.cend();) {
    throw_if_stopped();
    const std::uint32_t feature = line_of_part(*first).feature;
    const auto end = std::find_if(first, by_feature.cend(), [&](const LinePart& part) {
      return line_of_part(part).feature != feature;
    });
    of_feature.assign(first, end);
    const std::size_t before = layer.strokes.size();
    draw_chained(
        of_feature, view,
        [&](const LinePart& part) {
          const SurfaceEdge line = line_of_part(part).ends;
          return ChainLink{part.t_begin <= 0 ? line.from : kLooseEnd,
                           part.t_end >= 1 ? line.to : kLooseEnd};
        },
        [&](const LinePart& part, double t) {
          const ProfileLine whole = ends(line_of_part(part).ends);
          return point_between(whole.from, whole.to, t);
        },
        builder);
    first = end;
    if (layer.strokes.size() == before) continue;
    const Attributes& attributes = on_ground.features[feature].attributes;
    if (attributes.empty()) continue;
    for (std::size_t i = before; i < layer.strokes.size(); ++i)
      layer.strokes[i].feature = static_cast<std::int32_t>(layer.features.size());
    layer.features.push_back(attributes);
  }
}

} // namespace orograph
