// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/report/measurements.hpp"

#include "cli/say.hpp"
#include "cli/version.hpp"
#include "geometry/error.hpp"
#include "text/words.hpp"
#include "write/output_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <optional>

namespace orograph {
namespace {

using Json = nlohmann::ordered_json;

Json json_value(const Value& value) {
  return std::visit(
      [](const auto& x) {
        if constexpr (std::is_same_v<std::decay_t<decltype(x)>, std::monostate>)
          return Json();
        else
          return Json(x);
      },
      value);
}

} // namespace

std::string json_text(const Value& value) {
  return json_value(value).dump(-1, ' ', false, Json::error_handler_t::replace);
}

std::string csv_value(const Value& value) {
  if (std::holds_alternative<std::monostate>(value)) return "";
  const std::string* text = std::get_if<std::string>(&value);
  if (!text) return json_text(value);
  return csv_text(*text);
}

std::string milliseconds(double seconds, int decimals) {
  return fmt::format("{:.{}f}", 1e3 * seconds, decimals);
}

std::string csv_of(const std::vector<Record>& records) {
  std::string text;
  for (const Record& record : records) {
    std::vector<std::string> names, values;
    for (const auto& [name, value] : record) {
      names.push_back(name);
      values.push_back(csv_value(value));
    }
    if (text.empty()) text += fmt::format("{}\n", joined(names, ","));
    text += fmt::format("{}\n", joined(values, ","));
  }
  return text;
}

std::string json_of(const std::string& terrain, const std::vector<NamedRecords>& lists) {
  Json json{{"schema", 1},
            {"program", {{"name", "orograph"}, {"version", kVersion}, {"commit", kCommit}}},
            {"input", terrain}};
  for (const NamedRecords& list : lists) {
    Json& rows = json[list.name] = Json::array();
    for (const Record& record : list.records) {
      Json row = Json::object();
      for (const auto& [name, value] : record) row[name] = json_value(value);
      rows.push_back(std::move(row));
    }
  }
  // Paths may be in any encoding; JSON is UTF-8.
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string quoted_for_gnuplot(const std::string& text) {
  std::string out = "'";
  for (const char c : text)
    if (c == '\'')
      out += "''";
    else if (static_cast<unsigned char>(c) >= 0x20)
      out += c;
  return out + "'";
}

namespace {

// The exit code; nothing where it can't be started. `silent`: its standard output goes nowhere.
std::optional<int> exit_code_of_gnuplot(std::string argument, bool silent) {
  std::string program = "gnuplot";
  char* arguments[] = {program.data(), argument.data(), nullptr};
  posix_spawn_file_actions_t streams;
  posix_spawn_file_actions_init(&streams);
  posix_spawn_file_actions_adddup2(&streams, ::fileno(told_stream()), STDERR_FILENO);
  if (silent) posix_spawn_file_actions_addopen(&streams, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
  pid_t process = 0;
  const int failed = posix_spawnp(&process, program.c_str(), &streams, nullptr, arguments, environ);
  posix_spawn_file_actions_destroy(&streams);
  int status = 0;
  if (failed != 0) return std::nullopt;
  return waitpid(process, &status, 0) == process && WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

} // namespace

void check_gnuplot(const std::string& what) {
  if (exit_code_of_gnuplot("--version", true) != 0)
    throw Error(fmt::format("gnuplot, which draws {}, can't be started", what),
                "install it (Debian package gnuplot-nox), or leave --output out: the table on "
                "standard output needs none");
}

void run_gnuplot(const std::string& script, const std::string& path, const std::string& what) {
  // Beside what is drawn, and removed like it where we are interrupted.
  const OutputFile script_file(path + ".gnuplot", true);
  const std::string& script_path = script_file.temporary_path();
  std::ofstream file(script_path, std::ios::binary | std::ios::trunc);
  file << script;
  file.close();
  if (!file) throw Error("can't write '" + script_path + "'", "make room on the disk");

  if (exit_code_of_gnuplot(script_path, false) != 0)
    throw Error(fmt::format("gnuplot failed to draw {}", what),
                "look at its message above; the table, CSV and JSON are written");
}

} // namespace orograph
