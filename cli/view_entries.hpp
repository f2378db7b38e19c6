// SPDX-License-Identifier: GPL-3.0-or-later
// The keys of a view file, from whatever format they came.
#pragma once

#include "cli/view_file.hpp"

#include <cstddef>
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

/// The view that they describe, checked without a terrain. `path` names the file in messages.
/// Throws the Errors of `read_view_file` from an unknown key on.
ViewFile view_of_entries(const std::vector<ViewEntry>& entries, const std::string& path);

} // namespace orograph
