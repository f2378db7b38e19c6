// SPDX-License-Identifier: GPL-3.0-or-later
#include "profiles/slab_lines.hpp"

namespace orograph {

ProfileLine line_of(const Grid& grid, const View& view, SurfaceEdge edge) {
  return {to_profile_frame(view, grid.vertex_m(edge.from)),
          to_profile_frame(view, grid.vertex_m(edge.to))};
}

ProfileLine line_of(const Tin& tin, const View& view, SurfaceEdge edge) {
  return {to_profile_frame(view, tin.vertices_m[edge.from]),
          to_profile_frame(view, tin.vertices_m[edge.to])};
}

ProfileLine line_of(const Surface& surface, const View& view, SurfaceEdge edge) {
  return std::visit([&](const auto& s) { return line_of(s, view, edge); }, surface);
}

ProfilePoint point_of(const Surface& surface, const View& view, std::uint32_t vertex) {
  if (const Grid* grid = std::get_if<Grid>(&surface))
    return to_profile_frame(view, grid->vertex_m(std::size_t{vertex}));
  return to_profile_frame(view, std::get<Tin>(surface).vertices_m[vertex]);
}

} // namespace orograph
