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
/// reads back as it was written (`MapFrame::to_map` may round when it makes the numbers).
///  - GeoPackage: a layer `tin` with one TIN Z feature, in the CRS ("Undefined Cartesian SRS" where
///    there is none); fields `surface_error_m` (null where it is 0) and `height_unit_m`. One
///    geometry holds up to 9 million triangles there; memory 500 bytes a triangle.
///  - OFF, PLY (ascii) and OBJ: comments `orograph: units UNIT_M HEIGHT_UNIT_M`, `orograph: crs
///    WKT` (on one line, where there is one) and `orograph: surface_error_m NUMBER` (where it is
///    above 0). Vertices and triangles keep their order.
/// The same bytes on any day. A file at `path` is overwritten; one that couldn't be written whole
/// is left to whoever named it (a temporary file that is renamed when all is well). Messages call
/// the file `name`, or `path` where that is empty.
/// REQUIRES a Tin in `terrain.surface`. Throws Error where the file can't be written whole.
void write_tin(const TerrainData& terrain, const std::string& path, TinFormat format,
               const std::string& name = {});

} // namespace orograph
