// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/ray_walk.hpp"

#include "dem/approximate/tin_of_grid.hpp"

namespace orograph {
namespace {

using Walk = std::variant<GridRayWalk, TinRayWalk>;

std::shared_ptr<const Tin> triangles_of(const Grid& grid) {
  return grid.is_on_earth() ? std::make_shared<const Tin>(tin_of(grid)) : nullptr;
}

Walk walk_over(const Grid& grid, const Tin* triangles, const View& view) {
  return triangles ? Walk(std::in_place_type<TinRayWalk>, *triangles, view)
                   : Walk(std::in_place_type<GridRayWalk>, grid, view);
}

} // namespace

RayWalk::RayWalk(const Grid& grid, const View& view)
    : triangles_(triangles_of(grid)), walk_(walk_over(grid, triangles_.get(), view)) {}

RayWalk::RayWalk(const Tin& tin, const View& view)
    : walk_(std::in_place_type<TinRayWalk>, tin, view) {}

RayWalk::RayWalk(const Surface& surface, const View& view)
    : RayWalk(std::holds_alternative<Grid>(surface) ? RayWalk(std::get<Grid>(surface), view)
                                                    : RayWalk(std::get<Tin>(surface), view)) {}

} // namespace orograph
