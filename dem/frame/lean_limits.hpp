// SPDX-License-Identifier: GPL-3.0-or-later
// Vertices of a lattice on the earth that don't lean as far as their height would have them.
#pragma once

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace orograph {

/// At a vertex higher than `height_m`, or at one lower than that, what lies beyond goes straight
/// up, or down, instead of away from the earth's centre.
struct LeanLimit {
  int column;
  double height_m; ///< before exaggeration
  bool is_above;   ///< the vertex is higher

  /// The height that says how far something at a height leans.
  double of(double at_m) const {
    return is_above ? std::min(at_m, height_m) : std::max(at_m, height_m);
  }
};

class LeanLimits {
public:
  /// Row after row, each with rising columns. `turned_over`: triangles that would be without them.
  LeanLimits(std::vector<std::vector<LeanLimit>> rows, std::size_t turned_over)
      : rows_(std::move(rows)), turned_over_(turned_over) {}

  const std::vector<LeanLimit>& of_row(int row) const {
    return rows_[static_cast<std::size_t>(row)];
  }
  /// Null where a vertex leans by its height.
  const LeanLimit* of(int column, int row) const {
    const std::vector<LeanLimit>& limits = of_row(row);
    if (limits.empty()) return nullptr;
    const auto at = std::ranges::lower_bound(limits, column, {}, &LeanLimit::column);
    return at != limits.end() && at->column == column ? &*at : nullptr;
  }
  std::size_t turned_over() const { return turned_over_; }

private:
  std::vector<std::vector<LeanLimit>> rows_;
  std::size_t turned_over_;
};

} // namespace orograph
