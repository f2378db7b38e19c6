// SPDX-License-Identifier: GPL-3.0-or-later
#include "profiles/slab_lines.hpp"
#include "tests/catch.hpp"
#include "tests/profiles/triangle_cuts.hpp"
#include "tests/support/made_grid.hpp"
#include "tests/support/random.hpp"

#include <algorithm>
#include <limits>

namespace orograph::slab_lines_test {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

double near_end(const ProfileLine& line) {
  return std::min(line.from.v, line.to.v);
}
double far_end(const ProfileLine& line) {
  return std::max(line.from.v, line.to.v);
}

std::vector<ProfileLine> random_lines(Random& random) {
  const bool whole = random.chance(0.5); // so that ends lie in planes, and lines too
  const auto depth = [&] {
    const double v = random.between(-4, 9);
    return whole ? std::floor(v) : v;
  };
  std::vector<ProfileLine> lines;
  for (int i = random.whole(0, 30); i > 0; --i)
    lines.push_back({{random.between(-9, 9), depth(), random.between(0, 9)},
                     {random.between(-9, 9), depth(), random.between(0, 9)}});
  return lines;
}

double distance(const ProfilePoint& a, const ProfilePoint& b) {
  return std::hypot(a.u - b.u, a.v - b.v, a.z - b.z);
}

} // namespace

TEST_CASE("the pieces of all slabs tile each line") {
  // Coordinates up to 9, and a share with a rounding or two of 1: a few ulp of 9.
  constexpr double rounding = 1e-14;
  for (std::uint64_t seed = 1; seed <= last_seed(2000); ++seed) {
    Random random(seed);
    INFO("seed " << seed);
    const auto lines = random_lines(random);
    const double from = random.pick({-infinity, -2.0, 1.0, random.between(-4, 9)});
    std::vector<LineAtDepth> depths;
    for (std::uint32_t i = 0; i < lines.size(); ++i)
      depths.push_back({i, static_cast<float>(near_end(lines[i]))});
    SlabLines slabs(
        depths, [&](std::uint32_t i) { return lines[i]; }, from);
    std::vector<std::vector<SlabPiece>> by_line(lines.size());
    double plane = random.chance(0.5) ? std::max(from, -5.0) : std::max(from, 2.0), last = from;
    while (last < infinity) {
      slabs.next(plane, [&](const SlabPiece& piece) {
        const ProfileLine& line = lines[piece.line];
        by_line[piece.line].push_back(piece);
        REQUIRE(piece.t_begin < piece.t_end);
        for (const auto& [t, at] :
             {std::pair(piece.t_begin, piece.begin), {piece.t_end, piece.end}}) {
          REQUIRE(at.v >= last - rounding);
          REQUIRE(at.v <= plane + rounding);
          const ProfilePoint on_line{line.from.u + t * (line.to.u - line.from.u),
                                     line.from.v + t * (line.to.v - line.from.v),
                                     line.from.z + t * (line.to.z - line.from.z)};
          REQUIRE(distance(at, on_line) <= rounding);
        }
        // A line in a plane belongs to the slab in front of it.
        if (line.from.v == line.to.v && line.from.v != from) REQUIRE(line.from.v > last);
        return true;
      });
      last = plane;
      plane = plane > 9 ? infinity : plane + random.pick({0.0, 1.0, random.between(0, 2)});
    }
    for (std::size_t i = 0; i < lines.size(); ++i) {
      CAPTURE(i, lines[i].from.v, lines[i].to.v, from);
      auto& pieces = by_line[i];
      const bool whole = near_end(lines[i]) >= from;
      const bool none = whole ? false : far_end(lines[i]) <= from;
      REQUIRE(pieces.empty() == none);
      if (none) continue;
      std::sort(pieces.begin(), pieces.end(),
                [](const SlabPiece& a, const SlabPiece& b) { return a.t_begin < b.t_begin; });
      for (std::size_t k = 0; k + 1 < pieces.size(); ++k)
        REQUIRE(pieces[k].t_end == pieces[k + 1].t_begin);
      const bool near_first = lines[i].from.v <= lines[i].to.v;
      if (whole || !near_first) {
        REQUIRE(pieces.front().t_begin == 0);
        REQUIRE(distance(pieces.front().begin, lines[i].from) == 0);
      } else {
        REQUIRE(std::abs(pieces.front().begin.v - from) <= rounding);
      }
      if (whole || near_first) {
        REQUIRE(pieces.back().t_end == 1);
        REQUIRE(distance(pieces.back().end, lines[i].to) == 0);
      } else {
        REQUIRE(std::abs(pieces.back().end.v - from) <= rounding);
      }
    }
  }
}

TEST_CASE("a line that isn't taken any more is left out of all slabs behind") {
  const std::vector<ProfileLine> lines{{{0, 0.5, 0}, {1, 3.5, 0}}, {{0, 0.5, 0}, {1, 2.5, 0}}};
  const std::vector<LineAtDepth> depths{{0, 0.5F}, {1, 0.5F}};
  SlabLines slabs(
      depths, [&](std::uint32_t i) { return lines[i]; }, -infinity);
  std::vector<std::uint32_t> taken;
  for (const double plane : {1.0, 2.0, 3.0, 4.0})
    slabs.next(plane, [&](const SlabPiece& piece) {
      taken.push_back(piece.line);
      return piece.line == 0 || plane < 2;
    });
  CHECK(std::count(taken.begin(), taken.end(), 0U) == 4);
  CHECK(std::count(taken.begin(), taken.end(), 1U) == 2);
}

TEST_CASE("a grid edge in the profile frame runs from its lower vertex to its higher one") {
  Random random(3);
  const Grid grid = made_grid(random, turned_lattice(5, 4, {10, 12}, 0.3), {});
  const View view = looking({0.6, 0.8}, {5, -7}, 1.5);
  const auto check = [&](std::uint32_t vertex, const ProfilePoint& p) {
    const Vec3 at = vertex_m(grid, vertex);
    CHECK(std::abs(p.u - ((at.x - 5) * 0.8 - (at.y + 7) * 0.6)) <= 1e-13);
    CHECK(std::abs(p.v - ((at.x - 5) * 0.6 + (at.y + 7) * 0.8)) <= 1e-13);
    CHECK(p.z == 1.5 * at.z);
  };
  for (const SurfaceEdge edge : {SurfaceEdge{0, 1}, {3, 8}, {7, 13}, {14, 19}}) {
    const ProfileLine line = line_of(grid, view, edge);
    check(edge.from, line.from);
    check(edge.to, line.to);
  }
}

} // namespace orograph::slab_lines_test
