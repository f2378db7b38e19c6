// SPDX-License-Identifier: GPL-3.0-or-later
// What stands in front of an edge that runs straight away from the eye, along a line of the
// lattice.
#pragma once

#include "dem/grid.hpp"
#include "horizon/blocked_horizon.hpp"
#include "horizon/surface_line.hpp"
#include "profiles/triangles.hpp"
#include "view/view.hpp"

#include <cstdint>
#include <unordered_map>

namespace orograph {

/// On a map plane the ground in front of such an edge is the line of the lattice that it lies on,
/// whose running maximum is kept. (A horizon may already hold what stands farther and only touches
/// the edge's X.) On the earth the line turns aside, and the horizon tells: of its two sides there
/// the one where the cell behind the edge is holds nothing yet that isn't in front.
class UprightHeights {
public:
  /// REQUIRES that both outlive this. Ground nearer than `from_m` is cut away.
  UprightHeights(const Grid& grid, const View& view, double from_m)
      : grid_(grid), view_(view), from_m_(from_m) {}

  /// The greatest Y on the ray from the eye up to the edge's nearer end, -infinity if there is no
  /// ground. `line` is the edge's, which is upright, `horizon` as it stands at its turn. REQUIRES
  /// that edges of one line are asked front to back. Cost: O(1) over all edges of a line.
  double in_front(SurfaceEdge edge, bool from_is_nearer, const SurfaceLine& line,
                  const BlockedHorizon& horizon);

private:
  struct Line {
    int steps_done = 0; ///< from the line's first vertex
    double greatest_y;
  };
  template <class Height>
  double in_front(const Heights<Height>& heights, SurfaceEdge edge, bool from_is_nearer);

  const Grid& grid_;
  const View& view_;
  double from_m_;
  std::unordered_map<std::uint64_t, Line> lines_;
};

} // namespace orograph
