// SPDX-License-Identifier: GPL-3.0-or-later
// Whether a Tin keeps what it promises, and whether triangles fit together along their edges.
#pragma once

#include "dem/mesh/neighbours.hpp"
#include "dem/tin.hpp"

#include <optional>
#include <string>
#include <vector>

namespace orograph {

struct TinFault {
  enum class Kind {
    no_triangles,
    bad_sizes,           ///< neighbours aren't as many as triangles
    bad_index,           ///< of a vertex or a neighbour that isn't there
    not_finite,          ///< a coordinate
    repeated_vertex,     ///< a triangle has one vertex twice, or two at one point
    no_area,             ///< a triangle's vertices lie on one line in space
    turned_over,         ///< a triangle runs clockwise seen from above
    edge_of_three,       ///< an edge has more than two triangles
    edge_runs_twice,     ///< two triangles run along an edge in one direction
    neighbours_disagree, ///< they aren't those across the edge
    overlap              ///< two triangles share ground of more than a line
  };
  Kind kind;
  std::string what; ///< a phrase that names the triangles and vertices by number, from 0
};

/// The first fault found; none if the Tin is valid. Decided exactly: signs of areas come from
/// predicates that are right for any doubles. Cost O(n log n) for n triangles of about one size.
std::optional<TinFault> verify(const Tin& tin);

/// Triangles that can't be side by side in a terrain, by number.
struct Misfit {
  TinFault::Kind kind = TinFault::Kind::overlap; ///< edge_of_three, edge_runs_twice or overlap
  std::vector<std::uint32_t> triangles;
};

/// An edge of three, or one that two run along in one direction. `neighbours` are `tin`'s;
/// tin.neighbours isn't looked at.
std::optional<Misfit> edge_misfit(const Tin& tin, const Neighbours& neighbours);

/// "triangles 3 and 5 overlap seen from above".
std::string phrase(const Misfit& misfit);

} // namespace orograph
