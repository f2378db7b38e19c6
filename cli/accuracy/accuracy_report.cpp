// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/accuracy/accuracy_report.hpp"

#include "cli/report/measurements.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <utility>

namespace orograph {
namespace {

using Cells = std::vector<std::string>;

std::string number(double x) {
  return fmt::format("{:.3g}", x);
}

std::string number_or_dash(const std::optional<double>& x) {
  return x ? number(*x) : "-";
}

std::string milliseconds(double s) {
  return fmt::format("{:.1f}", 1e3 * s);
}

// "0.31 ±0.04", or what would have been seen: "0 (<0.015)".
std::string percent(const InkSample& ink) {
  if (ink.asked == 0) return "-";
  if (ink.hidden + ink.missing == 0) return fmt::format("0 (<{:.2g})", 100 * ink.smallest_seen());
  return fmt::format("{:.3g} ±{:.2g}", 100 * ink.error(), 100 * ink.standard_error());
}

Cells cells_of(const AccuracyRow& row) {
  const StageSeconds& s = row.seconds;
  const auto promised_percent =
      row.promise.ink_error ? number(100 * *row.promise.ink_error) : std::string("-");
  return {name_of(row),
          milliseconds(s.facing),
          milliseconds(s.cut),
          milliseconds(s.project),
          milliseconds(s.clip),
          milliseconds(s.layout),
          milliseconds(s.total),
          std::to_string(row.counts.segments),
          row.simplified ? std::to_string(row.counts.strokes) : "-",
          std::to_string(row.counts.largest_horizon),
          percent(row.profiles),
          percent(row.lines),
          promised_percent,
          row.ends.asked > 0 ? number(row.ends.largest_mm) : "-",
          row.simplified ? number(row.simplified->largest_mm) : "-",
          number_or_dash(row.arithmetic_mm),
          number_or_dash(row.detail_mm),
          number_or_dash(row.promise.displacement_mm)};
}

// What every row holds.
Record record_of(const AccuracyRow& row) {
  const RowSettings& s = row.settings;
  const InkSample ink = row.profiles + row.lines;
  constexpr std::array<const char*, 3> kArithmetics{"float", "double", "exact"};
  const auto whole = [](std::optional<int> x) {
    return x ? Value(static_cast<std::uint64_t>(*x)) : Value();
  };
  return {{"name", name_of(row)},
          {"varied", row.group},
          {"occluder", s.occluder == Occluder::surface ? "surface" : "profiles"},
          {"profiles", row.profile_count},
          {"simplify_mm", s.simplify_mm},
          {"collapse", s.collapse},
          {"overview", whole(s.overview)},
          {"arithmetic", kArithmetics[static_cast<std::size_t>(s.arithmetic)]},
          {"facing_s", row.seconds.facing},
          {"cut_s", row.seconds.cut},
          {"project_s", row.seconds.project},
          {"clip_s", row.seconds.clip},
          {"layout_s", row.seconds.layout},
          {"total_s", row.seconds.total},
          {"segments", row.counts.segments},
          {"strokes", row.simplified ? Value(row.counts.strokes) : Value()},
          {"largest_horizon", row.counts.largest_horizon},
          {"probes", ink.asked},
          {"ties", ink.ties},
          {"drawn_but_hidden", ink.hidden},
          {"visible_but_missing", ink.missing},
          {"ink_error", ink.error()},
          {"ink_standard_error", ink.standard_error()},
          {"ink_smallest_seen", ink.smallest_seen()},
          {"profiles_ink_error", row.profiles.error()},
          {"lines_ink_error", row.lines.asked > 0 ? Value(row.lines.error()) : Value()},
          {"promised_ink_error", known(row.promise.ink_error)},
          {"ends_asked", row.ends.asked},
          {"ends_tied", row.ends.tied},
          {"ends_astray", row.ends.astray},
          {"ends_mm", row.ends.asked > 0 ? Value(row.ends.largest_mm) : Value()},
          {"simplified_mm", row.simplified ? Value(row.simplified->largest_mm) : Value()},
          {"strokes_compared", row.simplified ? Value(row.simplified->strokes) : Value()},
          {"arithmetic_mm", known(row.arithmetic_mm)},
          {"level_of_detail_mm", known(row.detail_mm)},
          {"displacement_mm", row.displacement_mm()},
          {"promised_displacement_mm", known(row.promise.displacement_mm)},
          {"promised_simplified_mm", known(row.promise.simplified_mm)},
          {"keeps_promise", broken_promise(row).empty()}};
}

std::vector<Record> records_of(const std::vector<AccuracyRow>& rows) {
  std::vector<Record> records;
  for (const AccuracyRow& row : rows) records.push_back(record_of(row));
  return records;
}

} // namespace

std::string accuracy_table(const std::vector<AccuracyRow>& rows) {
  std::vector<Cells> table{{"", "facing", "cut", "project", "clip", "layout", "total", "segments",
                            "strokes", "largest", "ink error, %", "", "promised", "ends",
                            "simplified", "arithmetic", "detail", "promised"},
                           {"settings", "ms", "ms", "ms", "ms", "ms", "ms", "", "", "horizon",
                            "profiles", "other lines", "%", "mm", "mm", "mm", "mm", "mm"}};
  for (const AccuracyRow& row : rows) table.push_back(cells_of(row));
  return aligned_table(table);
}

std::string accuracy_csv(const std::vector<AccuracyRow>& rows) {
  return csv_of(records_of(rows));
}

std::string accuracy_json(const std::vector<AccuracyRow>& rows, const std::string& terrain) {
  return json_of(terrain, {{"rows", records_of(rows)}});
}

} // namespace orograph
