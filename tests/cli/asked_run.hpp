// SPDX-License-Identifier: GPL-3.0-or-later
// A run of the command, as tests ask for it, and as the process that forks it is told.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace orograph {

struct RunConditions {
  std::string folder;                                ///< to run in; empty: the test's own
  std::optional<std::uint64_t> largest_file_bytes{}; ///< RLIMIT_FSIZE of the program
  std::string out_path{};                            ///< standard output goes there
};

/// The process is under these conditions from now on, and writes to `out` and `err`; false where it
/// can't. By system calls alone: safe after a fork.
bool take_on(const RunConditions& conditions, int out, int err);

struct AskedRun {
  std::vector<std::string> arguments;
  RunConditions conditions;
  int out = -1, err = -1;
};

/// Where fork_orograph finds its end of the socket, a SOCK_SEQPACKET; for each run that is asked
/// for it writes back an int, the status of `wait`.
constexpr int kRunsSocket = 3;

/// False where the other end is gone, or the whole is longer than a message may be (200 kB).
bool ask_for_run(int socket, const AskedRun& run);

/// Waits for it; nothing where the other end is closed. The descriptors are the caller's to close.
std::optional<AskedRun> asked_run(int socket);

} // namespace orograph
