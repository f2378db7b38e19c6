// SPDX-License-Identifier: GPL-3.0-or-later
// The scene graph: a directed acyclic multigraph of parts, with affine maps on its arcs.
// Source: Alberto Paoluzzi, Geometric programming for computer-aided design, 2003, chapter 8.
#pragma once

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

} // namespace orograph
