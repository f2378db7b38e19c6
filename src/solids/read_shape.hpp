// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "solids/scene_table.hpp"
#include "solids/solid.hpp"

#include <optional>
#include <string>

namespace orograph {

/// The key `uses` of a part.
constexpr TomlKey kUsesKey{"uses", "a list of tables", "[{ part = \"wall\" }]"};

/// A part of a scene by the keys that its shape has, `shape` and `uses` among them.
SceneTable part_table(const std::string& path, const TomlValue& value);

/// The path of the file that holds the part's shape, if one does. Throws Error for a name that is
/// no text.
std::optional<std::string> shape_file(const SceneTable& part);

/// The shape that `part` describes. A polyhedron in a file of its own is read relative to the
/// scene's file. Throws Error, with the line of what describes the shape: those of `box` and its
/// neighbours (solids/shapes.hpp), `revolution` and `rotation_body` (solids/turned_shapes.hpp),
/// `build_solid` and `read_polyhedron`. REQUIRES a table of `part_table` with the key `shape`.
Solid read_shape(const SceneTable& part);

} // namespace orograph
