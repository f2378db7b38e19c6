// SPDX-License-Identifier: GPL-3.0-or-later
// A command line against the table of a command's options.
#include "cli/options/parse_arguments.hpp"

#include "cli/options/options.hpp"
#include "cli/options/settings_file.hpp"
#include "cli/options/suggest_option.hpp"
#include "geometry/error.hpp"
#include "text/words.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <map>
#include <string_view>

namespace orograph {
namespace {

std::string see_help(const Command& command) {
  return fmt::format("orograph {} {} lists what there is", command.name, command.full_help());
}

std::string how_to_give(const Option& option) {
  if (option.is_positional()) return "give " + option.help;
  return fmt::format("give {} {}{}{}", option.name, option.value,
                     option.allowed.empty() ? "" : ", ", option.allowed);
}

const Option* find_option(const Command& command, std::string_view argument) {
  for (const auto& option : command.options) {
    if (option.is_positional()) continue;
    const bool short_form = argument.size() == 2 && argument[0] == '-' && option.letter != 0 &&
                            argument[1] == option.letter;
    if (argument == option.name || short_form) return &option;
  }
  return nullptr;
}

/// "-120,5,3", "-.5", "-inf": what follows an option is its value, although it begins like one.
bool looks_negative(std::string_view argument) {
  if (argument.size() < 2 || argument[0] != '-') return false;
  const char next = argument[1];
  return std::isdigit(static_cast<unsigned char>(next)) != 0 || next == '.' ||
         argument.starts_with("-inf") || argument.starts_with("-nan");
}

/// Of an option that may stand alone: whether the next argument is its value all the same. A
/// number, with a unit of length or without, and not a file whose name begins with one.
bool may_follow(const Option& option, std::string_view argument) {
  for (const std::string_view unit : {"m", "ft"})
    if (argument.ends_with(unit) &&
        number_of<double>(argument.substr(0, argument.size() - unit.size())))
      return true;
  return argument == option.if_alone || argument == "nan" || number_of<double>(argument);
}

/// False only where none of the arguments can be this option. CLI11 compares each option that it is
/// told of with all others: for all of them that is some 2 ms, and under a sanitizer five sixths of
/// what reading a command line takes.
bool may_be_among(const Option& option, const std::vector<std::string>& arguments) {
  return std::ranges::any_of(arguments, [&](std::string_view argument) {
    const bool may_hold_letters = argument.starts_with('-') && !argument.starts_with("--");
    return argument.starts_with(option.name) || (may_hold_letters && option.letter != 0 &&
                                                 argument.find(option.letter) != argument.npos);
  });
}

/// The arguments with each value tied to its option, so that CLI11 takes negative numbers for
/// values and an empty value for one that is there.
std::vector<std::string> tie_values(const Command& command,
                                    const std::vector<std::string>& arguments) {
  std::vector<std::string> tied;
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    const std::string& argument = arguments[i];
    if (argument == "--") {
      tied.insert(tied.end(), arguments.begin() + static_cast<std::ptrdiff_t>(i), arguments.end());
      break;
    }
    if (const auto equals = argument.find('=');
        argument.starts_with("--") && equals + 1 == argument.size()) {
      tied.push_back(argument.substr(0, equals)); // CLI11 takes "--title=" for "--title"
      tied.emplace_back();
      continue;
    }
    const Option* option = find_option(command, argument);
    if (option == nullptr || option->is_switch()) {
      tied.push_back(argument);
      continue;
    }
    const bool last = i + 1 == arguments.size();
    if (!option->if_alone.empty() && (last || !may_follow(*option, arguments[i + 1]))) {
      tied.push_back(option->name + "=" + option->if_alone);
      continue;
    }
    if (last || (arguments[i + 1].starts_with('-') && arguments[i + 1].size() > 1 &&
                 !looks_negative(arguments[i + 1])))
      throw UsageError(option->name + " has no value", how_to_give(*option));
    const std::string& value = arguments[++i];
    if (value.empty())
      tied.insert(tied.end(), {option->name, value});
    else
      tied.push_back(option->name + "=" + value);
  }
  return tied;
}

bool is_of_render(const std::string& name) {
  RenderSettings settings;
  return find_option(render_command(settings), name) != nullptr;
}

[[noreturn]] void refuse_unknown(const Command& command, const std::string& argument) {
  const std::string name = argument.substr(0, argument.find('='));
  const std::string meant = suggestion(command, name);
  throw UsageError(command.name == "sweep" && is_of_render(name)
                       ? fmt::format("{} is an option of orograph render that a sweep hasn't", name)
                       : fmt::format("unknown option {}", name),
                   meant.empty() ? see_help(command)
                                 : fmt::format("{}{} {}", meant, meant.ends_with('?') ? "" : ";",
                                               see_help(command)));
}

void refuse_leftovers(const Command& command, std::vector<std::string> leftovers) {
  // CLI11 counts the mark after which all are names among what it couldn't use.
  std::erase(leftovers, "--");
  if (leftovers.empty()) return;
  const auto unknown = std::find_if(leftovers.begin(), leftovers.end(), [](const auto& argument) {
    return argument.size() > 1 && argument[0] == '-';
  });
  refuse_unknown(command, unknown != leftovers.end() ? *unknown : leftovers.back());
}

// Which positional arguments go to which option: each takes one, and the repeatable one what the
// others leave. Too few are left to be spoken of as missing, in their order.
std::map<std::string, std::vector<std::string>> places_of(const Command& command,
                                                          std::vector<std::string> arguments) {
  std::vector<const Option*> wanted;
  for (const auto& option : command.options)
    if (option.is_positional()) wanted.push_back(&option);
  std::map<std::string, std::vector<std::string>> places;
  std::size_t next = 0;
  for (const Option* option : wanted) {
    if (next == arguments.size()) break;
    std::size_t count = 1;
    if (option->repeatable && arguments.size() > wanted.size())
      count += arguments.size() - wanted.size();
    for (; count > 0; --count) places[option->name].push_back(std::move(arguments[next++]));
  }
  if (next == arguments.size()) return places;
  std::string names;
  for (const Option* option : wanted) names += " " + option->name;
  throw UsageError(fmt::format("one argument too many, '{}'", arguments.back()),
                   fmt::format("orograph {} takes{} and options (quote names with spaces)",
                               command.name, names));
}

void take_values(const Option& option, const std::vector<std::string>& values) {
  if (option.is_switch()) {
    if (!values.front().empty())
      throw UsageError(option.name + " takes no value", "give " + option.name + " alone");
    option.take("");
    return;
  }
  if (values.size() > 1 && !option.repeatable)
    throw UsageError(fmt::format("{} is given {} times", option.name, values.size()),
                     "give it once");
  for (const auto& value : values)
    if (!option.take(value))
      throw UsageError(fmt::format("{} '{}' can't be used", option.name, value),
                       how_to_give(option));
}

void take_given(const Option& option, const GivenOption& given) {
  if (given.place.empty()) return take_values(option, given.values);
  try {
    take_values(option, given.values);
  } catch (const UsageError& error) {
    throw Error(fmt::format("{}: {}", given.place, error.wrong()), error.right());
  }
}

void refuse_conflicts(const Command& command, const GivenOptions& given) {
  for (const auto& [one, other, right] : command.conflicts) {
    const auto first = given.find(one), second = given.find(other);
    if (first == given.end() || second == given.end()) continue;
    const std::string wrong = fmt::format("{} and {} exclude each other", one, other);
    // Of what is in conflict with the command line nothing was taken from a settings file.
    const std::string place = std::max(first->second.place, second->second.place);
    if (place.empty()) throw UsageError(wrong, right);
    throw Error(fmt::format("{}: {}", place, wrong), right);
  }
}

// Hands each value that is given to its option's `take`, in the table's order, and adds those of a
// settings file.
void take_all(const Command& command, GivenOptions& given) {
  for (const auto& option : command.options) {
    if (!option.is_positional()) continue;
    const auto found = given.find(option.name);
    if (found == given.end())
      throw UsageError("no " + option.name + " is given", how_to_give(option));
    take_values(option, found->second.values);
  }
  if (const auto settings = given.find("--settings"); settings != given.end()) {
    take_values(*find_option(command, "--settings"), settings->second.values);
    add_settings(command, settings->second.values.front(), given);
  }
  for (const auto& option : command.options)
    if (!option.is_positional() && given.contains(option.name))
      take_given(option, given.at(option.name));
  refuse_conflicts(command, given);
}

} // namespace

