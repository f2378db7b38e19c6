// SPDX-License-Identifier: GPL-3.0-or-later
#include "write/pens_file.hpp"

#include "geometry/error.hpp"
#include "text/nesting.hpp"
#include "text/text_of_file.hpp"
#include "text/toml_table.hpp"
#include "text/words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>
#include <variant>

namespace orograph {
namespace {

constexpr auto kPensRight =
    "give each pen a table [[pen]] with lines such as number = 1 and width = 0.2";
constexpr int kGreatestNumber = 1000; // AxiDraw's

constexpr std::array<TomlKey, 1> kPensKeys{{{"pen", "tables", "[[pen]]"}}};
constexpr std::array<TomlKey, 11> kPenKeys{{
    {"number", "a whole number from 1 to 1000", "1"},
    {"name", "text", "\"black 0.2\""},
    {"colour", "red, green and blue in hexadecimal digits, or a name", "\"#1a1a1a\""},
    {"width", "mm, 0.01 to 10", "0.2"},
    {"speed", "mm/s, above 0", "40"},
    {"height", "percent, 0 to 100", "30"},
    {"pause", "true or false", "true"},
    {"layers", "a list of names", "[\"profiles\", \"shores\"]"},
    {"field", "the name of a field", "\"class\""},
    {"values", "a list of texts or numbers", "[\"river\", \"stream\"]"},
    {"dash", "the lengths of a dash and of a gap, mm, 0.01 to 1000", "[2, 1]"},
}};

Colour pen_colour(const TomlTable& table) {
  const std::string& text = table.text("colour");
  try {
    return colour_of(text);
  } catch (const UsageError& error) {
    throw Error(fmt::format("{}: {}", table.place(table.at("colour")), error.wrong()),
                error.right());
  }
}

double number_within(const TomlTable& table, std::string_view key, double low, double high) {
  const double number = table.number(key);
  if (!(number >= low && number <= high)) table.refuse(key, table.at(key));
  return number;
}

std::vector<std::string> layers_of(const TomlTable& table,
                                   std::span<const std::string_view> known) {
  std::vector<std::string> layers;
  for (const TomlValue& item : table.list("layers")) {
    const auto* name = std::get_if<std::string>(&item.value);
    if (name == nullptr) table.refuse("layers", item);
    if (std::ranges::find(known, *name) == known.end()) {
      const std::string_view nearest = nearest_word(*name, known);
      throw Error(fmt::format("{}: there is no layer '{}'", table.place(item), *name),
                  nearest.empty() ? fmt::format("there are {}", joined(known, ", "))
                                  : fmt::format("did you mean {}?", nearest));
    }
    layers.push_back(*name);
  }
  if (layers.empty()) table.refuse("layers", table.at("layers"));
  return layers;
}

std::vector<std::string> values_of(const TomlTable& table) {
  std::vector<std::string> values;
  for (const TomlValue& item : table.list("values")) {
    if (const auto* text = std::get_if<std::string>(&item.value))
      values.push_back(*text);
    else if (const auto* number = std::get_if<double>(&item.value))
      values.push_back(fmt::format("{}", *number));
    else
      table.refuse("values", item);
  }
  if (values.empty()) table.refuse("values", table.at("values"));
  return values;
}

Dash dash_of(const TomlTable& table) {
  constexpr double kLongest_mm = 1000;
  const std::vector<double> mm = table.numbers("dash", 2, 2);
  for (const double length_mm : mm)
    if (!(length_mm >= 0.01 && length_mm <= kLongest_mm)) table.refuse("dash", table.at("dash"));
  return {mm[0], mm[1]};
}

// `next`: its number, unless it is told.
PenOfLayers pen_of(const TomlTable& table, int next, std::span<const std::string_view> known) {
  PenOfLayers one;
  Pen& pen = one.pen;
  pen.number = table.has("number") || next > kGreatestNumber
                   ? static_cast<int>(table.whole("number"))
                   : next;
  if (pen.number < 1 || pen.number > kGreatestNumber) table.refuse("number", table.at("number"));
  pen.width_mm = number_within(table, "width", 0.01, 10);
  if (table.has("name")) pen.name = table.text("name");
  if (table.has("colour")) pen.colour = pen_colour(table);
  if (table.has("speed")) pen.speed_mm_s = number_within(table, "speed", 1e-3, 1e4);
  if (table.has("height")) pen.height_percent = number_within(table, "height", 0, 100);
  if (table.has("pause")) pen.waits = table.truth("pause");
  if (table.has("layers")) one.layers = layers_of(table, known);
  if (table.has("field") || table.has("values")) {
    one.field = table.text("field");
    if (one.field.empty()) table.refuse("field", table.at("field"));
    one.values = values_of(table);
  }
  if (table.has("dash")) one.dash = dash_of(table);
  return one;
}

} // namespace

std::vector<PenOfLayers> read_pens(const std::string& path,
                                   std::span<const std::string_view> layers, const Device* device) {
  const std::string text =
      text_of_file(path, {.most_bytes = 1'000'000, .noun = "pens", .right = kPensRight});
  check_toml_nesting(text, path, kPensRight);
  const TomlValue root{1, parse_toml(text, path, kPensRight)};
  const TomlTable table(path, root, "a file of pens", kPensKeys);
  if (!table.has("pen")) throw Error(path + " holds no pen", kPensRight);
  std::vector<PenOfLayers> pens;
  for (const TomlValue& value : table.list("pen")) {
    const TomlTable one(path, value, "a pen", kPenKeys);
    PenOfLayers pen = pen_of(one, pens.empty() ? 1 : pens.back().pen.number + 1, layers);
    pen.place = one.place(value);
    if (std::ranges::any_of(
            pens, [&](const PenOfLayers& other) { return other.pen.number == pen.pen.number; }))
      throw Error(fmt::format("{}: a second pen {}",
                              one.place(one.has("number") ? one.at("number") : value),
                              pen.pen.number),
                  "give each a number of its own");
    if (device != nullptr && device->pens && pen.pen.number > *device->pens)
      throw Error(fmt::format("{}: pen {} of the {}, which has {}",
                              one.place(one.has("number") ? one.at("number") : value),
                              pen.pen.number, device->name, *device->pens),
                  fmt::format("give numbers up to {}", *device->pens));
    if (device != nullptr && device->language == Device::Language::hpgl && pen.pen.waits &&
        device->wait.empty())
      throw Error(fmt::format("{}: the {} has no word to wait for a pen",
                              one.place(one.at("pause")), device->name),
                  "give a device with the key wait, or leave pause out");
    pens.push_back(std::move(pen));
  }
  if (pens.empty()) throw Error(path + " holds no pen", kPensRight);
  return pens;
}

} // namespace orograph
