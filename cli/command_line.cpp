// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/command_line.hpp"

#include "cli/accuracy/accuracy.hpp"
#include "cli/fragmentation/fragmentation.hpp"
#include "cli/index.hpp"
#include "cli/info.hpp"
#include "cli/options/help.hpp"
#include "cli/options/named_fields.hpp"
#include "cli/options/options.hpp"
#include "cli/render.hpp"
#include "cli/say.hpp"
#include "cli/sweep/ranks.hpp"
#include "cli/tin.hpp"
#include "cli/visible.hpp"
#include "geometry/error.hpp"
#include "geometry/on_all_cores.hpp"
#include "reference/exact_memory.hpp"
#include "write/output_file.hpp"

#include <fcntl.h>
#include <signal.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <exception>
#include <new>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "gdal/gdal.hpp"

namespace orograph {
namespace {

// A file that is opened takes the lowest free number; where that is one of these three, what is
// said would go into it. Nothing can be written to the standard output that wasn't there.
void keep_standard_streams() {
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
    if (::fcntl(stream, F_GETFD) == -1 && errno == EBADF &&
        ::open("/dev/null", stream == STDERR_FILENO ? O_WRONLY : O_RDONLY) < 0)
      return; // the numbers above are taken no sooner
}

int fail_without_memory() {
  say_without_memory("error: not enough memory: use --overview, --bbox or fewer --profiles");
  return 1;
}

extern "C" void remove_all_and_exit(int signal_number) {
  remove_temporary_files();
  _exit(128 + signal_number);
}

// GDAL and json-c call abort() where a call of theirs has no memory, or go on without what they
// asked for. What else ends so is a fault, and ends as it would without this, but that nothing
// half-written is left.
extern "C" void tell_of_memory_and_exit(int signal_number) {
  const bool for_want_of_memory = errno == ENOMEM;
  remove_temporary_files();
  if (for_want_of_memory) {
    fail_without_memory();
    _exit(1);
  }
  signal(signal_number, SIG_DFL);
  ::raise(signal_number);
}

// From now on SIGHUP, SIGINT and SIGTERM remove temporary files and exit with 129, 130 and 143,
// unless they are ignored, as by nohup; SIGXFSZ and SIGPIPE are ignored, so that a file-size limit
// or a closed pipe shows as a write error; and an end for want of memory is told.
void remove_output_files_on_signals() {
  constexpr std::array<int, 3> kInterrupting{SIGHUP, SIGINT, SIGTERM};
  struct sigaction action {};
  action.sa_handler = remove_all_and_exit;
  sigemptyset(&action.sa_mask);
  for (const int interrupting : kInterrupting) sigaddset(&action.sa_mask, interrupting);
  for (const int interrupting : kInterrupting) {
    struct sigaction before {};
    sigaction(interrupting, nullptr, &before);
    if (before.sa_handler != SIG_IGN) sigaction(interrupting, &action, nullptr);
  }
  for (const int of_writing : {SIGXFSZ, SIGPIPE}) signal(of_writing, SIG_IGN);
  action.sa_handler = tell_of_memory_and_exit;
  for (const int fault : {SIGABRT, SIGSEGV, SIGBUS}) {
    struct sigaction before {};
    sigaction(fault, nullptr, &before);
    if (before.sa_handler == SIG_DFL) sigaction(fault, &action, nullptr); // or a sanitizer has it
  }
}

void print(const std::string& text) {
  std::fwrite(text.data(), 1, text.size(), stdout);
}

// Cores to use, 0 for all. A sweep gives them to its views itself.
int cores_of(const SweepSettings&) {
  return 0;
}
int cores_of(const MergeSettings&) {
  return 0;
}
template <class Settings>
int cores_of(const Settings& settings) {
  if constexpr (requires { settings.render; })
    return settings.render.jobs;
  else
    return settings.jobs;
}

// What a command line asks for, or the command's help where it asks for that.
template <class Settings, class Parse, class Run>
void run_command(const Command& command, const std::vector<std::string>& rest, const Parse& parse,
                 const Run& run) {
  if (rest == std::vector<std::string>{"--json-usage"}) return print(usage_json(command));
  if (const std::optional<Settings> settings = parse(rest))
    on_cores(cores_of(*settings), {}, [&] { run(*settings); });
  else
    print(command_help(command, std::ranges::find(rest, "--help-all") != rest.end()
                                    ? HelpLength::all
                                    : HelpLength::daily));
}

void run(std::vector<std::string> rest) {
  RenderSettings render_settings;
  SweepSettings sweep_settings;
  MergeSettings merge_settings;
  AccuracySettings accuracy_settings;
  InfoSettings info_settings;
  IndexSettings index_settings;
  TinSettings tin_settings;
  FragmentationSettings fragmentation_settings;
  VisibleSettings visible_settings;
  const std::vector<Command> commands{render_command(render_settings),
                                      sweep_command(sweep_settings),
                                      merge_command(merge_settings),
                                      accuracy_command(accuracy_settings),
                                      info_command(info_settings),
                                      tin_command(tin_settings),
                                      fragmentation_command(fragmentation_settings),
                                      visible_command(visible_settings),
                                      index_command(index_settings)};
  const std::string name = rest.empty() ? "" : rest.front();
  if (!rest.empty()) rest.erase(rest.begin());
  if (name == "--help" || name == "-h") {
    print(program_help(commands));
  } else if (name == "--version") {
    print(version_line() + "\n");
  } else if (name == "--man") { // for the build, which installs it
    print(man_page(commands));
  } else if (name == "--completion") {
    print(completion(commands, rest.empty() ? "" : rest.front()));
  } else if (name == "render") {
    run_command<RenderSettings>(commands[0], rest, parse_render, render);
  } else if (name == "sweep") {
    run_command<SweepSettings>(commands[1], rest, parse_sweep, sweep);
  } else if (name == "merge") {
    run_command<MergeSettings>(commands[2], rest, parse_merge, merge);
  } else if (name == "accuracy") {
    run_command<AccuracySettings>(commands[3], rest, parse_accuracy, accuracy);
  } else if (name == "info") {
    run_command<InfoSettings>(commands[4], rest, parse_info, info);
  } else if (name == "tin") {
    run_command<TinSettings>(commands[5], rest, parse_tin, tin);
  } else if (name == "fragmentation") {
    run_command<FragmentationSettings>(commands[6], rest, parse_fragmentation, fragmentation);
  } else if (name == "visible") {
    run_command<VisibleSettings>(commands[7], rest, parse_visible, visible);
  } else if (name == "index") {
    run_command<IndexSettings>(commands[8], rest, parse_index, index);
  } else {
    throw UsageError(
        name.empty() ? "no command is given" : "unknown command " + name,
        "use render, visible, sweep, merge, accuracy, info, index, tin or fragmentation, as in "
        "orograph render INPUT OUTPUT; orograph --help tells more");
  }
  if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0)
    throw Error("can't write to standard output", "make room on the device, or keep it open");
}

int fail(const std::string& told, int exit_code) {
  try {
    say("error: {}", with_options(told));
  } catch (const std::bad_alloc&) {
    return fail_without_memory();
  }
  return exit_code;
}

} // namespace

int run_command_line(int argc, char** argv) {
  try {
    keep_standard_streams();
    keep_stderr_from_libraries();
    remove_output_files_on_signals();
    set_gdal_for_this_program();
    set_exact_numbers_for_this_program();
    run({argv + std::min(argc, 1), argv + argc});
    return 0;
  } catch (const StoppedElsewhere&) {
    return 1;
  } catch (const UsageError& error) {
    // All processes of a sweep are told the same; the first tells what is wrong with it. The others
    // end without an exit code of their own: mpirun kills the rest at the first that isn't 0, and
    // the first process may not have told it yet. What mpirun hands on is the first's.
    return launched_rank() == 0 ? fail(error.what(), 2) : 0;
  } catch (const Error& error) {
    return fail(error.what(), 1);
  } catch (const std::bad_alloc&) {
    return fail_without_memory();
  } catch (const std::exception& error) {
    // The words with which TBB tells that the system gives no thread.
    if (std::string_view(error.what()).starts_with("pthread_create has failed"))
      return fail("no thread can be started: give -j 1, or the process more memory or threads "
                  "(ulimit -v, ulimit -u)",
                  1);
    return fail(std::string("internal: ") + error.what() + ": please report it", 1);
  }
}

} // namespace orograph
