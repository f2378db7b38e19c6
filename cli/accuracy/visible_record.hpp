// SPDX-License-Identifier: GPL-3.0-or-later
// What was visible of the profiles of a run, to be compared with another run's.
#pragma once

#include "cli/instruments.hpp"
#include "cli/scene.hpp"

#include <cstddef>
#include <utility>
#include <vector>

namespace orograph {

/// Keeps the visible stretches of each profile, in mm on the page along it. REQUIRES that the scene
/// outlives the record. Memory: 16 bytes a stretch.
class VisibleRecord : public LineObserver {
public:
  explicit VisibleRecord(const Scene& scene) : scene_(scene) {}

  void see(const Sector& sector, const Profile& profile, const std::vector<Segment>& segments,
           const std::vector<Piece>& visible) override;
  void see(const Sector&, const LineSweep&, const std::vector<LinePart>&) override {}

  /// The longest stretch that is visible in one run of a scene and hidden in the other: 0 where the
  /// two agree, else how far an end has moved, or what was lost or gained.
  friend double longest_difference_mm(const VisibleRecord& a, const VisibleRecord& b);

private:
  using Stretches = std::vector<std::pair<double, double>>;

  const Scene& scene_;
  std::vector<Stretches> profiles_;
};

double longest_difference_mm(const VisibleRecord& a, const VisibleRecord& b);

} // namespace orograph
