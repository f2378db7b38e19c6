// SPDX-License-Identifier: GPL-3.0-or-later
// Scene files are parsed by toml++; this is the only place of the scene that knows it.
#include "solids/scene_table.hpp"

#include "geometry/error.hpp"
#include "text/nesting.hpp"
#include "text/text_of_file.hpp"
#include "text/words.hpp"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <algorithm>
#include <cmath>
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
  check_toml_nesting(text, path, "a scene's names have two, as in part.hut.shape");
  try {
    return table_of(toml::parse(text));
  } catch (const toml::parse_error& error) {
    throw Error(fmt::format("{}, line {}: this isn't TOML ({})", path, error.source().begin.line,
                            printable(error.description())),
                "give a scene with tables such as [part.hut] and [[place]]");
  }
}

namespace {

std::string how_to_give(const SceneKey& key) {
  return fmt::format("give {}, as in {} = {}", key.what, key.name, key.example);
}

std::string listed(const std::vector<std::string_view>& names) {
  std::string text;
  for (std::size_t i = 0; i < names.size(); ++i)
    text += fmt::format("{}{}", i == 0 ? "" : i + 1 == names.size() ? " and " : ", ", names[i]);
  return text;
}

} // namespace

SceneTable::SceneTable(const std::string& path, const SceneValue& value, std::string noun,
                       std::span<const SceneKey> keys)
    : path_(path), value_(value), noun_(std::move(noun)), keys_(keys) {
  if (value.table() == nullptr)
    throw Error(fmt::format("{}: {} is {}", place(value), noun_, words_for(value)),
                fmt::format("give a table, as in {{ {} = {} }}", keys[0].name, keys[0].example));
  std::vector<std::string_view> names;
  for (const SceneKey& key : keys) names.push_back(key.name);
  for (const SceneEntry& entry : *value.table()) {
    if (std::find(names.begin(), names.end(), entry.key) != names.end()) continue;
    std::string hint = fmt::format("{} has {}", noun_, listed(names));
    if (const auto nearest = nearest_word(entry.key, names); !nearest.empty())
      hint = fmt::format("did you mean {}? {}", nearest, hint);
    throw Error(fmt::format("{}: unknown key '{}'", place(entry.value), entry.key), hint);
  }
}

const SceneValue* SceneTable::find(std::string_view key) const {
  const SceneValue::Table& table = *value_.table();
  const auto found = std::find_if(table.begin(), table.end(),
                                  [&](const SceneEntry& entry) { return entry.key == key; });
  return found == table.end() ? nullptr : &found->value;
}

const SceneValue& SceneTable::at(std::string_view key) const {
  if (const SceneValue* value = find(key)) return *value;
  throw Error(fmt::format("{}: {} has no {}", place(value_), noun_, key), how_to_give(known(key)));
}

const std::string& SceneTable::text(std::string_view key) const {
  const SceneValue& value = at(key);
  const auto* text = std::get_if<std::string>(&value.value);
  if (text == nullptr) refuse(key, value);
  return *text;
}

double SceneTable::number(std::string_view key) const {
  return number_in(key, at(key));
}

bool SceneTable::truth(std::string_view key) const {
  const SceneValue& value = at(key);
  const bool* truth = std::get_if<bool>(&value.value);
  if (truth == nullptr) refuse(key, value);
  return *truth;
}

std::uint32_t SceneTable::whole(std::string_view key) const {
  return whole_in(key, at(key));
}

const SceneValue::List& SceneTable::list(std::string_view key) const {
  const SceneValue& value = at(key);
  if (value.list() == nullptr) refuse(key, value);
  return *value.list();
}

std::vector<double> SceneTable::numbers(std::string_view key, std::size_t least,
                                        std::size_t most) const {
  return numbers_in(key, at(key), least, most);
}

Vec3 SceneTable::point3(std::string_view key) const {
  const auto n = numbers(key, 3, 3);
  return {n[0], n[1], n[2]};
}

std::vector<Vec2> SceneTable::points2(std::string_view key) const {
  std::vector<Vec2> points;
  for (const SceneValue& item : list(key)) {
    const auto n = numbers_in(key, item, 2, 2);
    points.push_back({n[0], n[1]});
  }
  return points;
}

std::vector<Vec3> SceneTable::points3(std::string_view key) const {
  std::vector<Vec3> points;
  for (const SceneValue& item : list(key)) {
    const auto n = numbers_in(key, item, 3, 3);
    points.push_back({n[0], n[1], n[2]});
  }
  return points;
}

std::vector<std::vector<std::uint32_t>> SceneTable::indices(std::string_view key) const {
  std::vector<std::vector<std::uint32_t>> all;
  for (const SceneValue& item : list(key)) {
    if (item.list() == nullptr) refuse(key, item);
    auto& one = all.emplace_back();
    for (const SceneValue& index : *item.list()) one.push_back(whole_in(key, index));
  }
  return all;
}

void SceneTable::refuse(std::string_view key, const SceneValue& value) const {
  throw Error(fmt::format("{}: {}{} is {}", place(value), &value == find(key) ? "" : "a value in ",
                          key, words_for(value)),
              how_to_give(known(key)));
}

std::string SceneTable::place(const SceneValue& value) const {
  return fmt::format("{}, line {}", path_, value.line);
}

const SceneKey& SceneTable::known(std::string_view key) const {
  return *std::find_if(keys_.begin(), keys_.end(),
                       [&](const SceneKey& known) { return known.name == key; });
}

double SceneTable::number_in(std::string_view key, const SceneValue& value) const {
  const double* number = std::get_if<double>(&value.value);
  if (number == nullptr) refuse(key, value);
  if (!std::isfinite(*number))
    throw Error(fmt::format("{}: {} is not finite", place(value), key), how_to_give(known(key)));
  if (std::abs(*number) > 1e12)
    throw Error(fmt::format("{}: {} is beyond 1e12", place(value), key), how_to_give(known(key)));
  return *number;
}

std::uint32_t SceneTable::whole_in(std::string_view key, const SceneValue& value) const {
  const double number = number_in(key, value);
  if (!(number >= 0 && number <= 1e9 && number == std::floor(number))) refuse(key, value);
  return static_cast<std::uint32_t>(number);
}

std::vector<double> SceneTable::numbers_in(std::string_view key, const SceneValue& value,
                                           std::size_t least, std::size_t most) const {
  const SceneValue::List* list = value.list();
  if (list == nullptr || list->size() < least || list->size() > most) refuse(key, value);
  std::vector<double> numbers;
  for (const SceneValue& item : *list) numbers.push_back(number_in(key, item));
  return numbers;
}

} // namespace orograph
