// SPDX-License-Identifier: GPL-3.0-or-later
#include "solids/read_shape.hpp"

#include "geometry/error.hpp"
#include "solids/build_solid.hpp"
#include "solids/shapes.hpp"
#include "text/printable.hpp"
#include "text/text_of_file.hpp"
#include "text/words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <optional>

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

// Vertices and faces of OFF (plain, or with colours and normals, which are passed over) or OBJ
// (`v` and `f`; all else is passed over), by the extension of `path`, in upper or lower case;
// metres, z up. Polygons have any number of corners.
//
// CGAL's readers aren't used: they pass over wrong counts and words that are no numbers, and stop
// at OBJ's lines (`l`).
//
// Throws Error, which begins with the path, and has the line where there is one: another
// extension; no such file, a folder, over 10 MB; more or fewer lines than OFF's counts say; a
// coordinate that is no finite number; a face that isn't made of vertices that are there.
Polyhedron read_polyhedron(const std::string& path) {
  const std::string extension = extension_of(path);
  if (extension != ".off" && extension != ".obj")
    throw Error(path + " is neither OFF nor OBJ by its name", "give FILE.off or FILE.obj");
  const std::string text =
      text_of_file(path, {10'000'000, "a polyhedron", "give the path of an OFF or OBJ file"});
  TextFile file{path, DataLines(text)};
  return extension == ".off" ? read_off(file) : read_obj(file);
}

constexpr TomlKey kShape{"shape", "a shape's name", "\"box\""};
constexpr TomlKey kBase{"base", "a list of corners [x, y]", "[[0, 0], [8, 0], [8, 6]]"};
constexpr TomlKey kVertices{"vertices", "a list of points [x, y, z]",
                            "[[0, 0, 0], [4, 0, 0], [0, 4, 0], [0, 0, 4]]"};
constexpr TomlKey kProfile{"profile", "a list of points [r, z]", "[[2, 0], [2, 5], [0, 7]]"};
constexpr TomlKey kSides{"sides", "a whole number", "24"};
constexpr TomlKey kStart{"start", "an angle in degrees", "7.5"};
constexpr TomlKey kSmooth{"smooth", "true or false", "true"};

constexpr std::array kNoShapeKeys{kShape, kUsesKey};
constexpr std::array kBoxKeys{kShape, kUsesKey,
                              TomlKey{"size", "a list of 3 numbers", "[8, 6, 3]"}};
constexpr std::array kPrismKeys{kShape, kUsesKey, kBase, TomlKey{"height", "a number", "3"}};
constexpr std::array kPyramidKeys{kShape, kUsesKey, kBase,
                                  TomlKey{"apex", "a height, or a point [x, y, z]", "5"}};
constexpr std::array kTetrahedronKeys{kShape, kUsesKey, kVertices};
constexpr std::array kRevolutionKeys{kShape, kUsesKey, kProfile, kSides, kStart, kSmooth};
constexpr std::array kRotationKeys{kShape,
                                   kUsesKey,
                                   kProfile,
                                   kSides,
                                   kStart,
                                   kSmooth,
                                   TomlKey{"rise", "metres in a turn", "2.5"},
                                   TomlKey{"turns", "a number", "1.5"}};
constexpr std::array kPolyhedronKeys{
    kShape, kUsesKey, kVertices,
    TomlKey{"faces", "lists of vertices, from 0 on",
            "[[0, 2, 1], [0, 1, 3], [1, 2, 3], [0, 3, 2]]"},
    TomlKey{"file", "the path of an OFF or OBJ file", "\"church.obj\""}};
constexpr std::array kWiresKeys{
    kShape, kUsesKey, kVertices,
    TomlKey{"lines", "pairs of vertices, from 0 on", "[[0, 1], [1, 2]]"}};

Solid read_box(const SceneTable& part) {
  return box(part.point3("size"));
}

Solid read_prism(const SceneTable& part) {
  return prism(part.points2("base"), part.number("height"));
}

Solid read_pyramid(const SceneTable& part) {
  const TomlValue& apex = part.at("apex");
  if (apex.list() != nullptr) return pyramid(part.points2("base"), part.point3("apex"));
  if (!std::holds_alternative<double>(apex.value)) part.refuse("apex", apex);
  return pyramid(part.points2("base"), part.number("apex"));
}

Solid read_tetrahedron(const SceneTable& part) {
  const auto vertices = part.points3("vertices");
  if (vertices.size() != 4) part.refuse("vertices", part.at("vertices"));
  return tetrahedron({vertices[0], vertices[1], vertices[2], vertices[3]});
}

Turning turning_of(const SceneTable& part) {
  return {part.points2("profile"), static_cast<int>(part.whole("sides")),
          Angle::degrees(part.has("start") ? part.number("start") : 0),
          part.has("smooth") && part.truth("smooth")};
}

Solid read_revolution(const SceneTable& part) {
  return revolution(turning_of(part));
}

Solid read_rotation(const SceneTable& part) {
  return rotation_body(turning_of(part),
                       {part.number("rise"), part.has("turns") ? part.number("turns") : 1});
}

