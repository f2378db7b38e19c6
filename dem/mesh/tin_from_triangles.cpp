// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/mesh/tin_from_triangles.hpp"

#include "dem/mesh/overlap.hpp"
#include "dem/mesh/upper_surface.hpp"
#include "dem/mesh/verify_tin.hpp"
#include "dem/mesh/walls.hpp"
#include "dem/triangulate/orientation.hpp"
#include "geometry/error.hpp"
#include "geometry/on_all_cores.hpp"
#include "geometry/vec.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <span>
#include <utility>

namespace orograph {
namespace {

// Points that are given more than once are found by a hash table with open addresses: a soup of
// millions of points is merged in the time that it takes to go to memory for each.

constexpr std::uint32_t kEmpty = 0xffffffff;

// Multiplication by an odd number carries low bits upwards; the shift brings them back.
std::uint64_t mixed(std::uint64_t bits) {
  bits *= 0x9e3779b97f4a7c15; // 2^64 / golden ratio (Knuth, volume 3, section 6.4)
  return bits ^ (bits >> 32U);
}

std::uint64_t hash(const Vec3& p) {
  const auto bits = [](double value) { return std::bit_cast<std::uint64_t>(value + 0.0); }; // -0: 0
  return mixed(mixed(mixed(bits(p.x)) ^ bits(p.y)) ^ bits(p.z));
}

// For each point the number of the first one that is equal to it in all coordinates: its own
// unless an earlier one is. 0 and -0 are equal. REQUIRES finite coordinates. Cost O(n).
std::vector<std::uint32_t> first_equal(std::span<const Vec3> points) {
  std::vector<std::uint32_t> table(std::bit_ceil(2 * points.size() + 1), kEmpty);
  std::vector<std::uint32_t> first(points.size());
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    throw_if_stopped(i);
    std::size_t place = hash(points[i]) & (table.size() - 1);
    while (table[place] != kEmpty && points[table[place]] != points[i])
      place = (place + 1) & (table.size() - 1);
    if (table[place] == kEmpty) table[place] = i;
    first[i] = table[place];
  }
  return first;
}

void require_finite(const TriangleSoup& soup, const std::string& source) {
  for (std::size_t i = 0; i < soup.points_m.size(); ++i) {
    const Vec3& p = soup.points_m[i];
    if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z))
      throw Error(
          fmt::format("{}: point {} (counted from 0) is at {}, {}, {}", source, i, p.x, p.y, p.z),
          "coordinates are finite numbers");
  }
}

std::string count_of(std::size_t count, const char* one, const char* many) {
  return count == 1 ? fmt::format("1 {}.", one) : fmt::format("{} {}.", count, many);
}

// A soup's triangles by merged points, each with an area and counterclockwise or a wall.
struct Prepared {
  Tin tin;                           ///< without neighbours
  std::vector<std::uint32_t> number; ///< of each triangle in the soup
  std::vector<std::string> notes;
};

Prepared prepare(const TriangleSoup& soup) {
  Prepared prepared;
  const std::vector<std::uint32_t> first = first_equal(soup.points_m);
  std::size_t no_area = 0, turned = 0;
  prepared.tin.vertices_m = soup.points_m;
  for (std::uint32_t t = 0; t < soup.triangles.size(); ++t) {
    throw_if_stopped(t);
    std::array<std::uint32_t, 3> triangle = soup.triangles[t];
    for (std::uint32_t& v : triangle) v = first[v];
    const Vec3 &a = soup.points_m[triangle[0]], &b = soup.points_m[triangle[1]],
               &c = soup.points_m[triangle[2]];
    const int turn = plan_orientation(a, b, c);
    if (turn == 0 && on_one_line(a, b, c)) {
      ++no_area;
      continue;
    }
    if (turn < 0) std::swap(triangle[1], triangle[2]);
    turned += turn < 0 ? 1 : 0;
    prepared.tin.triangles.push_back(triangle);
    prepared.number.push_back(t);
  }
  if (no_area > 0)
    prepared.notes.push_back(count_of(no_area, "triangle has no area and was dropped",
                                      "triangles have no area and were dropped"));
  if (turned > 0)
    prepared.notes.push_back(count_of(turned,
                                      "triangle ran clockwise seen from above and was turned",
                                      "triangles ran clockwise seen from above and were turned"));
  return prepared;
}

