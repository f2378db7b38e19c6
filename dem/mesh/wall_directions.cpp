// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/mesh/wall_directions.hpp"

#include "dem/mesh/edges_fit.hpp"
#include "dem/mesh/overlap.hpp"

#include <utility>

namespace orograph {
namespace {

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

} // namespace

void turn_over(Tin& tin, std::uint32_t triangle) {
  std::swap(tin.triangles[triangle][1], tin.triangles[triangle][2]);
  if (triangle < tin.neighbours.size())
    std::swap(tin.neighbours[triangle][1], tin.neighbours[triangle][2]);
}

void turn_walls(Tin& tin) {
  Spread spread{tin, std::vector<std::uint8_t>(tin.triangles.size()), {}};
  std::vector<std::uint32_t> walls;
  for (std::uint32_t t = 0; t < tin.triangles.size(); ++t) {
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

} // namespace orograph
