// SPDX-License-Identifier: GPL-3.0-or-later
// Small scene files for tests of the command line.
#pragma once

#include "tests/cli/made_files.hpp"

#include <string>

namespace orograph {

/// A scene with the parts `box` (20 x 20 x 30 m) and `mast` (a wire of 60 m), and from line 10 on
/// one place with these lines.
std::string scene_text(const std::string& place);

/// hut.toml: a box at 200,200; with-file.toml: a polyhedron there, of tetrahedron.off; bad ones as
/// their names say.
void make_scenes(const MadeFolder& folder);

} // namespace orograph
