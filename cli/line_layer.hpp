// SPDX-License-Identifier: GPL-3.0-or-later
// A layer of lines on the surface other than profiles: shores, the border.
#pragma once

#include "draw/stroke_builder.hpp"
#include "horizon/clip_line.hpp"
#include "profiles/slab_lines.hpp"

#include <cstdint>
#include <vector>

namespace orograph {

/// Collects what is visible of a set of grid edges, slab by slab, and joins it into long strokes.
class LineLayer {
public:
  LineLayer(const Grid& grid, const View& view, std::vector<GridEdge> edges, double from_m);

  /// Takes the slab up to the plane at `to_m`: what is above `horizon`, which is made of what
  /// stands in front of the slab.
  void take_slab(double to_m, const Horizon& horizon);

  /// All visible lines, joined at shared vertices, as strokes. Call once, at the end.
  void draw(StrokeBuilder& builder);

private:
  struct VisiblePart {
    std::uint32_t line;
    double t_begin, t_end;
  };

  void join_parts();

  const View& view_;
  std::vector<GridEdge> edges_;
  SlabLines slabs_;
  std::vector<LinePart> scratch_;
  std::vector<VisiblePart> parts_;
};

} // namespace orograph