GivenOptions parse_arguments(const Command& command, const std::vector<std::string>& arguments) {
  auto tied = tie_values(command, arguments);
  CLI::App app;
  app.set_help_flag();
  app.allow_extras();
  std::vector<std::pair<const Option*, CLI::Option*>> table;
  for (const auto& option : command.options) {
    if (option.is_positional() || !may_be_among(option, tied)) continue;
    const std::string names =
        option.letter != 0 ? fmt::format("-{},{}", option.letter, option.name) : option.name;
    CLI::Option* parsed = nullptr;
    if (option.is_switch())
      parsed = app.add_flag(names);
    else
      parsed = app.add_option(names, [](const CLI::results_t&) { return true; });
    if (!option.is_switch()) parsed->expected(1);
    parsed->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
    table.emplace_back(&option, parsed);
  }
  CLI::Option* positional = app.add_option("FILES", [](const CLI::results_t&) { return true; });
  positional->allow_extra_args(); // any number of them
  positional->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);

  std::reverse(tied.begin(), tied.end()); // as CLI11 wants its vectors
  try {
    app.parse(tied);
  } catch (const CLI::ParseError& error) {
    throw UsageError(error.what(), see_help(command));
  }

  GivenOptions given;
  for (const auto& [option, parsed] : table) {
    if (parsed->count() == 0) continue;
    std::vector<std::string> values = parsed->results();
    if (option->is_switch()) // any number of times
      values = {std::all_of(values.begin(), values.end(), [](const auto& v) { return v == "true"; })
                    ? ""
                    : values.front()};
    given[option->name] = {std::move(values)};
  }
  if (asks_for_help(given)) return given;

  refuse_leftovers(command, app.remaining());
  for (auto& [name, values] : places_of(command, positional->results()))
    given[name] = {std::move(values)};
  take_all(command, given);
  return given;
}

GivenOptions take_named(const Command& command, const NamedValues& named) {
  GivenOptions given;
  for (const auto& [name, values] : named) {
    const bool is_positional = std::ranges::any_of(command.options, [&](const Option& option) {
      return option.is_positional() && option.name == name;
    });
    const std::string option = is_positional ? name : "--" + name;
    if (!is_positional && find_option(command, option) == nullptr) refuse_unknown(command, option);
    given[option] = {values.empty() ? std::vector<std::string>{""} : values};
  }
  take_all(command, given);
  return given;
}

} // namespace orograph
