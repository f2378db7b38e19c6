// SPDX-License-Identifier: GPL-3.0-or-later
#include "map/letter_map.hpp"

#include "map/layer_table.hpp"

namespace orograph {

void letter_map(Map& map, const TerrainData& terrain, const PlacedView& placed,
                const MapSpec& spec) {
  Drawing& drawing = map.drawing;
  drawing.letters = spec.letters;
  if (spec.ground_points) return;
  Lettering lettering(spec.letters);
  (void)terrain;
  (void)placed;
  if (spec.letters.kind == LetterKind::stroke) texts_to_strokes(drawing, lettering);
  map.facts.lettering = lettering.notes();
}

} // namespace orograph
