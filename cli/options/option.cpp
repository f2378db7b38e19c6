// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/options/option.hpp"

#include "cli/free_memory.hpp"
#include "cli/options/option_values.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>

namespace orograph {
namespace {

constexpr auto kGeneral = "General";

bool is_word(std::string_view text) {
  return !text.empty() && text.find_first_not_of("abcdefghijklmnopqrstuvwxyz-") == text.npos;
}

} // namespace

std::vector<std::string> Option::words_to_choose() const {
  std::vector<std::string> all;
  for (std::string& part : split(value, '|'))
    if (is_word(part)) all.push_back(std::move(part));
  all.insert(all.end(), words.begin(), words.end());
  return all;
}

bool Option::is_choice() const {
  if (value == "FORMAT") return true; // any of `words`, in any case
  const std::vector<std::string> parts = split(value, '|');
  return std::all_of(parts.begin(), parts.end(), is_word);
}

bool insists_on(const GivenOptions& given, const std::string& option) {
  const auto found = given.find(option);
  return found != given.end() && found->second.place.empty();
}

std::string NumberRange::describe() const {
  std::string limits;
  if (std::isfinite(low) && std::isfinite(high) && !low_excluded && !high_excluded) {
    limits = fmt::format("{} to {}", low, high);
  } else {
    if (std::isfinite(low)) limits = fmt::format("{} {}", low_excluded ? "above" : "at least", low);
    if (std::isfinite(high))
      limits += fmt::format("{}{} {}", limits.empty() ? "" : " and ",
                            high_excluded ? "below" : "at most", high);
  }
  return unit + (unit.empty() || limits.empty() ? "" : ", ") + limits;
}

Option with_number(Option option, const NumberRange& range, std::function<void(double)> store) {
  option.allowed = range.describe();
  option.range = range;
  option.take = [range, store = std::move(store)](const std::string& text) {
    const auto number = parse_number(text);
    if (!number || !range.holds(*number)) return false;
    store(*number);
    return true;
  };
  return option;
}

Option with_integer(Option option, int low, int high, std::function<void(int)> store) {
  option.allowed = high == std::numeric_limits<int>::max()
                       ? fmt::format("a whole number, at least {}", low)
                       : fmt::format("a whole number, {} to {}", low, high);
  option.range = NumberRange{.low = static_cast<double>(low)};
  if (high != std::numeric_limits<int>::max()) option.range->high = high;
  option.is_whole = true;
  option.take = [low, high, store = std::move(store)](const std::string& text) {
    const auto number = parse_integer(text);
    if (!number || *number < low || *number > high) return false;
    store(*number);
    return true;
  };
  return option;
}

std::function<bool(const std::string&)> stored_name(std::string& into) {
  return [&into](const std::string& text) {
    into = text;
    return !text.empty();
  };
}

Option help_option() {
  return {.group = kGeneral,
          .name = "--help",
          .letter = 'h',
          .help = "Show this and do nothing else",
          .take = [](const std::string&) { return true; }};
}

Option full_help_option() {
  return {.group = kGeneral,
          .name = "--help-all",
          .help = "Show all options",
          .take = [](const std::string&) { return true; }};
}

Option quiet_option(bool& quiet) {
  return {.group = kGeneral,
          .name = "--quiet",
          .letter = 'q',
          .help = "Only errors on stderr",
          .take = set_to(quiet, true)};
}

Option jobs_option(int& jobs) {
  return with_integer({.group = kGeneral,
                       .name = "--jobs",
                       .letter = 'j',
                       .value = "N",
                       .help = "Cores to use, which changes nothing but the time",
                       .by_default = "all"},
                      1, 1024, [&jobs](int n) { jobs = n; });
}

Option memory_option(std::optional<std::uint64_t>& bytes) {
  if (const auto free = free_memory()) bytes = *free / 2;
  return {.group = kGeneral,
          .name = "--max-memory",
          .value = "SIZE",
          .help = "Refuse a raster that would take more memory than this",
          .allowed = "a number with kB, MB or GB, such as 4GB",
          .by_default = "half of what is free",
          .take = stored(parse_bytes, bytes)};
}

void add_general_options(std::vector<Option>& options, std::string& settings_file, bool& quiet,
                         std::optional<bool>& progress) {
  options.push_back({.group = kGeneral,
                     .name = "--settings",
                     .value = "FILE",
                     .help = "Take what else is to be set from a file with lines such as fov = 40 "
                             "or light = \"off\": any options, by their names; what stands on the "
                             "command line goes before it",
                     .allowed = "settings in TOML, or the report of a run (.json)",
                     .extensions = {"toml", "json"},
                     .take = stored_name(settings_file)});
  add_message_options(options, quiet, progress);
}

void add_message_options(std::vector<Option>& options, bool& quiet, std::optional<bool>& progress) {
  options.push_back(quiet_option(quiet));
  options.push_back({.group = kGeneral,
                     .name = "--progress",
                     .help = "Show the progress on stderr, the default on a terminal",
                     .take = set_to(progress, true)});
  options.push_back({.group = kGeneral,
                     .name = "--no-progress",
                     .help = "Don't show it",
                     .take = set_to(progress, false)});
  options.push_back(help_option());
}

} // namespace orograph
