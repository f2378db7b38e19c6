// SPDX-License-Identifier: GPL-3.0-or-later
// Sides are put into one array, ordered by their edge's lower vertex (a counting sort), then by its
// higher one (few sides a vertex). Sides of one edge are neighbours then. Bands of lower vertices
// know nothing of each other: each core looks at all triangles for those of its own. Arrays are the
// caller's, whose memory is in larger pages than other threads' (docs/decisions/0066).
#include "dem/mesh/neighbours.hpp"

#include "geometry/on_all_cores.hpp"

#include <algorithm>
#include <functional>
#include <iterator>
#include <utility>

namespace orograph {
namespace {

// The edge's higher vertex, and below it three times the triangle and the side: 8 bytes, and in
// the order of both.
using SideAtVertex = std::uint64_t;

std::uint32_t other_end(SideAtVertex side) {
  return static_cast<std::uint32_t>(side >> 32U);
}
TriangleSide side_of(SideAtVertex side) {
  const auto number = static_cast<std::uint32_t>(side);
  return {number / 3, number % 3};
}

struct VertexBand {
  std::uint32_t first, end;
};

// Of the sides whose lower vertex is in a band.
template <class Visit>
void for_each_side(std::span<const std::array<std::uint32_t, 3>> triangles, VertexBand band,
                   Visit visit) {
  for (std::uint32_t t = 0; t < triangles.size(); ++t) {
    throw_if_stopped(t);
    for (std::uint32_t k = 0; k < 3; ++k) {
      const auto [a, b] = ends_of(triangles[t], k);
      const std::uint32_t low = std::min(a, b);
      if (low >= band.first && low < band.end)
        visit(low, SideAtVertex{std::max(a, b)} << 32U | (3 * t + k));
    }
  }
}

// The sides of one edge.
void join(std::span<const SideAtVertex> sides, Neighbours& neighbours,
          std::vector<std::vector<TriangleSide>>& crowded) {
  if (sides.size() == 2) {
    const TriangleSide a = side_of(sides[0]), b = side_of(sides[1]);
    neighbours.of[a.triangle][a.side] = b.triangle;
    neighbours.of[b.triangle][b.side] = a.triangle;
  } else if (sides.size() > 2) {
    auto& crowd = crowded.emplace_back();
    for (const SideAtVertex s : sides) crowd.push_back(side_of(s));
  }
}

} // namespace

Neighbours find_neighbours(std::span<const std::array<std::uint32_t, 3>> triangles,
                           std::size_t vertices) {
  // Few triangles are looked at sooner than cores are woken. Each band looks at all of them: on two
  // cores four bands take a fifth longer than two.
  const std::size_t bands = triangles.size() < 20000 ? 1 : 2;
  const auto in_bands = [&](const std::function<void(VertexBand, std::size_t)>& task) {
    on_all_cores(bands, [&](std::size_t band) {
      const auto border = [&](std::size_t i) {
        return static_cast<std::uint32_t>(vertices * i / bands);
      };
      task({border(band), border(band + 1)}, band);
    });
  };
  std::vector<std::uint32_t> begin(vertices + 1, 0);
  in_bands([&](VertexBand band, std::size_t) {
    for_each_side(triangles, band, [&](std::uint32_t low, SideAtVertex) { ++begin[low]; });
  });
  std::uint32_t sum = 0;
  for (std::uint32_t& b : begin) sum += std::exchange(b, sum);

  std::vector<SideAtVertex> sides(sum);
  Neighbours neighbours;
  neighbours.of.assign(triangles.size(), {kNoTriangle, kNoTriangle, kNoTriangle});
  std::vector<std::vector<std::vector<TriangleSide>>> crowded(bands);
  in_bands([&](VertexBand band, std::size_t number) {
    // Filling moves each begin to its end, which is the next one's begin.
    std::uint32_t from = begin[band.first];
    for_each_side(triangles, band,
                  [&](std::uint32_t low, SideAtVertex side) { sides[begin[low]++] = side; });
    for (std::uint32_t vertex = band.first; vertex < band.end; ++vertex) {
      throw_if_stopped(vertex);
      const std::uint32_t to = begin[vertex];
      std::sort(sides.begin() + from, sides.begin() + to);
      while (from < to) {
        std::uint32_t next = from + 1;
        while (next < to && other_end(sides[next]) == other_end(sides[from])) ++next;
        join({sides.data() + from, next - from}, neighbours, crowded[number]);
        from = next;
      }
    }
  });
  for (auto& of_band : crowded) std::ranges::move(of_band, std::back_inserter(neighbours.crowded));
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
