// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/options/help.hpp"
#include "geometry/error.hpp"
#include "text/words.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace orograph {
namespace {

using Words = std::vector<std::string>;

bool takes_files(const Option& option) {
  return option.is_positional() || option.value.find("FILE") != std::string::npos;
}

// The sentence's beginning, as far as a line has room for it.
std::string in_brief(std::string_view help) {
  constexpr std::size_t kMost = 66;
  std::string text(help.substr(0, help.find_first_of(";:")));
  if (text.size() <= kMost) return text;
  text.resize(text.rfind(' ', kMost));
  while (text.ends_with(',')) text.pop_back();
  return text;
}

std::string in_single_quotes(std::string_view text, std::string_view of_a_quote) {
  std::string quoted = "'";
  for (const char c : text) {
    if (c == '\'')
      quoted += of_a_quote;
    else
      quoted += c;
  }
  return quoted + "'";
}

Words names_of(const std::vector<Command>& commands) {
  Words names;
  for (const Command& command : commands) names.push_back(command.name);
  return names;
}

// --- bash

// What stands behind an option, as the variables of the function.
std::string bash_case(const Option& option) {
  std::string set;
  if (const Words words = option.words_to_choose(); !words.empty())
    set +=
        fmt::format(" {}='{}'", option.is_list_of_words() ? "list" : "words", joined(words, " "));
  if (takes_files(option))
    set += option.extensions.empty() ? " files='*'"
                                     : fmt::format(" files='{}'", joined(option.extensions, " "));
  const std::string letter = option.letter == 0 ? "" : fmt::format("|-{}", option.letter);
  return fmt::format("        {}{}) value=1{} ;;\n", option.name, letter, set);
}

std::string bash_completion(const std::vector<Command>& commands) {
  std::string text = R"(# bash completion for orograph, made from its tables of options.
_orograph() {
  local cur=${COMP_WORDS[COMP_CWORD]} prev=${COMP_WORDS[COMP_CWORD-1]}
  local command=${COMP_WORDS[1]} options= words= list= files= value= done= extension
  COMPREPLY=()
  # Readline parts --option=value in three.
  if [[ $cur == '=' ]]; then
    cur=
  elif [[ $prev == '=' && COMP_CWORD -gt 2 ]]; then
    prev=${COMP_WORDS[COMP_CWORD-2]}
  fi
  if [[ COMP_CWORD -eq 1 ]]; then
)";
  text += fmt::format("    COMPREPLY=($(compgen -W '{} --help --version' -- \"$cur\"))\n",
                      joined(names_of(commands), " "));
  text += "    return\n  fi\n  case $command in\n";
  for (const Command& command : commands) {
    Words options;
    text += fmt::format("    {})\n      case $prev in\n", command.name);
    for (const Option& option : command.options) {
      if (option.is_positional()) continue;
      options.push_back(option.name);
      if (!option.is_switch()) text += bash_case(option);
    }
    text += fmt::format("      esac\n      options='{}'\n      ;;\n", joined(options, " "));
  }
  return text + R"(  esac
  if [[ -z $value && $cur == -* ]]; then
    COMPREPLY=($(compgen -W "$options" -- "$cur"))
    return
  fi
  if [[ -n $list ]]; then
    [[ $cur != *,* ]] || done=${cur%,*},
    for value in $list; do
      [[ ,$done == *,$value,* || $value != "${cur##*,}"* ]] || COMPREPLY+=("$done$value")
    done
    compopt -o nospace 2>/dev/null
    return
  fi
  COMPREPLY=($(compgen -W "$words" -- "$cur"))
  [[ -n $value ]] || files='*'
  [[ -n $files ]] || return
  compopt -o filenames 2>/dev/null
  local IFS=$'\n'
  if [[ $files == '*' ]]; then
    COMPREPLY+=($(compgen -f -- "$cur"))
    return
  fi
  COMPREPLY+=($(compgen -d -- "$cur"))
  IFS=$' \n'
  for extension in $files; do
    IFS=$'\n'
    COMPREPLY+=($(compgen -f -X "!*.$extension" -- "$cur"))
  done
}
complete -F _orograph orograph
)";
}

// --- zsh

std::string zsh_described(std::string_view help) {
  std::string text;
  for (const char c : in_brief(help)) {
    if (c == '[' || c == ']' || c == ':' || c == '\\') text += '\\';
    text += c;
  }
  return text;
}

std::string zsh_files(const Option& option) {
  if (option.extensions.empty()) return "_files";
  return fmt::format("_files -g \"*.({})\"", joined(option.extensions, "|"));
}

