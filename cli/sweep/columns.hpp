// SPDX-License-Identifier: GPL-3.0-or-later
// What a sweep's tables tell of a view.
#pragma once

#include "cli/report/measurements.hpp"
#include "cli/report/run_report.hpp"
#include "cli/sweep/view_list.hpp"
#include "map/ground_meter.hpp"

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

/// A drawn view.
struct DrawnView {
  const RunReport& report;
  const GroundMeter& ground;
  double seconds;
};

class Columns {
public:
  /// REQUIRES that `views` outlives it.
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
  const ViewList& views_;
  std::vector<Measured> measured_;
};

} // namespace orograph
