// SPDX-License-Identifier: GPL-3.0-or-later
#include "solids/read_map.hpp"

#include "geometry/error.hpp"
#include "view/model_transform.hpp"

#include <fmt/format.h>

namespace orograph {
namespace {

constexpr std::array<SceneKey, 7> kStepKeys{{
    {"move", "a list of 3 numbers", "[0, 0, 3]"},
    {"scale", "a number, or a list of 3", "[1, 1, 2]"},
    {"turn_x", "an angle in degrees", "90"},
    {"turn_y", "an angle in degrees", "90"},
    {"turn_z", "an angle in degrees", "90"},
    {"turn", "an axis and an angle in degrees", "{ axis = [1, 1, 0], angle = 90 }"},
    {"matrix", "3 or 4 rows of 4 numbers", "[[1, 0, 0.5, 0], [0, 1, 0, 0], [0, 0, 1, 0]]"},
}};

constexpr std::array<SceneKey, 2> kTurnKeys{{
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
  const SceneValue::List& rows = step.list("matrix");
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

} // namespace

Eigen::Matrix4d read_map(const SceneTable& table) {
  Eigen::Matrix4d product = Eigen::Matrix4d::Identity();
  if (!table.has("map")) return product;
  for (const SceneValue& value : table.list("map")) {
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

} // namespace orograph
