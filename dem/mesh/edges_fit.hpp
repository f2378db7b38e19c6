// SPDX-License-Identifier: GPL-3.0-or-later
// Whether triangles fit together along their edges.
#pragma once

#include "dem/mesh/neighbours.hpp"
#include "dem/mesh/verify_tin.hpp"

#include <optional>
#include <string>
#include <vector>

namespace orograph {

/// Triangles that can't be side by side in a terrain, by number.
struct Misfit {
  TinFault::Kind kind = TinFault::Kind::overlap; ///< edge_of_three, edge_runs_twice or overlap
  std::vector<std::uint32_t> triangles;
};

/// The two run the same way along the edge opposite to vertex `side` of a. REQUIRES that they are
/// neighbours there.
bool run_alike(const Tin& tin, std::uint32_t a, std::uint32_t side, std::uint32_t b);

/// An edge of three, or one that two run along in one direction. `neighbours` are `tin`'s;
/// tin.neighbours isn't looked at.
std::optional<Misfit> edge_misfit(const Tin& tin, const Neighbours& neighbours);

/// "triangles 3 and 5 overlap seen from above".
std::string phrase(const Misfit& misfit);

} // namespace orograph
