// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/read/check_mesh.hpp"

#include "geometry/error.hpp"
#include "geometry/words.hpp"

#include <fmt/format.h>

#include <cstdint>
#include <cstring>

namespace orograph {

const char* const triangulate_faces =
    "every face must be a triangle; mesh programs split them (MeshLab: Turn into a Pure-Triangular "
    "Mesh, Blender: Triangulate Faces)";

namespace {

std::string place(const std::string& path, const DataLines& lines) {
  return fmt::format("{}, line {}", path, lines.number());
}

void check_coordinates(std::string_view words, const DataLines& lines, const std::string& path) {
  for (int axis = 0; axis < 3; ++axis) {
    const std::string_view word = next_word(words);
    if (word.empty())
      throw Error(fmt::format("{} has {} coordinates", place(path, lines), axis),
                  "a vertex has three, x y z");
    if (!is_finite_number(word))
      throw Error(fmt::format("{} has the coordinate '{:.40}'", place(path, lines), word),
                  "it must be a finite number");
  }
}

void check_corners(long long corners, const DataLines& lines, const std::string& path) {
  if (corners != 3)
    throw Error(fmt::format("{} has a face with {} corners", place(path, lines), corners),
                triangulate_faces);
}

struct OffCounts {
  bool plain = true; ///< no colours, normals or the like
  std::size_t vertices = 0, faces = 0;
};

OffCounts off_counts(DataLines& lines, const std::string& path) {
  const char* const form = "the file must begin with OFF and the counts of vertices, faces, edges";
  if (!lines.next()) throw Error(fmt::format("{} is empty", path), form);
  std::string_view words = lines.line();
  const std::string_view keyword = next_word(words);
  if (!keyword.ends_with("OFF")) throw Error(fmt::format("{} isn't OFF", path), form);
  if (keyword.find_first_of("4n") != std::string_view::npos || words.find("BINARY") < words.size())
    throw Error(fmt::format("{} is of the kind '{}{}'", path, keyword, words),
                "write it as plain OFF, in text and with three coordinates");
  if (count_words(words) == 0 && lines.next()) words = lines.line();
  const auto vertices = number_of<std::size_t>(next_word(words));
  const auto faces = number_of<std::size_t>(next_word(words));
  const auto edges = number_of<std::size_t>(next_word(words));
  if (!vertices || !faces || !edges || !next_word(words).empty())
    throw Error(fmt::format("{} has no counts", place(path, lines)), form);
  return {keyword == "OFF", *vertices, *faces};
}

} // namespace

void check_off(std::string_view text, const std::string& path) {
  DataLines lines(text);
  const OffCounts counts = off_counts(lines, path);
  std::size_t found = 0;
  for (DataLines rest = lines; rest.next();) ++found;
  const std::string told = fmt::format("{} says that it has {} vertices and {} faces", path,
                                       counts.vertices, counts.faces);
  if (counts.vertices > found || counts.faces != found - counts.vertices)
    throw Error(fmt::format("{} but {} lines follow", told, found),
                found < counts.vertices + counts.faces ? "the file is truncated or its counts wrong"
                                                       : "its counts are wrong");
  for (std::size_t i = 0; i < counts.vertices && lines.next(); ++i) {
    if (counts.plain && count_words(lines.line()) == 4)
      throw Error(fmt::format("{} but its line {} has four numbers", told, lines.number()),
                  "its counts are wrong, or it isn't plain OFF");
    check_coordinates(lines.line(), lines, path);
  }
  while (lines.next()) {
    std::string_view words = lines.line();
    const auto corners = number_of<long long>(next_word(words));
    if (!corners)
      throw Error(fmt::format("{} is no face", place(path, lines)),
                  "a face is the number of its corners and as many vertices");
    check_corners(*corners, lines, path);
  }
}

void check_obj(std::string_view text, const std::string& path) {
  for (DataLines lines(text); lines.next();) {
    std::string_view words = lines.line();
    const std::string_view keyword = next_word(words);
    if (keyword == "v") check_coordinates(words, lines, path);
    if (keyword == "f") check_corners(static_cast<long long>(count_words(words)), lines, path);
  }
}

bool is_binary_stl(std::string_view text) {
  if (!text.starts_with("solid")) return true;
  if (text.size() < 84) return false;
  std::uint32_t count = 0;
  std::memcpy(&count, text.data() + 80, 4);
  return text.size() == 84 + std::uint64_t{50} * count;
}

void check_stl(std::string_view text, const std::string& path) {
  if (!is_binary_stl(text)) {
    for (DataLines lines(text); lines.next();) {
      std::string_view words = lines.line();
      if (next_word(words) == "vertex") check_coordinates(words, lines, path);
    }
    return;
  }
  std::uint32_t count = 0;
  if (text.size() >= 84) std::memcpy(&count, text.data() + 80, 4);
  if (text.size() < 84 || text.size() != 84 + std::uint64_t{50} * count)
    throw Error(fmt::format("{} has {} bytes, which isn't STL", path, text.size()),
                fmt::format("binary STL of {} triangles has {}; the file may be truncated", count,
                            84 + std::uint64_t{50} * count));
  for (std::size_t face = 0; face < count; ++face) {
    float corners[9]; // after the normal
    std::memcpy(corners, text.data() + 84 + 50 * face + 12, sizeof corners);
    for (const float c : corners)
      if (!std::isfinite(c))
        throw Error(
            fmt::format("{}: triangle {} of {} has the coordinate {}", path, face + 1, count, c),
            "it must be a finite number");
  }
}

} // namespace orograph
