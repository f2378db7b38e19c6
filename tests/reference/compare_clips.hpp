// SPDX-License-Identifier: GPL-3.0-or-later
// `clip` against the exact clip, on a flat scene: what double precision promises
// (docs/how-it-works.md).
#pragma once

#include "horizon/clip.hpp"
#include "tests/horizon/flat_scenes.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace orograph {

struct ClipDifferences {
  std::size_t pieces = 0, exact_pieces = 0; ///< drawn by `clip`, and by the exact clip
  double farthest_end_mm = 0; ///< an end's distance from the true one, where that is promised
  /// Stretches that one of the two alone draws and that are longer than promised for an end; the
  /// sources lie close enough to each other all along (a tie, or a crossing of near parallels).
  std::size_t close = 0;
  std::size_t wrong = 0; ///< the same where the sources don't
  std::string first_wrong;
};

/// Clips the lists in order, each in its role, without a tolerance for ties. The scene's X range is
/// 200 mm wide on the page, and Y to the same scale. Promised for an end: 1e-9 mm, or 4 ulp of the
/// way along its segment where that is more (on segments of kilometres).
ClipDifferences compare_clips(const FlatScene& scene, const std::vector<Role>& roles);

} // namespace orograph
