// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "solids/scene_file.hpp"

#include <string>

namespace orograph {

/// Reads a scene from TOML; polyhedra that it names are read from their files, beside it.
SceneFile read_scene(const std::string& path);

} // namespace orograph
