// SPDX-License-Identifier: GPL-3.0-or-later
// The command, spared its start: to load and link GDAL's 140 shared libraries takes 50 ms, most of
// what the runs of a thousand tests took. Here it is done once, and each run that a test asks for
// is a fork of this process, in which nothing but that has been done. What cli/main.cpp does beside
// is to say how memory is kept, which decides no drawing.
#include "cli/command_line.hpp"
#include "tests/cli/asked_run.hpp"

#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>

using namespace orograph;

namespace {

[[noreturn]] void run(AskedRun asked) {
  ::close(kRunsSocket);
  if (!take_on(asked.conditions, asked.out, asked.err)) ::_exit(125);
  std::string program = OROGRAPH_PROGRAM;
  std::vector<char*> arguments{program.data()};
  for (auto& argument : asked.arguments) arguments.push_back(argument.data());
  const int count = static_cast<int>(arguments.size());
  arguments.push_back(nullptr);
  const int code = run_command_line(count, arguments.data());
  // What 140 libraries do at the end of a program is left out: a seventh of a short run.
  std::fflush(nullptr);
  ::_exit(code);
}

} // namespace

int main() {
  while (const auto asked = asked_run(kRunsSocket)) {
    const pid_t process = ::fork();
    if (process == 0) run(*asked);
    ::close(asked->out);
    ::close(asked->err);
    int status = 0;
    if (process < 0 || ::waitpid(process, &status, 0) != process) return 1;
    if (::write(kRunsSocket, &status, sizeof status) != sizeof status) return 1;
  }
}
