// SPDX-License-Identifier: GPL-3.0-or-later
// Bodies that stand on the terrain: huts, towers, masts (docs/scenes.md).
#pragma once

#include "geometry/vec.hpp"

#include <array>
#include <cstdint>
#include <vector>

namespace orograph {

/// An edge of a solid, or a wire of its own, which hides nothing. An edge of a surface is there
/// once, with from < to.
struct SolidEdge {
  static constexpr std::uint32_t kNoTriangle = 0xffffffff;

  std::uint32_t from = 0, to = 0; ///< vertices
  /// Those on either side. `left` has the edge in the order of its corners, `right` the other way
  /// round. A wire has neither.
  std::uint32_t left = kNoTriangle, right = kNoTriangle;
  bool smooth = false; ///< of a curved surface, or within a face: drawn only as its outline

  bool is_wire() const { return left == kNoTriangle; }
  bool operator==(const SolidEdge&) const = default;
};

/// A closed surface of triangles, or several, or wires (`build_solid`, `build_wires`); in metres of
/// its own frame (the SETUP position of Angell and Jones 1983, chapter 9), z up.
struct Solid {
  std::vector<Vec3> vertices_m;
  /// Counterclockwise for who looks from outside.
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<SolidEdge> edges;

  bool operator==(const Solid&) const = default;
};

} // namespace orograph
