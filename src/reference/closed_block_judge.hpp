// SPDX-License-Identifier: GPL-3.0-or-later
// Whether a place on a line of a block that is closed below is drawn as it is seen, by the walk.
#pragma once

#include "horizon/compare.hpp"
#include "profiles/slab_lines.hpp"
#include "reference/closed_block_walk.hpp"

namespace orograph {

class ClosedBlockJudge {
public:
  /// As `ClosedBlockWalk` has it.
  ClosedBlockJudge(const TerrainData& terrain, double base_m, const View& view,
                   const TieTolerance& tolerance)
      : walk_(terrain, base_m, view), view_(&view), tolerance_(tolerance) {}
  /// From now on it judges another view of the same block.
  void set_view(const View& view, const TieTolerance& tolerance);

  enum class Sight { hidden, seen, unsure };
  /// Of the place at share t of a line on the block. Unsure where it is otherwise a little to
  /// either side, or hardly hidden, near the near plane, and in views straight from above or below.
  Sight sight(const ProfileLine& line, double t) const;

private:
  ClosedBlockWalk walk_;
  const View* view_;
  TieTolerance tolerance_;
};

} // namespace orograph
