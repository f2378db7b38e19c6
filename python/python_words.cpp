// SPDX-License-Identifier: GPL-3.0-or-later
#include "python/python_words.hpp"

#include "cli/options/named_fields.hpp"
#include "cli/options/options.hpp"

#include <algorithm>
#include <array>
#include <set>
#include <string_view>
#include <utility>

namespace orograph {
namespace {

const std::set<std::string>& option_names() {
  static const std::set<std::string> names = [] {
    RenderSettings render;
    VisibleSettings visible;
    std::set<std::string> all;
    for (const Command& command : {render_command(render), visible_command(visible)})
      for (const Option& option : command.options)
        if (!option.is_positional()) all.insert(option.name);
    return all;
  }();
  return names;
}

bool is_of_name(char c) {
  return (c >= 'a' && c <= 'z') || c == '-';
}

// Whatever says how the command is called.
constexpr std::array<std::pair<std::string_view, std::string_view>, 6> kPhrases{{
    {"orograph render --help lists", "help(orograph.Terrain.render) lists"},
    {"orograph visible --help lists", "help(orograph.Terrain.visible) lists"},
    {"orograph horizon --help lists", "help(orograph.Terrain.horizon) lists"},
    {"orograph info --help lists", "help(orograph.read) lists"},
    {"INPUT", "input"},
    {"OUTPUT", "path"},
}};

} // namespace

std::string in_python(const std::string& message) {
  std::string text = with_options(message);
  for (const auto& [phrase, ours] : kPhrases)
    for (std::size_t at = text.find(phrase); at != std::string::npos;
         at = text.find(phrase, at + ours.size()))
      text.replace(at, phrase.size(), ours);
  for (std::size_t at = text.find("--"); at != std::string::npos; at = text.find("--", at + 1)) {
    const bool begins = at == 0 || text[at - 1] == ' ' || text[at - 1] == '(';
    const bool is_unknown = std::string_view(text).substr(0, at).ends_with("unknown option ");
    const auto begin = text.begin() + static_cast<std::ptrdiff_t>(at);
    std::string name(begin, std::find_if_not(begin, text.end(), is_of_name));
    if (!begins || !(is_unknown || option_names().contains(name))) continue;
    const std::size_t length = name.size();
    name.erase(0, 2);
    std::replace(name.begin(), name.end(), '-', '_');
    text.replace(at, length, name);
  }
  return text;
}

} // namespace orograph
