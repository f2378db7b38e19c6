// SPDX-License-Identifier: GPL-3.0-or-later
// What is kept of each view that is done, so that a sweep can go on after any end.
#pragma once

#include "cli/sweep/plan.hpp"
#include "cli/sweep/preview.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace orograph {

struct ViewRecord {
  std::vector<Cell> row; ///< by the plan's columns
  std::string preview;   ///< JSON; "null" where there is no drawing
  bool failed = false;
};

/// Where the record of a view is, in OUT_DIR.
std::string record_path(const std::string& out_dir, const Plan& plan, std::size_t view);

/// Whole or not at all, in place of an older one. Throws Error where it can't be written.
void write_record(const std::string& out_dir, const Plan& plan, std::size_t view,
                  const std::vector<Cell>& row, const std::optional<Preview>& preview);

/// None where there is none. Throws Error where the file isn't the record of this view.
std::optional<ViewRecord> read_record(const std::string& out_dir, const Plan& plan,
                                      std::size_t view);

/// A row as a line of CSV, and as JSON.
std::string csv_line(const std::vector<Cell>& row);
std::string json_row(const std::vector<Column>& columns, const std::vector<Cell>& row);

} // namespace orograph
