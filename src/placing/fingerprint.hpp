// SPDX-License-Identifier: GPL-3.0-or-later
// Whether two terrains, scenes or files are the same, told by a short text.
#pragma once

#include "dem/terrain.hpp"
#include "solids/scene_file.hpp"

#include <string>
#include <string_view>

namespace orograph {

/// Sixteen hexadecimal digits from the vertices' places and heights, bit for bit, and the CRS;
/// where the files are and what they are called takes no part. For telling mistakes, not for
/// security. Cost: one pass, at the speed of memory.
std::string fingerprint(const TerrainData& terrain);

/// The same of a scene's solids, places and instances, whatever its parts are called.
std::string fingerprint(const SceneFile& scene);

/// The same of a file's text, byte for byte.
std::string fingerprint(std::string_view text);

} // namespace orograph
