// SPDX-License-Identifier: GPL-3.0-or-later
// Triangles of mesh files, and what their comments tell of place and units.
#include "dem/read/crs_frame.hpp"
#include "dem/read/length_units.hpp"
#include "dem/read/map_shapes.hpp"
#include "geometry/error.hpp"
#include "text/words.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <fstream>
#include <utility>

#include "gdal/gdal.hpp"

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

// From lines of comment ('#' in OFF and OBJ, 'comment' in PLY):
//     orograph: crs WKT
//     orograph: units METRES_IN_A_UNIT METRES_IN_A_UNIT_OF_HEIGHT
//     orograph: surface_error_m METRES
// each on one line; of several of a kind the last counts. `text` may be the whole file. Throws
// Error where one of them can't be right.
void read_mesh_comments(std::string_view text, MapShapes& shapes) {
  std::string_view crs, units;
  for (std::size_t at = text.find(mark); at != std::string_view::npos;
       at = text.find(mark, at + mark.size())) {
    std::string_view line = comment_at(text, at);
    const auto starts = [&](std::string_view word) {
      if (!line.starts_with(word)) return false;
      line.remove_prefix(word.size());
      return true;
    };
    if (starts("crs "))
      crs = line;
    else if (starts("units "))
      units = line;
    else if (starts("surface_error_m "))
      shapes.surface_error_m = next_length(line, "surface_error_m", true, shapes);
  }
  if (!crs.empty()) read_crs(crs, shapes);
  // After the CRS, whose units they make more precise.
  if (!units.empty()) read_units(units, shapes);
}

std::string text_of(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::string text;
  if (file.seekg(0, std::ios::end)) {
    const std::streamoff size = file.tellg();
    file.seekg(0);
    if (size > 0) text.resize(static_cast<std::size_t>(size));
    file.read(text.data(), size);
  }
  if (!file) throw Error(fmt::format("{} can't be read", path), "give the path of a mesh file");
  if (text.empty()) throw Error(fmt::format("{} is empty", path), "give a file with triangles");
  return text;
}

void take(MeshFormat format, std::string_view text, MapShapes& shapes) {
  switch (format) {
  case MeshFormat::off:
    return take_off(text, shapes);
  case MeshFormat::ply:
    return take_ply(text, shapes);
  case MeshFormat::obj:
    return take_obj(text, shapes);
  case MeshFormat::stl:
    return take_stl(text, shapes);
  }
}

} // namespace

std::optional<MeshFormat> mesh_format_of(const std::string& path) {
  const std::string end = extension_of(path);
  if (end == ".off") return MeshFormat::off;
  if (end == ".ply") return MeshFormat::ply;
  if (end == ".obj") return MeshFormat::obj;
  if (end == ".stl") return MeshFormat::stl;
  return std::nullopt;
}

MapShapes read_mesh(const std::string& path, MeshFormat format) {
  MapShapes shapes;
  shapes.path = path;
  const std::string text = text_of(path);
  take(format, text, shapes);
  if (shapes.triangles.empty())
    throw Error(fmt::format("{} has no faces", path), "it must hold triangles");
  if (format == MeshFormat::ply)
    read_mesh_comments(std::string_view(text).substr(0, text.find("end_header")), shapes);
  else if (format != MeshFormat::stl)
    read_mesh_comments(text, shapes);
  return shapes;
}

} // namespace orograph
