// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/report/view_of_report.hpp"

#include "geometry/error.hpp"
#include "text/text_of_file.hpp"
#include "text/words.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>

#include "placing/view_entries.hpp"

namespace orograph {
namespace {

constexpr std::size_t kMostBytesOfReport = 20'000'000; // it tells of every profile

std::optional<double> as_number(const nlohmann::json& value) {
  if (!value.is_number()) return std::nullopt;
  return value.get<double>();
}

ViewEntry entry_of(const std::string& key, const nlohmann::json& value) {
  ViewEntry entry;
  entry.key = printable(key);
  if (value.is_string()) {
    entry.kind = ViewEntry::Kind::text;
    entry.text = printable(value.get<std::string>());
  } else if (const auto number = as_number(value)) {
    entry.kind = ViewEntry::Kind::number;
    entry.numbers = {*number};
  } else if (value.is_array()) {
    take_numbers(entry, value.size(), [&](std::size_t i) { return as_number(value[i]); });
  } else {
    entry.text = value.is_null() ? "null" : value.is_boolean() ? "true or false" : "an object";
  }
  return entry;
}

// Where a key isn't there, or its owner is no object, null.
nlohmann::json member(const nlohmann::json& owner, const char* key) {
  return owner.is_object() && owner.contains(key) ? owner[key] : nlohmann::json();
}

std::vector<ViewEntry> report_entries(const std::string& path) {
  const std::string text = view_text(path, kMostBytesOfReport);
  nlohmann::json report;
  try {
    report = nlohmann::json::parse(text);
  } catch (const nlohmann::json::parse_error& error) {
    const auto end = text.begin() + static_cast<std::ptrdiff_t>(std::min(error.byte, text.size()));
    throw Error(
        fmt::format("{}, line {}: this isn't JSON", path, 1 + std::count(text.begin(), end, '\n')),
        "give the report again with --report");
  } catch (const nlohmann::json::out_of_range&) {
    throw Error(path + ": a number is too large", "give the report again with --report");
  }
  const nlohmann::json view = member(member(report, "view"), "phigs");
  if (!view.is_object())
    throw Error(path + " is no report of a run with a view to take over (view.phigs)",
                "give a report that orograph render --report wrote, or a view in TOML");
  std::vector<ViewEntry> entries;
  for (const auto& [key, value] : view.items()) {
    if (value.is_null() && (key == "front" || key == "back")) continue;
    entries.push_back(entry_of(key, value));
  }
  return entries;
}

} // namespace

ViewFile read_view(const std::string& path) {
  return extension_of(path) == ".json" ? view_of_entries(report_entries(path), path)
                                       : read_view_file(path);
}

} // namespace orograph
