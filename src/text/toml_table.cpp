// SPDX-License-Identifier: GPL-3.0-or-later
// Tables are parsed by toml++; nothing else here knows it.
#include "text/toml_table.hpp"

#include "geometry/error.hpp"
#include "text/printable.hpp"
#include "text/words.hpp"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace orograph {
namespace {

TomlValue value_of(const toml::node& node);

TomlValue::Table table_of(const toml::table& table) {
  struct Placed {
    toml::source_position at;
    TomlEntry entry;
  };
  std::vector<Placed> placed;
  for (const auto& [key, value] : table)
    placed.push_back({key.source().begin, {printable(key.str()), value_of(value)}});
  // The library sorts by name.
  std::stable_sort(placed.begin(), placed.end(),
                   [](const Placed& a, const Placed& b) { return a.at < b.at; });
  TomlValue::Table entries;
  for (Placed& one : placed) entries.push_back(std::move(one.entry));
  return entries;
}

TomlValue::List list_of(const toml::array& array) {
  TomlValue::List list;
  for (const toml::node& item : array) list.push_back(value_of(item));
  return list;
}

TomlValue value_of(const toml::node& node) {
  TomlValue value{node.source().begin.line, TomlValue::Time{}};
  if (const auto* text = node.as_string()) value.value = printable(text->get());
  if (const auto* integer = node.as_integer()) value.value = static_cast<double>(integer->get());
  if (const auto* number = node.as_floating_point()) value.value = number->get();
  if (const auto* truth = node.as_boolean()) value.value = truth->get();
  if (const auto* array = node.as_array()) value.value = list_of(*array);
  if (const auto* table = node.as_table()) value.value = table_of(*table);
  return value;
}

} // namespace

std::string words_for(const TomlValue& value) {
  struct Words {
    std::string operator()(const std::string&) const { return "text"; }
    std::string operator()(double number) const { return fmt::format("the number {}", number); }
    std::string operator()(bool) const { return "true or false"; }
    std::string operator()(TomlValue::Time) const { return "a time"; }
    std::string operator()(const TomlValue::List& list) const {
      return fmt::format("a list of {} value{}", list.size(), list.size() == 1 ? "" : "s");
    }
    std::string operator()(const TomlValue::Table&) const { return "a table"; }
  };
  return std::visit(Words{}, value.value);
}

TomlValue::Table parse_toml(const std::string& text, const std::string& path, const char* right) {
  try {
    return table_of(toml::parse(text));
  } catch (const toml::parse_error& error) {
    throw Error(fmt::format("{}, line {}: this isn't TOML ({})", path, error.source().begin.line,
                            printable(error.description())),
                right);
  }
}

namespace {

std::string how_to_give(const TomlKey& key) {
  if (key.example == fmt::format("[[{}]]", key.name)) // tables of its own
    return fmt::format("give {}, as in {}", key.what, key.example);
  return fmt::format("give {}, as in {} = {}", key.what, key.name, key.example);
}

std::string listed(const std::vector<std::string_view>& names) {
  std::string text;
  for (std::size_t i = 0; i < names.size(); ++i)
    text += fmt::format("{}{}", i == 0 ? "" : i + 1 == names.size() ? " and " : ", ", names[i]);
  return text;
}

} // namespace

TomlTable::TomlTable(const std::string& path, const TomlValue& value, std::string noun,
                     std::span<const TomlKey> keys)
    : path_(path), value_(value), noun_(std::move(noun)), keys_(keys) {
  if (value.table() == nullptr)
    throw Error(fmt::format("{}: {} is {}", place(value), noun_, words_for(value)),
                fmt::format("give a table, as in {{ {} = {} }}", keys[0].name, keys[0].example));
  std::vector<std::string_view> names;
  for (const TomlKey& key : keys) names.push_back(key.name);
  for (const TomlEntry& entry : *value.table()) {
    if (std::find(names.begin(), names.end(), entry.key) != names.end()) continue;
    std::string hint = fmt::format("{} has {}", noun_, listed(names));
    if (const auto nearest = nearest_word(entry.key, names); !nearest.empty())
      hint = fmt::format("did you mean {}? {}", nearest, hint);
    throw Error(fmt::format("{}: unknown key '{}'", place(entry.value), entry.key), hint);
  }
}

