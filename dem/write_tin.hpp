// SPDX-License-Identifier: GPL-3.0-or-later
// Writing a TIN.
#pragma once

#include "dem/terrain.hpp"

#include <optional>
#include <string>

namespace orograph {

enum class TinFormat { gpkg, off, ply, obj };

/// By the extension of `path`; none where there is no such format.
std::optional<TinFormat> tin_format_of(const std::string& path);

/// Writes the terrain's Tin in map coordinates and the file's height unit, every number so that it
/// reads back as it was. A GeoPackage holds one TIN Z feature and the CRS; the mesh formats name
/// CRS and units in a comment. `terrain.surface_error_m`, where above 0, goes along (a field
/// `surface_error_m`, a comment), and `read_terrain` finds it there.
/// REQUIRES a Tin in `terrain.surface`. Throws Error where the file can't be written whole.
void write_tin(const Terrain& terrain, const std::string& path, TinFormat format);

} // namespace orograph
