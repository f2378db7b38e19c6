// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/mesh/walls.hpp"

#include "dem/mesh/neighbours.hpp"
#include "dem/mesh/overlap.hpp"
#include "dem/mesh/verify_tin.hpp"
#include "dem/triangulate/orientation.hpp"
#include "geometry/on_all_cores.hpp"

#include <algorithm>
#include <utility>

namespace orograph {
namespace {

// Turns a triangle over: its second and third vertices change places, as do its neighbours there.
void turn_over(Tin& tin, std::uint32_t triangle) {
  std::swap(tin.triangles[triangle][1], tin.triangles[triangle][2]);
  if (triangle < tin.neighbours.size())
    std::swap(tin.neighbours[triangle][1], tin.neighbours[triangle][2]);
}

// Lets the direction of walls spread to the walls beside them.
struct Spread {
  Tin& tin;
  std::vector<std::uint8_t> settled;
  std::vector<std::uint32_t> to_do; ///< settled walls whose neighbours haven't been asked

  // Turns walls beside triangle t as it asks, and settles them.
  void ask_beside(std::uint32_t t) {
    for (std::uint32_t k = 0; k < 3; ++k) {
      const std::uint32_t wall = tin.neighbours[t][k];
      if (wall == kNoTriangle || settled[wall]) continue;
      if (run_alike(tin, t, k, wall)) turn_over(tin, wall);
      settled[wall] = 1;
      to_do.push_back(wall);
    }
  }
  void finish() {
    while (!to_do.empty()) {
      const std::uint32_t wall = to_do.back();
      to_do.pop_back();
      ask_beside(wall);
    }
  }
};

using Marks = std::vector<std::uint8_t>;

bool upright(const Tin& tin, std::uint32_t triangle, std::uint32_t side) {
  const auto [i, j] = ends_of(tin.triangles[triangle], side);
  const Vec3 &a = tin.vertices_m[i], &b = tin.vertices_m[j];
  return a.x == b.x && a.y == b.y;
}

// Marks walls that hang free, and those that do once others are gone.
void mark_hanging(const Tin& tin, const Marks& walls, const std::vector<HadBeside>& had,
                  Marks& doomed) {
  auto beside = tin.neighbours;
  std::vector<std::uint32_t> to_do;
  const auto look_at = [&](std::uint32_t wall) {
    if (!walls[wall] || doomed[wall]) return;
    for (std::uint32_t k = 0; k < 3; ++k)
      if (had[wall][k] && beside[wall][k] == kNoTriangle && !upright(tin, wall, k))
        doomed[wall] = 1;
    if (doomed[wall]) to_do.push_back(wall);
  };
  for (std::uint32_t t = 0; t < walls.size(); ++t) look_at(t);
  while (!to_do.empty()) {
    const std::uint32_t gone = to_do.back();
    to_do.pop_back();
    for (const std::uint32_t other : beside[gone]) {
      if (other == kNoTriangle) continue;
      std::replace(beside[other].begin(), beside[other].end(), gone, kNoTriangle);
      look_at(other);
    }
  }
}

void mark_at_crowded_edges(const Neighbours& neighbours, const Marks& walls, Marks& doomed) {
  for (const auto& crowd : neighbours.crowded)
    for (const TriangleSide& side : crowd) doomed[side.triangle] |= walls[side.triangle];
}

void mark_contradicted(const Tin& tin, const Marks& walls, Marks& doomed) {
  for (std::uint32_t t = 0; t < walls.size(); ++t)
    for (std::uint32_t k = 0; k < 3; ++k)
      if (walls[t] && tin.neighbours[t][k] != kNoTriangle &&
          run_alike(tin, t, k, tin.neighbours[t][k]))
        doomed[t] = 1;
}

template <class Value>
void erase_marked(std::vector<Value>& values, const Marks& marks) {
  std::size_t kept = 0;
  for (std::size_t i = 0; i < values.size(); ++i)
    if (!marks[i]) values[kept++] = values[i];
  values.resize(kept);
}

} // namespace

bool is_wall(const Tin& tin, std::uint32_t triangle) {
  const auto& [a, b, c] = tin.triangles[triangle];
  return plan_orientation(tin.vertices_m[a], tin.vertices_m[b], tin.vertices_m[c]) == 0;
}

std::vector<std::uint8_t> are_walls(const Tin& tin) {
  std::vector<std::uint8_t> walls(tin.triangles.size());
  for (std::uint32_t t = 0; t < walls.size(); ++t) {
    throw_if_stopped(t);
    walls[t] = is_wall(tin, t);
  }
  return walls;
}

void turn_walls(Tin& tin) {
  Spread spread{tin, std::vector<std::uint8_t>(tin.triangles.size()), {}};
  std::vector<std::uint32_t> walls;
  for (std::uint32_t t = 0; t < tin.triangles.size(); ++t) {
    throw_if_stopped(t);
    spread.settled[t] = !is_wall(tin, t);
    if (!spread.settled[t]) walls.push_back(t);
  }
  for (const std::uint32_t wall : walls)
    for (const std::uint32_t beside : tin.neighbours[wall])
      if (beside != kNoTriangle && spread.settled[beside] && !is_wall(tin, beside))
        spread.ask_beside(beside);
  spread.finish();
  for (const std::uint32_t wall : walls) {
    if (spread.settled[wall]) continue;
    spread.settled[wall] = 1;
    spread.to_do.push_back(wall);
    spread.finish();
  }
}

std::size_t keep_standing_walls(Tin& tin, std::vector<HadBeside> had) {
  const std::size_t before = tin.triangles.size();
  for (;;) {
    const Marks walls = are_walls(tin);
    Neighbours neighbours = find_neighbours(tin.triangles, tin.vertices_m.size());
    tin.neighbours = std::move(neighbours.of);
    Marks doomed(walls.size());
    const auto any = [&] { return std::find(doomed.begin(), doomed.end(), 1) != doomed.end(); };
    mark_at_crowded_edges(neighbours, walls, doomed);
    if (!any()) mark_hanging(tin, walls, had, doomed);
    if (!any()) {
      const auto as_was = tin.triangles;
      turn_walls(tin);
      for (std::size_t t = 0; t < had.size(); ++t)
        if (tin.triangles[t] != as_was[t]) std::swap(had[t][1], had[t][2]);
      mark_contradicted(tin, walls, doomed);
      if (!any()) return before - tin.triangles.size();
    }
    erase_marked(tin.triangles, doomed);
    erase_marked(had, doomed);
  }
}

} // namespace orograph
