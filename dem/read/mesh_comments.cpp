// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/read/mesh_comments.hpp"

#include "dem/read/crs_frame.hpp"
#include "dem/read/gdal_messages.hpp"
#include "dem/read/length_units.hpp"
#include "geometry/error.hpp"

#include <fmt/format.h>
#include <ogr_spatialref.h>

#include <charconv>
#include <cmath>
#include <string>

namespace orograph {
namespace {

constexpr std::string_view mark = "orograph: ";

// The text from `at` to the end of its line, if the line is a comment that begins with the mark.
std::string_view comment_at(std::string_view text, std::size_t at) {
  const std::size_t begin = text.rfind('\n', at) + 1; // npos + 1 is 0
  std::string_view before = text.substr(begin, at - begin);
  while (!before.empty() && before.back() == ' ') before.remove_suffix(1);
  if (before != "#" && before != "comment") return {};
  std::string_view line = text.substr(at + mark.size());
  line = line.substr(0, line.find('\n'));
  while (!line.empty() && (line.back() == '\r' || line.back() == ' ')) line.remove_suffix(1);
  return line;
}

// A positive length; `words` loses it. `key` is what the comment begins with.
double next_length(std::string_view& words, std::string_view key, bool may_be_zero,
                   const MapShapes& shapes) {
  const std::string_view all = words;
  while (!words.empty() && words.front() == ' ') words.remove_prefix(1);
  double value = 0;
  const auto [end, fault] = std::from_chars(words.data(), words.data() + words.size(), value);
  if (fault != std::errc{} || !std::isfinite(value) || value < 0 || (value == 0 && !may_be_zero))
    throw Error(
        fmt::format("{}: its comment 'orograph: {} {:.40}' tells no length", shapes.path, key, all),
        "metres are wanted there; take the comment out if it isn't known");
  words.remove_prefix(static_cast<std::size_t>(end - words.data()));
  return value;
}

void read_crs(std::string_view wkt, MapShapes& shapes) {
  const GdalMessages messages;
  const Crs crs = crs_from_text(std::string(wkt));
  if (!tells_place(crs.get())) {
    shapes.notes.push_back("The CRS in the file's comment can't be understood: it is left out.");
    return;
  }
  set_crs(shapes.map, *crs, shapes.path, FileKind::other, {});
  if (!set_height_unit(shapes.map, *crs)) {
    shapes.map.height_unit_m = shapes.map.unit_m;
    shapes.map.height_unit_name = shapes.map.unit_name;
  }
  shapes.units_known = true;
}

void read_units(std::string_view words, MapShapes& shapes) {
  MapFrame& map = shapes.map;
  map.unit_m = next_length(words, "units", false, shapes);
  map.height_unit_m = next_length(words, "units", false, shapes);
  map.unit_name = unit_name(map.unit_m);
  map.height_unit_name = unit_name(map.height_unit_m);
  shapes.units_known = true;
}

} // namespace

void read_mesh_comments(std::string_view text, MapShapes& shapes) {
  std::string_view units;
  for (std::size_t at = text.find(mark); at != std::string_view::npos;
       at = text.find(mark, at + mark.size())) {
    std::string_view line = comment_at(text, at);
    const auto starts = [&](std::string_view word) {
      if (!line.starts_with(word)) return false;
      line.remove_prefix(word.size());
      return true;
    };
    if (starts("crs "))
      read_crs(line, shapes);
    else if (starts("units "))
      units = line;
    else if (starts("surface_error_m "))
      shapes.surface_error_m = next_length(line, "surface_error_m", true, shapes);
  }
  // After the CRS, whose units they make more precise.
  if (!units.empty()) read_units(units, shapes);
}

} // namespace orograph
