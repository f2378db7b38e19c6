// SPDX-License-Identifier: GPL-3.0-or-later
#include "placing/overlay_points.hpp"

#include "geometry/error.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace orograph {

OverlayPoints points_of(const Overlay& overlay) {
  OverlayPoints out;
  bool any = false;
  for (std::size_t f = 0; f < overlay.features.size(); ++f) {
    const Overlay::Feature& feature = overlay.features[f];
    const std::size_t count = std::max<std::size_t>(feature.line_count, 1);
    for (std::size_t i = 0; i < count; ++i) {
      out.feature_of.push_back(f);
      out.place_of.push_back(OverlayPoints::kNone);
      if (i == feature.line_count) continue;
      const Overlay::Line& line = overlay.lines[feature.first_line + i];
      if (line.place_count > 1)
        throw Error(fmt::format("feature {} of {} is a line or an area", f + 1, overlay.source),
                    "give points, such as those of ogr2ogr -dialect SQLite -sql \"SELECT "
                    "ST_PointOnSurface(geometry), * FROM layer\"");
      any = true;
      if (line.place_count == 0) continue; // in no place that the terrain's CRS has
      out.place_of.back() = out.places.size();
      out.places.push_back(overlay.places[line.first_place]);
    }
  }
  if (!any)
    throw Error(overlay.source + " has no point with a place",
                "give points with geometries, or of CSV columns lon and lat, or x and y");
  return out;
}

} // namespace orograph
