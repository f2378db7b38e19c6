// SPDX-License-Identifier: GPL-3.0-or-later
// The order of a Grid, from the geotransform alone.
#include "dem/read/raster_order.hpp"
#include "tests/catch.hpp"
#include "tests/dem/read/stored_surface.hpp"

#include <limits>
#include <vector>

namespace orograph::raster_order_test {
namespace {

bool near(Vec2 a, Vec2 b, double tolerance) {
  return length(a - b) <= tolerance;
}

// Coordinates of 5e6 are right to 1e-9.
constexpr double rounding = 1e-8;

} // namespace

TEST_CASE("every storage of a surface comes to one grid order, at every angle") {
  for (int angle_deg = -44; angle_deg <= 44; angle_deg += 4) {
    const StoredSurface surface = rotated_surface(angle_deg);
    for (const Storage how : all_storages()) {
      const RasterLattice lattice = stored_lattice(surface, how);
      const GridOrder order = grid_order(lattice);
      INFO("angle " << angle_deg << " transposed " << how.transposed);
      REQUIRE(order.columns == surface.columns);
      REQUIRE(order.rows == surface.rows);
      CHECK(near(order.first, surface.first, rounding));
      CHECK(order.column_step == surface.column_step);
      CHECK(order.row_step == surface.row_step);
      // Each pixel goes where its vertex is.
      for (int line = 0; line < lattice.lines; ++line)
        for (int pixel = 0; pixel < lattice.pixels; ++pixel) {
          const auto index = order.start + pixel * order.per_pixel + line * order.per_line;
          REQUIRE(index >= 0);
          REQUIRE(index < order.columns * order.rows);
          const int column = static_cast<int>(index) % order.columns;
          const int row = static_cast<int>(index) / order.columns;
          CHECK(near(lattice.position(pixel, line), surface.position(column, row), rounding));
        }
    }
  }
}

TEST_CASE("turning by more than 45 degrees takes the other order of axes") {
  for (int angle_deg = 48; angle_deg <= 312; angle_deg += 8) {
    if ((angle_deg + 45) % 90 == 0) continue;
    const GridOrder order = grid_order(stored_lattice(rotated_surface(angle_deg), {}));
    INFO("angle " << angle_deg);
    CHECK(order.column_step.x > std::abs(order.column_step.y));
    CHECK(-order.row_step.y > std::abs(order.row_step.x));
    CHECK(cross(order.column_step, order.row_step) < 0);
    const bool upright = (angle_deg + 45) / 90 % 2 == 0;
    CHECK(order.columns == (upright ? 7 : 5));
  }
}

TEST_CASE("at 45 degrees all storages agree too") {
  for (const double angle_deg : {45., 135., 225., 315.}) {
    const StoredSurface surface = rotated_surface(angle_deg);
    for (const Storage how : all_storages()) {
      const GridOrder order = grid_order(stored_lattice(surface, how));
      CHECK(order.column_step.x > 0);
      CHECK(order.column_step.y > 0);
      CHECK(order.row_step.x > 0);
      CHECK(order.row_step.y < 0);
    }
  }
}

TEST_CASE("a sheared raster keeps its rows to the right of its columns") {
  for (const double shear : {-3., -1., -0.2, 0.2, 1., 3.}) {
    StoredSurface surface;
    surface.row_step = {8 * shear, -8};
    Vec2 column, row;
    for (const Storage how : all_storages()) {
      const GridOrder order = grid_order(stored_lattice(surface, how));
      CHECK(cross(order.column_step, order.row_step) < 0);
      if (how.transposed || how.columns_reversed || how.rows_reversed) {
        CHECK(order.column_step == column);
        CHECK(order.row_step == row);
      }
      column = order.column_step;
      row = order.row_step;
    }
  }
}

TEST_CASE("steps that don't span a plane are told") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto spans = [](Vec2 p, Vec2 l) { return spans_a_plane({3, 3, {0, 0}, p, l}); };
  CHECK(spans({10, 0}, {0, -10}));
  CHECK(spans({1e-5, 0}, {0, 1e5}));
  CHECK(!spans({10, 0}, {0, 0}));
  CHECK(!spans({10, 5}, {20, 10}));
  CHECK(!spans({0, 0}, {0, -10}));
  CHECK(!spans({nan, 0}, {0, -10}));
  CHECK(!spans_a_plane({3, 3, {nan, 0}, {1, 0}, {0, 1}}));
}

TEST_CASE("a window holds the vertices in the box and no others") {
  const StoredSurface surface;
  const Box2 box{{500014, 4999970}, {500036, 4999990}}; // columns 1 to 3, rows 1 to 3
  for (const Storage how : all_storages()) {
    const RasterLattice lattice = stored_lattice(surface, how);
    const RasterWindow window = window_of(lattice, box);
    const RasterLattice part = part_of(lattice, window);
    int inside = 0;
    for (int line = 0; line < lattice.lines; ++line)
      for (int pixel = 0; pixel < lattice.pixels; ++pixel)
        inside += in_box(lattice, lattice.position(pixel, line), box);
    CHECK(inside == 9);
    CHECK(window.pixels * window.lines == 9);
    for (int line = 0; line < part.lines; ++line)
      for (int pixel = 0; pixel < part.pixels; ++pixel)
        CHECK(in_box(part, part.position(pixel, line), box));
  }
}

TEST_CASE("the window's border counts, whatever rounding does to it") {
  const StoredSurface surface = [] {
    StoredSurface odd;
    odd.first = {0.1, 0.7};
    odd.column_step = {0.1, 0};
    odd.row_step = {0, -0.1};
    return odd;
  }();
  const RasterLattice lattice = stored_lattice(surface, {});
  const RasterWindow window = window_of(lattice, {{0.3, 0.4}, {0.6, 0.7}});
  CHECK(window.pixel == 2);
  CHECK(window.pixels == 4);
  CHECK(window.line == 0);
  CHECK(window.lines == 4);
  const RasterWindow nothing = window_of(lattice, {{1e300, 0}, {1e301, 1}});
  CHECK(nothing.pixels * nothing.lines == 0);
}

} // namespace orograph::raster_order_test
