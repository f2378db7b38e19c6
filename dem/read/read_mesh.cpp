// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/read/read_mesh.hpp"

#include "dem/read/check_mesh.hpp"
#include "dem/read/mesh_comments.hpp"
#include "geometry/error.hpp"
#include "geometry/words.hpp"

#include <CGAL/IO/OBJ.h>
#include <CGAL/IO/OFF.h>
#include <CGAL/IO/PLY.h>
#include <CGAL/IO/STL.h>
#include <CGAL/Simple_cartesian.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <fstream>
#include <sstream>
#include <string_view>
#include <utility>

namespace orograph {
namespace {

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

void check(MeshFormat format, std::string_view text, const std::string& path) {
  switch (format) {
  case MeshFormat::off:
    return check_off(text, path);
  case MeshFormat::ply:
    return check_ply(text, path);
  case MeshFormat::obj:
    return check_obj(text, path);
  case MeshFormat::stl:
    return check_stl(text, path);
  }
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
  check(format, text, path);
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
