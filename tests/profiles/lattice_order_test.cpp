// SPDX-License-Identifier: GPL-3.0-or-later
// The order of a lattice's triangles and edges, by its definition: nothing is taken before what a
// ray meets earlier. All in whole numbers: the eye stands at eighths of a cell, so that it is often
// on lines, diagonals and vertices; rays and crossings are fractions, compared exactly.
#include "profiles/lattice_order.hpp"
#include "tests/catch.hpp"
#include "tests/support/random.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <vector>

namespace orograph::lattice_order_test {
namespace {

using Whole = std::int64_t; // numbers here stay below 10^6, their products below 10^12
constexpr int kUnit = 8;    // a cell

struct Place {
  std::int64_t x, y; // columns and rows, in eighths of a cell
};
Whole cross_of(Place a, Place b) {
  return Whole{a.x} * b.y - Whole{a.y} * b.x;
}
Place from_to(Place a, Place b) {
  return {b.x - a.x, b.y - a.y};
}

struct Fraction {
  Whole above, below; // below > 0
  bool operator==(const Fraction& o) const { return above * o.below == o.above * below; }
  bool operator<(const Fraction& o) const { return above * o.below < o.above * below; }
  bool operator<=(const Fraction& o) const { return !(o < *this); }
};

struct Ray {
  Place from, along;
  bool is_half; // begins at `from`
};

// What a ray meets: a triangle along a stretch of it, or an edge in a point. An edge is crossed
// properly if its ends are on either side of the ray.
struct Met {
  Fraction begin, end;
  bool properly;
  LatticeOrder::Turn turn;
  std::string what;
};

struct Lattice {
  int columns, rows;
  std::uint32_t vertex(int c, int r) const { return static_cast<std::uint32_t>(r * columns + c); }
};

void meet_edge(const LatticeOrder& order, const Lattice& lattice, const Ray& ray, int c, int r,
               int right, int down, std::vector<Met>& all) {
  const Place a{c * kUnit, r * kUnit}, b{(c + right) * kUnit, (r + down) * kUnit};
  const Whole side_a = cross_of(ray.along, from_to(ray.from, a)),
              side_b = cross_of(ray.along, from_to(ray.from, b));
  if (side_a == 0 && side_b == 0) return; // runs along the ray
  if ((side_a > 0 && side_b > 0) || (side_a < 0 && side_b < 0)) return;
  const Place edge = from_to(a, b);
  Whole above = cross_of(from_to(ray.from, a), edge), below = cross_of(ray.along, edge);
  if (below < 0) above = -above, below = -below;
  if (ray.is_half && above <= 0) return;
  const Fraction at{above, below};
  all.push_back({at, at, side_a != 0 && side_b != 0,
                 order.turn(SurfaceEdge{lattice.vertex(c, r), lattice.vertex(c + right, r + down)}),
                 "edge " + std::to_string(c) + "," + std::to_string(r) + "+" +
                     std::to_string(right) + "," + std::to_string(down)});
}

void meet_triangle(const LatticeOrder& order, const Ray& ray, int c, int r, Half half,
                   std::vector<Met>& all) {
  const std::array<Place, 3> corners{
      Place{c * kUnit, r * kUnit}, Place{(c + 1) * kUnit, (r + 1) * kUnit},
      half == Half::lower ? Place{c * kUnit, (r + 1) * kUnit} : Place{(c + 1) * kUnit, r * kUnit}};
  std::vector<Fraction> ends;
  for (std::size_t i = 0; i < 3; ++i) {
    const Place a = corners[i], b = corners[(i + 1) % 3], edge = from_to(a, b);
    const Whole side_a = cross_of(ray.along, from_to(ray.from, a)),
                side_b = cross_of(ray.along, from_to(ray.from, b));
    if (side_a == 0 && side_b == 0) return; // touches it along an edge
    if ((side_a > 0 && side_b > 0) || (side_a < 0 && side_b < 0)) continue;
    Whole above = cross_of(from_to(ray.from, a), edge), below = cross_of(ray.along, edge);
    if (below < 0) above = -above, below = -below;
    ends.push_back({above, below});
  }
  if (ends.empty()) return;
  auto [begin, end] = std::minmax_element(ends.begin(), ends.end());
  Fraction first = *begin;
  const Fraction start{0, 1};
  if (ray.is_half && first < start) first = start; // the eye is over the triangle
  if (!(first < *end)) return;
  all.push_back(
      {first, *end, true, order.turn(c, r, half),
       (half == Half::lower ? "lower " : "upper ") + std::to_string(c) + "," + std::to_string(r)});
}

std::vector<Met> meet_all(const LatticeOrder& order, const Lattice& lattice, const Ray& ray) {
  std::vector<Met> all;
  for (int r = 0; r < lattice.rows; ++r)
    for (int c = 0; c < lattice.columns; ++c) {
      const bool right = c + 1 < lattice.columns, down = r + 1 < lattice.rows;
      if (right) meet_edge(order, lattice, ray, c, r, 1, 0, all);
      if (down) meet_edge(order, lattice, ray, c, r, 0, 1, all);
      if (!right || !down) continue;
      meet_edge(order, lattice, ray, c, r, 1, 1, all);
      for (const Half half : {Half::lower, Half::upper}) meet_triangle(order, ray, c, r, half, all);
    }
  return all;
}

std::size_t pairs_asked = 0;

void check_ray(const LatticeOrder& order, const Lattice& lattice, const Ray& ray) {
  const std::vector<Met> all = meet_all(order, lattice, ray);
  for (const Met& near : all)
    for (const Met& far : all) {
      if (!(near.properly || far.properly) || !(near.end <= far.begin)) continue;
      if (near.begin == far.end) continue; // two edges at one place
      const bool touch = near.end == far.begin;
      if (touch && !(near.properly && far.properly)) continue;
      ++pairs_asked;
      if (near.turn < far.turn) continue;
      FAIL_CHECK(near.what << " is in front of " << far.what << " and taken behind it");
      return;
    }
}

} // namespace

TEST_CASE("nothing is taken before what a ray meets earlier") {
  pairs_asked = 0;
  for (std::uint64_t seed = 1; seed <= last_seed(3000); ++seed) {
    Random random(seed);
    const Lattice lattice{random.whole(2, 7), random.whole(2, 7)};
    const bool is_parallel = random.chance(0.3);
    // Inside of the lattice, or around it.
    const int beside = random.chance(0.7) ? 0 : 40;
    const int grain = random.pick({1, 2, 4, 8});
    const auto place = [&](int count) {
      return std::int64_t{random.whole(-beside / grain, ((count - 1) * kUnit + beside) / grain) *
                          grain};
    };
    const Place eye{place(lattice.columns), place(lattice.rows)};
    const auto direction = [&] {
      Place d{};
      while (d.x == 0 && d.y == 0) d = {random.whole(-9, 9), random.whole(-9, 9)};
      return d;
    };
    const Place along = direction();
    EyeInCells at{static_cast<double>(eye.x) / kUnit, static_cast<double>(eye.y) / kUnit, 0};
    if (is_parallel)
      at = {-1.0 * static_cast<double>(along.x), -1.0 * static_cast<double>(along.y), 0};
    for (const bool rows_are_strips : {true, false}) {
      INFO("seed " << seed << (is_parallel ? ", parallel" : "") << ", eye " << at.column << ", "
                   << at.row << ", strips are " << (rows_are_strips ? "rows" : "columns"));
      const LatticeOrder order(lattice.columns, lattice.rows, at, is_parallel, rows_are_strips);
      for (int i = 0; i < 14; ++i) {
        if (is_parallel)
          check_ray(order, lattice, {{place(lattice.columns), place(lattice.rows)}, along, false});
        else
          check_ray(order, lattice, {eye, direction(), true});
      }
    }
  }
  CHECK(pairs_asked > enough(3000000));
}

TEST_CASE("places of the order hold what has its turn there") {
  for (std::uint64_t seed = 1; seed <= last_seed(500); ++seed) {
    Random random(seed);
    const Lattice lattice{random.whole(2, 6), random.whole(2, 6)};
    const EyeInCells eye{random.whole(-2, 14) * 0.5, random.whole(-2, 14) * 0.5, 0};
    for (const bool rows : {true, false}) {
      INFO("seed " << seed << ", eye " << eye.column << ", " << eye.row << (rows ? ", rows" : ""));
      const LatticeOrder order(lattice.columns, lattice.rows, eye, random.chance(0.2), rows);
      std::vector<int> strips, lines;
      for (std::uint32_t i = 0; i < order.place_count(); ++i) {
        const auto [line, strip] = order.place(i);
        if (line != LatticeOrder::Place::kNone) {
          lines.push_back(line);
          const SurfaceEdge edge =
              rows ? SurfaceEdge{lattice.vertex(0, line), lattice.vertex(1, line)}
                   : SurfaceEdge{lattice.vertex(line, 0), lattice.vertex(line, 1)};
          CHECK(LatticeOrder::place_of(order.turn(edge)) == i);
          CHECK(LatticeOrder::is_on_line(order.turn(edge)));
        }
        if (strip != LatticeOrder::Place::kNone) {
          strips.push_back(strip);
          const auto turn =
              rows ? order.turn(0, strip, Half::lower) : order.turn(strip, 0, Half::upper);
          CHECK(LatticeOrder::place_of(turn) == i);
          CHECK(!LatticeOrder::is_on_line(turn));
        }
      }
      std::sort(strips.begin(), strips.end());
      std::sort(lines.begin(), lines.end());
      const int cells = (rows ? lattice.rows : lattice.columns) - 1;
      REQUIRE(static_cast<int>(strips.size()) == cells);
      REQUIRE(static_cast<int>(lines.size()) == cells + 1);
      for (int i = 0; i < cells; ++i) CHECK(strips[static_cast<std::size_t>(i)] == i);
      for (int i = 0; i <= cells; ++i) CHECK(lines[static_cast<std::size_t>(i)] == i);
    }
  }
}

} // namespace orograph::lattice_order_test
