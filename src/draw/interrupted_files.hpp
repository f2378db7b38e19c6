// SPDX-License-Identifier: GPL-3.0-or-later
// The temporary files that a signal handler has to remove.
#pragma once

#include <csignal>
#include <string>

namespace orograph {

/// Keeps SIGINT and SIGTERM waiting in this thread as long as it lives.
class SignalPause {
public:
  SignalPause();
  ~SignalPause();
  SignalPause(const SignalPause&) = delete;
  SignalPause& operator=(const SignalPause&) = delete;

private:
  sigset_t before_;
};

/// Notes a file, by a path of less than 4096 bytes; up to 64 files at a time, from any thread.
/// Returns false where there is no room.
bool note_for_removal(const std::string& path);
/// Forgets it again.
void forget_removal(const std::string& path);

/// Removes the file and what SQLite leaves beside it. Safe in signal handlers. The path may be
/// gone already.
void remove_with_companions(const char* path);

} // namespace orograph
