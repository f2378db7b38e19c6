// SPDX-License-Identifier: GPL-3.0-or-later
// Strokes whose ends nearly meet, as one: a ridge that something small hides here and there is one
// line on paper.
#pragma once

#include "draw/drawing.hpp"

namespace orograph {

/// How strokes become chains, and which of those are drawn.
struct JoinSettings {
  double gap_mm = 0;        ///< widest gap between two ends that become one line
  double min_stroke_mm = 0; ///< chains with less ink are left out, whole
  double simplify_mm = 0;   ///< as in `simplify`, of what is joined
};

/// The layer of its strokes' chains, in the order of the first stroke of each. Each end is joined
/// to at most one other, no farther away than the gap, nearer ones and those that go straight on
/// first; a stroke of less than eight gaps isn't closed with itself. Gaps are bridged by straight
/// lines, but in a layer with map points, whose strokes stay what they are: there is no ground
/// under a gap. Chains without enough ink are left out, whole; their length is added to
/// `left_out_mm`. The same layer gives the same chains. Cost O(n log n) for n strokes: of each
/// end's neighbours the best four are looked at.
Layer joined(const Layer& layer, const JoinSettings& settings, double& left_out_mm);

} // namespace orograph
