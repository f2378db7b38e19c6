// SPDX-License-Identifier: GPL-3.0-or-later
// A command's table of options for programs that call it.
#pragma once

#include "cli/options/option.hpp"

#include <string>

namespace orograph {

/// JSON, an object with the keys that `gdal --json-usage` has for the same, as far as there are
/// such: `name`, `description`, `examples`, and `input_arguments`, each with `name`, `type`
/// (string, boolean, integer or real), `description`, and where they tell something `metavar`,
/// `allowed`, `default` (a value as it may be given) or `default_text`, `min_value` and `max_value`
/// with `…_is_included`, `unit`, `choices` (all that it may be), `words` (some that it may be),
/// `list` (choices with commas between), `repeatable`, `extensions`, `between`, `group`, `short`,
/// and of positional arguments `positional` and `required`.
std::string usage_json(const Command& command);

} // namespace orograph
