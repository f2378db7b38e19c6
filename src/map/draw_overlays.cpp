// SPDX-License-Identifier: GPL-3.0-or-later
#include "map/draw_overlays.hpp"

#include "map/draw_features.hpp"
#include "map/found_parts.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace orograph {

double draw_more_overlays(const TerrainData& terrain, const PlacedView& placed, const Style& style,
                          std::span<const SeenGround> ground, const Instruments& instruments,
                          const StrokeSettings& settings, LinesOfView& lines, Layer& seen,
                          Layer* hidden, const PassCounts& counts) {
  double left_out_mm = 0;
  while (take_more_overlays(terrain, placed, style, instruments, lines)) {
    count_draped(lines.on_ground, counts.counts);
    Counts again; // of what the first pass has counted
    std::vector<SectorLines> sectors;
    for (std::size_t i = 0; i < placed.sectors.size(); ++i)
      sectors.push_back(sector_pass(terrain, placed, placed.sectors[i], lines,
                                    ground.empty() ? nullptr : &ground[i], style, instruments,
                                    nullptr, {again, counts.seconds}, [] {}));
    Stopwatch watch;
    const std::size_t first = lines.listed.size() - lines.on_ground.lines.size();
    const FoundParts found(terrain, placed, lines.on_ground.points, lines.listed,
                           std::move(sectors));
    const auto draw = [&](std::vector<LinePart> parts, Layer& layer) {
      return draw_features(terrain.surface, placed.view, found.lines(), lines.on_ground, first,
                           std::move(parts), settings, settings, layer);
    };
    left_out_mm += draw(found.visible_of(LineKind::drape, found.of(&SectorLines::visible)), seen);
    if (hidden) draw(of_kind(found.lines(), found.hidden(), LineKind::drape), *hidden);
    watch.mark(counts.seconds.layout);
  }
  return left_out_mm;
}

void count_draped(const GroundLines& on_ground, Counts& counts) {
  counts.draped_in_part += on_ground.draped_in_part;
  counts.not_draped += on_ground.not_draped;
  counts.draped += static_cast<std::uint64_t>(
      std::ranges::count(on_ground.features, LineKind::drape, &GroundFeature::kind));
}

} // namespace orograph
