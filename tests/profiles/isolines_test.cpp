// SPDX-License-Identifier: GPL-3.0-or-later
// Lines of equal value against every triangle's own crossings, on heights of few whole numbers, so
// that levels go through vertices and along edges all the time.
#include "dem/approximate/tin_of_grid.hpp"
#include "profiles/isolines.hpp"
#include "profiles/triangle_isolines.hpp"
#include "tests/catch.hpp"
#include "tests/support/made_grid.hpp"
#include "tests/support/random.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <set>
#include <utility>
#include <vector>

namespace orograph::isolines_test {
namespace {

using Triangle = std::array<std::uint32_t, 3>;
// A vertex is an edge from itself to itself.
using Node = SurfaceEdge;
using Line = std::pair<double, std::pair<Node, Node>>; // its level first

std::vector<Triangle> all_triangles(const Grid& grid) {
  std::vector<Triangle> out(grid_triangle_count(grid));
  for (int r = 0; r + 1 < grid.rows; ++r)
    for (int c = 0; c + 1 < grid.columns; ++c) {
      const auto at = [&](int x, int y) { return static_cast<std::uint32_t>(grid.index(x, y)); };
      out[grid_triangle(grid, c, r, Half::lower)] = {at(c, r), at(c, r + 1), at(c + 1, r + 1)};
      out[grid_triangle(grid, c, r, Half::upper)] = {at(c, r), at(c + 1, r + 1), at(c + 1, r)};
    }
  return out;
}

// By the rule: at or above the level, or below it.
std::set<Line> wanted_lines(const std::vector<Triangle>& triangles,
                            const std::vector<double>& value, const std::vector<double>& levels) {
  std::set<Line> out;
  for (const Triangle& t : triangles) {
    if (std::isnan(value[t[0]]) || std::isnan(value[t[1]]) || std::isnan(value[t[2]])) continue;
    for (const double level : levels) {
      std::vector<Node> nodes;
      for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t a = std::min(t[k], t[(k + 1) % 3]), b = std::max(t[k], t[(k + 1) % 3]);
        if ((value[a] >= level) == (value[b] >= level)) continue;
        const std::uint32_t upper = value[a] >= level ? a : b;
        nodes.push_back(value[upper] == level ? Node{upper, upper} : Node{a, b});
      }
      if (nodes.size() == 2 && nodes[0] != nodes[1])
        out.insert({level, std::minmax(nodes[0], nodes[1])});
    }
  }
  return out;
}

VertexValues given(const std::vector<double>& value) {
  return [&value](std::size_t first, std::span<double> out) {
    std::copy_n(value.begin() + static_cast<std::ptrdiff_t>(first), out.size(), out.begin());
  };
}

// What was found, as nodes; each point is where its level is.
std::set<Line> found_lines(const Isolines& found, const std::vector<double>& value,
                           const std::vector<double>& levels) {
  std::set<Line> out;
  const auto vertices = static_cast<std::uint32_t>(value.size());
  for (const Isoline& line : found.lines) {
    REQUIRE(line.from < line.to);
    const double level = levels.at(line.level);
    const auto node = [&](std::uint32_t end) {
      if (end < vertices) {
        REQUIRE(value[end] == level);
        return Node{end, end};
      }
      const auto& [edge, t] = found.points.at(end - vertices);
      REQUIRE((t >= 0 && t <= 1)); // a level may be a vertex's value but for rounding
      REQUIRE(std::abs(value[edge.from] + t * (value[edge.to] - value[edge.from]) - level) < 1e-12);
      return edge;
    };
    const bool is_new = out.insert({level, std::minmax(node(line.from), node(line.to))}).second;
    REQUIRE(is_new);
  }
  return out;
}

// Every point within an edge joins two lines, or ends one at the border; every vertex joins pairs
// of them, but where a ridge or a trough lies on the level.
void check_joined(const std::set<Line>& lines, const std::vector<Triangle>& triangles,
                  const std::vector<double>& value) {
  std::map<SurfaceEdge, int> sides;
  for (const Triangle& t : triangles) {
    if (std::isnan(value[t[0]]) || std::isnan(value[t[1]]) || std::isnan(value[t[2]])) continue;
    for (std::size_t k = 0; k < 3; ++k) {
      const auto [a, b] = std::minmax(t[k], t[(k + 1) % 3]);
      ++sides[{a, b}];
    }
  }
  std::map<std::pair<double, Node>, int> ends;
  for (const auto& [level, nodes] : lines) {
    ++ends[{level, nodes.first}];
    ++ends[{level, nodes.second}];
  }
  for (const auto& [at, count] : ends) {
    const Node node = at.second;
    if (node.from != node.to) REQUIRE(count == sides[node]);
  }
}

} // namespace

