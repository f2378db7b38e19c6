// SPDX-License-Identifier: GPL-3.0-or-later
// From a feature's geometry to triangles, points, lines and rings.
#pragma once

#include "dem/map_shapes.hpp"
#include "dem/read_vector.hpp"

#include <optional>
#include <string>

class OGRGeometry;

namespace orograph {

/// Adds what a feature's geometry is. `height` is that of points, where a field tells it; `feature`
/// names it in messages, as in "feature 7 of x.gpkg". Throws Error where the geometry can't serve.
void add_geometry(const OGRGeometry& geometry, VectorUse use, std::optional<double> height,
                  const std::string& feature, MapShapes& shapes);

} // namespace orograph
