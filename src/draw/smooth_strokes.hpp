// SPDX-License-Identifier: GPL-3.0-or-later
// Strokes drawn smoothly: a shore along the edges of cells, without their staircase.
#pragma once

#include "draw/drawing.hpp"

namespace orograph {

/// How far strokes may be moved, and what becomes of them then.
struct SmoothSettings {
  double bound_mm = 0;    ///< smoothed and unsmoothed strokes are never farther apart
  double simplify_mm = 0; ///< as in `simplify`, of what is smoothed
  Box2 frame_mm;          ///< strokes stay in it
};

/// The bound below which strokes stay what they are: no pen shows so little.
constexpr double kLeastSmoothing_mm = 0.02;

/// The layer with each stroke drawn smoothly, and then simplified. Before it is simplified a stroke
/// has a Fréchet distance of at most `bound_mm` to what it was: both can be walked from end to end,
/// never farther apart than that. Ends stay where they are; a closed stroke stays closed, and
/// nowhere on it is an end. What is far longer than the bound, bays and islands, keeps its size.
/// Strokes of the layer that come to cross each other or themselves, and didn't before, go back to
/// where they were as far as is needed; what they are compared with is each stroke as it was to a
/// tenth of the bound. REQUIRES a layer without map points and strokes inside the frame. The same
/// layer gives the same strokes. Cost: about 5 µs for each fifth of the bound along a stroke.
Layer smoothed(const Layer& layer, const SmoothSettings& settings);

} // namespace orograph
