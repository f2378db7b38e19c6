// SPDX-License-Identifier: GPL-3.0-or-later
// Sides are put into one array, ordered by their edge's lower vertex (a counting sort), then by its
// higher one (few sides a vertex). Sides of one edge are neighbours then.
#include "dem/mesh/neighbours.hpp"

#include "geometry/on_all_cores.hpp"

#include <algorithm>
#include <utility>

namespace orograph {
namespace {

struct SideAtVertex {
  std::uint32_t other; ///< the edge's higher vertex
  TriangleSide side;

  bool operator<(const SideAtVertex& b) const {
    return other != b.other ? other < b.other : side.triangle < b.side.triangle;
  }
};

template <class Visit>
void for_each_side(std::span<const std::array<std::uint32_t, 3>> triangles, Visit visit) {
  for (std::uint32_t t = 0; t < triangles.size(); ++t) {
    throw_if_stopped(t);
    for (std::uint32_t k = 0; k < 3; ++k) {
      const auto [a, b] = ends_of(triangles[t], k);
      visit(std::min(a, b), std::max(a, b), TriangleSide{t, k});
    }
  }
}

// The sides of one edge.
void join(std::span<const SideAtVertex> sides, Neighbours& neighbours) {
  if (sides.size() == 2) {
    const TriangleSide a = sides[0].side, b = sides[1].side;
    neighbours.of[a.triangle][a.side] = b.triangle;
    neighbours.of[b.triangle][b.side] = a.triangle;
  } else if (sides.size() > 2) {
    auto& crowd = neighbours.crowded.emplace_back();
    for (const SideAtVertex& s : sides) crowd.push_back(s.side);
  }
}

} // namespace

Neighbours find_neighbours(std::span<const std::array<std::uint32_t, 3>> triangles,
                           std::size_t vertices) {
  std::vector<std::size_t> begin(vertices + 1, 0);
  for_each_side(triangles, [&](std::uint32_t low, std::uint32_t, TriangleSide) { ++begin[low]; });
  std::size_t sum = 0;
  for (std::size_t& b : begin) sum += std::exchange(b, sum);

  // Filling moves each begin to its end, which is the next one's begin.
  std::vector<SideAtVertex> sides(sum);
  for_each_side(triangles, [&](std::uint32_t low, std::uint32_t high, TriangleSide side) {
    sides[begin[low]++] = {high, side};
  });

  Neighbours neighbours;
  neighbours.of.assign(triangles.size(), {kNoTriangle, kNoTriangle, kNoTriangle});
  std::size_t from = 0;
  for (std::size_t vertex = 0; vertex < vertices; ++vertex) {
    throw_if_stopped(vertex);
    const std::size_t to = begin[vertex];
    std::sort(sides.begin() + static_cast<std::ptrdiff_t>(from),
              sides.begin() + static_cast<std::ptrdiff_t>(to));
    while (from < to) {
      std::size_t next = from + 1;
      while (next < to && sides[next].other == sides[from].other) ++next;
      join({sides.data() + from, next - from}, neighbours);
      from = next;
    }
  }
  return neighbours;
}

bool run_alike(const Tin& tin, std::uint32_t a, std::uint32_t side, std::uint32_t b) {
  const auto [from, to] = ends_of(tin.triangles[a], side);
  const auto& other = tin.triangles[b];
  for (std::uint32_t k = 0; k < 3; ++k)
    if (ends_of(other, k) == std::array{from, to}) return true;
  return false;
}

} // namespace orograph
