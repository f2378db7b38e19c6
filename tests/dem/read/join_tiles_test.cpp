// SPDX-License-Identifier: GPL-3.0-or-later
// Tiles on one lattice, around the earth.
#include "dem/read/join_tiles.hpp"
#include "geometry/error.hpp"
#include "tests/catch.hpp"
#include "tests/dem/read/refused.hpp"
#include "tests/dem/read/stored_surface.hpp"
#include "tests/support/random.hpp"

#include <cmath>
#include <map>

namespace orograph::join_tiles_test {
namespace {

/// `count` columns with their first at a longitude, in steps of `step` degrees; 3 rows.
Tile tile_at(double west, int count, double step, double north = 10) {
  return {"tile", {count, 3, {west, north}, {step, 0}, {0, -step}}};
}

JoinedTiles joined(const std::vector<Tile>& tiles) {
  return join_tiles(tiles, 360, std::nullopt);
}

std::string refusal(const std::vector<Tile>& tiles) {
  try {
    joined(tiles);
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

} // namespace

TEST_CASE("tiles on both sides of 180 degrees become neighbours") {
  // As SRTM has them (a common column), and as Copernicus has (none).
  for (const bool shared : {true, false}) {
    const double step = 1. / 1200;
    const int count = shared ? 1201 : 1200;
    const Tile east = tile_at(179, count, step), west = tile_at(-180, count, step);
    for (const bool swapped : {false, true}) {
      const JoinedTiles all = swapped ? joined({west, east}) : joined({east, west});
      CHECK(all.lattice.pixels == (shared ? 2401 : 2400));
      CHECK(all.lattice.lines == 3);
      CHECK(all.lattice.first == Vec2{179, 10});
      CHECK(all.places[swapped ? 1 : 0].at.pixel == 0);
      CHECK(all.places[swapped ? 0 : 1].at.pixel == 1200);
    }
  }
}

TEST_CASE("tiles that count longitudes otherwise go to where the others are") {
  const JoinedTiles all = joined({tile_at(-72, 11, 0.1), tile_at(289, 11, 0.1)});
  CHECK(all.lattice.first.x == -72);
  CHECK(all.lattice.pixels == 21);
  // Around the whole earth nothing has to move.
  std::vector<Tile> world;
  for (int west = -180; west < 180; west += 10) world.push_back(tile_at(west, 10, 1));
  CHECK(joined(world).lattice.first.x == -180);
  CHECK(joined(world).lattice.pixels == 360);
  // But for a gap at Greenwich.
  world.erase(world.begin() + 18);
  CHECK(joined(world).lattice.first.x == 10);
  CHECK(joined(world).lattice.pixels == 350);
  // A single grid stays as it is, and takes others in.
  CHECK(joined({tile_at(0, 360, 1)}).lattice.first.x == 0);
  CHECK(joined({tile_at(0, 361, 1)}).lattice.pixels == 361);
  const JoinedTiles within = joined({tile_at(0, 360, 1), tile_at(-72, 5, 1)});
  CHECK(within.lattice.pixels == 360);
  CHECK(within.places[1].at.pixel == 288);
}

TEST_CASE("tiles above each other may begin a rounding apart, and at other counts of turns") {
  for (const double off : {1e-11, -1e-11}) {
    const JoinedTiles all = joined({tile_at(7, 20, 1), tile_at(7 + off, 20, 1, 7),
                                    tile_at(367, 20, 1, 4), tile_at(-353 + off, 20, 1, 13)});
    CHECK(all.lattice.pixels == 20);
    CHECK(all.lattice.lines == 12);
  }
}

TEST_CASE("tiles of a part of the earth come together wherever it is") {
  Random random(3);
  for (int run = 0; run < 300; ++run) {
    // A row of touching tiles that leaves 20 degrees free at least, each counted anyhow.
    const int start = random.whole(-180, 179), count = random.whole(1, 17);
    std::vector<Tile> tiles;
    std::map<std::size_t, int> columns;
    for (int i = 0; i < count; ++i) {
      columns[tiles.size()] = 20 * i;
      const double turns = random.whole(-1, 1);
      tiles.push_back(tile_at(start + 20 * i + 360 * turns, random.whole(20, 25), 1));
    }
    const double west = tiles.front().lattice.first.x;
    const JoinedTiles all = joined(tiles);
    CHECK(all.lattice.first.x == west);
    for (const TilePlace& place : all.places) CHECK(place.at.pixel == columns[place.tile]);
  }
}

TEST_CASE("tiles around the earth that don't meet are refused") {
  check_message(refusal({tile_at(0, 20, 1), tile_at(181, 10, 1)}), {"doesn't touch"});
  // A turn that is no whole number of columns: the neighbour's vertices lie between.
  check_message(refusal({tile_at(170, 34, 0.7), tile_at(-170, 20, 0.7)}), {"beside the lattice"});
}

TEST_CASE("a window over a grid's end goes on at its beginning") {
  Random random(4);
  for (int run = 0; run < 300; ++run) {
    const int first = random.pick({-180, 0, -90}), count = random.pick({360, 361, 90});
    JoinedTiles all = joined({tile_at(first, count, 1)});
    const double low = first + random.whole(-500, 500), width = random.whole(0, 360);
    const double x = turned_onto(low, width, first, first + count - 1, 360);
    CHECK(std::remainder(x - low, 360) == 0);
    const Box2 window{{x, 0}, {x + width, 20}};
    continue_around(all, 360, window);
    // Every meridian of the window that the grid has is there, at its place.
    std::map<int, int> found; // longitude to the grid's column
    for (const TilePlace& place : all.places)
      for (int column = 0; column < place.at.pixels; ++column) {
        const Vec2 at = all.lattice.position(place.at.pixel + column, 0);
        CHECK(std::remainder(at.x - (first + column), 360) == 0);
        found[static_cast<int>(std::lround(at.x))] = column;
      }
    int wanted = 0;
    for (int lon = static_cast<int>(x); lon <= x + width; ++lon) {
      const int column = ((lon - first) % 360 + 360) % 360; // in a grid of a whole turn, or none
      if (column >= count) continue;
      ++wanted;
      REQUIRE(found.contains(lon));
      CHECK((found[lon] - column) % 360 == 0);
    }
    CHECK((window_of(all.lattice, window).pixels > 0) == (wanted > 0));
    CHECK(all.lattice.pixels <= 3 * count + 720);
  }
}

TEST_CASE("heights of any storage go to their place in a wider array") {
  for (const Storage how : all_storages()) {
    const StoredSurface surface;
    const RasterLattice lattice = stored_lattice(surface, how);
    const GridOrder order = grid_order(lattice);
    const RasterWindow part{2, 1, 4, 3}; // columns 2 to 5, rows 1 to 3
    const RasterWindow window = raster_window(order, part);
    const GridOrder within = order_within(order, part, 20, 7, 5);
    CHECK(window.pixels * window.lines == 12);
    for (int line = 0; line < window.lines; ++line)
      for (int pixel = 0; pixel < window.pixels; ++pixel) {
        const auto index = within.start + pixel * within.per_pixel + line * within.per_line;
        const int column = static_cast<int>(index % 20) - 7 + 2;
        const int row = static_cast<int>(index / 20) - 5 + 1;
        CHECK(column >= 2);
        CHECK(column <= 5);
        CHECK(row >= 1);
        CHECK(row <= 3);
        CHECK(length(lattice.position(window.pixel + pixel, window.line + line) -
                     surface.position(column, row)) <= 1e-8);
      }
  }
}

} // namespace orograph::join_tiles_test
