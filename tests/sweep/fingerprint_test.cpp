// SPDX-License-Identifier: GPL-3.0-or-later
// What tells terrains from each other.
#include "dem/read/read_terrain.hpp"
#include "placing/fingerprint.hpp"
#include "tests/catch.hpp"
#include "tests/support/made_grid.hpp"
#include "tests/support/made_tin.hpp"
#include "tests/sweep/made_sweep.hpp"

#include <cmath>
#include <filesystem>
#include <limits>
#include <set>

using namespace orograph;

namespace {

TerrainData terrain_of(Surface surface) {
  TerrainData terrain{};
  terrain.surface = std::move(surface);
  return terrain;
}

double next(double number) {
  return std::nextafter(number, std::numeric_limits<double>::infinity());
}
float next(float number) {
  return std::nextafter(number, std::numeric_limits<float>::infinity());
}

} // namespace

TEST_CASE("any height, size and corner of a grid shows in its fingerprint") {
  Random random(6);
  for (const bool in_double : {false, true})
    for (int i = 0; i < 20; ++i) {
      const Grid grid = made_grid(
          random, turned_lattice(random.whole(2, 7), random.whole(2, 7), {3, 5}, 0.3, 0.2),
          {.missing = 0.1, .in_double = in_double});
      std::set<std::string> prints{fingerprint(terrain_of(grid))};
      CHECK(prints.begin()->size() == 16);
      CHECK(fingerprint(terrain_of(Grid(grid))) == *prints.begin());
      std::size_t changed = 1;
      const auto add = [&](const Grid& other) {
        prints.insert(fingerprint(terrain_of(other)));
        CHECK(prints.size() == ++changed);
      };
      for (std::size_t vertex = 0; vertex < grid.size(); ++vertex) {
        Grid other = grid;
        std::visit(
            [&](auto& heights) {
              auto& height = heights.own()[vertex];
              height = std::isnan(height) ? 0 : next(height);
            },
            other.heights_m);
        add(other);
      }
      Grid other = grid;
      other.plane().first_vertex_m.x = next(other.plane().first_vertex_m.x);
      add(other);
      other = grid;
      other.plane().row_step_m.y *= 1.001;
      add(other);
      other = grid;
      other.plane().column_step_m.x *= 1.001;
      add(other);
      // Sheared about the diagonal between the first and the last vertex.
      other = grid;
      other.plane().column_step_m.x += 0.5 * (grid.rows - 1);
      other.plane().row_step_m.x -= 0.5 * (grid.columns - 1);
      add(other);
      if (grid.columns != grid.rows) {
        other = grid;
        std::swap(other.columns, other.rows);
        add(other);
      }
    }
}

TEST_CASE("any vertex and triangle of a TIN shows in its fingerprint") {
  Random random(7);
  for (int i = 0; i < 20; ++i) {
    const Tin tin = made_tin(random, {.columns = random.whole(2, 6), .rows = random.whole(2, 6)});
    std::set<std::string> prints{fingerprint(terrain_of(tin))};
    std::size_t changed = 1;
    const auto add = [&](const Tin& other) {
      prints.insert(fingerprint(terrain_of(other)));
      CHECK(prints.size() == ++changed);
    };
    for (std::size_t v = 0; v < tin.vertices_m.size(); ++v)
      for (double Vec3::*coordinate : {&Vec3::x, &Vec3::y, &Vec3::z}) {
        Tin other = tin;
        other.vertices_m[v].*coordinate = next(other.vertices_m[v].*coordinate);
        add(other);
      }
    Tin other = tin;
    other.triangles.pop_back();
    add(other);
    other = tin;
    std::swap(other.triangles[0][0], other.triangles[0][1]);
    add(other);
  }
}

TEST_CASE("where a terrain is on the map shows in its fingerprint, where its file is doesn't") {
  const MadeFolder folder;
  make_terrains(folder);
  std::filesystem::create_directory(folder.path("elsewhere"));
  const auto print_of = [&](const std::string& name) {
    return fingerprint(read_terrain({folder.path(name)}, {}));
  };
  const std::string hill = print_of("hill.asc");
  folder.write("elsewhere/copy.asc", folder.read("hill.asc"));
  CHECK(print_of("elsewhere/copy.asc") == hill);
  folder.write(
      "moved.asc",
      ascii_grid(24, 24, [](int column, int row) { return hill_m(column, row, 24); }, {.x = 10}));
  std::set<std::string> prints{hill, print_of("utm.asc"), print_of("other.asc"),
                               print_of("moved.asc")};
  CHECK(prints.size() == 4);

  // One in degrees has no frame before there is a view: it is always the same then.
  const std::string islands = std::string(OROGRAPH_SOURCE_DIR) + "/data_samples/archipelago.tif";
  ReadOptions less;
  less.bbox = Box2{{2.2, 0.2}, {2.8, 0.8}};
  CHECK(fingerprint(read_terrain({islands}, {})) == fingerprint(read_terrain({islands}, {})));
  CHECK(fingerprint(read_terrain({islands}, {})) != fingerprint(read_terrain({islands}, less)));
}
