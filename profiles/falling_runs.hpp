// SPDX-License-Identifier: GPL-3.0-or-later
// Cells side by side in strips, in the order front to back that the edges between them give: they
// come with rising numbers, but for runs that fall.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace orograph {

/// Cells of a strip that come with falling numbers, both ends included.
struct FallingRun {
  int first, last;
};

class FallingRuns {
public:
  /// Of a strip behind the last one; its runs are added with rising numbers.
  void begin_strip() { first_.push_back(runs_.size()); }
  void add(FallingRun run) {
    runs_.push_back(run);
    first_.back() = runs_.size();
  }
  /// Strips that follow these.
  void append(const FallingRuns& others) {
    const std::size_t before = runs_.size();
    runs_.insert(runs_.end(), others.runs_.begin(), others.runs_.end());
    for (std::size_t i = 1; i < others.first_.size(); ++i)
      first_.push_back(before + others.first_[i]);
  }

  int strips() const { return static_cast<int>(first_.size()) - 1; }

  std::span<const FallingRun> of_strip(int strip) const {
    const auto i = static_cast<std::size_t>(strip);
    return {runs_.data() + first_[i], runs_.data() + first_[i + 1]};
  }

  /// Which in its strip's order a cell is.
  std::uint32_t place(int strip, int cell) const {
    const std::span<const FallingRun> runs = of_strip(strip);
    const auto run = std::ranges::lower_bound(runs, cell, {}, &FallingRun::last);
    const bool falls = run != runs.end() && run->first <= cell;
    return static_cast<std::uint32_t>(falls ? run->first + run->last - cell : cell);
  }

  /// Whether a cell comes before the one with the number before.
  bool falls(int strip, int cell) const {
    const std::span<const FallingRun> runs = of_strip(strip);
    const auto run = std::ranges::lower_bound(runs, cell, {}, &FallingRun::last);
    return run != runs.end() && run->first < cell;
  }

private:
  std::vector<FallingRun> runs_;      // strip after strip
  std::vector<std::size_t> first_{0}; // by strip, and behind the last
};

} // namespace orograph
