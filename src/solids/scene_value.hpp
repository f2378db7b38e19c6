// SPDX-License-Identifier: GPL-3.0-or-later
// What a scene file says, as a tree of plain values that know their lines.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace orograph {

struct SceneEntry;

struct SceneValue {
  using List = std::vector<SceneValue>;
  using Table = std::vector<SceneEntry>; ///< in the file's order
  struct Time {};

  std::size_t line = 0;
  std::variant<std::string, double, bool, Time, List, Table> value;

  const List* list() const { return std::get_if<List>(&value); }
  const Table* table() const { return std::get_if<Table>(&value); }
};

/// A key of a table with its value; printable.
struct SceneEntry {
  std::string key;
  SceneValue value;
};

/// For messages: "text", "the number 7", "a list of 2 values".
std::string words_for(const SceneValue& value);

/// Reads TOML. Throws Error, which begins with the path: no such file, a folder, over 10 MB, not
/// TOML, names with over 1000 dots (with the line).
SceneValue::Table parse_scene(const std::string& path);

} // namespace orograph
