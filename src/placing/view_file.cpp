// SPDX-License-Identifier: GPL-3.0-or-later
// View files are TOML.
#include "placing/view_file.hpp"

#include "geometry/error.hpp"
#include "placing/view_entries.hpp"
#include "text/nesting.hpp"
#include "text/printable.hpp"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <algorithm>
#include <charconv>
#include <initializer_list>
#include <map>
#include <string_view>

namespace orograph {
namespace {

using Kind = ViewEntry::Kind;

// A view takes less than a kilobyte; a list may hold thousands.
constexpr std::size_t kMostBytesOfView = 1'000'000, kMostBytesOfList = 20'000'000;

// Text is no number, and neither is true or false.
std::optional<double> as_number(const toml::node& node) {
  if (const auto* integer = node.as_integer()) return static_cast<double>(integer->get());
  if (const auto* number = node.as_floating_point()) return number->get();
  return std::nullopt;
}

ViewEntry entry_of(std::string_view key, const toml::node& node) {
  ViewEntry entry;
  entry.key = printable(key);
  entry.line = node.source().begin.line;
  if (const auto* text = node.as_string()) {
    entry.kind = Kind::text;
    entry.text = printable(text->get());
  } else if (const auto number = as_number(node)) {
    entry.kind = Kind::number;
    entry.numbers = {*number};
  } else if (const auto* list = node.as_array()) {
    take_numbers(entry, list->size(), [&](std::size_t i) { return as_number((*list)[i]); });
  } else {
    entry.text = node.is_table() ? "a table" : node.is_boolean() ? "true or false" : "a time";
  }
  return entry;
}

toml::table parsed_toml(const std::string& path, std::size_t most_bytes) {
  constexpr auto kRight = "give a view with lines such as vrp = [500000, 100000, 1200]";
  const std::string text = view_text(path, most_bytes);
  check_toml_nesting(text, path, kRight);
  try {
    return toml::parse(text);
  } catch (const toml::parse_error& error) {
    throw Error(fmt::format("{}, line {}: this isn't TOML ({})", path, error.source().begin.line,
                            printable(error.description())),
                kRight);
  }
}

std::vector<ViewEntry> toml_entries(const toml::table& table) {
  std::vector<ViewEntry> entries;
  for (const auto& [key, value] : table) entries.push_back(entry_of(key, value));
  // What stands first in the file is spoken of first.
  std::stable_sort(entries.begin(), entries.end(),
                   [](const ViewEntry& a, const ViewEntry& b) { return a.line < b.line; });
  return entries;
}

// Takes the name out of a view's entries.
std::string take_name(std::vector<ViewEntry>& entries, const std::string& path) {
  const auto named = std::find_if(entries.begin(), entries.end(),
                                  [](const ViewEntry& entry) { return entry.key == "name"; });
  if (named == entries.end()) return {};
  const std::string name = named->text;
  if (named->kind != Kind::text || name.empty() || name.find('/') != std::string::npos)
    throw Error(fmt::format("{}, line {}: this can't be a view's name", path, named->line),
                "give text without a slash, as in name = \"north\"");
  entries.erase(named);
  return name;
}

// The shortest that reads back to the same number, and as a float: an integer -0 would lose its
// sign, and one of twenty digits would be too large.
std::string printed(double number) {
  char buffer[32];
  std::string text(buffer, std::to_chars(buffer, buffer + sizeof buffer, number).ptr);
  if (text.find_first_of(".e") == std::string::npos) text += ".0";
  return text;
}

std::string printed(std::initializer_list<double> numbers) {
  std::string text;
  for (const double number : numbers)
    text += fmt::format("{}{}", text.empty() ? "" : ", ", printed(number));
  return "[" + text + "]";
}

std::string printed(Vec3 p) {
  return printed({p.x, p.y, p.z});
}

} // namespace

ViewFile read_view_file(const std::string& path) {
  return view_of_entries(toml_entries(parsed_toml(path, kMostBytesOfView)), path);
}

std::vector<NamedView> read_view_list(const std::string& path) {
  constexpr auto kRight = "begin each view with a line [[view]], and give its keys below";
  const toml::table file = parsed_toml(path, kMostBytesOfList);
  std::map<std::size_t, std::string> strangers; // by line: the first is spoken of
  for (const auto& [key, value] : file)
    if (key != "view" || !value.is_array_of_tables())
      strangers.emplace(value.source().begin.line, printable(key.str()));
  if (!strangers.empty())
    throw Error(fmt::format("{}, line {}: '{}' is no list of views", path, strangers.begin()->first,
                            strangers.begin()->second),
                kRight);
  if (file.empty()) throw Error(path + " holds no view", kRight);
  std::vector<NamedView> views;
  for (const toml::node& node : *file["view"].as_array()) {
    std::vector<ViewEntry> entries = toml_entries(*node.as_table());
    const std::string name = take_name(entries, path);
    views.push_back({name, view_of_entries(entries, path)});
  }
  return views;
}

std::string view_file_text(const ViewFile& view) {
  const Box2& window = view.window_m;
  std::string text = fmt::format(
      "# A view of orograph. Points u, v, n are metres from vrp: to the right, up, to the viewer.\n"
      "projection = \"{}\"\n"
      "vrp = {} # view reference point: x, y and height of the terrain\n"
      "vpn = {} # view plane normal, to the viewer: east, north, up\n"
      "vup = {} # what is up in the picture: east, north, up\n"
      "prp = {} # {}: u, v, n\n"
      "window = {} # what is shown of the view plane: umin, vmin, umax, vmax\n",
      view.projection == PhigsProjection::perspective ? "perspective" : "parallel",
      printed(view.vrp_map), printed(view.vpn), printed(view.vup), printed(view.prp_m),
      view.projection == PhigsProjection::perspective ? "the eye"
                                                      : "from the window's centre to the viewer",
      printed({window.low.x, window.low.y, window.high.x, window.high.y}));
  if (view.exaggeration != 1)
    text += fmt::format("exaggeration = {} # of all heights\n", printed(view.exaggeration));
  if (view.front_m)
    text += fmt::format("front = {} # n; what is nearer is cut away\n", printed(*view.front_m));
  if (view.back_m)
    text += fmt::format("back = {} # n; what is farther is cut away\n", printed(*view.back_m));
  return text;
}

} // namespace orograph
