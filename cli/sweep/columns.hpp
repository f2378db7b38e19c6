// SPDX-License-Identifier: GPL-3.0-or-later
// What a sweep's tables tell of a view, and how the visible share is measured.
#pragma once

#include "cli/report/measurements.hpp"
#include "cli/report/run_report.hpp"
#include "cli/sweep/view_list.hpp"
#include "hidden_lines/instruments.hpp"
#include "placing/placed_view.hpp"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace orograph {

struct Column {
  std::string name, unit; ///< unit: empty for counts, ratios and texts
  std::string about;      ///< a phrase
};

/// Where a row has what tells of the view itself; these come first.
enum LeadingColumn : std::size_t { kViewColumn, kNameColumn, kFileColumn, kErrorColumn };

/// How much of the ground a picture shows: measures the profiles as they are clipped. Level ground
/// counts, whether it is drawn or not; what is outside of the frame isn't shown.
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

/// A drawn view.
struct DrawnView {
  const RunReport& report;
  const GroundMeter& ground;
  double seconds;
};

class Columns {
public:
  /// REQUIRES that both outlive it.
  Columns(const SweepSettings& settings, const ViewList& views);

  std::vector<Column> columns() const;
  /// A row of view `number`; what was measured is left out of one that failed, which has no facts.
  std::vector<Value> row(std::size_t number, const std::string& file, const std::string& error,
                         const DrawnView* facts) const;

private:
  struct Measured {
    Column column;
    std::function<Value(const DrawnView&)> of;
  };
  const SweepSettings& settings_;
  const ViewList& views_;
  std::vector<Measured> measured_;
};

} // namespace orograph
