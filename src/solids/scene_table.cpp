// SPDX-License-Identifier: GPL-3.0-or-later
#include "solids/scene_table.hpp"

#include "text/nesting.hpp"
#include "text/text_of_file.hpp"

namespace orograph {

TomlValue::Table parse_scene(const std::string& path) {
  const std::string text = text_of_file(
      path, {10'000'000, "a scene", "give a scene in TOML, with tables [part.NAME] and [[place]]"});
  check_toml_nesting(text, path, "a scene's names have two, as in part.hut.shape");
  return parse_toml(text, path, "give a scene with tables such as [part.hut] and [[place]]");
}

Vec3 SceneTable::point3(std::string_view key) const {
  const auto n = numbers(key, 3, 3);
  return {n[0], n[1], n[2]};
}

std::vector<Vec2> SceneTable::points2(std::string_view key) const {
  std::vector<Vec2> points;
  for (const TomlValue& item : list(key)) {
    const auto n = numbers_in(key, item, 2, 2);
    points.push_back({n[0], n[1]});
  }
  return points;
}

std::vector<Vec3> SceneTable::points3(std::string_view key) const {
  std::vector<Vec3> points;
  for (const TomlValue& item : list(key)) {
    const auto n = numbers_in(key, item, 3, 3);
    points.push_back({n[0], n[1], n[2]});
  }
  return points;
}

} // namespace orograph
