// SPDX-License-Identifier: GPL-3.0-or-later
// The best of all sets of names that stand side by side on one line.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "naming/rank_names.hpp"

namespace orograph {

struct NameOnLine {
  double x_mm = 0;
  NameWeight weight; ///< above 0
};

/// Of all sets of at most `most` names, no two of which are less than `pitch_mm` apart in x, the
/// one of the greatest sum of weights: exactly, by weighted interval scheduling. Returns numbers,
/// by x. Of sets that are as good it depends on places and weights alone which one it is.
/// REQUIRES a pitch above 0. Cost: O(n log n), and O(n most) where `most` binds.
std::vector<std::size_t> choose_on_line(std::span<const NameOnLine> names, double pitch_mm,
                                        std::optional<std::size_t> most = std::nullopt);

} // namespace orograph
