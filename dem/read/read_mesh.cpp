// SPDX-License-Identifier: GPL-3.0-or-later
// Triangles of mesh files, through CGAL: the only place that knows its readers.
#include "dem/read/crs_frame.hpp"
#include "dem/read/length_units.hpp"
#include "dem/read/map_shapes.hpp"
#include "geometry/error.hpp"
#include "text/words.hpp"

#include <CGAL/IO/OBJ.h>
#include <CGAL/IO/OFF.h>
#include <CGAL/IO/PLY.h>
#include <CGAL/IO/STL.h>
#include <CGAL/Simple_cartesian.h>
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <exception>
#include <fstream>
#include <sstream>
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
// each on one line. `text` may be the whole file. Throws Error where one of them can't be right.
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

using Points = std::vector<CGAL::Simple_cartesian<double>::Point_3>;
using Faces = std::vector<std::vector<std::uint32_t>>;

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

bool read(MeshFormat format, std::istream& in, Points& points, Faces& faces) {
  const auto quiet = CGAL::parameters::verbose(false);
  switch (format) {
  case MeshFormat::off:
    return CGAL::IO::read_OFF(in, points, faces, quiet);
  case MeshFormat::ply:
    return CGAL::IO::read_PLY(in, points, faces, quiet);
  case MeshFormat::obj:
    return CGAL::IO::read_OBJ(in, points, faces, quiet);
  case MeshFormat::stl:
    return CGAL::IO::read_STL(in, points, faces, quiet);
  }
  return false;
}

// In a text the reader stops at the line that it can't take.
std::string where_stopped(std::istringstream& in) {
  in.clear();
  const std::streamoff at = in.tellg();
  const std::string_view text = in.view();
  if (at <= 0 || static_cast<std::size_t>(at) > text.size()) return "";
  const auto line = std::count(text.begin(), text.begin() + at - 1, '\n') + 1;
  return fmt::format(" beyond line {}", line);
}

const char* name_of(MeshFormat format) {
  switch (format) {
  case MeshFormat::off:
    return "OFF";
  case MeshFormat::ply:
    return "PLY";
  case MeshFormat::obj:
    return "OBJ";
  case MeshFormat::stl:
    return "STL";
  }
  return "";
}

void add_faces(const Faces& faces, MapShapes& shapes) {
  shapes.triangles.reserve(faces.size());
  for (std::size_t i = 0; i < faces.size(); ++i) {
    if (faces[i].size() != 3)
      throw Error(fmt::format("{}: face {} has {} corners", shapes.path, i + 1, faces[i].size()),
                  triangulate_faces);
    for (const std::uint32_t corner : faces[i])
      if (corner >= shapes.points.size())
        throw Error(fmt::format("{}: face {} names a vertex that isn't there", shapes.path, i + 1),
                    fmt::format("the file has {} vertices", shapes.points.size()));
    shapes.triangles.push_back({faces[i][0], faces[i][1], faces[i][2]});
  }
  if (shapes.triangles.empty())
    throw Error(fmt::format("{} has no faces", shapes.path), "it must hold triangles");
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
  std::string text = text_of(path);
  check_mesh(format, text, path);
  if (format == MeshFormat::ply)
    read_mesh_comments(std::string_view(text).substr(0, text.find("end_header")), shapes);
  else if (format != MeshFormat::stl)
    read_mesh_comments(text, shapes);

  Points points;
  Faces faces;
  std::istringstream in(std::move(text), std::ios::in | std::ios::binary);
  bool is_read = false;
  try {
    is_read = read(format, in, points, faces);
  } catch (const std::exception&) {
    is_read = false; // a size that the memory can't hold, or a check of CGAL's own
  }
  if (!is_read)
    throw Error(fmt::format("{} can't be read as {}{}", path, name_of(format), where_stopped(in)),
                "the file is damaged or isn't of that format");
  shapes.points.reserve(points.size());
  for (const auto& p : points) shapes.points.push_back({p.x(), p.y(), p.z()});
  add_faces(faces, shapes);
  return shapes;
}

} // namespace orograph
