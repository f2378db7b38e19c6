// SPDX-License-Identifier: GPL-3.0-or-later
// The program: commands, and exceptions to messages and exit codes.
#include "cli/accuracy/accuracy.hpp"
#include "cli/fragmentation/fragmentation.hpp"
#include "cli/info.hpp"
#include "cli/options/help.hpp"
#include "cli/options/options.hpp"
#include "cli/render.hpp"
#include "cli/tin.hpp"
#include "draw/output_file.hpp"
#include "geometry/error.hpp"

#include <algorithm>
#include <cstdio>
#include <exception>
#include <new>
#include <string>
#include <vector>

using namespace orograph;

namespace {

void print(const std::string& text) {
  std::fwrite(text.data(), 1, text.size(), stdout);
}

void run(std::vector<std::string> rest) {
  RenderSettings render_settings;
  AccuracySettings accuracy_settings;
  InfoSettings info_settings;
  TinSettings tin_settings;
  FragmentationSettings fragmentation_settings;
  const std::vector<Command> commands{render_command(render_settings),
                                      accuracy_command(accuracy_settings),
                                      info_command(info_settings), tin_command(tin_settings),
                                      fragmentation_command(fragmentation_settings)};
  const std::string command = rest.empty() ? "" : rest.front();
  if (!rest.empty()) rest.erase(rest.begin());
  if (command == "--help" || command == "-h") {
    print(program_help(commands));
  } else if (command == "--version") {
    print(version_line() + "\n");
  } else if (command == "--man") { // for the build, which installs it
    print(man_page(commands));
  } else if (command == "render") {
    if (const auto settings = parse_render(rest))
      render(*settings);
    else
      print(command_help(commands[0]));
  } else if (command == "accuracy") {
    if (const auto settings = parse_accuracy(rest))
      accuracy(*settings);
    else
      print(command_help(commands[1]));
  } else if (command == "info") {
    if (const auto settings = parse_info(rest))
      info(*settings);
    else
      print(command_help(commands[2]));
  } else if (command == "tin") {
    if (const auto settings = parse_tin(rest))
      tin(*settings);
    else
      print(command_help(commands[3]));
  } else if (command == "fragmentation") {
    if (const auto settings = parse_fragmentation(rest))
      fragmentation(*settings);
    else
      print(command_help(commands[4]));
  } else {
    throw UsageError(command.empty() ? "no command is given" : "unknown command " + command,
                     "use render, accuracy, info, tin or fragmentation, as in orograph render "
                     "INPUT OUTPUT; orograph "
                     "--help tells more");
  }
  if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0)
    throw Error("can't write to standard output", "make room on the device, or keep it open");
}

int fail(std::string message, int exit_code) {
  std::replace_if(
      message.begin(), message.end(), [](char c) { return c == '\n' || c == '\r'; }, ' ');
  std::fprintf(stderr, "orograph: error: %s\n", message.c_str());
  return exit_code;
}

} // namespace

int main(int argc, char** argv) {
  try {
    remove_output_files_on_signals();
    run({argv + std::min(argc, 1), argv + argc});
    return 0;
  } catch (const UsageError& error) {
    return fail(error.what(), 2);
  } catch (const Error& error) {
    return fail(error.what(), 1);
  } catch (const std::bad_alloc&) {
    return fail("not enough memory: use --overview, --bbox or fewer --profiles", 1);
  } catch (const std::exception& error) {
    return fail(std::string("internal: ") + error.what() + ": please report it", 1);
  }
}
