// SPDX-License-Identifier: GPL-3.0-or-later
// The formats behind write_tin.
#pragma once

#include "dem/terrain.hpp"
#include "dem/write/write_tin.hpp"

#include <string>

namespace orograph {

/// OFF, PLY or OBJ. Throws Error, in which the file is called `name`.
void write_mesh_text(const Terrain& terrain, const std::string& path, TinFormat format,
                     const std::string& name);
void write_tin_geopackage(const Terrain& terrain, const std::string& path, const std::string& name);

} // namespace orograph
