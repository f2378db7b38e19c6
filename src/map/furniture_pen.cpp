// SPDX-License-Identifier: GPL-3.0-or-later
#include "map/furniture_pen.hpp"

#include "draw/round_drawing.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

namespace orograph {

void FurniturePen::line(std::initializer_list<Vec2> points) {
  layer_.strokes.push_back({.first_point = static_cast<std::uint32_t>(layer_.page_mm.size()),
                            .point_count = static_cast<std::uint32_t>(points.size())});
  for (const Vec2 p : points)
    layer_.page_mm.push_back({rounded_to_page_step(p.x), rounded_to_page_step(p.y)});
}

Box2 FurniturePen::row(std::string text, double size_mm, Vec2 upper_left_mm, double most_mm,
                       bool is_bold) {
  PageText one{
      .text = std::move(text), .at_mm = upper_left_mm, .size_mm = size_mm, .is_bold = is_bold};
  one = lettering_.set(std::move(one));
  // A font that needs more height than a row has is set smaller.
  const double height_mm = one.extent.ascent_mm + one.extent.descent_mm;
  if (height_mm > kRowOfEm * size_mm)
    one.size_mm = std::floor(100 * size_mm * kRowOfEm * size_mm / height_mm) / 100;
  const double baseline_mm = 0.5 * (kRowOfEm * size_mm - std::min(height_mm, kRowOfEm * size_mm)) +
                             one.extent.ascent_mm * one.size_mm / size_mm;
  one.at_mm.y += baseline_mm;
  const std::string whole = one.text;
  one = lettering_.set_within(std::move(one), most_mm);
  if (one.text != whole) now_.cut.push_back(whole);
  const Box2 box{upper_left_mm, upper_left_mm + Vec2{one.extent.width_mm, kRowOfEm * size_mm}};
  if (!one.text.empty()) add(std::move(one));
  return box;
}

} // namespace orograph
