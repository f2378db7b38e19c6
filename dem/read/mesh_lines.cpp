// SPDX-License-Identifier: GPL-3.0-or-later
// Triangles of meshes in lines of text, OFF, OBJ and STL, and of STL in binary.
#include "dem/read/map_shapes.hpp"
#include "geometry/error.hpp"
#include "text/words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <unordered_map>
#include <utility>

namespace orograph {
namespace {

std::string place(const MapShapes& shapes, const DataLines& lines) {
  return fmt::format("{}, line {}", shapes.path, lines.number());
}

// The next three words; `words` loses them.
Vec3 next_point(std::string_view& words, const DataLines& lines, const MapShapes& shapes) {
  std::array<double, 3> axes;
  for (int axis = 0; axis < 3; ++axis) {
    const std::string_view word = next_word(words);
    if (word.empty())
      throw Error(fmt::format("{} has {} coordinates", place(shapes, lines), axis),
                  "a vertex has three, x y z");
    const auto value = number_of<double>(word);
    if (!value || !std::isfinite(*value))
      throw Error(fmt::format("{} has the coordinate '{:.40}'", place(shapes, lines), word),
                  "it must be a finite number");
    axes[static_cast<std::size_t>(axis)] = *value;
  }
  return {axes[0], axes[1], axes[2]};
}

void check_corners(std::size_t corners, const DataLines& lines, const MapShapes& shapes) {
  if (corners != 3)
    throw Error(fmt::format("{} has a face with {} corners", place(shapes, lines), corners),
                triangulate_faces);
}

struct OffCounts {
  bool plain = true; ///< no colours, normals or the like
  std::size_t vertices = 0, faces = 0;
};

OffCounts off_counts(DataLines& lines, const MapShapes& shapes) {
  const char* const form = "the file must begin with OFF and the counts of vertices, faces, edges";
  if (!lines.next()) throw Error(fmt::format("{} is empty", shapes.path), form);
  std::string_view words = lines.line();
  const std::string_view keyword = next_word(words);
  if (!keyword.ends_with("OFF")) throw Error(fmt::format("{} isn't OFF", shapes.path), form);
  if (keyword.find_first_of("4n") != std::string_view::npos || words.find("BINARY") < words.size())
    throw Error(fmt::format("{} is of the kind '{}{}'", shapes.path, keyword, words),
                "write it as plain OFF, in text and with three coordinates");
  if (count_words(words) == 0 && lines.next()) words = lines.line();
  const auto vertices = number_of<std::size_t>(next_word(words));
  const auto faces = number_of<std::size_t>(next_word(words));
  const auto edges = number_of<std::size_t>(next_word(words));
  if (!vertices || !faces || !edges || !next_word(words).empty())
    throw Error(fmt::format("{} has no counts", place(shapes, lines)), form);
  return {keyword == "OFF", *vertices, *faces};
}

std::array<std::uint32_t, 3> off_face(const DataLines& lines, std::size_t vertices,
                                      const MapShapes& shapes) {
  std::string_view words = lines.line();
  const auto corners = number_of<std::size_t>(next_word(words));
  if (!corners)
    throw Error(fmt::format("{} is no face", place(shapes, lines)),
                "a face is the number of its corners and as many vertices");
  check_corners(*corners, lines, shapes);
  std::array<std::uint32_t, 3> face;
  for (std::uint32_t& corner : face) {
    const std::string_view word = next_word(words);
    const auto vertex = number_of<std::uint32_t>(word);
    if (!vertex || *vertex >= vertices)
      throw Error(fmt::format("{}: a face names '{:.40}', a vertex that isn't there",
                              place(shapes, lines), word),
                  fmt::format("vertices are 0 to {}", vertices - 1));
    corner = *vertex;
  }
  return face;
}

// A corner is the number of a vertex, from 1, or from the last one back; a slash and more may
// follow.
std::uint32_t obj_corner(std::string_view word, const DataLines& lines, const MapShapes& shapes) {
  const auto number = number_of<long long>(word.substr(0, word.find('/')));
  const auto count = static_cast<long long>(shapes.points.size());
  const long long vertex = !number ? -1 : *number < 0 ? count + *number : *number - 1;
  if (vertex < 0 || vertex > UINT32_MAX)
    throw Error(fmt::format("{}: a face names '{:.40}', a vertex that isn't there",
                            place(shapes, lines), word),
                "vertices are numbered from 1, or from the last one back by -1, -2 and so on");
  return static_cast<std::uint32_t>(vertex);
}

constexpr std::array<std::string_view, 18> passed_over_in_obj{
    "vt", "vn", "vp",     "o",      "g",   "s",     "mg",       "mtllib",   "usemtl",
    "l",  "p",  "usemap", "maplib", "lod", "bevel", "c_interp", "d_interp", "csh"};

// One point for the vertices of STL's triangles that lie together.
class Joined {
public:
  explicit Joined(MapShapes& shapes) : shapes_(shapes) {}
  std::uint32_t corner(Vec3 point) {
    const Vec3 key{point.x + 0.0, point.y + 0.0, point.z + 0.0}; // without -0
    const auto [at, is_new] =
        numbers_.try_emplace(key, static_cast<std::uint32_t>(shapes_.points.size()));
    if (is_new) shapes_.points.push_back(point);
    return at->second;
  }

private:
  struct Hash {
    std::size_t operator()(const Vec3& p) const {
      std::uint64_t hash = 0;
      for (const double axis : {p.x, p.y, p.z})
        hash = (std::rotl(hash, 23) ^ std::bit_cast<std::uint64_t>(axis)) * 0x9e3779b97f4a7c15U;
      return hash ^ (hash >> 32U);
    }
  };
  MapShapes& shapes_;
  std::unordered_map<Vec3, std::uint32_t, Hash> numbers_;
};

// Text or binary: the first five letters alone don't tell.
bool is_binary_stl(std::string_view text) {
  if (!text.starts_with("solid")) return true;
  if (text.size() < 84) return false;
  std::uint32_t count = 0;
  std::memcpy(&count, text.data() + 80, 4);
  return text.size() == 84 + std::uint64_t{50} * count;
}

void take_binary_stl(std::string_view text, MapShapes& shapes) {
  std::uint32_t count = 0;
  if (text.size() >= 84) std::memcpy(&count, text.data() + 80, 4);
  if (text.size() < 84 || text.size() != 84 + std::uint64_t{50} * count)
    throw Error(fmt::format("{} has {} bytes, which isn't STL", shapes.path, text.size()),
                fmt::format("binary STL of {} triangles has {}; the file may be truncated", count,
                            84 + std::uint64_t{50} * count));
  Joined joined(shapes);
  shapes.triangles.reserve(count);
  for (std::size_t face = 0; face < count; ++face) {
    std::array<float, 9> axes; // after the normal
    std::memcpy(axes.data(), text.data() + 84 + 50 * face + 12, sizeof axes);
    for (const float c : axes)
      if (!std::isfinite(c))
        throw Error(fmt::format("{}: triangle {} of {} has the coordinate {}", shapes.path,
                                face + 1, count, c),
                    "it must be a finite number");
    shapes.triangles.push_back({joined.corner({axes[0], axes[1], axes[2]}),
                                joined.corner({axes[3], axes[4], axes[5]}),
                                joined.corner({axes[6], axes[7], axes[8]})});
  }
}

void take_text_stl(std::string_view text, MapShapes& shapes) {
  Joined joined(shapes);
  std::array<std::uint32_t, 3> corners;
  std::size_t count = 0;  // of the vertices of a loop
  bool is_open = true;    // until `endsolid`
  std::string_view words; // of a line
  const auto pass = [&](int some) {
    for (int i = 0; i < some; ++i) next_word(words);
  };
  for (DataLines lines(text); lines.next();) {
    words = lines.line();
    for (auto word = next_word(words); !word.empty(); word = next_word(words)) {
      if (word == "solid" || word == "endsolid") {
        is_open = word == "solid";
        words = {}; // a name
      } else if (word == "facet") {
        pass(4); // `normal` and its direction
      } else if (word == "outer") {
        pass(1); // `loop`
        count = 0;
      } else if (word == "vertex") {
        const std::uint32_t corner = joined.corner(next_point(words, lines, shapes));
        if (count < corners.size()) corners[count] = corner;
        ++count;
      } else if (word == "endloop") {
        check_corners(count, lines, shapes);
        shapes.triangles.push_back(corners);
      } else if (word != "endfacet") {
        throw Error(fmt::format("{} has '{:.40}', which isn't STL", place(shapes, lines), word),
                    "the file is damaged or isn't of that format");
      }
    }
  }
  if (is_open)
    throw Error(fmt::format("{} ends before its solid does", shapes.path), "the file is truncated");
}

} // namespace

const char* const triangulate_faces =
    "every face must be a triangle; mesh programs split them (MeshLab: Turn into a Pure-Triangular "
    "Mesh, Blender: Triangulate Faces)";

void take_off(std::string_view text, MapShapes& shapes) {
  DataLines lines(text);
  const OffCounts counts = off_counts(lines, shapes);
  std::size_t found = 0;
  for (DataLines rest = lines; rest.next();) ++found;
  const std::string told = fmt::format("{} says that it has {} vertices and {} faces", shapes.path,
                                       counts.vertices, counts.faces);
  if (counts.vertices > found || counts.faces != found - counts.vertices)
    throw Error(fmt::format("{} but {} lines follow", told, found),
                found < counts.vertices + counts.faces ? "the file is truncated or its counts wrong"
                                                       : "its counts are wrong");
  shapes.points.reserve(counts.vertices);
  shapes.triangles.reserve(counts.faces);
  for (std::size_t i = 0; i < counts.vertices && lines.next(); ++i) {
    std::string_view words = lines.line();
    shapes.points.push_back(next_point(words, lines, shapes));
    if (counts.plain && count_words(words) == 1)
      throw Error(fmt::format("{} but its line {} has four numbers", told, lines.number()),
                  "its counts are wrong, or it isn't plain OFF");
  }
  while (lines.next()) shapes.triangles.push_back(off_face(lines, counts.vertices, shapes));
}

void take_obj(std::string_view text, MapShapes& shapes) {
  for (DataLines lines(text); lines.next();) {
    std::string_view words = lines.line();
    const std::string_view keyword = next_word(words);
    if (keyword == "v") {
      shapes.points.push_back(next_point(words, lines, shapes));
    } else if (keyword == "f") {
      check_corners(count_words(words), lines, shapes);
      std::array<std::uint32_t, 3> face;
      for (std::uint32_t& corner : face) corner = obj_corner(next_word(words), lines, shapes);
      shapes.triangles.push_back(face);
    } else if (std::ranges::find(passed_over_in_obj, keyword) == passed_over_in_obj.end()) {
      throw Error(
          fmt::format("{} begins with '{:.40}', which isn't OBJ", place(shapes, lines), keyword),
          "the file is damaged or isn't of that format");
    }
  }
  // A face may stand before its vertices.
  for (std::size_t i = 0; i < shapes.triangles.size(); ++i)
    for (const std::uint32_t corner : shapes.triangles[i])
      if (corner >= shapes.points.size())
        throw Error(fmt::format("{}: face {} names a vertex that isn't there", shapes.path, i + 1),
                    fmt::format("the file has {} vertices", shapes.points.size()));
}

void take_stl(std::string_view text, MapShapes& shapes) {
  is_binary_stl(text) ? take_binary_stl(text, shapes) : take_text_stl(text, shapes);
}

} // namespace orograph
