// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "solids/scene_file.hpp"

#include <string>

namespace orograph {

/// Reads a scene from TOML (docs/scenes.md); polyhedra that it names are read from their files,
/// beside it. Places are not looked for on a terrain.
///
/// Throws Error, one line that begins with the file's path, and line where there is one: no such
/// file, a folder, over 10 MB; not TOML; keys that are unknown, missing, or of the wrong type or
/// count; numbers not finite or beyond 1e12; parts that aren't there, hold nothing or hold
/// themselves; shapes and maps that are none (`read_shape`, `read_map`); a place with at and lonlat
/// or neither; no place; over a million instances (`walk_scene`).
SceneFile read_scene(const std::string& path);

} // namespace orograph
