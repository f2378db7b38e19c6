// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/accuracy/accuracy_report.hpp"

#include "cli/version.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace orograph {
namespace {

using Json = nlohmann::ordered_json;
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
  const SecondsReport& s = row.seconds;
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

// Characters, not bytes: "±" is one.
std::size_t width_of(const std::string& text) {
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return (c & 0xC0) != 0x80; }));
}

/// What every row holds, as names and values; what isn't known is null.
Json fields_of(const AccuracyRow& row) {
  const RowSettings& s = row.settings;
  const InkSample ink = row.profiles + row.lines;
  constexpr std::array<const char*, 3> kArithmetics{"float", "double", "exact"};
  const auto optional = [](const auto& x) { return x ? Json(*x) : Json(); };
  return {{"name", name_of(row)},
          {"varied", row.group},
          {"occluder", s.occluder == Occluder::surface ? "surface" : "profiles"},
          {"profiles", row.profile_count},
          {"simplify_mm", s.simplify_mm},
          {"collapse", s.collapse},
          {"overview", optional(s.overview)},
          {"arithmetic", kArithmetics[static_cast<std::size_t>(s.arithmetic)]},
          {"facing_s", row.seconds.facing},
          {"cut_s", row.seconds.cut},
          {"project_s", row.seconds.project},
          {"clip_s", row.seconds.clip},
          {"layout_s", row.seconds.layout},
          {"total_s", row.seconds.total},
          {"segments", row.counts.segments},
          {"strokes", row.simplified ? Json(row.counts.strokes) : Json()},
          {"largest_horizon", row.counts.largest_horizon},
          {"probes", ink.asked},
          {"ties", ink.ties},
          {"drawn_but_hidden", ink.hidden},
          {"visible_but_missing", ink.missing},
          {"ink_error", ink.error()},
          {"ink_standard_error", ink.standard_error()},
          {"ink_smallest_seen", ink.smallest_seen()},
          {"profiles_ink_error", row.profiles.error()},
          {"lines_ink_error", row.lines.asked > 0 ? Json(row.lines.error()) : Json()},
          {"promised_ink_error", optional(row.promise.ink_error)},
          {"ends_asked", row.ends.asked},
          {"ends_tied", row.ends.tied},
          {"ends_astray", row.ends.astray},
          {"ends_mm", row.ends.asked > 0 ? Json(row.ends.largest_mm) : Json()},
          {"simplified_mm", row.simplified ? Json(row.simplified->largest_mm) : Json()},
          {"strokes_compared", row.simplified ? Json(row.simplified->strokes) : Json()},
          {"arithmetic_mm", optional(row.arithmetic_mm)},
          {"level_of_detail_mm", optional(row.detail_mm)},
          {"displacement_mm", row.displacement_mm()},
          {"promised_displacement_mm", optional(row.promise.displacement_mm)},
          {"promised_simplified_mm", optional(row.promise.simplified_mm)},
          {"keeps_promise", broken_promise(row).empty()}};
}

} // namespace

std::string accuracy_table(const std::vector<AccuracyRow>& rows) {
  std::vector<Cells> table{{"", "facing", "cut", "project", "clip", "layout", "total", "segments",
                            "strokes", "largest", "ink error, %", "", "promised", "ends",
                            "simplified", "arithmetic", "detail", "promised"},
                           {"settings", "ms", "ms", "ms", "ms", "ms", "ms", "", "", "horizon",
                            "profiles", "other lines", "%", "mm", "mm", "mm", "mm", "mm"}};
  for (const AccuracyRow& row : rows) table.push_back(cells_of(row));
  std::vector<std::size_t> widths(table.front().size(), 0);
  for (const Cells& cells : table)
    for (std::size_t i = 0; i < cells.size(); ++i)
      widths[i] = std::max(widths[i], width_of(cells[i]));
  std::string text;
  for (const Cells& cells : table) {
    std::string line;
    for (std::size_t i = 0; i < cells.size(); ++i) {
      const std::string padding(widths[i] - width_of(cells[i]), ' ');
      line += i == 0 ? fmt::format("{}{}", cells[i], padding)
                     : fmt::format("  {}{}", padding, cells[i]);
    }
    text += line + "\n";
  }
  return text;
}

std::string accuracy_csv(const std::vector<AccuracyRow>& rows) {
  std::string text;
  for (const AccuracyRow& row : rows) {
    const Json fields = fields_of(row);
    Cells names, values;
    for (const auto& [name, value] : fields.items()) {
      names.push_back(name);
      if (value.is_string())
        values.push_back(fmt::format("\"{}\"", value.get<std::string>()));
      else
        values.push_back(value.is_null() ? "" : value.dump());
    }
    if (text.empty()) text += fmt::format("{}\n", fmt::join(names, ","));
    text += fmt::format("{}\n", fmt::join(values, ","));
  }
  return text;
}

std::string accuracy_json(const std::vector<AccuracyRow>& rows, const std::string& terrain) {
  Json list = Json::array();
  for (const AccuracyRow& row : rows) list.push_back(fields_of(row));
  const Json json{{"schema", 1},
                  {"program", {{"name", "orograph"}, {"version", kVersion}, {"commit", kCommit}}},
                  {"input", terrain},
                  {"rows", std::move(list)}};
  // Paths may be in any encoding; JSON is UTF-8.
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

} // namespace orograph
