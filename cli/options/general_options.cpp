// SPDX-License-Identifier: GPL-3.0-or-later
// What every command takes, or every one that draws: cores, memory, settings, messages, help.
#include "cli/options/option_group.hpp"
#include "cli/options/option_groups.hpp"
#include "geometry/free_memory.hpp"
#include "text/quantities.hpp"

#include <cstdint>
#include <optional>
#include <string>

namespace orograph {
namespace {

OptionGroup general(std::vector<Option>& options) {
  return OptionGroup(options, "General");
}

bool is_asked_for(const std::string&) {
  return true;
}

} // namespace

void add_jobs(std::vector<Option>& options, int& jobs) {
  general(options).whole("-j, --jobs N", "Cores to use, which changes nothing but the time", 1,
                         1024, jobs, "all");
}

void add_memory(std::vector<Option>& options, std::optional<std::uint64_t>& bytes) {
  if (const auto free = free_memory_bytes()) bytes = *free / 2;
  general(options).parsed(
      "--max-memory SIZE", "Refuse a raster that would take more memory than this",
      "a number with kB, MB or GB, such as 4GB", "half of what is free", parse_bytes, bytes);
}

void add_index_use(std::vector<Option>& options, bool& use_index) {
  general(options).choice("--index",
                          "Take larger cells from the file that orograph index made, where there "
                          "is one for these heights",
                          {{"auto", true}, {"off", false}}, use_index);
}

void add_general_options(std::vector<Option>& options, std::string& settings_file, bool& quiet,
                         std::optional<bool>& progress) {
  general(options)
      .name("--settings FILE",
            "Take what else is to be set from a file with lines such as fov = 40 or light = "
            "\"off\": any options, by their names; what stands on the command line goes before it",
            "settings in TOML, or the report of a run (.json)", "", settings_file)
      .files({"toml", "json"});
  add_message_options(options, quiet, progress);
}

void add_message_options(std::vector<Option>& options, bool& quiet, std::optional<bool>& progress) {
  add_quiet(options, quiet);
  general(options)
      .flag("--progress", "Show the progress on stderr, the default on a terminal", progress, true)
      .flag("--no-progress", "Don't show it", progress, false);
  add_help(options);
}

void add_quiet(std::vector<Option>& options, bool& quiet) {
  general(options).flag("-q, --quiet", "Only errors on stderr", quiet);
}

void add_help(std::vector<Option>& options) {
  general(options).value("-h, --help", "Show this and do nothing else", "", "", is_asked_for);
}

void add_full_help(std::vector<Option>& options) {
  general(options).value("--help-all", "Show all options", "", "", is_asked_for);
}

} // namespace orograph
