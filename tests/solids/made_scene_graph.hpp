// SPDX-License-Identifier: GPL-3.0-or-later
// Random acyclic multigraphs of parts, and the maps of their instances as matrices.
#pragma once

#include "solids/scene_file.hpp"
#include "solids/walk_scene.hpp"
#include "tests/support/random.hpp"
#include "view/pipeline.hpp"

namespace orograph {

inline Eigen::Matrix4d matrix_of(const AffineMap& map) {
  Eigen::Matrix4d matrix = Eigen::Matrix4d::Identity();
  int column = 0;
  for (const Vec3& v : {map.x, map.y, map.z, map.origin})
    matrix.col(column++).head<3>() = Eigen::Vector3d(v.x, v.y, v.z);
  return matrix;
}

inline Eigen::Matrix4d made_map(Random& random) {
  const Vec3 by{random.between(-2, 2), random.between(-2, 2), random.between(-2, 2)};
  return translation(by) *
         rotation({random.between(-1, 1), random.between(-1, 1), 1},
                  Angle::degrees(random.between(-180, 180))) *
         scaling({random.between(0.7, 1.3), random.between(-1.3, -0.7), random.between(0.7, 1.3)});
}

/// Parts use others of lower numbers, some more than once; the lowest have shapes.
inline SceneGraph made_scene_graph(Random& random) {
  SceneGraph graph;
  const int parts = random.whole(1, 8);
  for (int i = 0; i < parts; ++i) {
    ScenePart part{"p" + std::to_string(i), {}, {}};
    if (i == 0 || random.chance(0.4)) part.solid = static_cast<std::uint32_t>(random.whole(0, 5));
    const int uses = i == 0 ? 0 : random.whole(1, 4);
    for (int k = 0; k < uses; ++k)
      part.uses.push_back(
          {static_cast<std::uint32_t>(random.whole(0, i - 1)), made_map(random), 1});
    graph.parts.push_back(part);
  }
  for (int i = random.whole(1, 4); i > 0; --i)
    graph.places.push_back(
        {static_cast<std::uint32_t>(random.whole(0, parts - 1)), made_map(random), 1});
  return graph;
}

} // namespace orograph
