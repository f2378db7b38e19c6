// SPDX-License-Identifier: GPL-3.0-or-later
// A TIN as triangles to walk over (profiles/walk_mesh.hpp).
#pragma once

#include "dem/tin.hpp"
#include "profiles/mesh_vertex.hpp"
#include "view/view.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>

namespace orograph {

/// The side of a triangle opposite to its corner k.
struct TinSide {
  std::uint32_t triangle;
  std::uint8_t k;
};

struct TinMesh {
  using Side = TinSide;

  const Tin& tin;
  const View& view;

  std::uint32_t index(std::uint32_t t, std::size_t k) const { return tin.triangles[t][k]; }
  MeshVertex vertex(std::uint32_t t, std::size_t k) const {
    const std::uint32_t i = index(t, k);
    return {i, to_profile_frame(view, tin.vertices_m[i])};
  }
  std::optional<Side> across(const Side& side) const {
    const std::uint32_t next = tin.neighbours[side.triangle][side.k];
    if (next == kNoTriangle) return std::nullopt;
    const auto& back = tin.neighbours[next];
    const auto k = std::find(back.begin(), back.end(), side.triangle) - back.begin();
    return Side{next, static_cast<std::uint8_t>(k)};
  }
};

} // namespace orograph