// Cutting multiplies coordinates, which mustn't overflow.
void require_small_enough(const Tin& tin, const std::string& source) {
  for (const Vec3& p : tin.vertices_m)
    if (std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)}) > 1e100)
      throw Error(fmt::format("{} has coordinates beyond 1e100, too large to repair", source),
                  "coordinates are metres near the terrain");
}

// Gives the Tin its neighbours and its walls their direction. What doesn't fit, if anything.
std::optional<Misfit> fit_together(Tin& tin) {
  Neighbours neighbours = find_neighbours(tin.triangles, tin.vertices_m.size());
  tin.neighbours = neighbours.of;
  if (neighbours.crowded.empty()) turn_walls(tin);
  neighbours.of = tin.neighbours;
  if (auto misfit = edge_misfit(tin, neighbours)) return misfit;
  if (const auto pair = first_overlap(tin))
    return Misfit{TinFault::Kind::overlap, {(*pair)[0], (*pair)[1]}};
  return std::nullopt;
}

void drop_unused_vertices(Tin& tin) {
  std::vector<std::uint32_t> number(tin.vertices_m.size(), 0);
  for (const auto& triangle : tin.triangles)
    for (const std::uint32_t v : triangle) number[v] = 1;
  std::uint32_t count = 0;
  for (std::size_t v = 0; v < number.size(); ++v) {
    if (number[v] == 0) continue;
    tin.vertices_m[count] = tin.vertices_m[v];
    number[v] = count++;
  }
  tin.vertices_m.resize(count);
  for (auto& triangle : tin.triangles)
    for (std::uint32_t& v : triangle) v = number[v];
}

void note_repair(const UpperSurface& upper, std::vector<std::string>& notes) {
  if (upper.hidden > 0)
    notes.push_back(count_of(upper.hidden, "triangle is hidden seen from above and was dropped",
                             "triangles are hidden seen from above and were dropped"));
  if (upper.cut > 0)
    notes.push_back(count_of(upper.cut,
                             "triangle is partly hidden or has a cut neighbour, and was cut",
                             "triangles are partly hidden or have cut neighbours, and were cut"));
  if (upper.dropped_walls > 0)
    notes.push_back(count_of(upper.dropped_walls,
                             "vertical triangle fits nothing that is left and was dropped",
                             "vertical triangles fit nothing that is left and were dropped"));
}

} // namespace

TinFromTriangles tin_from_triangles(const TriangleSoup& soup, bool repair,
                                    const std::string& source) {
  require_finite(soup, source);
  Prepared prepared = prepare(soup);
  const auto require_triangles = [&] {
    if (prepared.tin.triangles.empty())
      throw Error(fmt::format("{} has no triangle with an area", source), "a TIN has at least one");
  };
  require_triangles();
  if (auto misfit = fit_together(prepared.tin)) {
    if (!repair) {
      for (std::uint32_t& t : misfit->triangles) t = prepared.number[t];
      std::sort(misfit->triangles.begin(), misfit->triangles.end());
      throw Error(fmt::format("{} isn't a terrain, {} (counted from 0)", source, phrase(*misfit)),
                  "one height at each place; `repair` keeps what is seen from above");
    }
    require_small_enough(prepared.tin, source);
    UpperSurface upper = upper_surface(prepared.tin);
    note_repair(upper, prepared.notes);
    prepared.tin = std::move(upper.tin);
    require_triangles();
  }
  drop_unused_vertices(prepared.tin);
  return {std::move(prepared.tin), std::move(prepared.notes)};
}

} // namespace orograph
