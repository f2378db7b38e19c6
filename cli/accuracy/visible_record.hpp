// SPDX-License-Identifier: GPL-3.0-or-later
// What was visible of the profiles of a run, to be compared with another run's.
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "hidden_lines/instruments.hpp"
#include "placing/placed_view.hpp"

namespace orograph {

/// Keeps the visible stretches of each profile, in mm on the page along it. REQUIRES that the
/// placed view outlives the record. Memory: 16 bytes a stretch.
class VisibleRecord : public LineObserver {
public:
  explicit VisibleRecord(const PlacedView& scene) : scene_(scene) {}

  void see(const SeenProfile& profile) override;
  void see(const SeenLines&) override {}

  /// The longest stretch that is visible in one run of a view and hidden in the other: 0 where the
  /// two agree, else how far an end has moved, or what was lost or gained.
  friend double longest_difference_mm(const VisibleRecord& a, const VisibleRecord& b);

private:
  using Stretches = std::vector<std::pair<double, double>>;

  const PlacedView& scene_;
  std::vector<Stretches> profiles_;
};

double longest_difference_mm(const VisibleRecord& a, const VisibleRecord& b);

} // namespace orograph