// ":message:action", what stands behind an option.
std::string zsh_value(const Option& option) {
  std::string message = option.value;
  std::replace(message.begin(), message.end(), ':', ' ');
  const Words words = option.words_to_choose();
  if (option.is_list_of_words())
    return fmt::format(":{}:_values -s , layer {}", message, joined(words, " "));
  if (words.empty())
    return fmt::format(":{}:{}", message, takes_files(option) ? zsh_files(option) : " ");
  if (!takes_files(option)) return fmt::format(":{}:({})", message, joined(words, " "));
  return fmt::format(R"(:{}:_alternative 'words\:name\:({})' 'files\:file\:{}')", message,
                     joined(words, " "), zsh_files(option));
}

std::string zsh_completion(const std::vector<Command>& commands) {
  const auto quoted = [](const std::string& text) { return in_single_quotes(text, "'\\''"); };
  std::string text = R"(#compdef orograph
# zsh completion for orograph, made from its tables of options.
_orograph() {
  local context state state_descr line
  local -A opt_args
  local -a commands
  commands=(
)";
  for (const Command& command : commands)
    text += fmt::format("    {}\n", quoted(command.name + ":" + zsh_described(command.summary)));
  text += R"(  )
  _arguments -C '--help[What there is]' '--version[Version and commit]' '1:command:->command' '*::argument:->argument'
  case $state in
    command) _describe command commands ;;
    argument)
      case $line[1] in
)";
  for (const Command& command : commands) {
    text += fmt::format("        {})\n          _arguments \\\n", command.name);
    for (const Option& option : command.options) {
      if (option.is_positional()) continue;
      std::string spec = option.repeatable ? "*" : "";
      spec += fmt::format("{}{}[{}]", option.name, option.is_switch() ? "" : "=",
                          zsh_described(option.help));
      if (!option.is_switch()) spec += zsh_value(option);
      text += fmt::format("            {} \\\n", quoted(spec));
    }
    text += "            '*:file:_files'\n          ;;\n";
  }
  return text + R"(      esac
      ;;
  esac
}
# As a function that the shell loads, or sourced.
if [[ $funcstack[1] == _orograph ]]; then
  _orograph "$@"
else
  compdef _orograph orograph
fi
)";
}

// --- fish

std::string fish_value(const Option& option) {
  if (option.is_switch()) return "";
  const Words words = option.words_to_choose();
  if (option.is_list_of_words())
    return fmt::format(" -x -a '(__fish_complete_list , \"string split \\' \\' \\'{}\\'\")'",
                       joined(words, " "));
  if (takes_files(option) && option.extensions.empty()) return " -r -F";
  Words offered = words;
  for (const std::string& extension : option.extensions)
    offered.push_back("(__fish_complete_suffix ." + extension + ")");
  return offered.empty() ? " -x" : fmt::format(" -x -a '{}'", joined(offered, " "));
}

std::string fish_completion(const std::vector<Command>& commands) {
  const auto quoted = [](const std::string& text) { return in_single_quotes(text, "\\'"); };
  std::string text = "# fish completion for orograph, made from its tables of options.\n";
  const std::string none =
      "'not __fish_seen_subcommand_from " + joined(names_of(commands), " ") + "'";
  for (const Command& command : commands)
    text += fmt::format("complete -c orograph -f -n {} -a {} -d {}\n", none, command.name,
                        quoted(in_brief(command.summary)));
  text += fmt::format("complete -c orograph -n {} -l help -d 'What there is'\n", none);
  text += fmt::format("complete -c orograph -n {} -l version -d 'Version and commit'\n", none);
  for (const Command& command : commands)
    for (const Option& option : command.options) {
      if (option.is_positional()) continue;
      text +=
          fmt::format("complete -c orograph -n '__fish_seen_subcommand_from {}' -l {}{} -d {}{}\n",
                      command.name, option.name.substr(2),
                      option.letter == 0 ? "" : fmt::format(" -s {}", option.letter),
                      quoted(in_brief(option.help)), fish_value(option));
    }
  return text;
}

} // namespace

std::string completion(const std::vector<Command>& commands, std::string_view shell) {
  if (shell == "bash") return bash_completion(commands);
  if (shell == "zsh") return zsh_completion(commands);
  if (shell == "fish") return fish_completion(commands);
  throw UsageError(shell.empty() ? std::string("--completion names no shell")
                                 : fmt::format("there is no completion for {}", shell),
                   "give --completion bash, zsh or fish");
}

} // namespace orograph
