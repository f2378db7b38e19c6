// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "solids/polyhedron.hpp"

#include <string>

namespace orograph {

/// Vertices and faces of OFF (plain, or with colours and normals, which are passed over) or OBJ
/// (`v` and `f`; all else is passed over), by the extension of `path`, in upper or lower case;
/// metres, z up. Polygons have any number of corners.
///
/// CGAL's readers aren't used: they pass over wrong counts and words that are no numbers, and stop
/// at OBJ's lines (`l`).
///
/// Throws Error, which begins with the path, and has the line where there is one: another
/// extension; no such file, a folder, over 10 MB; more or fewer lines than OFF's counts say; a
/// coordinate that is no finite number; a face that isn't made of vertices that are there.
Polyhedron read_polyhedron(const std::string& path);

} // namespace orograph
