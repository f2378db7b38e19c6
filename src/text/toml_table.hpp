// SPDX-License-Identifier: GPL-3.0-or-later
// What a TOML file says, as a tree of plain values that know their lines; and its tables by their
// keys, with what their values should be.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace orograph {

struct TomlEntry;

struct TomlValue {
  using List = std::vector<TomlValue>;
  using Table = std::vector<TomlEntry>; ///< in the file's order
  struct Time {};

  std::size_t line = 0;
  std::variant<std::string, double, bool, Time, List, Table> value;

  const List* list() const { return std::get_if<List>(&value); }
  const Table* table() const { return std::get_if<Table>(&value); }
};

/// A key of a table with its value; printable.
struct TomlEntry {
  std::string key;
  TomlValue value;
};

/// For messages: "text", "the number 7", "a list of 2 values".
std::string words_for(const TomlValue& value);

/// Reads TOML. Throws Error, which begins with the path and the line and ends with `right`, where
/// it isn't. REQUIRES a text that `check_toml_nesting` has passed.
TomlValue::Table parse_toml(const std::string& text, const std::string& path, const char* right);

/// A key that a table may have.
struct TomlKey {
  std::string_view name;
  std::string_view what;    ///< its value should be: "a list of 3 numbers"
  std::string_view example; ///< "[8, 6, 3]"
};

// Everything below throws Error of one line that begins with the file's path and line.

/// A table whose keys are all known.
class TomlTable {
public:
  /// `noun` is what the table describes, "a box". Throws Error for a value that is no table, and
  /// for other keys than `keys`, which outlive this as all else does that is given.
  TomlTable(const std::string& path, const TomlValue& value, std::string noun,
            std::span<const TomlKey> keys);

  std::size_t line() const { return value_.line; }
  const std::string& path() const { return path_; }
  bool has(std::string_view key) const { return find(key) != nullptr; }
  /// None: null.
  const TomlValue* find(std::string_view key) const;
  /// Throws Error where it isn't there.
  const TomlValue& at(std::string_view key) const;

  // Each of these throws Error where the key isn't there, and where its value is something else.
  // Numbers are finite and up to 1e12.

  const std::string& text(std::string_view key) const;
  double number(std::string_view key) const;
  bool truth(std::string_view key) const;
  /// Between 0 and 1e9.
  std::uint32_t whole(std::string_view key) const;
  const TomlValue::List& list(std::string_view key) const;
  /// So many numbers, `most` at most.
  std::vector<double> numbers(std::string_view key, std::size_t least, std::size_t most) const;
  /// Lists of whole numbers from 0 on.
  std::vector<std::vector<std::uint32_t>> indices(std::string_view key) const;
  /// So many numbers in a value under that key.
  std::vector<double> numbers_in(std::string_view key, const TomlValue& value, std::size_t least,
                                 std::size_t most) const;

  /// Throws Error for a value under that key that isn't as it should be.
  [[noreturn]] void refuse(std::string_view key, const TomlValue& value) const;
  /// "PATH, line N".
  std::string place(const TomlValue& value) const;

private:
  const TomlKey& known(std::string_view key) const;
  double number_in(std::string_view key, const TomlValue& value) const;
  std::uint32_t whole_in(std::string_view key, const TomlValue& value) const;

  const std::string& path_;
  const TomlValue& value_;
  std::string noun_;
  std::span<const TomlKey> keys_;
};

} // namespace orograph
