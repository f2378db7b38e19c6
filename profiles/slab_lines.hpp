// SPDX-License-Identifier: GPL-3.0-or-later
// Lines on the surface, handed out slab by slab.
#pragma once

#include "dem/surface.hpp"
#include "geometry/profile_point.hpp"
#include "profiles/surface_edge.hpp"
#include "view/view.hpp"

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace orograph {

/// Ends of a line in the profile frame.
struct ProfileLine {
  ProfilePoint from, to;
};
ProfileLine line_of(const Grid& grid, const View& view, SurfaceEdge edge);
ProfileLine line_of(const Tin& tin, const View& view, SurfaceEdge edge);
ProfileLine line_of(const Surface& surface, const View& view, SurfaceEdge edge);

/// The part of a line that lies in one slab, from t_begin to t_end (0 at the line's `from` end, 1
/// at its `to` end). Where a slab's plane cuts a line, the t on both sides is the same number.
struct SlabPiece {
  std::uint32_t line;
  double t_begin, t_end;
  ProfileLine whole; ///< the line
  ProfilePoint begin, end;
};

/// Cuts lines by the planes of consecutive slabs. Memory: 4 bytes a line, and the lines of one
/// slab. Cost in all: a sort of the lines, and O(1) a piece.
class SlabLines {
public:
  using LineOf = std::function<ProfileLine(std::uint32_t)>;

  /// `count` lines, each asked from `line_of` when it is needed. The first slab begins at depth
  /// `from_m`; what lies nearer is left out.
  SlabLines(std::uint32_t count, LineOf line_of, double from_m);

  /// The pieces in the slab from the last plane to the one at `to_m`, which is in it, in no
  /// particular order. Lines that begin in the slab and are `hidden` as a whole are left out for
  /// good. REQUIRES that `to_m` never falls. The span is valid until the next call.
  using Hidden = std::function<bool(const ProfileLine&)>;
  std::span<const SlabPiece> next(double to_m, const Hidden& hidden = {});

  ProfileLine line(std::uint32_t i) const { return line_of_(i); }

private:
  bool cut(std::uint32_t line, double to_m, const Hidden& hidden);

  LineOf line_of_;
  std::vector<std::uint32_t> by_depth_;   ///< lines, by bucket of their nearer end
  std::vector<std::uint32_t> bucket_end_; ///< in `by_depth_`
  std::vector<double> bucket_begin_m_;    ///< no line of the bucket is nearer
  std::size_t waiting_ = 0;               ///< first bucket that hasn't begun
  std::size_t begun_ = 0;                 ///< lines that have
  std::vector<std::uint32_t> active_;
  std::vector<SlabPiece> pieces_;
  double from_m_;
};

} // namespace orograph
