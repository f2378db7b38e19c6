// SPDX-License-Identifier: GPL-3.0-or-later
// Scenes for the clip alone: lists of segments in the visibility plane, nearest list first.
#pragma once

#include "geometry/segment.hpp"
#include "tests/support/random.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace orograph {

using FlatScene = std::vector<std::vector<Segment>>;

/// How a scene's coordinates are drawn.
struct SceneKind {
  std::string name;
  int lists, segments;
  double gap_chance;
  bool lattice;   ///< small whole numbers: shared ends, ties and crossings at vertices abound
  double y_scale; ///< steepness
  double offset;  ///< added to all coordinates
};

inline std::vector<SceneKind> scene_kinds() {
  return {{"smooth", 30, 40, 0.0, false, 1, 0},         {"gaps", 30, 40, 0.3, false, 1, 0},
          {"lattice", 12, 12, 0.2, true, 3, 0},         {"flat lattice", 12, 10, 0.1, true, 1, 0},
          {"steep", 20, 20, 0.2, false, 1e12, 0},       {"shallow", 20, 20, 0.2, false, 1e-12, 0},
          {"far from zero", 20, 20, 0.2, false, 1, 1e7}};
}

inline FlatScene flat_scene(const SceneKind& kind, std::uint64_t seed) {
  Random random(seed);
  FlatScene scene;
  for (int list = 0; list < kind.lists; ++list) {
    auto& segments = scene.emplace_back();
    double x = kind.lattice ? random.whole(0, 4) : random.between(0, 1);
    const auto height = [&] {
      return kind.offset + (kind.lattice ? random.whole(0, static_cast<int>(2 * kind.y_scale))
                                         : kind.y_scale * random.between(0, 1) + 0.02 * list);
    };
    double y = height();
    for (int i = 0; i < kind.segments; ++i) {
      const double next_x = x + (kind.lattice ? random.whole(1, 3) : random.between(1e-3, 1));
      const double next_y = height();
      if (!random.chance(kind.gap_chance))
        segments.push_back({kind.offset + x, y, kind.offset + next_x, next_y,
                            (static_cast<std::uint64_t>(list) << 32U) | segments.size()});
      x = next_x;
      y = next_y;
    }
  }
  return scene;
}

} // namespace orograph
