// SPDX-License-Identifier: GPL-3.0-or-later
#include "placing/template_file.hpp"

#include "geometry/error.hpp"
#include "text/nesting.hpp"
#include "text/printable.hpp"
#include "text/text_of_file.hpp"
#include "text/toml_table.hpp"
#include "text/words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <span>
#include <variant>

namespace orograph {
namespace {

constexpr auto kRight = "lines such as furniture = \"map\" and source = \"Survey of 2024\"";

constexpr std::array<TomlKey, 11> kKeys{{
    {"furniture", "none, map, panorama, or a list of pieces", "[\"title\", \"scale\"]"},
    {"title", "text", "\"Matterhorn\""},
    {"subtitle", "text", "\"from the north\""},
    {"source", "text", "\"Survey of 2024\""},
    {"date", "text", "\"May 2024\""},
    {"font", "the name of a font", "\"DejaVu Sans\""},
    {"letters", "font or stroke", "\"stroke\""},
    {"title-size", "mm, 0.5 to 100", "6"},
    {"subtitle-size", "mm, 0.5 to 100", "3.6"},
    {"text-size", "mm, 0.5 to 100", "2.5"},
    {"gap", "mm, 0 to 100", "2.5"},
}};

constexpr Furniture kOfMap[] = {Furniture::title, Furniture::subtitle, Furniture::neatline,
                                Furniture::north, Furniture::scale,    Furniture::caption,
                                Furniture::source};
constexpr Furniture kOfPanorama[] = {Furniture::title,    Furniture::subtitle, Furniture::caption,
                                     Furniture::source,   Furniture::azimuths, Furniture::altitudes,
                                     Furniture::viewpoint};

std::optional<double> number_of(const TomlTable& table, std::string_view key, double low) {
  constexpr double kMost_mm = 100;
  if (!table.has(key)) return std::nullopt;
  const double mm = table.number(key);
  if (!(mm >= low && mm <= kMost_mm)) table.refuse(key, table.at(key));
  return mm;
}

std::optional<std::string> text_of(const TomlTable& table, std::string_view key) {
  if (!table.has(key)) return std::nullopt;
  return table.text(key);
}

std::vector<Furniture> pieces_of(const TomlTable& table) {
  const TomlValue& value = table.at("furniture");
  std::string names;
  if (const auto* text = std::get_if<std::string>(&value.value)) {
    names = *text;
  } else if (const auto* list = value.list()) {
    if (list->empty()) return {};
    for (const TomlValue& item : *list) {
      const auto* name = std::get_if<std::string>(&item.value);
      if (name == nullptr) table.refuse("furniture", item);
      names += (names.empty() ? "" : ",") + *name;
    }
  } else {
    table.refuse("furniture", value);
  }
  return furniture_of(names, table.place(value));
}

} // namespace

const std::vector<std::string>& furniture_names() {
  static const std::vector<std::string> names{"title",     "subtitle", "neatline", "north",
                                              "scale",     "caption",  "source",   "azimuths",
                                              "altitudes", "viewpoint"};
  return names;
}

std::vector<Furniture> furniture_of(std::string_view text, const std::string& place) {
  std::vector<Furniture> pieces;
  const auto add = [&](std::span<const Furniture> some) {
    for (const Furniture piece : some)
      if (std::ranges::find(pieces, piece) == pieces.end()) pieces.push_back(piece);
  };
  if (text == "none") return pieces;
  for (bool is_last = false; !is_last;) {
    const std::size_t comma = text.find(',');
    const std::string_view name = text.substr(0, comma);
    is_last = comma == std::string_view::npos;
    text.remove_prefix(is_last ? text.size() : comma + 1);
    const auto found = std::ranges::find(furniture_names(), name);
    if (name == "map") {
      add(kOfMap);
    } else if (name == "panorama") {
      add(kOfPanorama);
    } else if (found != furniture_names().end()) {
      const auto piece = static_cast<Furniture>(found - furniture_names().begin());
      add({&piece, 1});
    } else {
      std::vector<std::string_view> known(furniture_names().begin(), furniture_names().end());
      known.insert(known.end(), {"map", "panorama"});
      const std::string_view nearest = nearest_word(name, known);
      throw UsageError(fmt::format("{}: there is no furniture '{}'", place, printable(name)),
                       nearest.empty() ? fmt::format("none, or some of map, panorama, {}",
                                                     joined(furniture_names(), ", "))
                                       : fmt::format("did you mean {}?", nearest));
    }
  }
  return pieces;
}

Template read_template(const std::string& path) {
  const std::string text =
      text_of_file(path, {.most_bytes = 1'000'000, .noun = "a template", .right = kRight});
  check_toml_nesting(text, path, kRight);
  const TomlValue root{1, parse_toml(text, path, kRight)};
  const TomlTable table(path, root, "a template", kKeys);
  Template out;
  if (table.has("furniture")) out.pieces = pieces_of(table);
  out.title = text_of(table, "title");
  out.subtitle = text_of(table, "subtitle");
  out.source = text_of(table, "source");
  out.date = text_of(table, "date");
  out.font = text_of(table, "font");
  if (out.font && out.font->empty()) table.refuse("font", table.at("font"));
  if (table.has("letters")) {
    const std::string& kind = table.text("letters");
    if (kind != "font" && kind != "stroke") table.refuse("letters", table.at("letters"));
    out.letters = kind == "font" ? LetterKind::font : LetterKind::stroke;
  }
  out.title_mm = number_of(table, "title-size", 0.5);
  out.subtitle_mm = number_of(table, "subtitle-size", 0.5);
  out.text_mm = number_of(table, "text-size", 0.5);
  out.gap_mm = number_of(table, "gap", 0);
  return out;
}

} // namespace orograph
