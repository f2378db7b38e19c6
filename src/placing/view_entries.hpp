// SPDX-License-Identifier: GPL-3.0-or-later
// The keys of a view file, from whatever format they came.
#pragma once

#include "placing/view_file.hpp"

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace orograph {

/// A key with its value.
struct ViewEntry {
  enum class Kind { text, number, numbers, other };
  std::string key;
  std::size_t line = 0; ///< 0: not known
  Kind kind = Kind::other;
  std::string text;            ///< the text; of `other`, what it is instead: "a table"
  std::vector<double> numbers; ///< of `number` a single one
};

/// Makes of an entry a list of numbers, or `other` where `number_at(i)` is none for one of them.
void take_numbers(ViewEntry& entry, std::size_t count,
                  const std::function<std::optional<double>(std::size_t)>& number_at);

/// The text of a file with a view. Throws Error where there is none, or more than so many bytes.
std::string view_text(const std::string& path, std::size_t most_bytes);

/// The view that they describe, checked without a terrain. `path` names the file in messages.
/// Throws the Errors of `read_view_file` from an unknown key on.
ViewFile view_of_entries(const std::vector<ViewEntry>& entries, const std::string& path);

} // namespace orograph
