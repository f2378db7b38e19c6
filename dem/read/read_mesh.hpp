// SPDX-License-Identifier: GPL-3.0-or-later
// Reading triangles from mesh files, through CGAL; the only place that knows CGAL's readers.
#pragma once

#include "dem/read/map_shapes.hpp"

#include <optional>
#include <string>

namespace orograph {

enum class MeshFormat { off, ply, obj, stl };

/// By the extension of `path`, in upper or lower case; none where there is no such format.
std::optional<MeshFormat> mesh_format_of(const std::string& path);

/// Triangles of OFF, PLY (text or binary), OBJ or STL (text or binary), x east, y north, z up.
/// Comments that `write_tin` leaves (dem/read/mesh_comments.hpp) tell the CRS, the units and the
/// error; without them coordinates and heights are metres.
///
/// Throws Error: the file can't be read, ends early, holds more or less than it says, isn't of the
/// format; a coordinate isn't a finite number; a face isn't a triangle or names a vertex that isn't
/// there; no faces.
MapShapes read_mesh(const std::string& path, MeshFormat format);

} // namespace orograph
