// SPDX-License-Identifier: GPL-3.0-or-later
// What stands in front of an edge that runs straight away from the eye, along a line of the
// lattice.
#pragma once

#include "dem/grid.hpp"
#include "profiles/triangles.hpp"
#include "view/view.hpp"

#include <cstdint>
#include <unordered_map>

namespace orograph {

/// The ground in front of such an edge is the line of the lattice that it lies on, whose running
/// maximum is kept. (A horizon may already hold what stands farther and only touches the edge's X.)
class UprightHeights {
public:
  /// REQUIRES a grid on a map plane, and that both outlive this. Ground nearer than `from_m` is
  /// cut away.
  UprightHeights(const Grid& grid, const View& view, double from_m)
      : grid_(grid), view_(view), from_m_(from_m) {}

  /// The greatest Y on the line from the eye up to the edge's nearer end, -infinity if there is no
  /// ground. REQUIRES that edges of one line are asked front to back. Cost: O(1) over all edges
  /// of a line.
  double in_front(SurfaceEdge edge, bool from_is_nearer);

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
