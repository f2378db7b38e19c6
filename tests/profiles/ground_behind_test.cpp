// SPDX-License-Identifier: GPL-3.0-or-later
// The ground behind silhouettes of a grid on a map plane: that behind those of the TIN of its
// triangles, which is walked over another way.
#include "dem/approximate/tin_of_grid.hpp"
#include "profiles/ground_behind.hpp"
#include "profiles/silhouettes.hpp"
#include "profiles/slab_lines.hpp"
#include "tests/catch.hpp"
#include "tests/support/made_grid.hpp"
#include "tests/support/random.hpp"

#include <algorithm>
#include <cmath>
#include <set>

namespace orograph::ground_behind_test {
namespace {

Grid random_grid(Random& random) {
  const int columns = random.whole(3, 24), rows = random.whole(3, 24);
  GridLattice lattice{columns, rows, {}, {30, 0}, {0, random.pick({-20.0, 20.0})}}; // 20: mirrored
  if (random.chance(0.5))
    lattice = turned_lattice(columns, rows, {30, 25}, random.between(-0.7, 0.7),
                             random.between(-0.3, 0.3));
  lattice.first_vertex_m = {random.between(-500, 500), random.between(-500, 500)};
  return made_grid(
      random, lattice,
      {0, random.pick({5.0, 60.0}), random.pick({0.0, 0.1}), false, random.chance(0.5)});
}

View random_view(Random& random) {
  View view;
  view.forward = direction_of_azimuth(Angle::degrees(random.between(0, 360)));
  view.right = {view.forward.y, -view.forward.x};
  view.exaggeration = random.pick({1.0, 2.5});
  if (random.chance(0.5)) view.drop = {1e-6, 3e-7, 2e-6};
  if (random.chance(0.6)) {
    view.projection = Projection::perspective;
    view.depth_origin_m = {random.between(-900, 900), random.between(-900, 900)};
    view.eye_z_m = random.between(0, 200);
  } else {
    view.projection = Projection::orthographic;
    view.elevation = Angle::degrees(random.between(0, 80));
    view.y_per_v = sin(view.elevation);
    view.y_per_z = cos(view.elevation);
    view.x_per_v = random.pick({0.0, random.between(-1, 1)});
  }
  return view;
}

// Of a TIN's vertices, the grid's.
std::vector<std::uint32_t> numbers_in_grid(const Grid& grid) {
  std::set<std::uint32_t> used;
  for (const GridTriangle& t : triangles_of(grid))
    used.insert(t.vertices.begin(), t.vertices.end());
  return {used.begin(), used.end()};
}

} // namespace

TEST_CASE("the ground behind a grid's silhouettes is that behind its triangles'") {
  std::size_t rises = 0, falls = 0;
  for (std::uint64_t seed = 1; seed <= last_seed(2000); ++seed) {
    Random random(seed);
    const Grid grid = random_grid(random);
    const View view = random_view(random);
    const Surface as_grid = grid, as_tin = tin_of(grid);
    const std::vector<std::uint32_t> number = numbers_in_grid(grid);
    const auto in_tin = [&](std::uint32_t vertex) {
      return static_cast<std::uint32_t>(std::lower_bound(number.begin(), number.end(), vertex) -
                                        number.begin());
    };
    const GroundBehind behind(as_grid, view), behind_tin(as_tin, view);
    for (const SurfaceEdge& edge : silhouette_edges(grid, view)) {
      const ProfileLine line = line_of(grid, view, edge);
      const ProfilePoint from = point_between(line.from, line.to, random.between(0.01, 0.99));
      if (view.is_perspective() && !(from.v > 1)) continue;
      const double reach_m = random.pick({10.0, 100.0, 1e5});
      const SurfaceEdge in_its_tin{in_tin(edge.from), in_tin(edge.to)};
      const bool found = behind.rises_within(edge, from, reach_m);
      CAPTURE(seed, edge.from, edge.to, from.u, from.v, from.z, reach_m);
      REQUIRE(found == behind_tin.rises_within(in_its_tin, from, reach_m));
      // Of a silhouette the ground falls away; a point above it has the ray come from above.
      const ProfilePoint above{from.u, from.v, from.z + random.between(0, 30)};
      REQUIRE(behind.falls_within(edge, above, reach_m) ==
              behind_tin.falls_within(in_its_tin, above, reach_m));
      REQUIRE(behind.rises_within(edge, above, reach_m) ==
              behind_tin.rises_within(in_its_tin, above, reach_m));
      ++(found ? rises : falls);
    }
  }
  WARN("the ground rises " << rises << " times and falls " << falls);
  CHECK(rises > enough(20000));
  CHECK(falls > enough(20000));
}

TEST_CASE("silhouettes as marks are those of the list") {
  std::size_t edges = 0;
  for (std::uint64_t seed = 1; seed <= last_seed(500); ++seed) {
    Random random(seed);
    const Grid grid = random_grid(random);
    const View view = random_view(random);
    const std::vector<SurfaceEdge> list = silhouette_edges(grid, view);
    for (const bool rows_are_strips : {true, false}) {
      const SilhouetteMarks marks = silhouette_marks(grid, view, rows_are_strips);
      const int strips = (rows_are_strips ? grid.rows : grid.columns) - 1,
                cells = (rows_are_strips ? grid.columns : grid.rows) - 1;
      std::vector<SurfaceEdge> marked;
      for (int strip = 0; strip < strips; ++strip) {
        REQUIRE(marks.of_strip(strip).size() == static_cast<std::size_t>(cells));
        for (int cell = 0; cell < cells; ++cell)
          for (const std::uint8_t mark :
               {SilhouetteMarks::kAlong, SilhouetteMarks::kUpright, SilhouetteMarks::kDiagonal}) {
            if (!(marks.of_strip(strip)[static_cast<std::size_t>(cell)] & mark)) continue;
            const int column = rows_are_strips ? cell : strip, row = rows_are_strips ? strip : cell;
            const bool east = mark == SilhouetteMarks::kDiagonal ||
                              (mark == SilhouetteMarks::kAlong) == rows_are_strips,
                       south = mark == SilhouetteMarks::kDiagonal ||
                               (mark == SilhouetteMarks::kUpright) == rows_are_strips;
            marked.push_back({static_cast<std::uint32_t>(grid.index(column, row)),
                              static_cast<std::uint32_t>(grid.index(column + east, row + south))});
          }
      }
      std::sort(marked.begin(), marked.end());
      REQUIRE(marked == list);
    }
    edges += list.size();
  }
  CHECK(edges > enough(20000));
}

} // namespace orograph::ground_behind_test
