// SPDX-License-Identifier: GPL-3.0-or-later
// The scene graph: a directed acyclic multigraph of parts, with affine maps on its arcs.
// Source: Alberto Paoluzzi, Geometric programming for computer-aided design, 2003, chapter 8.
#pragma once

#include "solids/scene_file.hpp"

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace orograph {

/// An arc: a part that another is made of, or that a place holds.
struct PartUse {
  std::uint32_t part = 0;
  Eigen::Matrix4d map; ///< from the used part's frame to the user's
  std::size_t line = 0;
};

/// A node. It has a shape, or uses others, or both.
struct ScenePart {
  std::string name;
  std::optional<std::uint32_t> solid; ///< its own shape
  std::vector<PartUse> uses;
};

struct SceneGraph {
  std::vector<ScenePart> parts;
  std::vector<PartUse> places; ///< its roots, by place
};

/// Each box among them takes some 5 kB on its way to the page.
constexpr std::size_t kMostInstances = 200'000;

/// Every path from a place to a part with a shape, as an instance of that shape: depth first, a
/// part's own shape before what it uses, with a stack of matrices (Paoluzzi 2003, section 8.3). The
/// arcs' matrices are multiplied on the right.
///
/// Throws Error, which begins with `path` and the line: a circle of parts (also one that no place
/// leads to); more than kMostInstances, or ten times as many paths to parts of any kind, told
/// before the walk begins; an instance whose matrix is singular, or holds a number beyond 1e12.
std::vector<SolidInstance> walk_scene(const SceneGraph& graph, const std::string& path);

} // namespace orograph
