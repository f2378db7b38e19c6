// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/options/settings_file.hpp"

#include "cli/options/options.hpp"
#include "cli/options/suggest_option.hpp"
#include "cli/report/run_report.hpp"
#include "geometry/error.hpp"
#include "text/nesting.hpp"
#include "text/printable.hpp"
#include "text/text_of_file.hpp"
#include "text/words.hpp"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <algorithm>
#include <filesystem>
#include <optional>

namespace orograph {
namespace {

namespace fs = std::filesystem;
using Kind = Setting::Kind;

constexpr auto kRight = "give settings with lines such as fov = 40 or light = \"off\"";

std::optional<std::string> value_of(const toml::node& node) {
  if (const auto* text = node.as_string()) return text->get();
  if (const auto* integer = node.as_integer()) return fmt::format("{}", integer->get());
  if (const auto* number = node.as_floating_point()) return fmt::format("{}", number->get());
  return std::nullopt;
}

Setting setting_of(std::string_view key, const toml::node& node) {
  Setting setting{.key = printable(key), .line = node.source().begin.line, .values = {}};
  if (const auto value = value_of(node)) {
    setting.kind = Kind::value;
    setting.values = {*value};
  } else if (const auto* is_on = node.as_boolean()) {
    setting.kind = Kind::yes_or_no;
    if (is_on->get()) setting.values = {""};
  } else if (const auto* list = node.as_array()) {
    setting.kind = Kind::list;
    for (const toml::node& element : *list) {
      const auto text = value_of(element);
      if (!text) return {setting.key, setting.line, Kind::other, {"a list of other things"}};
      setting.values.push_back(*text);
    }
  } else {
    setting.values = {node.is_table() ? "a table" : "a time"};
  }
  return setting;
}

std::vector<Setting> settings_of_toml(const std::string& path) {
  const std::string text =
      text_of_file(path, {.most_bytes = 1'000'000, .noun = "settings", .right = kRight});
  check_toml_nesting(text, path, kRight);
  std::vector<Setting> settings;
  try {
    for (const auto& [key, node] : toml::parse(text)) settings.push_back(setting_of(key, node));
  } catch (const toml::parse_error& error) {
    throw Error(fmt::format("{}, line {}: this isn't TOML ({})", path, error.source().begin.line,
                            printable(error.description())),
                kRight);
  }
  // What stands first in the file is spoken of first.
  std::stable_sort(settings.begin(), settings.end(),
                   [](const Setting& a, const Setting& b) { return a.line < b.line; });
  return settings;
}

bool has_option(const Command& command, const std::string& name) {
  return std::any_of(command.options.begin(), command.options.end(),
                     [&](const Option& option) { return option.name == name; });
}

// Of the commands that take settings.
bool is_known(const std::string& name) {
  RenderSettings render;
  SweepSettings sweep;
  AccuracySettings accuracy;
  FragmentationSettings fragmentation;
  return has_option(render_command(render), name) || has_option(sweep_command(sweep), name) ||
         has_option(accuracy_command(accuracy), name) ||
         has_option(fragmentation_command(fragmentation), name);
}

const Option* option_of(const Command& command, const std::string& key, const std::string& place) {
  for (const Option& option : command.options) {
    const bool is_itself = option.name == "--settings" || option.name.starts_with("--help");
    if ((option.is_positional() && in_lower_case(option.name) == in_lower_case(key)) ||
        (is_itself && option.name == "--" + key))
      throw Error(fmt::format("{}: '{}' is no setting", place, key), "give it on the command line");
    if (!option.is_positional() && option.name == "--" + key) return &option;
  }
  if (is_known("--" + key)) return nullptr;
  const std::string meant = suggestion(command, key);
  throw Error(fmt::format("{}: unknown key '{}'", place, key),
              meant.empty() ? fmt::format("orograph {} {} lists what there is", command.name,
                                          command.full_help())
                            : meant);
}

// The values as `take` reads them; none where the file says that the option isn't given.
std::vector<std::string> checked_values(const Option& option, Setting setting,
                                        const std::string& place) {
  const std::string what = setting.kind == Kind::other       ? setting.values.front()
                           : setting.kind == Kind::list      ? "a list"
                           : setting.kind == Kind::yes_or_no ? "true or false"
                                                             : "a value";
  if (option.is_switch()) {
    if (setting.kind != Kind::yes_or_no)
      throw Error(fmt::format("{}: '{}' is {}", place, setting.key, what), "give true or false");
  } else if (setting.kind != Kind::value && !(setting.kind == Kind::list && option.repeatable)) {
    throw Error(fmt::format("{}: '{}' is {}", place, setting.key, what),
                fmt::format("give {}, {}", option.repeatable ? "texts" : "a text or a number",
                            option.value));
  }
  return setting.values;
}

// GDAL's names with colons aren't files.
std::string path_from(const fs::path& folder, const std::string& path) {
  if (folder.empty() || path.empty() || path.find(':') != std::string::npos) return path;
  return (folder / path).string(); // which is `path` where that is absolute
}

// Below `folder` from there; elsewhere from the root, since links may be on the way up.
std::string path_in(const std::string& folder, const std::string& path) {
  if (path.find(':') != std::string::npos) return path;
  std::error_code error;
  const fs::path whole = fs::absolute(path, error).lexically_normal();
  const fs::path from =
      (fs::absolute(folder.empty() ? "." : folder, error) / "").lexically_normal();
  const fs::path relative = whole.lexically_relative(from);
  return (relative.empty() || *relative.begin() == ".." ? whole : relative).string();
}

bool are_in_conflict(const Command& command, const std::string& a, const std::string& b) {
  return std::any_of(command.conflicts.begin(), command.conflicts.end(), [&](const Conflict& c) {
    return (c.one == a && c.other == b) || (c.one == b && c.other == a);
  });
}

bool is_in_conflict(const Command& command, const std::string& name, const GivenOptions& given) {
  return std::any_of(given.begin(), given.end(), [&](const auto& other) {
    return are_in_conflict(command, name, other.first);
  });
}

} // namespace

void add_settings(const Command& command, const std::string& path, GivenOptions& given) {
  const bool of_report = extension_of(path) == ".json";
  GivenOptions of_file;
  for (const Setting& setting : of_report ? settings_of_report(path) : settings_of_toml(path)) {
    const std::string place =
        setting.line > 0 ? fmt::format("{}, line {}", path, setting.line) : path;
    const Option* option = option_of(command, setting.key, place);
    if (option == nullptr) continue;
    std::vector<std::string> values = checked_values(*option, setting, place);
    for (std::string& value : values)
      if (option->is_path(value)) value = path_from(fs::path(path).parent_path(), value);
    if (values.empty() || given.contains(option->name) ||
        is_in_conflict(command, option->name, given))
      continue;
    of_file[option->name] = {std::move(values), place};
  }
  given.merge(of_file);
}

NamedValues options_in_force(const Command& command, const GivenOptions& given,
                             const std::string& folder) {
  NamedValues in_force;
  for (const Option& option : command.options) {
    // How the work is done, and what is told of it, decides nothing of what is drawn.
    const bool decides = !option.is_positional() && option.group != "General" &&
                         option.name != "--overwrite" && option.name != "--report" &&
                         option.name != "--horizon-table" && option.name != "--horizon-step" &&
                         option.name != "--check";
    if (!decides) continue;
    const auto found = given.find(option.name);
    std::vector<std::string> values;
    if (found != given.end())
      values = found->second.values;
    else if (!option.by_default.empty() && option.by_default.find(' ') == std::string::npos &&
             !is_in_conflict(command, option.name, given) && option.take(option.by_default))
      values = {option.by_default};
    for (std::string& value : values)
      if (option.is_path(value)) value = path_in(folder, value);
    if (values.empty()) continue;
    if (option.is_switch()) values.clear();
    in_force.emplace_back(option.name.substr(2), std::move(values));
  }
  return in_force;
}

} // namespace orograph
