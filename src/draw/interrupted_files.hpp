// SPDX-License-Identifier: GPL-3.0-or-later
// The temporary files that a signal handler has to remove.
#pragma once

#include <csignal>
#include <cstddef>
#include <optional>
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

/// Notes a file, by a path of less than 4096 bytes; up to 256 files at a time, from any thread.
/// Returns its number, or nothing where there is no room.
std::optional<std::size_t> note_for_removal(const std::string& path);
/// Forgets it again, by its number.
void forget_removal(std::size_t number);

/// Removes the file and what SQLite leaves beside it. Safe in signal handlers. The path may be
/// gone already.
void remove_with_companions(const char* path);

} // namespace orograph
