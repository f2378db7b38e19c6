// SPDX-License-Identifier: GPL-3.0-or-later
#include "solids/read_scene.hpp"

#include "geometry/error.hpp"
#include "solids/read_shape.hpp"
#include "solids/scene_table.hpp"
#include "solids/walk_scene.hpp"
#include "text/words.hpp"
#include "view/pipeline.hpp"

#include <Eigen/Core>
#include <fmt/format.h>

#include <cmath>
#include <map>
#include <utility>

namespace orograph {
namespace {

constexpr std::array<TomlKey, 7> kStepKeys{{
    {"move", "a list of 3 numbers", "[0, 0, 3]"},
    {"scale", "a number, or a list of 3", "[1, 1, 2]"},
    {"turn_x", "an angle in degrees", "90"},
    {"turn_y", "an angle in degrees", "90"},
    {"turn_z", "an angle in degrees", "90"},
    {"turn", "an axis and an angle in degrees", "{ axis = [1, 1, 0], angle = 90 }"},
    {"matrix", "3 or 4 rows of 4 numbers", "[[1, 0, 0.5, 0], [0, 1, 0, 0], [0, 0, 1, 0]]"},
}};

constexpr std::array<TomlKey, 2> kTurnKeys{{
    {"axis", "a list of 3 numbers", "[1, 1, 0]"},
    {"angle", "an angle in degrees", "90"},
}};

Eigen::Matrix4d scale_of(const SceneTable& step) {
  if (step.at("scale").list() != nullptr) return scaling(step.point3("scale"));
  if (!std::holds_alternative<double>(step.at("scale").value))
    step.refuse("scale", step.at("scale"));
  const double s = step.number("scale");
  return scaling({s, s, s});
}

Eigen::Matrix4d turn_of(const SceneTable& step) {
  const SceneTable turn(step.path(), step.at("turn"), "a turn", kTurnKeys);
  const Vec3 axis = turn.point3("axis");
  if (axis == Vec3{})
    throw Error(turn.place(turn.at("axis")) + ": the axis has length 0",
                "give it a direction, say [0, 0, 1]");
  return rotation(axis, Angle::degrees(turn.number("angle")));
}

Eigen::Matrix4d matrix_of(const SceneTable& step) {
  Eigen::Matrix4d matrix = Eigen::Matrix4d::Identity();
  const TomlValue::List& rows = step.list("matrix");
  if (rows.size() < 3 || rows.size() > 4) step.refuse("matrix", step.at("matrix"));
  for (std::size_t row = 0; row < rows.size(); ++row) {
    const auto numbers = step.numbers_in("matrix", rows[row], 4, 4);
    for (std::size_t column = 0; column < 4; ++column)
      matrix(static_cast<int>(row), static_cast<int>(column)) = numbers[column];
  }
  return matrix;
}

Eigen::Matrix4d step_matrix(const SceneTable& step, const std::string& kind) {
  if (kind == "move") return translation(step.point3("move"));
  if (kind == "scale") return scale_of(step);
  if (kind == "turn") return turn_of(step);
  if (kind == "matrix") return matrix_of(step);
  const Vec3 axis = kind == "turn_x"   ? Vec3{1, 0, 0}
                    : kind == "turn_y" ? Vec3{0, 1, 0}
                                       : Vec3{0, 0, 1};
  return rotation(axis, Angle::degrees(step.number(kind)));
}

// The product of the steps of `map`, which act in their order; the identity where the table has
// none. A step is a table with one key: move, scale, turn_x, turn_y, turn_z, turn or matrix.
// Throws Error, with the step's line: another key, or several; values that are none; a matrix that
// is singular, or not affine.
Eigen::Matrix4d read_map(const SceneTable& table) {
  Eigen::Matrix4d product = Eigen::Matrix4d::Identity();
  if (!table.has("map")) return product;
  for (const TomlValue& value : table.list("map")) {
    const SceneTable step(table.path(), value, "a step of a map", kStepKeys);
    if (value.table()->size() != 1)
      throw Error(
          fmt::format("{}: a step of a map has {} keys", step.place(value), value.table()->size()),
          "give each step one, as in [{ turn_z = 30 }, { move = [0, 0, 3] }]");
    const Eigen::Matrix4d next = step_matrix(step, value.table()->front().key);
    try {
      require_model(next);
      product = next * product;
      require_model(product);
    } catch (const Error& error) {
      throw Error(step.place(value), error.what());
    }
  }
  return product;
}

// The key `map` of a part's use or of a place.
constexpr TomlKey kMapKey{"map", "a list of steps", "[{ turn_z = 30 }, { move = [0, 0, 3] }]"};

constexpr TomlKey kPart{"part", "a part's name", "\"hut\""};
constexpr std::array<TomlKey, 2> kTomlKeys{{
    {"part", "tables by name", "{ wall = { shape = \"box\", size = [8, 6, 3] } }"},
    {"place", "tables below lines [[place]]", "[{ part = \"hut\", at = [455000, 5080000] }]"},
}};
constexpr std::array kUseKeys{kPart, kMapKey};
constexpr std::array kPlaceKeys{kPart, kMapKey,
                                TomlKey{"at", "2 numbers, or 3 with a height", "[455000, 5080000]"},
                                TomlKey{"lonlat", "2 numbers, or 3 with a height", "[7.5, 46.1]"}};

using PartNumbers = std::map<std::string, std::uint32_t, std::less<>>;

PartUse read_use(const SceneTable& table, const PartNumbers& numbers) {
  const std::string& name = table.text("part");
  const auto found = numbers.find(name);
  if (found == numbers.end()) {
    std::vector<std::string_view> names;
    for (const auto& [known, number] : numbers) names.push_back(known);
    const auto nearest = nearest_word(name, names);
    throw Error(fmt::format("{}: there is no part '{}'", table.place(table.at("part")), name),
                nearest.empty() ? fmt::format("describe it in a table [part.{}]", name)
                                : fmt::format("did you mean {}?", nearest));
  }
  return {found->second, read_map(table), table.line()};
}

struct SceneParts {
  std::vector<ScenePart> nodes;
  PartNumbers numbers;
  std::vector<Solid> solids;
  std::vector<std::string> shape_files;
};

void read_part(const SceneTable& table, ScenePart& part, SceneParts& parts) {
  if (table.has("shape")) {
    if (auto file = shape_file(table)) parts.shape_files.push_back(*std::move(file));
    part.solid = static_cast<std::uint32_t>(parts.solids.size());
    parts.solids.push_back(read_shape(table));
  }
  if (table.has("uses"))
    for (const TomlValue& use : table.list("uses"))
      part.uses.push_back(
          read_use(SceneTable(table.path(), use, "a use of a part", kUseKeys), parts.numbers));
  if (!part.solid && part.uses.empty())
    throw Error(fmt::format("{}, line {}: part '{}' has neither a shape nor other parts",
                            table.path(), table.line(), part.name),
                "give it shape = \"box\" or another, or uses = [{ part = \"wall\" }]");
}

SceneParts read_parts(const SceneTable& scene) {
  SceneParts parts;
  if (!scene.has("part")) return parts;
  const TomlValue& given = scene.at("part");
  if (given.table() == nullptr) scene.refuse("part", given);
  for (const TomlEntry& entry : *given.table()) {
    parts.numbers.emplace(entry.key, static_cast<std::uint32_t>(parts.nodes.size()));
    parts.nodes.push_back({entry.key, {}, {}});
  }
  for (std::size_t i = 0; i < parts.nodes.size(); ++i)
    read_part(part_table(scene.path(), (*given.table())[i].value), parts.nodes[i], parts);
  return parts;
}

ScenePlace read_place(const SceneTable& table) {
  ScenePlace place;
  place.part = table.text("part");
  place.line = table.line();
  place.lonlat = table.has("lonlat");
  if (place.lonlat == table.has("at"))
    throw Error(fmt::format("{}, line {}: a place has {}", table.path(), table.line(),
                            place.lonlat ? "both at and lonlat" : "neither at nor lonlat"),
                "give the terrain's coordinates, at = [455000, 5080000], or lonlat = [7.5, 46.1]");
  const auto numbers = table.numbers(place.lonlat ? "lonlat" : "at", 2, 3);
  place.x = numbers[0];
  place.y = numbers[1];
  if (numbers.size() == 3) place.height = numbers[2];
  if (place.lonlat && !(std::abs(place.x) <= 360 && std::abs(place.y) <= 90))
    throw Error(fmt::format("{}: lonlat is not on the globe", table.place(table.at("lonlat"))),
                "longitude first, -360 to 360 degrees, then latitude, -90 to 90");
  return place;
}

} // namespace

SceneFile read_scene(const std::string& path) {
  const TomlValue root{1, parse_scene(path)};
  const SceneTable scene(path, root, "a scene", kTomlKeys);
  SceneParts parts = read_parts(scene);
  SceneFile file{.path = path,
                 .shape_files = std::move(parts.shape_files),
                 .solids = {},
                 .places = {},
                 .instances = {}};
  SceneGraph graph{std::move(parts.nodes), {}};
  if (scene.has("place"))
    for (const TomlValue& value : scene.list("place")) {
      const SceneTable table(path, value, "a place", kPlaceKeys);
      file.places.push_back(read_place(table));
      graph.places.push_back(read_use(table, parts.numbers));
    }
  if (file.places.empty())
    throw Error(path + " has no place, so nothing would be drawn",
                "add a table [[place]] with part = \"hut\" and at = [455000, 5080000]");
  file.solids = std::move(parts.solids);
  file.instances = walk_scene(graph, path);
  return file;
}

} // namespace orograph
