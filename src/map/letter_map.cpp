// SPDX-License-Identifier: GPL-3.0-or-later
#include "map/letter_map.hpp"

#include "map/layer_table.hpp"
#include "map/name_places.hpp"

namespace orograph {

void letter_map(Map& map, const TerrainData& terrain, const PlacedView& placed,
                const MapSpec& spec, const LinesToLabel& lines) {
  Drawing& drawing = map.drawing;
  drawing.letters = spec.letters;
  if (spec.ground_points) return;
  Lettering lettering(spec.letters);
  map.facts.names = name_places(terrain, placed, spec, lines, lettering, drawing);
  if (spec.letters.kind == LetterKind::stroke) texts_to_strokes(drawing, lettering);
  map.facts.lettering = lettering.notes();
}

} // namespace orograph
