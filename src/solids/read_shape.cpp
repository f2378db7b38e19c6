// SPDX-License-Identifier: GPL-3.0-or-later
#include "solids/read_shape.hpp"

#include "geometry/edit_distance.hpp"
#include "geometry/error.hpp"
#include "solids/build_solid.hpp"
#include "solids/read_polyhedron.hpp"
#include "solids/shapes.hpp"
#include "solids/turned_shapes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <optional>

namespace orograph {
namespace {

constexpr SceneKey kShape{"shape", "a shape's name", "\"box\""};
constexpr SceneKey kBase{"base", "a list of corners [x, y]", "[[0, 0], [8, 0], [8, 6]]"};
constexpr SceneKey kVertices{"vertices", "a list of points [x, y, z]",
                             "[[0, 0, 0], [4, 0, 0], [0, 4, 0], [0, 0, 4]]"};
constexpr SceneKey kProfile{"profile", "a list of points [r, z]", "[[2, 0], [2, 5], [0, 7]]"};
constexpr SceneKey kSides{"sides", "a whole number", "24"};
constexpr SceneKey kStart{"start", "an angle in degrees", "7.5"};
constexpr SceneKey kSmooth{"smooth", "true or false", "true"};

constexpr std::array kNoShapeKeys{kShape, kUsesKey};
constexpr std::array kBoxKeys{kShape, kUsesKey,
                              SceneKey{"size", "a list of 3 numbers", "[8, 6, 3]"}};
constexpr std::array kPrismKeys{kShape, kUsesKey, kBase, SceneKey{"height", "a number", "3"}};
constexpr std::array kPyramidKeys{kShape, kUsesKey, kBase,
                                  SceneKey{"apex", "a height, or a point [x, y, z]", "5"}};
constexpr std::array kTetrahedronKeys{kShape, kUsesKey, kVertices};
constexpr std::array kRevolutionKeys{kShape, kUsesKey, kProfile, kSides, kStart, kSmooth};
constexpr std::array kRotationKeys{kShape,
                                   kUsesKey,
                                   kProfile,
                                   kSides,
                                   kStart,
                                   kSmooth,
                                   SceneKey{"rise", "metres in a turn", "2.5"},
                                   SceneKey{"turns", "a number", "1.5"}};
constexpr std::array kPolyhedronKeys{
    kShape, kUsesKey, kVertices,
    SceneKey{"faces", "lists of vertices, from 0 on",
             "[[0, 2, 1], [0, 1, 3], [1, 2, 3], [0, 3, 2]]"},
    SceneKey{"file", "the path of an OFF or OBJ file", "\"church.obj\""}};
constexpr std::array kWiresKeys{
    kShape, kUsesKey, kVertices,
    SceneKey{"lines", "pairs of vertices, from 0 on", "[[0, 1], [1, 2]]"}};

Solid read_box(const SceneTable& part) {
  return box(part.point3("size"));
}

Solid read_prism(const SceneTable& part) {
  return prism(part.points2("base"), part.number("height"));
}

Solid read_pyramid(const SceneTable& part) {
  const SceneValue& apex = part.at("apex");
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
  std::span<const SceneKey> keys;
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
void refuse_shapeless(const std::string& path, const SceneEntry& entry) {
  for (const Shape& shape : kShapes)
    for (const SceneKey& key : shape.keys.subspan(2))
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

SceneTable part_table(const std::string& path, const SceneValue& value) {
  if (value.table() == nullptr) return {path, value, "a part", kNoShapeKeys};
  for (const SceneEntry& entry : *value.table()) {
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
  for (const SceneEntry& entry : *value.table()) refuse_shapeless(path, entry);
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
    const SceneValue* blamed = part.find(shape.described_by);
    if (blamed == nullptr) blamed = &part.at("shape");
    throw Error(part.place(*blamed), error.what());
  }
}

} // namespace orograph
