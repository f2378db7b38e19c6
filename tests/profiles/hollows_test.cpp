// SPDX-License-Identifier: GPL-3.0-or-later
// Closed lines around lower ground against what is lower: parts of the ground below a level that
// hang together, on heights of few whole numbers, so that lines touch in vertices all the time.
#include "dem/approximate/tin_of_grid.hpp"
#include "profiles/hollows.hpp"
#include "tests/catch.hpp"
#include "tests/support/made_grid.hpp"
#include "tests/support/random.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

namespace orograph::hollows_test {
namespace {

VertexValues given(const std::vector<double>& value) {
  return [&value](std::size_t first, std::span<double> out) {
    std::copy_n(value.begin() + static_cast<std::ptrdiff_t>(first), out.size(), out.begin());
  };
}

struct Counted {
  std::size_t closed = 0, at_border = 0;
};

// Parts of the ground below a level: by the edges of triangles between vertices that are below it.
Counted parts_below(const Grid& grid, const std::vector<double>& value, double level) {
  std::vector<std::uint32_t> part(value.size());
  std::iota(part.begin(), part.end(), 0U);
  const auto root = [&](std::uint32_t i) {
    while (part[i] != i) i = part[i];
    return i;
  };
  std::vector<bool> is_there(value.size()), is_border(value.size());
  for (const GridTriangle& triangle : triangles_of(grid))
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t a = triangle.vertices[k], b = triangle.vertices[(k + 1) % 3];
      is_there[a] = true;
      if (value[a] < level && value[b] < level) part[root(a)] = root(b);
    }
  for (const auto& [from, to] : outline_by_triangles(grid)) is_border[from] = is_border[to] = true;
  std::vector<bool> at_border(value.size());
  for (std::uint32_t i = 0; i < value.size(); ++i)
    if (is_there[i] && value[i] < level && is_border[i]) at_border[root(i)] = true;
  Counted out;
  for (std::uint32_t i = 0; i < value.size(); ++i)
    if (is_there[i] && value[i] < level && root(i) == i)
      ++(at_border[i] ? out.at_border : out.closed);
  return out;
}

// Whether a place is within a polygon, by a ray to the east.
bool is_within(Vec2 place, const std::vector<Vec2>& polygon) {
  bool within = false;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec2 a = polygon[i], b = polygon[(i + 1) % polygon.size()];
    if ((a.y > place.y) == (b.y > place.y)) continue;
    if (a.x + (place.y - a.y) / (b.y - a.y) * (b.x - a.x) > place.x) within = !within;
  }
  return within;
}

Vec2 plan_of(const Grid& grid, std::uint32_t vertex) {
  const Vec3 at = vertex_m(grid, vertex) - vertex_m(grid, 0);
  return {at.x, at.y};
}

GridLattice some_lattice(Random& random) {
  return turned_lattice(random.whole(3, 30), random.whole(3, 30), {random.between(5, 50), 20},
                        random.between(0, 6), random.between(-0.4, 0.4));
}

} // namespace

TEST_CASE("every part of the ground below a level that reaches no border has its line") {
  std::size_t count = 0;
  for (std::uint64_t seed = 1; seed <= last_seed(120); ++seed) {
    Random random(seed);
    INFO("seed " << seed);
    const Grid grid = made_grid(random, some_lattice(random),
                                {.low = 0,
                                 .high = random.between(2, 9),
                                 .missing = seed % 3 == 0 ? 0.02 : 0,
                                 .whole = seed % 5 != 0});
    std::vector<double> value;
    for (int r = 0; r < grid.rows; ++r)
      for (int c = 0; c < grid.columns; ++c) value.push_back(grid.height_m(c, r));
    std::vector<double> levels{0.5};
    for (double level = 1; level < 9; ++level) levels.push_back(level);
    const Surface as_grid = grid, as_tin = tin_of(grid);
    const auto find = [&](const Surface& surface, const VertexValues& values) {
      return hollows(PlanTriangles(surface, values), levels,
                     isolines(surface, values, levels).lines);
    };
    const std::vector<Hollow> found = find(as_grid, given(value));
    std::vector<double> of_tin;
    for (const Vec3& vertex : std::get<Tin>(as_tin).vertices_m) of_tin.push_back(vertex.z);
    CHECK(find(as_tin, given(of_tin)).size() == found.size());

    for (std::uint32_t i = 0; i < levels.size(); ++i) {
      const Counted wanted = parts_below(grid, value, levels[i]);
      const auto lines = static_cast<std::size_t>(std::ranges::count(found, i, &Hollow::level));
      // A part around a void may have a line around both.
      CHECK(lines >= wanted.closed);
      CHECK(lines <= wanted.closed + (seed % 3 == 0 ? wanted.at_border : 0));
      count += wanted.closed;
    }
    for (const Hollow& hollow : found) {
      std::vector<Vec2> polygon;
      for (const auto& [at, triangle] : hollow.line)
        polygon.push_back((1 - at.t) * plan_of(grid, at.edge.from) +
                          at.t * plan_of(grid, at.edge.to));
      std::size_t outside = 0;
      double twice = 0;
      for (std::size_t k = 0; k < polygon.size(); ++k) {
        const auto& [from, to] = hollow.line[k].at.edge;
        outside += is_within(plan_of(grid, value[from] < value[to] ? from : to), polygon) ? 0 : 1;
        twice += cross(polygon[k], polygon[(k + 1) % polygon.size()]);
      }
      CHECK(outside == 0);
      CHECK(std::abs(hollow.area_m2 - std::abs(twice) / 2) <= 1e-9 * hollow.area_m2 + 1e-6);
    }
  }
  CHECK(count > enough(2000));
}

