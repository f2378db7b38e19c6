// SPDX-License-Identifier: GPL-3.0-or-later
// How much of the ground a picture shows.
#pragma once

#include "hidden_lines/instruments.hpp"
#include "placing/placed_view.hpp"

#include <optional>

namespace orograph {

/// Measures the profiles as they are clipped. Level ground counts, whether it is drawn or not; what
/// is outside of the frame isn't shown.
class GroundMeter : public LineObserver {
public:
  /// REQUIRES that the placed view outlives the meter.
  explicit GroundMeter(const PlacedView& scene) : scene_(scene) {}

  void see(const SeenProfile& profile) override;
  bool asks_lines() const override { return false; }
  void see(const SeenLines&) override {}

  /// Length on the page of what is visible of the profiles, before any of it is simplified.
  double visible_mm() const { return visible_mm_; }
  /// Of the ground that the profiles cut, as seen from above, the share that the picture shows:
  /// each profile stands for the ground half way to its neighbours, the first and the last for as
  /// much on the other side. None where they cut no ground.
  std::optional<double> visible_share() const;

private:
  double width_m(const Sector& sector, double depth_m) const;

  const PlacedView& scene_;
  double visible_mm_ = 0, ground_m2_ = 0, visible_m2_ = 0;
};

} // namespace orograph
