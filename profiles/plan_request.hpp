// SPDX-License-Identifier: GPL-3.0-or-later
// How many profiles a user wants, or how close.
#pragma once

#include <variant>

namespace orograph {

struct ProfileCount {
  int count; ///< at least 1
};
struct PageSpacing {
  double mm; ///< on the page, for level ground at the terrain's mean height
};
struct GroundSpacing {
  double m; ///< in depth
};
using PlanRequest = std::variant<PageSpacing, GroundSpacing, ProfileCount>;

} // namespace orograph