TEST_CASE("lines of a level are each triangle's own, meet in points, and each is there once") {
  std::size_t count = 0, along_edges = 0;
  for (std::uint64_t seed = 1; seed <= last_seed(60); ++seed) {
    Random random(seed);
    INFO("seed " << seed);
    const GridLattice lattice{random.whole(2, 40), random.whole(2, 150)};
    const Grid grid = made_grid(
        random, lattice, {.low = 0, .high = random.between(2, 12), .missing = seed % 3 ? 0 : 0.1});
    std::vector<double> value;
    for (int r = 0; r < grid.rows; ++r)
      for (int c = 0; c < grid.columns; ++c) {
        const double height = grid.height_m(c, r);
        value.push_back(seed % 4 ? std::round(height) : height);
      }
    std::vector<double> levels;
    if (seed % 2 == 0) { // a list, as it comes
      for (int i = random.whole(1, 9); i > 0; --i) levels.push_back(random.between(-1, 12));
      levels.push_back(random.whole(0, 12));
      std::sort(levels.begin(), levels.end());
    } else {
      const double step = seed % 5 ? 1 : 0.3;
      for (double level = -2; level < 14; level += step) levels.push_back(level);
    }
    std::vector<Triangle> triangles = all_triangles(grid);
    std::set<Line> wanted = wanted_lines(triangles, value, levels);
    const std::set<Line> found = found_lines(isolines(grid, given(value), levels), value, levels);
    CHECK(found == wanted);
    check_joined(found, triangles, value);
    count += found.size();
    along_edges += static_cast<std::size_t>(std::ranges::count_if(found, [](const Line& line) {
      const auto& [a, b] = line.second;
      return a.from == a.to && b.from == b.to;
    }));

    // Of some blocks of cells, and of some triangles.
    SeenGround ground(grid);
    for (auto& seen : ground.seen) seen = random.whole(0, 1) ? 1 : 0;
    std::vector<Triangle> some;
    TriangleSet set(triangles.size());
    for (int r = 0; r + 1 < grid.rows; ++r)
      for (int c = 0; c + 1 < grid.columns; ++c)
        if (ground.seen[ground.index(c / SeenGround::kSide, r / SeenGround::kSide)])
          for (const Half half : {Half::lower, Half::upper})
            if (const std::size_t t = grid_triangle(grid, c, r, half); random.whole(0, 3)) {
              some.push_back(triangles[t]);
              set.add(t);
            }
    const Isolines of_some = isolines(grid, given(value), levels, {&ground, &set});
    CHECK(found_lines(of_some, value, levels) == wanted_lines(some, value, levels));

    // Of a TIN, whose vertices are the grid's that are there.
    bool has_triangle = false;
    for (const Triangle& t : triangles)
      has_triangle |= !std::isnan(value[t[0]] + value[t[1]] + value[t[2]]);
    if (!has_triangle) continue;
    const Tin tin = tin_of(grid);
    std::vector<double> of_tin;
    for (const Vec3 vertex : tin.vertices_m)
      of_tin.push_back(seed % 4 ? std::round(vertex.z) : vertex.z);
    triangles.assign(tin.triangles.begin(), tin.triangles.end());
    const std::set<Line> on_tin = found_lines(isolines(tin, given(of_tin), levels), of_tin, levels);
    CHECK(on_tin == wanted_lines(triangles, of_tin, levels));
    check_joined(on_tin, triangles, of_tin);
    CHECK(on_tin.size() == found.size());
  }
  WARN(count << " lines, " << along_edges << " along edges");
  CHECK(count > enough(50000));
  CHECK(along_edges > enough(1000));
}

TEST_CASE("without levels, or triangles, there are no lines of them") {
  Random random(1);
  const Grid grid = made_grid(random, {5, 5}, {.low = 0, .high = 3});
  const std::vector<double> value(25, 1.0), none(25, std::nan(""));
  CHECK(isolines(grid, given(value), {}).lines.empty());
  CHECK(isolines(grid, given(value), std::vector{1.0, 2.0}).lines.empty());
  CHECK(isolines(grid, given(none), std::vector{1.0, 2.0}).lines.empty());
}

TEST_CASE("levels that are counted for many heights at once are those up to each") {
  int at_once = 0, near_level = 0;
  for (std::uint64_t seed = 1; seed <= last_seed(300); ++seed) {
    CAPTURE(seed);
    Random random(seed);
    std::vector<double> given_levels{random.between(-100, 4000)};
    const double apart = random.pick({1.0, 30.48, 1e-4, 0.1});
    const bool is_even = random.chance(0.8);
    for (int i = random.whole(0, 120); i > 0; --i)
      given_levels.push_back(given_levels.back() + (is_even ? apart : random.between(0.01, 9)));
    const IsolineLevels levels(given_levels);
    std::vector<double> heights;
    for (int i = 0; i < 700; ++i) {
      const double level = given_levels[static_cast<std::size_t>(
          random.whole(0, static_cast<int>(given_levels.size()) - 1))];
      heights.push_back(random.pick({level, std::nextafter(level, 1e9), std::nextafter(level, -1e9),
                                     std::nan(""), level + random.between(-3, 3) * apart,
                                     random.between(-1e6, 1e6), random.between(-1e3, 5e3)}));
    }
    std::vector<std::int32_t> counts(heights.size());
    std::vector<std::uint32_t> near;
    levels.count_most(heights, counts, near);
    near_level += static_cast<int>(near.size());
    for (const std::uint32_t i : near) heights[i] = std::nan("");
    for (std::size_t i = 0; i < heights.size(); ++i) {
      if (std::isnan(heights[i])) continue; // told apart
      const auto up_to =
          std::ranges::count_if(given_levels, [&](double l) { return l <= heights[i]; });
      CHECK(counts[i] == up_to);
      CHECK(std::ranges::find(given_levels, heights[i]) == given_levels.end());
      ++at_once;
    }
  }
  WARN(at_once << " heights at once, " << near_level << " looked up");
  CHECK(at_once > enough(30000));
  CHECK(near_level > enough(30000));
}

} // namespace orograph::isolines_test
