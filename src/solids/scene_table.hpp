// SPDX-License-Identifier: GPL-3.0-or-later
// A scene file's tables, with the points that stand in them.
#pragma once

#include "geometry/vec.hpp"
#include "text/toml_table.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace orograph {

/// Reads TOML. Throws Error, which begins with the path: no such file, a folder, over 10 MB, not
/// TOML, names with over 1000 dots (with the line).
TomlValue::Table parse_scene(const std::string& path);

/// Throws as a `TomlTable` does.
class SceneTable : public TomlTable {
public:
  using TomlTable::TomlTable;

  Vec3 point3(std::string_view key) const;
  std::vector<Vec2> points2(std::string_view key) const;
  std::vector<Vec3> points3(std::string_view key) const;
};

} // namespace orograph
