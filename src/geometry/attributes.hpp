// SPDX-License-Identifier: GPL-3.0-or-later
// What is known of a thing on the map, by names.
#pragma once

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

namespace orograph {

struct Attribute {
  std::string name;
  std::variant<std::int64_t, double, std::string> value;

  bool operator==(const Attribute&) const = default;
};
using Attributes = std::vector<Attribute>;

} // namespace orograph
