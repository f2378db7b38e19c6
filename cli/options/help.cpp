// SPDX-License-Identifier: GPL-3.0-or-later
// The tables of options as text.
#include "cli/options/help.hpp"

#include "cli/version.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>
#include <string_view>

namespace orograph {
namespace {

constexpr std::size_t kLineLength = 80, kHelpColumn = 26;

/// Words in lines of `kLineLength`, the first line beginning at `column`, the others indented.
std::string wrapped(std::string_view text, std::size_t column, std::size_t indent) {
  std::string lines;
  std::istringstream words{std::string(text)};
  std::string word;
  bool first = true;
  while (words >> word) {
    if (!first && column + 1 + word.size() > kLineLength) {
      lines.append("\n").append(indent, ' ');
      column = indent;
      first = true;
    }
    lines.append(first ? "" : " ").append(word);
    column += word.size() + (first ? 0 : 1);
    first = false;
  }
  return lines + "\n";
}

/// "Horizontal field of view (degrees, above 0 and below 180; default 30)."
std::string explanation(const Option& option) {
  std::string details = option.allowed;
  if (!option.by_default.empty())
    details += (details.empty() ? "default " : "; default ") + option.by_default;
  return option.help + (details.empty() ? "" : " (" + details + ")") + ".";
}

/// The same without what isn't needed every day: no further sentences, and values only where they
/// are soon told.
std::string explanation_in_brief(const Option& option) {
  constexpr std::size_t kSoonTold = 80;
  const bool tells_values = option.is_list_of_words() || option.allowed.size() <= kSoonTold;
  std::string details = tells_values ? option.allowed : "";
  if (!option.by_default.empty() && option.by_default.size() <= kSoonTold / 2)
    details += (details.empty() ? "default " : "; default ") + option.by_default;
  const std::string help = option.help.substr(0, option.help.find(';'));
  return help + (details.empty() ? "" : " (" + details + ")") + ".";
}

std::string how_to_call(const Command& command) {
  std::string line = "orograph " + command.name + " [options]";
  for (const auto& option : command.options)
    if (option.is_positional()) line += " " + option.name + (option.repeatable ? "..." : "");
  return line;
}

void add_entry(std::string& text, const std::string& names, const std::string& help) {
  text += names;
  if (names.size() + 2 > kHelpColumn)
    text.append("\n").append(kHelpColumn, ' ');
  else
    text.append(kHelpColumn - names.size(), ' ');
  text += wrapped(help, kHelpColumn, kHelpColumn);
}

std::string names_of(const Option& option) {
  std::string names = option.letter != 0 ? fmt::format("-{}, ", option.letter) : "";
  return names + option.name + (option.value.empty() ? "" : " " + option.value);
}

/// Text of a man page: no line is taken for a macro, a hyphen is one that can be typed.
std::string troff(std::string_view text) {
  std::string escaped;
  for (const char c : text) {
    if (c == '\\')
      escaped += "\\e";
    else if (c == '-')
      escaped += "\\-";
    else
      escaped += c;
  }
  if (escaped.starts_with('.') || escaped.starts_with('\'')) escaped.insert(0, "\\&");
  return escaped;
}

void add_man_entry(std::string& page, const Option& option) {
  page += ".TP\n";
  if (option.letter != 0) page += fmt::format("\\fB\\-{}\\fR, ", option.letter);
  page += fmt::format("\\fB{}\\fR", troff(option.name));
  if (!option.value.empty()) page += fmt::format(" \\fI{}\\fR", troff(option.value));
  page += fmt::format("\n{}\n", troff(explanation(option)));
}

constexpr std::string_view kExitStatus =
    "0 on success, 2 for a wrong command line, 1 for any other error, 129, 130 and 143 when hung "
    "up, "
    "interrupted or terminated. Errors are one line on stderr, and leave no file half-written: "
    "what "
    "was there before stays, and so does a drawing that was done when its report failed.";

} // namespace

std::string version_line() {
  return fmt::format("orograph {} (commit {})", kVersion, kCommit);
}

std::string command_help(const Command& command, HelpLength length) {
  const auto is_shown = [&](const Option& option) {
    return length == HelpLength::all || command.daily.empty() ||
           is_among(command.daily, option.name);
  };
  std::size_t left_out = 0;
  std::string text = "Usage: " + how_to_call(command) + "\n\n";
  text += wrapped(command.summary + ".", 0, 0) + "\n";
  for (const auto& option : command.options)
    if (option.is_positional()) add_entry(text, "  " + option.name, explanation(option));
  std::string group;
  for (const auto& option : command.options) {
    if (option.is_positional()) continue;
    if (!is_shown(option)) {
      ++left_out;
      continue;
    }
    if (option.group != group) text += "\n" + option.group + ":\n";
    group = option.group;
    add_entry(text, (option.letter != 0 ? "  " : "      ") + names_of(option),
              length == HelpLength::all || command.daily.empty() ? explanation(option)
                                                                 : explanation_in_brief(option));
  }
  text += "\nExamples:\n";
  for (const auto& [call, meaning] : command.examples)
    text += fmt::format("  {}\n      {}", call, wrapped(meaning, 6, 6));
  if (left_out > 0)
    text += fmt::format("\nThere are {} more options: orograph {} {} shows all,\n"
                        "and all of their values.\n",
                        left_out, command.name, command.full_help());
  return text;
}

std::string program_help(const std::vector<Command>& commands) {
  std::string text = "Usage: orograph COMMAND [options] ...\n\n"
                     "Clean vector perspective maps of terrain.\n\nCommands:\n";
  for (const auto& command : commands) add_entry(text, "  " + command.name, command.summary + ".");
  text += "\n";
  add_entry(text, "  orograph COMMAND --help", "All options of a command.");
  add_entry(text, "  orograph COMMAND --json-usage", "The same for programs that call it.");
  add_entry(text, "  orograph --completion bash|zsh|fish",
            "A script by which the shell completes options and their values.");
  add_entry(text, "  orograph --version", "Version and commit.");
  return text + "\n" + wrapped("Exit status: " + std::string(kExitStatus), 0, 0);
}

std::string man_page(const std::vector<Command>& commands) {
  std::string page =
      fmt::format(".TH OROGRAPH 1 \"\" \"orograph {}\" \"User Commands\"\n", kVersion);
  page += ".SH NAME\norograph \\- clean vector perspective maps of terrain\n.SH SYNOPSIS\n";
  for (const auto& command : commands) page += ".B " + troff(how_to_call(command)) + "\n.br\n";
  page += ".B orograph \\-\\-help\n.br\n.B orograph \\-\\-version\n.br\n"
          ".B orograph COMMAND \\-\\-json-usage\n.br\n"
          ".B orograph \\-\\-completion bash|zsh|fish\n";
  for (const auto& command : commands) {
    page += fmt::format(".SH \"OROGRAPH {}\"\n{}\n", command.name, troff(command.summary + "."));
    std::string group;
    for (const auto& option : command.options) {
      if (option.group != group) page += fmt::format(".SS \"{}\"\n", troff(option.group));
      group = option.group;
      add_man_entry(page, option);
    }
    page += ".SS \"Examples\"\n";
    for (const auto& [call, meaning] : command.examples)
      page += fmt::format(".TP\n\\fB{}\\fR\n{}\n", troff(call), troff(meaning));
  }
  return page + ".SH \"EXIT STATUS\"\n" + troff(kExitStatus) + "\n";
}

} // namespace orograph
