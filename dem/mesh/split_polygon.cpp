// SPDX-License-Identifier: GPL-3.0-or-later
// Corners from i to j and the line between them are a polygon; it has one triangle at that line,
// whose third corner lies between i and j and splits the rest in two.
#include "dem/mesh/split_polygon.hpp"

#include "dem/mesh/orientation.hpp"

#include <algorithm>
#include <limits>

namespace orograph {
namespace {

// Its least height; below zero where it doesn't run counterclockwise.
double thickness_m(Vec2 a, Vec2 b, Vec2 c) {
  if (orientation(a, b, c) <= 0) return -1;
  return std::abs(cross(b - a, c - a)) / std::max({length(b - a), length(c - b), length(a - c)});
}

struct Best {
  double thinnest_m = std::numeric_limits<double>::infinity();
  std::uint32_t corner = 0;
};

} // namespace

std::vector<PolygonTriangle> split_polygon(std::span<const Vec2> corners) {
  const auto n = static_cast<std::uint32_t>(corners.size());
  if (n == 3 && orientation(corners[0], corners[1], corners[2]) > 0) return {{0, 1, 2}};
  std::vector<Best> best(std::size_t{n} * n);
  const auto at = [&](std::uint32_t i, std::uint32_t j) -> Best& {
    return best[std::size_t{i} * n + j];
  };
  for (std::uint32_t length = 2; length < n; ++length)
    for (std::uint32_t i = 0; i + length < n; ++i) {
      const std::uint32_t j = i + length;
      at(i, j).thinnest_m = -1;
      for (std::uint32_t k = i + 1; k < j; ++k) {
        const double thinnest_m = std::min({thickness_m(corners[i], corners[k], corners[j]),
                                            at(i, k).thinnest_m, at(k, j).thinnest_m});
        if (thinnest_m > at(i, j).thinnest_m) at(i, j) = {thinnest_m, k};
      }
    }
  if (at(0, n - 1).thinnest_m < 0) return {};
  std::vector<PolygonTriangle> triangles;
  std::vector<std::array<std::uint32_t, 2>> to_do{{0, n - 1}};
  while (!to_do.empty()) {
    const auto [i, j] = to_do.back();
    to_do.pop_back();
    if (j - i < 2) continue;
    const std::uint32_t k = at(i, j).corner;
    triangles.push_back({i, k, j});
    to_do.push_back({i, k});
    to_do.push_back({k, j});
  }
  return triangles;
}

} // namespace orograph
