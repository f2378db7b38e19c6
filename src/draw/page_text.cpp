// SPDX-License-Identifier: GPL-3.0-or-later
#include "draw/page_text.hpp"

namespace orograph {

Vec2 PageText::start_mm() const {
  const double share = anchor == TextAnchor::start ? 0 : anchor == TextAnchor::middle ? 0.5 : 1;
  return at_mm - share * extent.width_mm * Vec2{cos(angle), -sin(angle)};
}

std::array<Vec2, 4> PageText::corners_mm() const {
  const Vec2 along{cos(angle), -sin(angle)}, up{along.y, -along.x}, start = start_mm();
  const auto at = [&](double right_mm, double up_mm) {
    return start + right_mm * along + up_mm * up;
  };
  const auto [width_mm, ascent_mm, descent_mm] = extent;
  return {at(0, ascent_mm), at(width_mm, ascent_mm), at(width_mm, -descent_mm), at(0, -descent_mm)};
}

Box2 PageText::box_mm() const {
  Box2 box;
  for (const Vec2 corner : corners_mm()) box.include(corner);
  return box;
}

void PageText::scale(double factor) {
  at_mm = factor * at_mm;
  size_mm *= factor;
  extent = {factor * extent.width_mm, factor * extent.ascent_mm, factor * extent.descent_mm};
}

} // namespace orograph
