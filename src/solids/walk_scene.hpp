// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "solids/scene_file.hpp"
#include "solids/scene_graph.hpp"

#include <string>
#include <vector>

namespace orograph {

constexpr std::size_t kMostInstances = 1'000'000;

/// Every path from a place to a part with a shape, as an instance of that shape: depth first, a
/// part's own shape before what it uses, with a stack of matrices (Paoluzzi 2003, section 8.3). The
/// arcs' matrices are multiplied on the right.
///
/// Throws Error, which begins with `path` and the line: a circle of parts (also one that no place
/// leads to); more than kMostInstances, or ten times as many paths to parts of any kind, told
/// before the walk begins; an instance whose matrix is singular, or holds a number beyond 1e12.
std::vector<SolidInstance> walk_scene(const SceneGraph& graph, const std::string& path);

} // namespace orograph
