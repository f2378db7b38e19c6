// SPDX-License-Identifier: GPL-3.0-or-later
#include "profiles/facing.hpp"
#include "profiles/silhouettes.hpp"
#include "profiles/tin_edges.hpp"

#include <algorithm>

namespace orograph {

std::vector<SurfaceEdge> silhouette_edges(const Tin& tin, const View& view) {
  const std::vector<std::uint8_t> facing = facing_of_triangles(tin, view);
  std::vector<SurfaceEdge> edges;
  for_each_edge(tin, [&](const TinEdge& e) {
    if (e.left == kNoTriangle || e.right == kNoTriangle ||
        !are_seen_and_turned(facing[e.left], facing[e.right]))
      return;
    const auto at = [&](std::uint32_t i) { return to_profile_frame(view, tin.vertices_m[i]); };
    if (may_be_ridge(at(e.edge.from), at(e.edge.to), at(apex_of(tin, e.left, e.edge)),
                     at(apex_of(tin, e.right, e.edge))))
      edges.push_back(e.edge);
  });
  std::sort(edges.begin(), edges.end());
  return edges;
}

std::vector<SurfaceEdge> silhouette_edges(const Surface& surface, const View& view,
                                          const SeenGround* ground) {
  if (const Tin* tin = std::get_if<Tin>(&surface)) return silhouette_edges(*tin, view);
  return silhouette_edges(std::get<Grid>(surface), view, ground);
}

} // namespace orograph
