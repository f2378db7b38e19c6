// SPDX-License-Identifier: GPL-3.0-or-later
// Running the built program as a user does.
#pragma once

#include "tests/cli/asked_run.hpp"

#include <sys/types.h>

#include <optional>
#include <string>
#include <vector>

namespace orograph {

struct ProgramRun {
  int exit_code = -1; ///< 128 + signal where a signal ended it
  std::string out, err;
};

/// A program that runs while the test goes on; ended and waited for by the destructor.
class RunningProgram {
public:
  /// `command[0]` is a path or a name on PATH.
  RunningProgram(const std::vector<std::string>& command, const RunConditions& conditions);
  ~RunningProgram();
  RunningProgram(const RunningProgram&) = delete;
  RunningProgram& operator=(const RunningProgram&) = delete;

  bool has_ended();
  void send(int signal_number) const;
  ProgramRun wait();

private:
  pid_t process_ = -1;
  int out_ = -1, err_ = -1;
  std::optional<int> status_;
};

/// orograph with these arguments, to its end: from a process that has its libraries loaded and has
/// done nothing else (fork_orograph.cpp).
ProgramRun run_orograph(const std::vector<std::string>& arguments, const RunConditions& conditions);
ProgramRun run_in(const std::string& folder, const std::vector<std::string>& arguments);

/// Whether a part of the text is this.
bool holds(const std::string& text, const std::string& part);

/// What is wrong with how an error was told, or nothing: one line "orograph: error: wrong: right"
/// that comes last, with no lines but orograph's own before it.
std::string fault_of_message(const std::string& err);

} // namespace orograph
