// SPDX-License-Identifier: GPL-3.0-or-later
// Running the built program as a user does.
#include "tests/cli/run_program.hpp"

#include <signal.h>
#include <sys/mman.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <sstream>
#include <stdexcept>

namespace orograph {
namespace {

std::string content(int descriptor) {
  std::string text;
  std::array<char, 4096> block{};
  for (;;) {
    const ssize_t count =
        ::pread(descriptor, block.data(), block.size(), static_cast<off_t>(text.size()));
    if (count <= 0) return text;
    text.append(block.data(), static_cast<std::size_t>(count));
  }
}

/// In the child, where only system calls are safe and a failure shows as exit code 125.
[[noreturn]] void become(char* const* arguments, const RunConditions& conditions, int out,
                         int err) {
  if (take_on(conditions, out, err)) ::execvp(arguments[0], arguments);
  ::_exit(125);
}

ProgramRun ended(int status, int out, int err) {
  return {WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status), content(out),
          content(err)};
}

/// The process that forks the runs (fork_orograph.cpp); it ends with its end of the socket.
int forking_process() {
  std::array<int, 2> ends{};
  if (::socketpair(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0, ends.data()) != 0)
    throw std::runtime_error("can't make a socket");
  const pid_t process = ::fork();
  if (process == 0) {
    ::dup2(ends[1], kRunsSocket);
    ::execl(OROGRAPH_FORKING_PROGRAM, OROGRAPH_FORKING_PROGRAM, nullptr);
    ::_exit(125);
  }
  ::close(ends[1]);
  if (process < 0) throw std::runtime_error("can't start a program");
  return ends[0];
}

} // namespace

RunningProgram::RunningProgram(const std::vector<std::string>& command,
                               const RunConditions& conditions)
    : out_(::memfd_create("out", MFD_CLOEXEC)), err_(::memfd_create("err", MFD_CLOEXEC)) {
  std::vector<char*> arguments;
  for (const auto& argument : command) arguments.push_back(const_cast<char*>(argument.c_str()));
  arguments.push_back(nullptr);
  process_ = ::fork();
  if (process_ == 0) become(arguments.data(), conditions, out_, err_);
  if (process_ < 0 || out_ < 0 || err_ < 0) throw std::runtime_error("can't start a program");
}

RunningProgram::~RunningProgram() {
  if (!has_ended()) {
    send(SIGKILL);
    wait();
  }
  ::close(out_);
  ::close(err_);
}

bool RunningProgram::has_ended() {
  int status = 0;
  if (!status_ && ::waitpid(process_, &status, WNOHANG) == process_) status_ = status;
  return status_.has_value();
}

void RunningProgram::send(int signal_number) const {
  if (!status_) ::kill(process_, signal_number);
}

ProgramRun RunningProgram::wait() {
  int status = 0;
  if (!status_ && ::waitpid(process_, &status, 0) == process_) status_ = status;
  status = status_.value_or(0);
  return ended(status, out_, err_);
}

ProgramRun run_orograph(const std::vector<std::string>& arguments,
                        const RunConditions& conditions) {
  static const int socket = forking_process();
  const int out = ::memfd_create("out", MFD_CLOEXEC), err = ::memfd_create("err", MFD_CLOEXEC);
  int status = 0;
  if (!ask_for_run(socket, {arguments, conditions, out, err}) ||
      ::read(socket, &status, sizeof status) != sizeof status)
    throw std::runtime_error("can't start orograph");
  const ProgramRun run = ended(status, out, err);
  ::close(out);
  ::close(err);
  return run;
}

ProgramRun run_in(const std::string& folder, const std::vector<std::string>& arguments) {
  return run_orograph(arguments, {.folder = folder});
}

bool holds(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

std::string fault_of_message(const std::string& err) {
  if (err.empty() || err.back() != '\n') return "no whole line on stderr";
  std::istringstream lines(err);
  std::string line, last;
  while (std::getline(lines, line)) {
    if (last.starts_with("orograph: error: ")) return "more follows the error's line";
    if (!line.starts_with("orograph: ")) return "a line that isn't orograph's own: " + line;
    last = line;
  }
  const std::string begin = "orograph: error: ";
  if (!last.starts_with(begin)) return "the last line is no error: " + last;
  if (last.find(": ", begin.size()) == std::string::npos) return "nothing says what is right";
  return "";
}

} // namespace orograph
