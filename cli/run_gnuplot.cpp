// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/run_gnuplot.hpp"

#include "geometry/error.hpp"
#include "write/output_file.hpp"

#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fstream>

namespace orograph {

std::string quoted_for_gnuplot(const std::string& text) {
  std::string out = "'";
  for (const char c : text)
    if (c == '\'')
      out += "''";
    else if (static_cast<unsigned char>(c) >= 0x20)
      out += c;
  return out + "'";
}

void run_gnuplot(const std::string& script, const std::string& path, const std::string& what) {
  // Beside what is drawn, and removed like it where we are interrupted.
  const OutputFile script_file(path + ".gnuplot", true);
  const std::string& script_path = script_file.temporary_path();
  std::ofstream file(script_path, std::ios::binary | std::ios::trunc);
  file << script;
  file.close();
  if (!file) throw Error("can't write '" + script_path + "'", "make room on the disk");

  std::string program = "gnuplot", argument = script_path;
  char* arguments[] = {program.data(), argument.data(), nullptr};
  pid_t process = 0;
  if (posix_spawnp(&process, program.c_str(), nullptr, nullptr, arguments, environ) != 0)
    throw Error(fmt::format("gnuplot, which draws {}, can't be started", what),
                "install it (Debian package gnuplot-nox); the table, CSV and JSON are written");
  int status = 0;
  if (waitpid(process, &status, 0) != process || !WIFEXITED(status) || WEXITSTATUS(status) != 0)
    throw Error(fmt::format("gnuplot failed to draw {}", what),
                "look at its message above; the table, CSV and JSON are written");
}

} // namespace orograph
