// SPDX-License-Identifier: GPL-3.0-or-later
#include "map/letter_map.hpp"

#include "draw/round_drawing.hpp"
#include "map/draw_furniture.hpp"
#include "map/name_places.hpp"

#include <algorithm>
#include <utility>

namespace orograph {
namespace {

// All other layers, but that which shows the pen's way.
void add_above(Drawing& drawing, Layer layer) {
  drop_repeated_strokes(layer);
  const auto place = std::ranges::find_if(drawing.layers, &Layer::is_pen_way);
  drawing.layers.insert(place, std::move(layer));
}

} // namespace

void letter_map(Map& map, const TerrainData& terrain, const PlacedView& placed, const MapSpec& spec,
                const LinesToLabel& lines) {
  Drawing& drawing = map.drawing;
  drawing.letters = spec.letters;
  if (spec.ground_points) return;
  Lettering lettering(spec.letters);
  map.facts.names = name_places(terrain, placed, spec, lines, lettering, drawing);
  const bool is_empty =
      std::ranges::all_of(drawing.layers, [](const Layer& layer) { return layer.strokes.empty(); });
  if (spec.furniture.any() && !is_empty)
    add_above(drawing, draw_furniture(terrain, placed, spec, lettering, map.facts.furniture));
  if (spec.letters.kind == LetterKind::stroke) texts_to_strokes(drawing, lettering);
  map.facts.lettering = lettering.notes();
}

} // namespace orograph
