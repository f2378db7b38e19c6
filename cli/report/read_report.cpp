// SPDX-License-Identifier: GPL-3.0-or-later
// The run report read: the view and the settings that it holds.
#include "cli/options/settings_file.hpp"
#include "cli/report/run_report.hpp"
#include "geometry/error.hpp"
#include "placing/view_entries.hpp"
#include "text/nesting.hpp"
#include "text/printable.hpp"
#include "text/text_of_file.hpp"
#include "text/words.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <optional>

namespace orograph {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kMostBytes = 20'000'000; // it tells of every profile

std::optional<double> as_number(const Json& value) {
  if (!value.is_number()) return std::nullopt;
  return value.get<double>();
}

std::string kind_of(const Json& value) {
  return value.is_null()      ? "null"
         : value.is_boolean() ? "true or false"
         : value.is_array()   ? "a list of other things"
                              : "an object";
}

ViewEntry entry_of(const std::string& key, const Json& value) {
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
    entry.text = kind_of(value);
  }
  return entry;
}

// As the command line has it.
std::optional<std::string> text_of(const Json& value) {
  if (value.is_string()) return value.get<std::string>();
  if (value.is_number()) return value.dump();
  return std::nullopt;
}

Setting setting_of(const std::string& key, const Json& value) {
  Setting setting{.key = printable(key), .values = {}};
  if (const auto text = text_of(value)) {
    setting.kind = Setting::Kind::value;
    setting.values = {*text};
  } else if (value.is_boolean()) {
    setting.kind = Setting::Kind::yes_or_no;
    if (value.get<bool>()) setting.values = {""};
  } else if (value.is_array() && std::all_of(value.begin(), value.end(), [](const Json& v) {
               return text_of(v).has_value();
             })) {
    setting.kind = Setting::Kind::list;
    for (const Json& element : value) setting.values.push_back(*text_of(element));
  } else {
    setting.values = {kind_of(value)};
  }
  return setting;
}

Json parsed(const std::string& path, const std::string& text) {
  constexpr auto kRight = "give the report again with --report";
  check_json_nesting(text, path, kRight);
  try {
    return Json::parse(text);
  } catch (const Json::parse_error& error) {
    const auto end = text.begin() + static_cast<std::ptrdiff_t>(std::min(error.byte, text.size()));
    throw Error(
        fmt::format("{}, line {}: this isn't JSON", path, 1 + std::count(text.begin(), end, '\n')),
        kRight);
  } catch (const Json::out_of_range&) {
    throw Error(path + ": a number is too large", kRight);
  }
}

// Where a key isn't there, or its owner is no object, null.
Json member(const Json& owner, const char* key) {
  return owner.is_object() && owner.contains(key) ? owner[key] : Json();
}

std::vector<ViewEntry> report_entries(const std::string& path) {
  const Json view = member(member(parsed(path, view_text(path, kMostBytes)), "view"), "phigs");
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

std::vector<Setting> settings_of_report(const std::string& path) {
  constexpr auto kRight = "give a report that orograph render --report wrote, or settings in TOML";
  const std::string text =
      text_of_file(path, {.most_bytes = kMostBytes, .noun = "a report", .right = kRight});
  const Json options = member(parsed(path, text), "settings");
  if (!options.is_object())
    throw Error(path + " is no report of a run with settings to take over", kRight);
  std::vector<Setting> settings;
  for (const auto& [key, value] : options.items()) settings.push_back(setting_of(key, value));
  return settings;
}

} // namespace orograph
