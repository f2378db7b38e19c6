// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/mesh/edges_fit.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace orograph {

bool run_alike(const Tin& tin, std::uint32_t a, std::uint32_t side, std::uint32_t b) {
  const auto [from, to] = ends_of(tin.triangles[a], side);
  const auto& other = tin.triangles[b];
  for (std::uint32_t k = 0; k < 3; ++k)
    if (ends_of(other, k) == std::array{from, to}) return true;
  return false;
}

std::optional<Misfit> edge_misfit(const Tin& tin, const Neighbours& neighbours) {
  if (!neighbours.crowded.empty()) {
    Misfit misfit{TinFault::Kind::edge_of_three, {}};
    for (const TriangleSide& side : neighbours.crowded.front())
      misfit.triangles.push_back(side.triangle);
    return misfit;
  }
  for (std::uint32_t t = 0; t < tin.triangles.size(); ++t)
    for (std::uint32_t k = 0; k < 3; ++k) {
      const std::uint32_t other = neighbours.of[t][k];
      if (other != kNoTriangle && run_alike(tin, t, k, other))
        return Misfit{TinFault::Kind::edge_runs_twice, {std::min(t, other), std::max(t, other)}};
    }
  return std::nullopt;
}

std::string phrase(const Misfit& misfit) {
  const auto& t = misfit.triangles;
  switch (misfit.kind) {
  case TinFault::Kind::edge_of_three:
    return fmt::format("triangles {}, {} and {} have one edge in common", t[0], t[1], t[2]);
  case TinFault::Kind::edge_runs_twice:
    return fmt::format("triangles {} and {} run the same way along their common edge", t[0], t[1]);
  default:
    return fmt::format("triangles {} and {} overlap seen from above", t[0], t[1]);
  }
}

} // namespace orograph
