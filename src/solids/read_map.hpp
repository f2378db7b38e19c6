// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "solids/scene_table.hpp"

#include <Eigen/Core>

namespace orograph {

/// The key `map` of a part's use or of a place.
constexpr SceneKey kMapKey{"map", "a list of steps", "[{ turn_z = 30 }, { move = [0, 0, 3] }]"};

/// The product of the steps of `map`, which act in their order; the identity where the table has
/// none. A step is a table with one key: move, scale, turn_x, turn_y, turn_z, turn or matrix.
/// Throws Error, with the step's line: another key, or several; values that are none; a matrix that
/// is singular, or not affine.
Eigen::Matrix4d read_map(const SceneTable& table);

} // namespace orograph
