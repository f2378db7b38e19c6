// SPDX-License-Identifier: GPL-3.0-or-later
// What a view sees of a line of a lattice on the earth is what its vertices say, one by one: rows
// and columns of several blocks, level and rough, with voids and spikes; eyes near and far.
#include "dem/limit_lean.hpp"
#include "profiles/earth_line.hpp"
#include "profiles/eye_side.hpp"
#include "tests/catch.hpp"
#include "tests/profiles/triangle_cuts.hpp"
#include "tests/support/made_earth_grid.hpp"
#include "tests/support/random.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

namespace orograph::earth_line_test {
namespace {

Grid long_grid(Random& random, bool are_rows) {
  MadeEarth made = random_earth(random, 10);
  const int across = random.whole(2, 4), along = random.whole(2, 300);
  made.columns = are_rows ? along : across;
  made.rows = are_rows ? across : along;
  made.north_deg = std::clamp(made.north_deg, -88 + made.rows * made.lat_step_deg, 88.0);
  return made_earth_grid(random, made);
}

View any_view(Random& random, const Grid& grid) {
  const double azimuth_deg =
      random.chance(0.5) ? 90.0 * random.whole(0, 3) : random.between(0, 360);
  const Vec2 forward = direction_of_azimuth(Angle::degrees(azimuth_deg));
  const Vec3 at =
      grid.earth().vertex_m(random.whole(0, grid.columns - 1), random.whole(0, grid.rows - 1), 0);
  const double away_m = random.pick({0.0, 30.0, 3000.0, 1e5, 1e7});
  View view = looking(forward, {at.x - away_m * forward.x, at.y - away_m * forward.y});
  if (random.chance(0.3)) {
    view.x_per_v = random.pick({0.0, 0.5, -1.0});
    return view;
  }
  view.projection = Projection::perspective;
  view.eye_z_m = at.z + random.between(-1000, 6000);
  return view;
}

LookedAt any_part(Random& random, const View& view) {
  const double unit = view.is_perspective() ? 1 : 1e5;
  const double middle = unit * random.between(-0.5, 0.5),
               wide = unit * random.pick({0.01, 0.3, 3.0, kInfinity});
  return {{middle - wide, middle + wide},
          random.pick({-kInfinity, 0.0, 1.0, 1e4, random.between(0, 2e5)})};
}

// By the definition, from the vertices' places and nothing else.
class Vertices {
public:
  Vertices(const Grid& grid, const View& view, bool are_rows, int line) {
    const int count = are_rows ? grid.columns : grid.rows;
    std::vector<double> heights_m;
    for (int i = 0; i < count; ++i) {
      const int column = are_rows ? i : line, row = are_rows ? line : i;
      heights_m.push_back(grid.earth().leaning_height_m(column, row, grid.height_m(column, row)));
    }
    const auto is_there = [](double h) { return !std::isnan(h); };
    const auto first = std::ranges::find_if(heights_m, is_there);
    double last = first == heights_m.end() ? 0 : *first;
    for (int i = 0; i < count; ++i) {
      const double h = heights_m[static_cast<std::size_t>(i)];
      last = is_there(h) ? h : last;
      is_filled.push_back(!is_there(h));
      at.push_back(to_profile_frame(view, are_rows ? grid.earth().vertex_m(i, line, last)
                                                   : grid.earth().vertex_m(line, i, last)));
    }
  }
  std::vector<ProfilePoint> at;
  std::vector<bool> is_filled;
};

} // namespace

TEST_CASE("a line on the earth is looked at as its vertices are") {
  std::uint64_t vertices = 0, beyond = 0, high = 0, low = 0, falling = 0, rising = 0, limited = 0,
                apart = 0, turned = 0;
  for (std::uint64_t seed = 1; seed <= last_seed(2000); ++seed) {
    CAPTURE(seed);
    Random random(seed);
    const bool are_rows = random.chance(0.5), next_is_left = random.chance(0.5);
    Grid grid = long_grid(random, are_rows);
    if (random.chance(0.1)) {
      std::visit([&](auto& heights) { heights.own()[grid.size() / 2] = 32767; }, grid.heights_m);
      limit_lean(grid);
      limited += grid.earth().lean_limits() ? 1 : 0;
    }
    const View view = any_view(random, grid);
    const LookedAt looked = any_part(random, view);
    const bool is_perspective = view.is_perspective();
    const double sign = next_is_left ? 1 : -1;
    EarthLine line(grid, view, looked, are_rows, next_is_left), next = line;
    const int number = random.whole(0, (are_rows ? grid.rows : grid.columns) - 2);
    line.read(number, line);
    next.read(number + 1, line);
    const Vertices of(grid, view, are_rows, number), of_next(grid, view, are_rows, number + 1);
    const std::size_t count = of.at.size();
    REQUIRE(line.beyond().size() == count);
    REQUIRE(line.sides().size() == count - 1);
    const int cells = static_cast<int>(count) - 1;
    bool are_apart = true, are_filled = false;
    for (std::size_t i = 0; i + 1 < count; ++i) {
      const auto on = [](ProfilePoint p) { return Vec2{p.u, p.v}; };
      const Vec2 a = on(of.at[i]), b = on(of.at[i + 1]), c = on(of_next.at[i]),
                 d = on(of_next.at[i + 1]);
      const bool is_filled = of.is_filled[i] || of.is_filled[i + 1] || of_next.is_filled[i] ||
                             of_next.is_filled[i + 1];
      are_filled = are_filled || is_filled;
      are_apart = are_apart && (!is_filled ||
                                (sign * cross(b - a, d - a) > 0 && sign * cross(d - a, c - a) > 0));
    }
    REQUIRE(line.are_apart(next, 0, cells) == are_apart);
    apart += are_filled && are_apart ? 1 : 0;
    turned += are_apart ? 0 : 1;
    std::vector<std::uint8_t> falls(count, 2);
    next.find_falls(next, 0, 0, falls); // nothing
    line.find_falls(next, 1, static_cast<int>(count) - 1, falls);
    for (std::size_t i = 0; i < count; ++i) {
      CAPTURE(i, count, are_rows);
      const ProfilePoint p = of.at[i];
      const double x = is_perspective ? p.u : p.u + p.v * view.x_per_v,
                   w = is_perspective ? p.v : 1;
      REQUIRE(line.place(static_cast<int>(i)) == Vec2{p.u, p.v});
      const auto bit = [&](std::uint8_t which) { return (line.beyond()[i] & which) != 0; };
      const auto& [range, from_m] = looked;
      REQUIRE(bit(EarthLine::kBehind) == (p.v <= from_m));
      REQUIRE(bit(EarthLine::kLeft) == (x < range.begin * w && !std::isinf(range.begin)));
      REQUIRE(bit(EarthLine::kRight) == (x > range.end * w && !std::isinf(range.end)));
      const auto [nearest_m, farthest_m] = line.depths(i / EarthLine::kBlock);
      REQUIRE(nearest_m <= p.v);
      REQUIRE(farthest_m >= p.v);
      beyond += line.beyond()[i] != 0 ? 1 : 0;
      if (i + 1 < count) {
        const double side = sign * way_to_left(view, p, of.at[i + 1]);
        REQUIRE(line.sides()[i] == (side > 0 ? EarthLine::kHigh : side < 0 ? EarthLine::kLow : 0));
        ++(side > 0 ? high : low);
      }
      if (i > 0 && i + 1 < count) {
        const double turn = sign * way_to_left(view, p, of_next.at[i]);
        REQUIRE(falls[i] == (turn < 0 ? 1 : 0));
        ++(turn < 0 ? falling : rising);
      } else {
        REQUIRE(falls[i] == 2);
      }
    }
    vertices += count;
  }
  WARN(vertices << " vertices, " << beyond << " of them beyond, " << high << " and " << low
                << " edges, " << falling << " of the uprights fall and " << rising << " rise, "
                << limited << " lattices with limits, " << apart
                << " filled strips in which nothing is turned over and " << turned << " others");
  CHECK(beyond > enough(50000));
  CHECK(high > enough(50000));
  CHECK(low > enough(50000));
  CHECK(falling > enough(50000));
  CHECK(rising > enough(50000));
  CHECK(limited > enough(10));
  CHECK(apart > enough(50));
  CHECK(turned > enough(50));
}

} // namespace orograph::earth_line_test