TEST_CASE("the way down is straight, falls, and stays in its triangles") {
  std::size_t pieces_of_several = 0;
  for (std::uint64_t seed = 1; seed <= last_seed(300); ++seed) {
    Random random(seed);
    INFO("seed " << seed);
    const Grid grid = made_grid(random, some_lattice(random), {.low = 0, .high = 100});
    std::vector<double> value;
    for (int r = 0; r < grid.rows; ++r)
      for (int c = 0; c < grid.columns; ++c) value.push_back(grid.height_m(c, r));
    const Surface surface = grid;
    const VertexValues values = given(value);
    const PlanTriangles triangles(surface, values);
    const auto all = triangles_of(grid);
    const auto first =
        static_cast<std::uint32_t>(random.whole(0, static_cast<int>(all.size()) - 1));
    const auto& corners = all[first].vertices;
    const double a = random.between(0.05, 0.6), b = random.between(0.05, 0.3);
    const auto place_of = [&](const std::array<std::uint32_t, 3>& of,
                              const std::array<double, 3>& shares) {
      return shares[0] * plan_of(grid, of[0]) + shares[1] * plan_of(grid, of[1]) +
             shares[2] * plan_of(grid, of[2]);
    };
    const auto value_of = [&](const std::array<std::uint32_t, 3>& of,
                              const std::array<double, 3>& shares) {
      return shares[0] * value[of[0]] + shares[1] * value[of[1]] + shares[2] * value[of[2]];
    };
    const Vec2 begin = place_of(corners, {a, b, 1 - a - b});
    const double height = value_of(corners, {a, b, 1 - a - b});
    const double most_m = random.between(1, 60), lowest = height - random.between(0, 60);
    const auto number = static_cast<std::uint32_t>(
        grid_triangle(grid, all[first].column, all[first].row, all[first].half));
    const std::vector<DownhillPiece> way = downhill(triangles, number, begin, most_m, lowest);
    REQUIRE(!way.empty());
    pieces_of_several += way.size() > 1 ? 1 : 0;
    Vec2 at = begin;
    double last = height;
    const auto corners_of = [&](const DownhillPiece& piece) {
      return std::ranges::find_if(all,
                                  [&](const GridTriangle& t) {
                                    return grid_triangle(grid, t.column, t.row, t.half) ==
                                           piece.triangle;
                                  })
          ->vertices;
    };
    const Vec2 end = place_of(corners_of(way.back()), way.back().to);
    for (const DownhillPiece& piece : way) {
      const auto of = corners_of(piece);
      for (const auto* shares : {&piece.from, &piece.to})
        CHECK(*std::ranges::min_element(*shares) >= -1e-9);
      CHECK(length(place_of(of, piece.from) - at) <= 1e-9);
      at = place_of(of, piece.to);
      CHECK(std::abs(cross(end - begin, at - begin)) <= 1e-9 * most_m * most_m);
      CHECK(value_of(of, piece.to) < last + 1e-12);
      last = value_of(of, piece.to);
    }
    CHECK(length(end - begin) <= most_m + 1e-9);
    CHECK(last >= lowest - 1e-9);
    // Nowhere else in the first triangle is there lower ground as near.
    const double fallen = height - value_of(corners, way.front().to);
    const double step_m = length(place_of(corners, way.front().to) - begin);
    for (int k = 0; k < 20; ++k) {
      const double turn = 0.3 * k;
      const Vec2 aside = begin + 0.01 * Vec2{std::cos(turn), std::sin(turn)};
      const Vec2 pa = plan_of(grid, corners[0]), pb = plan_of(grid, corners[1]),
                 pc = plan_of(grid, corners[2]);
      const double area = cross(pb - pa, pc - pa);
      const std::array<double, 3> shares{cross(pc - pb, aside - pb) / area,
                                         cross(pa - pc, aside - pc) / area,
                                         cross(pb - pa, aside - pa) / area};
      CHECK(height - value_of(corners, shares) <= 0.01 * fallen / step_m + 1e-9);
    }
  }
  CHECK(pieces_of_several > enough(30));
}

} // namespace orograph::hollows_test
