// SPDX-License-Identifier: GPL-3.0-or-later
// Random valid TINs for tests by definition; shares no code with dem/.
#pragma once

#include "dem/tin.hpp"
#include "tests/support/random.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

namespace orograph {

/// A lattice whose vertices are moved, with cells split along either diagonal.
struct MadeTin {
  int columns = 6, rows = 6; ///< vertices, 2 or more each
  Vec2 first_vertex_m{};
  double step_m = 10;
  double moved = 0.2;            ///< share of a step that vertices move by; below 0.25
  double low_m = 0, high_m = 50; ///< heights
  bool whole = false;            ///< whole coordinates; asks for a whole first vertex and step
  double missing = 0;            ///< probability of a triangle not being there
  double walls = 0;              ///< probability of a wall along a row of vertices
  bool shuffled = false;         ///< vertices and triangles in any order
};

/// Neighbours by sorting the edges. REQUIRES that no edge has more than two triangles.
inline std::vector<std::array<std::uint32_t, 3>>
neighbours_by_sorting(const std::vector<std::array<std::uint32_t, 3>>& triangles) {
  struct Side {
    std::uint32_t low, high, triangle;
    std::size_t k;
  };
  std::vector<Side> sides;
  for (std::uint32_t t = 0; t < triangles.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t a = triangles[t][(k + 1) % 3], b = triangles[t][(k + 2) % 3];
      sides.push_back({std::min(a, b), std::max(a, b), t, k});
    }
  std::sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) {
    return std::pair(a.low, a.high) < std::pair(b.low, b.high);
  });
  std::vector<std::array<std::uint32_t, 3>> neighbours(triangles.size(),
                                                       {kNoTriangle, kNoTriangle, kNoTriangle});
  for (std::size_t i = 1; i < sides.size(); ++i) {
    const Side &a = sides[i - 1], &b = sides[i];
    if (a.low != b.low || a.high != b.high) continue;
    neighbours[a.triangle][a.k] = b.triangle;
    neighbours[b.triangle][b.k] = a.triangle;
  }
  return neighbours;
}

/// Numbers the vertices anew: new number of each. Those without a number are left out.
inline void renumber(Tin& tin, const std::vector<std::uint32_t>& number, std::size_t count) {
  std::vector<Vec3> vertices(count);
  for (std::size_t v = 0; v < number.size(); ++v)
    if (number[v] != kNoTriangle) vertices[number[v]] = tin.vertices_m[v];
  tin.vertices_m = std::move(vertices);
  for (auto& triangle : tin.triangles)
    for (std::uint32_t& v : triangle) v = number[v];
}

/// A valid Tin, without vertices that have no triangle; without triangles only where `missing`
/// took them all. A wall stands on a stretch of a row of vertices: the ground to the north of it is
/// higher or lower by up to half of the heights' range.
inline Tin made_tin(Random& random, const MadeTin& wanted) {
  const auto at = [&](int column, int row) {
    return static_cast<std::uint32_t>(row * wanted.columns + column);
  };
  const auto number = [&](double value) { return wanted.whole ? std::floor(value) : value; };
  Tin tin;
  for (int row = 0; row < wanted.rows; ++row)
    for (int column = 0; column < wanted.columns; ++column) {
      const auto moved = [&] {
        const double by = random.between(-wanted.moved, wanted.moved) * wanted.step_m;
        return wanted.whole ? std::trunc(by) : by;
      };
      const double x = wanted.first_vertex_m.x + column * wanted.step_m + moved();
      const double y = wanted.first_vertex_m.y + row * wanted.step_m + moved();
      tin.vertices_m.push_back({x, y, number(random.between(wanted.low_m, wanted.high_m))});
    }

  // The vertex that the ground to the north of a row has; another one where a wall stands.
  std::vector<std::uint32_t> north(tin.vertices_m.size());
  for (std::uint32_t v = 0; v < north.size(); ++v) north[v] = v;
  for (int row = 1; row + 1 < wanted.rows; ++row) {
    if (!random.chance(wanted.walls)) continue;
    int first = random.whole(0, wanted.columns - 1), last = random.whole(0, wanted.columns - 1);
    if (first > last) std::swap(first, last);
    const double most = (random.chance(0.5) ? 0.5 : -0.5) * (wanted.high_m - wanted.low_m);
    for (int column = first; column <= last; ++column) {
      Vec3 vertex = tin.vertices_m[at(column, row)];
      vertex.z += number(random.share() * most);
      if (vertex == tin.vertices_m[at(column, row)]) continue;
      north[at(column, row)] = static_cast<std::uint32_t>(tin.vertices_m.size());
      tin.vertices_m.push_back(vertex);
    }
  }

  // A cell or a wall by its corners, counterclockwise from the south-west or the foot.
  const auto add = [&](std::array<std::uint32_t, 4> c) {
    const std::size_t k = random.chance(0.5) ? 0 : 1;
    for (std::array<std::uint32_t, 3> t :
         {std::array{c[k], c[k + 1], c[k + 2]}, std::array{c[k], c[k + 2], c[(k + 3) % 4]}}) {
      std::rotate(t.begin(), t.begin() + random.whole(0, 2), t.end());
      if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0] || random.chance(wanted.missing)) continue;
      tin.triangles.push_back(t);
    }
  };
  for (int row = 0; row + 1 < wanted.rows; ++row)
    for (int column = 0; column + 1 < wanted.columns; ++column) {
      const std::uint32_t a = at(column, row), b = at(column + 1, row);
      if (north[a] != a || north[b] != b) add({a, b, north[b], north[a]});
      add({north[a], north[b], at(column + 1, row + 1), at(column, row + 1)});
    }

  std::vector<std::uint32_t> numbers(tin.vertices_m.size(), kNoTriangle), used;
  for (const auto& triangle : tin.triangles)
    for (const std::uint32_t v : triangle) numbers[v] = 0;
  for (std::uint32_t v = 0; v < numbers.size(); ++v)
    if (numbers[v] == 0) used.push_back(v);
  if (wanted.shuffled) {
    shuffle(random, used);
    shuffle(random, tin.triangles);
  }
  for (std::uint32_t i = 0; i < used.size(); ++i) numbers[used[i]] = i;
  renumber(tin, numbers, used.size());
  tin.neighbours = neighbours_by_sorting(tin.triangles);
  return tin;
}

} // namespace orograph