const TomlValue* TomlTable::find(std::string_view key) const {
  const TomlValue::Table& table = *value_.table();
  const auto found = std::find_if(table.begin(), table.end(),
                                  [&](const TomlEntry& entry) { return entry.key == key; });
  return found == table.end() ? nullptr : &found->value;
}

const TomlValue& TomlTable::at(std::string_view key) const {
  if (const TomlValue* value = find(key)) return *value;
  throw Error(fmt::format("{}: {} has no {}", place(value_), noun_, key), how_to_give(known(key)));
}

const std::string& TomlTable::text(std::string_view key) const {
  const TomlValue& value = at(key);
  const auto* text = std::get_if<std::string>(&value.value);
  if (text == nullptr) refuse(key, value);
  return *text;
}

double TomlTable::number(std::string_view key) const {
  return number_in(key, at(key));
}

bool TomlTable::truth(std::string_view key) const {
  const TomlValue& value = at(key);
  const bool* truth = std::get_if<bool>(&value.value);
  if (truth == nullptr) refuse(key, value);
  return *truth;
}

std::uint32_t TomlTable::whole(std::string_view key) const {
  return whole_in(key, at(key));
}

const TomlValue::List& TomlTable::list(std::string_view key) const {
  const TomlValue& value = at(key);
  if (value.list() == nullptr) refuse(key, value);
  return *value.list();
}

std::vector<double> TomlTable::numbers(std::string_view key, std::size_t least,
                                       std::size_t most) const {
  return numbers_in(key, at(key), least, most);
}

std::vector<std::vector<std::uint32_t>> TomlTable::indices(std::string_view key) const {
  std::vector<std::vector<std::uint32_t>> all;
  for (const TomlValue& item : list(key)) {
    if (item.list() == nullptr) refuse(key, item);
    auto& one = all.emplace_back();
    for (const TomlValue& index : *item.list()) one.push_back(whole_in(key, index));
  }
  return all;
}

void TomlTable::refuse(std::string_view key, const TomlValue& value) const {
  throw Error(fmt::format("{}: {}{} is {}", place(value), &value == find(key) ? "" : "a value in ",
                          key, words_for(value)),
              how_to_give(known(key)));
}

std::string TomlTable::place(const TomlValue& value) const {
  return fmt::format("{}, line {}", path_, value.line);
}

const TomlKey& TomlTable::known(std::string_view key) const {
  return *std::find_if(keys_.begin(), keys_.end(),
                       [&](const TomlKey& known) { return known.name == key; });
}

double TomlTable::number_in(std::string_view key, const TomlValue& value) const {
  const double* number = std::get_if<double>(&value.value);
  if (number == nullptr) refuse(key, value);
  if (!std::isfinite(*number))
    throw Error(fmt::format("{}: {} is not finite", place(value), key), how_to_give(known(key)));
  if (std::abs(*number) > 1e12)
    throw Error(fmt::format("{}: {} is beyond 1e12", place(value), key), how_to_give(known(key)));
  return *number;
}

std::uint32_t TomlTable::whole_in(std::string_view key, const TomlValue& value) const {
  const double number = number_in(key, value);
  if (!(number >= 0 && number <= 1e9 && number == std::floor(number))) refuse(key, value);
  return static_cast<std::uint32_t>(number);
}

std::vector<double> TomlTable::numbers_in(std::string_view key, const TomlValue& value,
                                          std::size_t least, std::size_t most) const {
  const TomlValue::List* list = value.list();
  if (list == nullptr || list->size() < least || list->size() > most) refuse(key, value);
  std::vector<double> numbers;
  for (const TomlValue& item : *list) numbers.push_back(number_in(key, item));
  return numbers;
}

} // namespace orograph
