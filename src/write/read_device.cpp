// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/error.hpp"
#include "text/nesting.hpp"
#include "text/printable.hpp"
#include "text/text_of_file.hpp"
#include "text/toml_table.hpp"
#include "text/words.hpp"
#include "write/device.hpp"
#include "write/device_words.hpp"
#include "write/known_devices.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace orograph {
namespace {

constexpr auto kRight = "give a device with lines such as language = \"hpgl\" and unit = 0.025";

constexpr std::array<TomlKey, 20> kKeys{{
    {"language", "hpgl or gcode", "\"hpgl\""},
    {"name", "text", "\"HP 7475A\""},
    {"unit", "mm, above 0", "0.025"},
    {"decimals", "a whole number up to 4", "3"},
    {"y", "up or down", "\"up\""},
    {"pens", "a whole number above 0", "6"},
    {"longest", "bytes, 40 or more", "250"},
    {"window", "the least x and y and the greatest, in units", "[0, 0, 11040, 7721]"},
    {"paper", "tables", "[[paper]]"},
    {"start", "text, or a list of texts", "\"IN;DF;\""},
    {"wait", "text, or a list of texts", "\"NR;\""},
    {"end", "text, or a list of texts", "\"SP0;IN;\""},
    {"relative", "true or false", "true"},
    {"speeds", "the least and the greatest in cm/s", "[1, 38]"},
    {"feed", "mm/min, above 0", "3000"},
    {"heights", "what lowers the pen least high and most", "[30, 80]"},
    {"height", "percent, 0 to 100", "30"},
    {"pen_up", "text, or a list of texts", "[\"M5\", \"G4 P0.15\"]"},
    {"pen_down", "text, or a list of texts", "[\"M3 S{height}\", \"G4 P0.15\"]"},
    {"moves", "two texts, with the pen up and down", "[\"G0 X{x} Y{y}\", \"G1 X{x} Y{y}\"]"},
}};
constexpr std::string_view kOfHpgl[] = {"relative", "speeds", "pens"};
constexpr std::string_view kOfGcode[] = {"decimals", "feed",     "heights", "height",
                                         "pen_up",   "pen_down", "moves"};

constexpr std::array<TomlKey, 6> kPaperKeys{{
    {"name", "text", "\"a4\""},
    {"size", "mm along x and y, above 0", "[297, 210]"},
    {"origin", "mm from the paper's corner", "[10, 4]"},
    {"window", "the least x and y and the greatest, in units", "[0, 0, 11040, 7721]"},
    {"choose", "text", "\"PS4;\""},
    {"park", "a point in units", "[0, 7721]"},
}};

void require(bool holds, const TomlTable& table, std::string_view key) {
  if (!holds) table.refuse(key, table.at(key));
}

// Within the integers that no device's language goes beyond.
constexpr double kGreatest = 8388607;

Box2 window_of(const TomlTable& table) {
  const std::vector<double> n = table.numbers("window", 4, 4);
  require(n[0] < n[2] && n[1] < n[3], table, "window");
  for (const double x : n) require(std::abs(x) <= kGreatest, table, "window");
  return {{n[0], n[1]}, {n[2], n[3]}};
}

Vec2 pair_of(const TomlTable& table, std::string_view key) {
  const std::vector<double> n = table.numbers(key, 2, 2);
  return {n[0], n[1]};
}

std::string checked_words(const std::string& text, const TomlTable& table, std::string_view key,
                          const TomlValue& value, const std::vector<std::string_view>& places) {
  const bool is_plain =
      !text.empty() && std::ranges::all_of(text, [](char c) { return c >= ' ' && c <= '~'; });
  if (!is_plain)
    throw Error(fmt::format("{}: {} isn't plain text", table.place(value), key),
                "give letters, digits and signs of ASCII");
  if (const auto unknown = unknown_place(text, places))
    throw Error(fmt::format("{}: {} knows no {}", table.place(value), key, *unknown),
                places.empty() ? "leave it out"
                               : fmt::format("it knows {{{}}}", joined(places, "}, {")));
  return text;
}

// A text, or a list of them; none where the key isn't there.
std::vector<std::string> words_of(const TomlTable& table, std::string_view key,
                                  const std::vector<std::string_view>& places = {}) {
  if (!table.has(key)) return {};
  const TomlValue& value = table.at(key);
  if (value.list() == nullptr) return {checked_words(table.text(key), table, key, value, places)};
  std::vector<std::string> all;
  for (const TomlValue& item : *value.list()) {
    const auto* text = std::get_if<std::string>(&item.value);
    if (text == nullptr) table.refuse(key, item);
    all.push_back(checked_words(*text, table, key, item, places));
  }
  return all;
}

DevicePaper paper_of(const TomlTable& table) {
  DevicePaper paper;
  paper.name = table.text("name");
  paper.size_mm = pair_of(table, "size");
  require(paper.size_mm.x > 0 && paper.size_mm.y > 0 && paper.size_mm.x <= 1e5 &&
              paper.size_mm.y <= 1e5,
          table, "size");
  paper.origin_mm = pair_of(table, "origin");
  paper.window = window_of(table);
  if (table.has("choose"))
    paper.choose = checked_words(table.text("choose"), table, "choose", table.at("choose"), {});
  if (table.has("park")) paper.park = pair_of(table, "park");
  return paper;
}

void take_gcode(const TomlTable& table, Device& device) {
  if (table.has("decimals")) {
    const std::uint32_t decimals = table.whole("decimals");
    require(decimals <= 4, table, "decimals");
    device.decimals = static_cast<int>(decimals);
  } else {
    device.decimals = 3;
  }
  if (table.has("feed")) {
    device.feed_mm_min = table.number("feed");
    require(device.feed_mm_min > 0 && device.feed_mm_min <= 1e6, table, "feed");
  }
  if (table.has("heights")) device.heights = pair_of(table, "heights");
  if (table.has("height")) {
    device.height_percent = table.number("height");
    require(device.height_percent >= 0 && device.height_percent <= 100, table, "height");
  }
  table.at("pen_up");
  table.at("pen_down");
  device.pen_up = words_of(table, "pen_up", {"feed"});
  device.pen_down = words_of(table, "pen_down", {"height", "feed"});
  device.travel = "G0 X{x} Y{y}";
  device.draw = "G1 X{x} Y{y}";
  if (!table.has("moves")) return;
  const std::vector<std::string> moves = words_of(table, "moves", {"x", "y", "feed"});
  require(moves.size() == 2, table, "moves");
  for (const std::string& move : moves)
    require(move.find("{x}") != std::string::npos && move.find("{y}") != std::string::npos, table,
            "moves");
  device.travel = moves[0];
  device.draw = moves[1];
}

void take_hpgl(const TomlTable& table, Device& device) {
  device.pens = 1;
  if (table.has("pens")) {
    device.pens = static_cast<int>(table.whole("pens"));
    require(*device.pens >= 1, table, "pens");
  }
  if (table.has("relative")) device.relative = table.truth("relative");
  if (table.has("speeds")) {
    const Vec2 speeds = pair_of(table, "speeds");
    require(speeds.x > 0 && speeds.x <= speeds.y && speeds.y <= 1000, table, "speeds");
    device.speeds_cm_s = speeds;
  }
}

Device device_of(const TomlValue& root, const std::string& path) {
  const TomlTable table(path, root, "a device", kKeys);
  Device device;
  const std::string& language = table.text("language");
  require(language == "hpgl" || language == "gcode", table, "language");
  const bool is_hpgl = language == "hpgl";
  device.language = is_hpgl ? Device::Language::hpgl : Device::Language::gcode;
  const auto refuse_all = [&](auto& keys) {
    for (const std::string_view key : keys)
      if (table.has(key))
        throw Error(
            fmt::format("{}: {} has no meaning in {}", table.place(table.at(key)), key, language),
            "leave it out");
  };
  is_hpgl ? refuse_all(kOfGcode) : refuse_all(kOfHpgl);
  device.name = table.text("name");
  device.unit_mm = table.number("unit");
  require(device.unit_mm > 0 && device.unit_mm <= 1000, table, "unit");
  if (table.has("y")) {
    const std::string& y = table.text("y");
    require(y == "up" || y == "down", table, "y");
    device.y_up = y == "up";
  }
  if (table.has("longest")) {
    device.longest = table.whole("longest");
    require(device.longest >= 40, table, "longest");
  }
  if (table.has("window")) device.window = window_of(table);
  if (table.has("paper")) {
    if (device.window)
      throw Error(fmt::format("{}: a window beside papers", table.place(table.at("window"))),
                  "give each paper its own");
    for (const TomlValue& paper : table.list("paper"))
      device.papers.push_back(paper_of(TomlTable(path, paper, "a paper", kPaperKeys)));
    require(!device.papers.empty(), table, "paper");
  }
  device.start = words_of(table, "start");
  device.wait = words_of(table, "wait", {"pen", "name"});
  device.end = words_of(table, "end");
  is_hpgl ? take_hpgl(table, device) : take_gcode(table, device);
  return device;
}

Device parsed_device(const std::string& text, const std::string& path) {
  check_toml_nesting(text, path, kRight);
  return device_of({1, parse_toml(text, path, kRight)}, path);
}

} // namespace

double Device::step_mm() const {
  return unit_mm / std::pow(10, decimals);
}

bool is_device_file(const std::string& name_or_path) {
  return extension_of(name_or_path) == ".toml";
}

const std::vector<std::string>& device_names() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> all;
    for (const KnownDevice& known : known_devices()) all.emplace_back(known.name);
    return all;
  }();
  return names;
}

Device read_device(const std::string& name_or_path) {
  if (is_device_file(name_or_path))
    return parsed_device(
        text_of_file(name_or_path, {.most_bytes = 1'000'000, .noun = "a device", .right = kRight}),
        name_or_path);
  for (const KnownDevice& known : known_devices())
    if (known.name == name_or_path) return parsed_device(std::string(known.toml), name_or_path);
  throw UsageError(
      fmt::format("unknown device '{}'", printable(name_or_path)),
      fmt::format("one of {}, or a file such as plotter.toml", joined(device_names(), ", ")));
}

} // namespace orograph
