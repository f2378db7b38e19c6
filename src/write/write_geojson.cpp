// SPDX-License-Identifier: GPL-3.0-or-later
#include "write/geojson_text.hpp"
#include "write/stroke_attributes.hpp"
#include "write/writers.hpp"

#include <span>

namespace orograph {

void write_geojson(const Drawing& drawing, ByteSink& out) {
  GeojsonText text({.name = "strokes", .description = drawing.title, .crs_wkt = drawing.crs_wkt},
                   {}, out);
  const bool with_colour = tells_colours(drawing);
  for (const Layer& layer : drawing.layers)
    for (const Stroke& stroke : layer.strokes) {
      for (const auto& [name, value] : attributes_of(stroke, layer, with_colour))
        text.property(name, value);
      if (!text.line(std::span(layer.map).subspan(stroke.first_point, stroke.point_count)))
        return; // `finish` of the sink tells
    }
  text.finish();
}

} // namespace orograph
