// SPDX-License-Identifier: GPL-3.0-or-later
// What a sweep writes down in its folder, so that it can go on after any end: its plan, before the
// first view is drawn, and a row for each view that is done. Tables are made of these.
#pragma once

#include "cli/sweep/columns.hpp"
#include "cli/sweep/view_list.hpp"
#include "dem/terrain.hpp"
#include "draw/preview.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace orograph {

struct PlannedView {
  std::string name;
  std::vector<double> values; ///< by axis
};

/// Where `--view-from auto` would have the viewer stand.
struct ChosenDirection {
  double azimuth_deg = 0, elevation_deg = 0;
};

struct Plan {
  std::string title, terrain;      ///< as in drawings; what it was read from, in brief
  std::string text;                ///< as in the file
  std::string extension;           ///< of the drawings, with its point
  std::vector<std::string> varied; ///< columns of the axes that have several values
  bool crossed = true;
  std::vector<Column> columns;
  std::vector<PlannedView> views;
  std::optional<ChosenDirection> chosen; ///< of a sweep round the terrain; the page marks it

  std::string file(std::size_t view) const { return views[view].name + extension; }
};

/// The same for the same sweep of the same heights, wherever the files are.
Plan make_plan(const SweepSettings& settings, const ViewList& views, const Columns& columns,
               const TerrainData& terrain, const std::optional<ChosenDirection>& chosen);

/// In OUT_DIR.
std::string plan_path(const std::string& out_dir);
/// None where there is none. Throws Error where the file isn't one.
std::optional<Plan> read_plan(const std::string& out_dir);

/// Throws Error where the two aren't the same sweep: it says what is another. `out_dir` is where
/// `old_plan` stands.
void check_same(const Plan& old_plan, const Plan& plan, const std::string& out_dir);

struct ViewRecord {
  std::vector<Value> row; ///< by the plan's columns
  std::string preview;    ///< JSON; "null" where there is no drawing
  bool failed = false;
};

/// Where the record of a view is, in OUT_DIR.
std::string record_path(const std::string& out_dir, const Plan& plan, std::size_t view);

/// Whole or not at all, in place of an older one. Throws Error where it can't be written.
void write_record(const std::string& out_dir, const Plan& plan, std::size_t view,
                  const std::vector<Value>& row, const std::optional<Preview>& preview);

/// None where there is none. Throws Error where the file isn't the record of this view.
std::optional<ViewRecord> read_record(const std::string& out_dir, const Plan& plan,
                                      std::size_t view);

/// sweep.csv and sweep.json of these rows.
std::string table_csv(const Plan& plan, const std::vector<ViewRecord>& records);
std::string table_json(const Plan& plan, const std::vector<ViewRecord>& records);

} // namespace orograph
