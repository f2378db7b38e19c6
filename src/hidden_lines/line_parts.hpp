// SPDX-License-Identifier: GPL-3.0-or-later
// Parts of lines on the surface, as sets of places along them.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

namespace orograph {

/// A visible part of a line; along its edge, 0 at `edge.from` and 1 at `edge.to`.
struct LinePart {
  std::uint32_t line;
  double t_begin, t_end;
};

/// Shares of one edge that were reckoned on both sides of a slab's plane are equal to rounding.
constexpr double kSameShare = 1e-12;

/// Brings parts in order by line and along it. Those that overlap, meet, or are no farther apart
/// than `gap` says of the line (shares; rounding, if it isn't given), become one. Slits that
/// rounding leaves where two occluders meet are dropped.
void join(std::vector<LinePart>& parts, const std::function<double(std::uint32_t)>& gap = {});

/// What is left of `parts` without `taken`; both by line.
std::vector<LinePart> without(const std::vector<LinePart>& parts,
                              const std::vector<LinePart>& taken);

/// What of `parts` is in `others` as well; both by line.
std::vector<LinePart> shared(const std::vector<LinePart>& parts,
                             const std::vector<LinePart>& others);

} // namespace orograph
