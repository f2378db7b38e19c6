// SPDX-License-Identifier: GPL-3.0-or-later
// From a feature's geometry to triangles, points, lines and rings.
#pragma once

#include "dem/read/map_shapes.hpp"
#include "dem/read/read_vector.hpp"

#include <cstdint>
#include <optional>
#include <string>

class OGRGeometry;

namespace orograph {

/// How messages name a feature.
std::string feature_name(std::int64_t id, const std::string& path);

/// Adds what the geometry of feature `id` is. `height` is that of points, where a field tells it.
/// Throws Error where the geometry can't serve.
void add_geometry(const OGRGeometry& geometry, VectorUse use, std::optional<double> height,
                  std::int64_t id, MapShapes& shapes);

} // namespace orograph
