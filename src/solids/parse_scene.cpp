// SPDX-License-Identifier: GPL-3.0-or-later
// Scene files, through toml++; the only place of the scene that knows it.
#include "geometry/error.hpp"
#include "geometry/text_of_file.hpp"
#include "geometry/words.hpp"
#include "solids/scene_value.hpp"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <algorithm>
#include <utility>

namespace orograph {
namespace {

SceneValue value_of(const toml::node& node);

SceneValue::Table table_of(const toml::table& table) {
  struct Placed {
    toml::source_position at;
    SceneEntry entry;
  };
  std::vector<Placed> placed;
  for (const auto& [key, value] : table)
    placed.push_back({key.source().begin, {printable(key.str()), value_of(value)}});
  // The library sorts by name.
  std::stable_sort(placed.begin(), placed.end(),
                   [](const Placed& a, const Placed& b) { return a.at < b.at; });
  SceneValue::Table entries;
  for (Placed& one : placed) entries.push_back(std::move(one.entry));
  return entries;
}

SceneValue::List list_of(const toml::array& array) {
  SceneValue::List list;
  for (const toml::node& item : array) list.push_back(value_of(item));
  return list;
}

SceneValue value_of(const toml::node& node) {
  SceneValue value{node.source().begin.line, SceneValue::Time{}};
  if (const auto* text = node.as_string()) value.value = printable(text->get());
  if (const auto* integer = node.as_integer()) value.value = static_cast<double>(integer->get());
  if (const auto* number = node.as_floating_point()) value.value = number->get();
  if (const auto* truth = node.as_boolean()) value.value = truth->get();
  if (const auto* array = node.as_array()) value.value = list_of(*array);
  if (const auto* table = node.as_table()) value.value = table_of(*table);
  return value;
}

// Names with many dots are tables in tables, which the library goes down by recursion.
void check_dots(const std::string& text, const std::string& path) {
  std::size_t line = 1, dots = 0;
  for (const char c : text) {
    if (c == '\n') ++line;
    if (c == '\n' || c == ',' || c == '=') dots = 0;
    if (c == '.' && ++dots > 1000)
      throw Error(fmt::format("{}, line {}: there are over 1000 dots in a row", path, line),
                  "a scene's names have two, as in part.hut.shape");
  }
}

} // namespace

std::string words_for(const SceneValue& value) {
  struct Words {
    std::string operator()(const std::string&) const { return "text"; }
    std::string operator()(double number) const { return fmt::format("the number {}", number); }
    std::string operator()(bool) const { return "true or false"; }
    std::string operator()(SceneValue::Time) const { return "a time"; }
    std::string operator()(const SceneValue::List& list) const {
      return fmt::format("a list of {} value{}", list.size(), list.size() == 1 ? "" : "s");
    }
    std::string operator()(const SceneValue::Table&) const { return "a table"; }
  };
  return std::visit(Words{}, value.value);
}

SceneValue::Table parse_scene(const std::string& path) {
  const std::string text = text_of_file(
      path, {10'000'000, "a scene", "give a scene in TOML, with tables [part.NAME] and [[place]]"});
  check_dots(text, path);
  try {
    return table_of(toml::parse(text));
  } catch (const toml::parse_error& error) {
    throw Error(fmt::format("{}, line {}: this isn't TOML ({})", path, error.source().begin.line,
                            printable(error.description())),
                "give a scene with tables such as [part.hut] and [[place]]");
  }
}

} // namespace orograph
