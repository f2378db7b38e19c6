// SPDX-License-Identifier: GPL-3.0-or-later
// Axis-parallel boxes. An empty box has low > high and takes any point by `include`.
#pragma once

#include "geometry/vec.hpp"

#include <algorithm>

namespace orograph {

struct Box2 {
  Vec2 low{kInfinity, kInfinity};
  Vec2 high{-kInfinity, -kInfinity};

  bool empty() const { return !(low.x <= high.x && low.y <= high.y); }
  double width() const { return high.x - low.x; }
  double height() const { return high.y - low.y; }
  Vec2 centre() const { return 0.5 * (low + high); }
  void include(Vec2 p) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
};

struct Box3 {
  Vec3 low{kInfinity, kInfinity, kInfinity};
  Vec3 high{-kInfinity, -kInfinity, -kInfinity};

  bool empty() const { return !(low.x <= high.x && low.y <= high.y && low.z <= high.z); }
  Vec3 centre() const { return 0.5 * (low + high); }
  void include(Vec3 p) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
};

} // namespace orograph
