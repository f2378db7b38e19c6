// SPDX-License-Identifier: GPL-3.0-or-later
// Ctrl-C, termination, and what would end the program in the midst of writing.
#include "cli/signals.hpp"

#include "write/output_file.hpp"

#include <signal.h>
#include <unistd.h>

namespace orograph {
namespace {

extern "C" void remove_all_and_exit(int signal_number) {
  remove_temporary_files();
  _exit(128 + signal_number);
}

} // namespace

void remove_output_files_on_signals() {
  struct sigaction action {};
  action.sa_handler = remove_all_and_exit;
  sigemptyset(&action.sa_mask);
  for (const int interrupting : {SIGINT, SIGTERM}) sigaddset(&action.sa_mask, interrupting);
  for (const int interrupting : {SIGINT, SIGTERM}) sigaction(interrupting, &action, nullptr);
  for (const int of_writing : {SIGXFSZ, SIGPIPE}) signal(of_writing, SIG_IGN);
}

} // namespace orograph
