// SPDX-License-Identifier: GPL-3.0-or-later
// Runs a command and measures the process as a whole.
//
//   timed_run SECONDS COMMAND [ARGUMENT…]
//
// Prints `WALL_S PROCESSOR_S PEAK_KIB` on stdout, or `timeout`, after which the command and all
// that it started have been killed. The command's own stdout goes to stderr. Exit code 1 where it
// fails.
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>

namespace {

constexpr rlim_t kMost_bytes = rlim_t{8} << 30U; // of address space: others work here too

volatile std::sig_atomic_t timed_out = 0;
pid_t child = 0;

extern "C" void kill_child(int) {
  timed_out = 1;
  kill(-child, SIGKILL);
}

double seconds(const timeval& time) {
  return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

} // namespace

int main(int count, char** arguments) {
  const int limit_s = count > 2 ? std::atoi(arguments[1]) : 0;
  if (limit_s < 1) {
    std::fputs("usage: timed_run SECONDS COMMAND [ARGUMENT…]\n", stderr);
    return 2;
  }
  using Clock = std::chrono::steady_clock;
  const auto begin = Clock::now();
  child = fork();
  if (child == 0) {
    setpgid(0, 0); // so that what it starts can be killed with it
    const rlimit most{kMost_bytes, kMost_bytes};
    setrlimit(RLIMIT_AS, &most);
    dup2(STDERR_FILENO, STDOUT_FILENO);
    execvp(arguments[2], arguments + 2);
    std::perror(arguments[2]);
    _exit(127);
  }
  if (child < 0) {
    std::perror("timed_run: error: fork");
    return 1;
  }
  setpgid(child, child);
  std::signal(SIGALRM, kill_child);
  alarm(static_cast<unsigned>(limit_s));
  int status = 0;
  rusage used{};
  while (wait4(child, &status, 0, &used) < 0 && errno == EINTR) {
  }
  const std::chrono::duration<double> wall = Clock::now() - begin;
  alarm(0);
  if (timed_out) {
    std::printf(">%d s\n", limit_s);
    return 0;
  }
  const bool well = WIFEXITED(status) && WEXITSTATUS(status) == 0;
  if (!well && used.ru_maxrss > static_cast<long>(kMost_bytes / 1024 / 10 * 8)) {
    std::puts(">8 GiB");
    return 0;
  }
  std::printf("%.4f %.4f %ld\n", wall.count(), seconds(used.ru_utime) + seconds(used.ru_stime),
              used.ru_maxrss);
  return well ? 0 : 1;
}
