// SPDX-License-Identifier: GPL-3.0-or-later
// Where ground ends over something else at one place, and what a wall hides by itself.
#include "profiles/outline.hpp"
#include "profiles/silhouettes.hpp"
#include "profiles/surface_edges.hpp"
#include "tests/catch.hpp"
#include "tests/profiles/triangle_cuts.hpp"
#include "tests/support/made_tin.hpp"

#include <algorithm>
#include <initializer_list>
#include <set>

namespace orograph::brinks_test {
namespace {

// A square block of height 5 on low ground, open in the east and the west: walls in the south (over
// y = 0) and the north (over y = 4). Vertices by column from the west:
//   0 1 low at y = -4, 2 3 foot and 4 5 top at y = 0, 6 7 top and 8 9 foot at y = 4, 10 11 at y
//   = 8.
Tin block() {
  Tin tin;
  for (const auto& [y, z] : {std::pair{-4., 0.}, {0., 0.}, {0., 5.}, {4., 5.}, {4., 0.}, {8., 0.}})
    for (const double x : {-2.0, 2.0}) tin.vertices_m.push_back({x, y, z});
  for (std::uint32_t row = 0; row < 10; row += 2) {
    tin.triangles.push_back({row, row + 1, row + 3});
    tin.triangles.push_back({row, row + 3, row + 2});
  }
  tin.neighbours = neighbours_by_sorting(tin.triangles);
  return tin;
}

View from_south(double elevation_deg) {
  View view = looking({0, 1});
  view.elevation = Angle::degrees(elevation_deg);
  view.y_per_v = sin(view.elevation);
  view.y_per_z = cos(view.elevation);
  return view;
}

using Edges = std::set<std::pair<std::uint32_t, std::uint32_t>>;
Edges set_of(const std::vector<SurfaceEdge>& edges) {
  Edges out;
  for (const SurfaceEdge& e : edges) out.insert({e.from, e.to});
  CHECK(out.size() == edges.size());
  CHECK(std::is_sorted(edges.begin(), edges.end()));
  return out;
}

} // namespace

TEST_CASE("a block from the south: its back wall hides its own foot and corners") {
  const Tin tin = block();
  const View view = from_south(20);
  CHECK(set_of(edges_behind_walls(Surface(tin), view)) == Edges{{6, 8}, {6, 9}, {7, 9}, {8, 9}});
  CHECK(set_of(silhouette_edges(tin, view)) == Edges{{6, 7}});
  // The foot of the front wall, the top of the back wall, and the end of the ground.
  CHECK(set_of(brinks(Surface(tin), border_edges(tin), view)) == Edges{{2, 3}, {6, 7}, {10, 11}});
}

TEST_CASE("and from the north, in perspective, the other way round") {
  const Tin tin = block();
  View view = looking({0, -1}, {0, 40});
  view.projection = Projection::perspective;
  view.eye_z_m = 20;
  CHECK(set_of(edges_behind_walls(Surface(tin), view)) == Edges{{2, 3}, {2, 4}, {2, 5}, {3, 5}});
  // The sides as well: the eye is between them.
  CHECK(set_of(brinks(Surface(tin), border_edges(tin), view)) ==
        Edges{{0, 1}, {4, 5}, {8, 9}, {0, 2}, {1, 3}, {4, 6}, {5, 7}, {8, 10}, {9, 11}});
}

TEST_CASE("without its walls, a block's ground still ends over what is below") {
  Tin tin = block();
  tin.triangles.erase(tin.triangles.begin() + 6, tin.triangles.begin() + 8); // the back wall
  tin.neighbours = neighbours_by_sorting(tin.triangles);
  const View view = from_south(20);
  CHECK(edges_behind_walls(Surface(tin), view).empty());
  CHECK(set_of(brinks(Surface(tin), border_edges(tin), view)) == Edges{{2, 3}, {6, 7}, {10, 11}});
}

} // namespace orograph::brinks_test