Solid read_polyhedron_part(const SceneTable& part) {
  if (!part.has("file")) return build_solid({part.points3("vertices"), part.indices("faces"), {}});
  for (const char* key : {"vertices", "faces"})
    if (part.has(key))
      throw Error(fmt::format("the polyhedron has a file and {} too", key),
                  "give the one or the other");
  const std::string path = *shape_file(part);
  const Polyhedron polyhedron = read_polyhedron(path);
  try {
    return build_solid(polyhedron);
  } catch (const Error& error) {
    throw Error(path, error.what());
  }
}

Solid read_wires(const SceneTable& part) {
  std::vector<std::array<std::uint32_t, 2>> lines;
  const auto& given = part.list("lines");
  const auto indices = part.indices("lines");
  for (std::size_t i = 0; i < indices.size(); ++i) {
    if (indices[i].size() != 2) part.refuse("lines", given[i]);
    lines.push_back({indices[i][0], indices[i][1]});
  }
  return build_wires(part.points3("vertices"), lines);
}

struct Shape {
  std::string_view name;
  const char* noun;
  std::span<const TomlKey> keys;
  Solid (*read)(const SceneTable& part);
  std::string_view described_by; // the key whose line is told where the shape is wrong
};

constexpr std::array<Shape, 8> kShapes{{
    {"box", "a box", kBoxKeys, read_box, "size"},
    {"prism", "a prism", kPrismKeys, read_prism, "base"},
    {"pyramid", "a pyramid", kPyramidKeys, read_pyramid, "base"},
    {"tetrahedron", "a tetrahedron", kTetrahedronKeys, read_tetrahedron, "vertices"},
    {"revolution", "a revolution", kRevolutionKeys, read_revolution, "profile"},
    {"rotation", "a rotation", kRotationKeys, read_rotation, "profile"},
    {"polyhedron", "a polyhedron", kPolyhedronKeys, read_polyhedron_part, "faces"},
    {"wires", "a shape of wires", kWiresKeys, read_wires, "lines"},
}};

const Shape* find_shape(std::string_view name) {
  const auto* const shape = std::find_if(kShapes.begin(), kShapes.end(),
                                         [&](const Shape& known) { return known.name == name; });
  return shape == kShapes.end() ? nullptr : shape;
}

[[noreturn]] void refuse_shape(const std::string& name, const std::string& place) {
  std::vector<std::string_view> names;
  std::string hint = "there are ";
  for (const Shape& known : kShapes) {
    hint += fmt::format("{}{}", names.empty() ? "" : ", ", known.name);
    names.push_back(known.name);
  }
  if (const auto nearest = nearest_word(name, names); !nearest.empty())
    hint = fmt::format("did you mean {}? {}", nearest, hint);
  throw Error(fmt::format("{}: there is no shape '{}'", place, name), hint);
}

// A part without `shape` that has a key of one.
void refuse_shapeless(const std::string& path, const TomlEntry& entry) {
  for (const Shape& shape : kShapes)
    for (const TomlKey& key : shape.keys.subspan(2))
      if (key.name == entry.key)
        throw Error(fmt::format("{}, line {}: the part has {} but no shape", path, entry.value.line,
                                entry.key),
                    fmt::format("add shape = \"{}\", or another", shape.name));
}

// An Error of the file itself tells its place already.
bool tells_place(const Error& error, const SceneTable& part) {
  return std::string_view(error.what()).starts_with(part.path() + ", line ");
}

} // namespace

SceneTable part_table(const std::string& path, const TomlValue& value) {
  if (value.table() == nullptr) return {path, value, "a part", kNoShapeKeys};
  for (const TomlEntry& entry : *value.table()) {
    if (entry.key != "shape") continue;
    const std::string place = fmt::format("{}, line {}", path, entry.value.line);
    const auto* const name = std::get_if<std::string>(&entry.value.value);
    if (name == nullptr)
      throw Error(fmt::format("{}: shape is {}", place, words_for(entry.value)),
                  "give a shape's name, as in shape = \"box\"");
    const Shape* const shape = find_shape(*name);
    if (shape == nullptr) refuse_shape(*name, place);
    return {path, value, shape->noun, shape->keys};
  }
  for (const TomlEntry& entry : *value.table()) refuse_shapeless(path, entry);
  return {path, value, "a part without a shape", kNoShapeKeys};
}

std::optional<std::string> shape_file(const SceneTable& part) {
  if (!part.has("file")) return std::nullopt;
  const auto folder = std::filesystem::path(part.path()).parent_path();
  return (folder / part.text("file")).string();
}

Solid read_shape(const SceneTable& part) {
  const Shape& shape = *find_shape(part.text("shape"));
  try {
    return shape.read(part);
  } catch (const Error& error) {
    if (tells_place(error, part)) throw;
    const TomlValue* blamed = part.find(shape.described_by);
    if (blamed == nullptr) blamed = &part.at("shape");
    throw Error(part.place(*blamed), error.what());
  }
}

} // namespace orograph
