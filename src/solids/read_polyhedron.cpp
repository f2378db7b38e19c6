// SPDX-License-Identifier: GPL-3.0-or-later
#include "solids/read_polyhedron.hpp"

#include "geometry/error.hpp"
#include "geometry/text_of_file.hpp"
#include "geometry/words.hpp"

#include <fmt/format.h>

namespace orograph {
namespace {

struct TextFile {
  const std::string& path;
  DataLines lines;

  std::string place() const { return fmt::format("{}, line {}", path, lines.number()); }
};

Vec3 point_of(std::string_view words, const TextFile& file) {
  double xyz[3];
  for (double& coordinate : xyz) {
    const std::string_view word = next_word(words);
    const auto number = number_of<double>(word);
    if (!number || !std::isfinite(*number))
      throw Error(word.empty() ? fmt::format("{} has fewer than three coordinates", file.place())
                               : fmt::format("{} has the coordinate '{}'", file.place(),
                                             printable(word.substr(0, 40))),
                  "a vertex has three finite numbers, x y z");
    coordinate = *number;
  }
  return {xyz[0], xyz[1], xyz[2]};
}

[[noreturn]] void refuse_corner(std::string_view word, const TextFile& file) {
  throw Error(word.empty() ? file.place() + " has fewer corners than it says"
                           : fmt::format("{} has the corner '{}'", file.place(),
                                         printable(word.substr(0, 40))),
              "a corner is the number of a vertex that is there");
}

struct OffCounts {
  std::size_t vertices = 0, faces = 0;
};

OffCounts off_counts(TextFile& file) {
  constexpr auto form = "it must begin with OFF and the counts of vertices, faces, edges";
  std::string_view words = file.lines.next() ? file.lines.line() : "";
  const std::string_view keyword = next_word(words);
  if (!keyword.ends_with("OFF") || keyword.find_first_of("4n") != std::string_view::npos ||
      words.find("BINARY") != std::string_view::npos)
    throw Error(file.path + " isn't plain OFF", form);
  if (count_words(words) == 0 && file.lines.next()) words = file.lines.line();
  const auto vertices = number_of<std::size_t>(next_word(words));
  const auto faces = number_of<std::size_t>(next_word(words));
  if (!vertices || !faces) throw Error(file.place() + " has no counts", form);
  return {*vertices, *faces};
}

void check_counts(const OffCounts& counts, const TextFile& file) {
  std::size_t found = 0;
  for (DataLines rest = file.lines; rest.next();) ++found;
  if (counts.vertices > found || counts.faces != found - counts.vertices)
    throw Error(fmt::format("{} says that it has {} vertices and {} faces but {} lines follow",
                            file.path, counts.vertices, counts.faces, found),
                "its counts are wrong, or a part of it is missing");
}

Polyhedron read_off(TextFile& file) {
  const OffCounts counts = off_counts(file);
  check_counts(counts, file);
  Polyhedron polyhedron;
  while (polyhedron.vertices_m.size() < counts.vertices && file.lines.next())
    polyhedron.vertices_m.push_back(point_of(file.lines.line(), file));
  while (file.lines.next()) {
    std::string_view words = file.lines.line();
    const std::string_view first = next_word(words);
    const auto corners = number_of<std::size_t>(first);
    if (!corners)
      throw Error(file.place() + " is no face",
                  "a face is the number of its corners and as many vertices");
    auto& face = polyhedron.faces.emplace_back();
    for (std::size_t i = 0; i < *corners; ++i) {
      const std::string_view word = next_word(words);
      const auto corner = number_of<std::uint32_t>(word);
      if (!corner || *corner >= counts.vertices) refuse_corner(word, file);
      face.push_back(*corner);
    }
  }
  return polyhedron;
}

// From 1 on, or back from -1, the last vertex so far.
std::uint32_t obj_corner(std::string_view word, std::size_t vertices, const TextFile& file) {
  const auto given = number_of<long>(word.substr(0, word.find('/')));
  const long count = static_cast<long>(vertices);
  if (!given || *given == 0 || *given > count || *given < -count) refuse_corner(word, file);
  return static_cast<std::uint32_t>(*given > 0 ? *given - 1 : count + *given);
}

Polyhedron read_obj(TextFile& file) {
  std::size_t vertices = 0; // a face may come before its vertices
  for (DataLines rest = file.lines; rest.next();) {
    std::string_view words = rest.line();
    vertices += next_word(words) == "v" ? 1 : 0;
  }
  Polyhedron polyhedron;
  while (file.lines.next()) {
    std::string_view words = file.lines.line();
    const std::string_view keyword = next_word(words);
    if (keyword == "v") polyhedron.vertices_m.push_back(point_of(words, file));
    if (keyword != "f") continue;
    auto& face = polyhedron.faces.emplace_back();
    for (auto word = next_word(words); !word.empty(); word = next_word(words))
      face.push_back(
          obj_corner(word, word.front() == '-' ? polyhedron.vertices_m.size() : vertices, file));
  }
  return polyhedron;
}

} // namespace

Polyhedron read_polyhedron(const std::string& path) {
  const std::string extension = extension_of(path);
  if (extension != ".off" && extension != ".obj")
    throw Error(path + " is neither OFF nor OBJ by its name", "give FILE.off or FILE.obj");
  const std::string text =
      text_of_file(path, {10'000'000, "a polyhedron", "give the path of an OFF or OBJ file"});
  TextFile file{path, DataLines(text)};
  return extension == ".off" ? read_off(file) : read_obj(file);
}

} // namespace orograph
