// SPDX-License-Identifier: GPL-3.0-or-later
// Lines on the surface, handed out slab by slab.
#pragma once

#include "dem/grid.hpp"
#include "geometry/profile_point.hpp"
#include "profiles/triangles.hpp"
#include "view/view.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace orograph {

/// The part of a line that lies in one slab, from t_begin to t_end (0 at the line's `from` vertex,
/// 1 at its `to` vertex). Where a slab's plane cuts a line, the t on both sides is the same number.
struct SlabPiece {
  std::uint32_t line;
  double t_begin, t_end;
  ProfilePoint begin, end;
};

/// Ends of a grid edge in the profile frame.
struct ProfileLine {
  ProfilePoint from, to;
};
ProfileLine line_of(const Grid& grid, const View& view, GridEdge edge);

/// Cuts lines by the planes of consecutive slabs. Cost in all: a sort of the lines, and O(1) a
/// piece.
class SlabLines {
public:
  /// The first slab begins at depth `from_m`; what lies nearer is left out.
  SlabLines(std::vector<ProfileLine> lines, double from_m);

  /// The pieces in the slab from the last plane to the one at `to_m`, which is in it, in no
  /// particular order. REQUIRES that `to_m` never falls. The span is valid until the next call.
  std::span<const SlabPiece> next(double to_m);

  const ProfileLine& line(std::uint32_t i) const { return lines_[i]; }

private:
  void cut(std::uint32_t line, double to_m);

  std::vector<ProfileLine> lines_;
  std::vector<std::uint32_t> by_depth_; ///< lines by their nearer end
  std::size_t waiting_ = 0;             ///< first of `by_depth_` that hasn't begun
  std::vector<std::uint32_t> active_;
  std::vector<SlabPiece> pieces_;
  double from_m_;
};

} // namespace orograph
