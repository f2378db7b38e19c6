// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/mesh/orientation.hpp"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

namespace orograph {

int exact_orientation(Vec2 a, Vec2 b, Vec2 c) {
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  using Point = Kernel::Point_2;
  return static_cast<int>(CGAL::orientation(Point(a.x, a.y), Point(b.x, b.y), Point(c.x, c.y)));
}

} // namespace orograph
