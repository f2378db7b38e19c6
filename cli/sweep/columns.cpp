// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/sweep/columns.hpp"

#include "text/words.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace orograph {
namespace {

Value cell(double number) {
  return std::isfinite(number) ? Value(number) : Value();
}
Value cell(std::optional<double> number) {
  return number ? cell(*number) : Value();
}
Value cell(std::uint64_t count) {
  return count;
}

// The columns before those that are measured.
const std::vector<Column>& leading_columns() {
  static const std::vector<Column> columns{
      {"view", "", "number of the view, from 0"},
      {"name", "", "what the drawing is called"},
      {"file", "", "the drawing"},
      {"error", "", "why there is no drawing; empty where there is one"}};
  return columns;
}

// What a parameter was where it isn't varied.
Value of_report(Parameter parameter, const RunReport& report) {
  const ViewFacts& view = report.view;
  switch (parameter) {
  case Parameter::view:
  case Parameter::eye:
    return {};
  case Parameter::azimuth:
    return cell(view.view_from_azimuth_deg);
  case Parameter::elevation:
    return cell(view.elevation_deg);
  case Parameter::look_azimuth:
    return cell(std::isfinite(view.look_azimuth_true_deg) ? view.look_azimuth_true_deg
                                                          : view.look_azimuth_deg);
  case Parameter::pitch:
    return cell(0 - view.elevation_deg); // level is 0, not -0
  case Parameter::distance:
    return cell(view.distance_m);
  case Parameter::fov:
    return cell(view.field_of_view_deg);
  case Parameter::exaggeration:
    return cell(view.exaggeration);
  case Parameter::profiles:
    return cell(std::uint64_t{report.profiles.depths_m.size()});
  }
  return {};
}

// Views and eyes have numbers only where they are varied.
bool is_shown(Parameter parameter, const std::vector<Axis>& axes) {
  if (parameter != Parameter::view && parameter != Parameter::eye) return true;
  return std::any_of(axes.begin(), axes.end(),
                     [&](const Axis& axis) { return axis.parameter == parameter; });
}

} // namespace

Columns::Columns(const SweepSettings& settings, const ViewList& views) : views_(views) {
  const auto add = [&](Column column, std::function<Value(const DrawnView&)> of) {
    measured_.push_back({std::move(column), std::move(of)});
  };
  const auto eye = [](double Vec3::*coordinate) {
    return [coordinate](const DrawnView& f) {
      const auto& place = f.report.view.eye;
      return place ? cell((*place).*coordinate) : Value();
    };
  };
  add({"eye_x", "", "the eye's place, in the terrain's CRS"}, eye(&Vec3::x));
  add({"eye_y", "", "the eye's place, in the terrain's CRS"}, eye(&Vec3::y));
  add({"eye_z", "", "the eye's height, in the unit of the terrain's heights"}, eye(&Vec3::z));
  add({"eye_height_m", "m", "the eye above the ground, where there is ground"},
      [](const DrawnView& f) { return cell(f.report.view.eye_height_m); });
  const auto count = [&](const std::string& name, const std::string& about,
                         std::uint64_t Counts::*of) {
    add({name, "", about}, [of](const DrawnView& f) { return cell(f.report.counts.*of); });
  };
  count("cut_vertices", "vertices of all profiles", &Counts::cut_vertices);
  count("segments", "projected pieces of profiles", &Counts::segments);
  count("horizon_pieces_made", "before pieces of one source were joined, over all profiles",
        &Counts::pieces_before_collapse);
  count("horizon_pieces_kept", "after that, over all profiles", &Counts::pieces_after_collapse);
  count("horizon_largest", "pieces of the largest horizon", &Counts::largest_horizon);
  count("ties", "pieces that lie along the horizon", &Counts::ties);
  count("strokes", "lines of the drawing", &Counts::strokes);
  count("points", "of these lines", &Counts::points);
  add({"visible_mm", "mm", "visible length of the profiles on the page, before simplification"},
      [](const DrawnView& f) { return cell(f.ground.visible_mm()); });
  add({"visible_share", "", "of the ground that profiles cut, what the picture shows"},
      [](const DrawnView& f) { return cell(f.ground.visible_share()); });
  add({"pen_down_mm", "mm", "length of all lines"},
      [](const DrawnView& f) { return cell(f.report.pen_down_mm); });
  add({"pen_up_mm", "mm", "between lines"},
      [](const DrawnView& f) { return cell(f.report.pen_up_mm); });
  if (!settings.render.labels.path.empty()) {
    const auto named = [&](const std::string& name, const std::string& about, NameState state) {
      add({name, "", about}, [state](const DrawnView& f) {
        return f.report.names ? cell(std::uint64_t{f.report.names->count(state)}) : Value();
      });
    };
    named("names", "printed", NameState::chosen);
    named("names_hidden", "of summits that aren't seen", NameState::hidden);
    named("names_without_room", "of summits that are seen", NameState::crowded_out);
    add({"names_printed", "", "those that are printed, the first that counts most, with ; between"},
        [](const DrawnView& f) {
          return f.report.names ? Value(f.report.names->chosen()) : Value();
        });
  }
  if (settings.render.map.check > 0) {
    const auto checked = [&](const std::string& name, const std::string& about,
                             std::uint64_t CheckCounts::*of) {
      add({name, "", about}, [of](const DrawnView& f) {
        return f.report.check ? cell((*f.report.check).*of) : Value();
      });
    };
    checked("check_asked", "points asked of the ray walk", &CheckCounts::asked);
    checked("check_ties", "of these, not judged", &CheckCounts::ties);
    checked("check_hidden", "of these, drawn but hidden", &CheckCounts::hidden);
    checked("check_missing", "of these, visible but not drawn", &CheckCounts::missing);
  }
  if (settings.render.map.check_of_file > 0)
    add({"check_of_file_hidden", "",
         "points drawn that the file's surface hides by more than twice the level's error"},
        [](const DrawnView& f) {
          return f.report.check_of_file ? cell(f.report.check_of_file->counts.hidden) : Value();
        });
  add({"error_bound_mm", "mm", "the farthest that a line may be from its place on paper"},
      [](const DrawnView& f) { return cell(f.report.error_budget.total_mm()); });
  if (settings.seconds)
    add({"seconds", "s", "to place, draw and write the view"},
        [](const DrawnView& f) { return cell(f.seconds); });
}

std::vector<Column> Columns::columns() const {
  std::vector<Column> columns = leading_columns();
  for (const ParameterNames& names : all_parameters())
    if (is_shown(names.parameter, views_.axes()))
      columns.push_back({names.column, names.unit, names.about});
  for (const Measured& measured : measured_) columns.push_back(measured.column);
  return columns;
}

std::vector<Value> Columns::row(std::size_t number, const std::string& file,
                                const std::string& error, const DrawnView* facts) const {
  std::vector<Value> row{std::uint64_t{number}, views_.name(number), file,
                         error.empty() ? Value() : Value(error)};
  const std::vector<Axis>& axes = views_.axes();
  const std::vector<double> values = views_.values(number);
  for (const ParameterNames& names : all_parameters()) {
    if (!is_shown(names.parameter, axes)) continue;
    const auto axis = std::find_if(axes.begin(), axes.end(),
                                   [&](const Axis& a) { return a.parameter == names.parameter; });
    if (axis != axes.end())
      row.push_back(cell(values[static_cast<std::size_t>(axis - axes.begin())]));
    else
      row.push_back(facts ? of_report(names.parameter, facts->report) : Value());
  }
  for (const Measured& measured : measured_) row.push_back(facts ? measured.of(*facts) : Value());
  return row;
}

} // namespace orograph
