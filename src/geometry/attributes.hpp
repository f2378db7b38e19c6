// SPDX-License-Identifier: GPL-3.0-or-later
// What is known of a thing on the map, by names.
#pragma once

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

namespace orograph {

using AttributeValue = std::variant<std::int64_t, double, std::string>;

struct Attribute {
  std::string name;
  AttributeValue value;

  bool operator==(const Attribute&) const = default;
};
using Attributes = std::vector<Attribute>;

} // namespace orograph
