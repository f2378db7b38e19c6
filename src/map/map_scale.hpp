// SPDX-License-Identifier: GPL-3.0-or-later
// How large, and where north is, at a framed view's middle.
#pragma once

#include "map/furniture_pen.hpp"
#include "placing/placed_view.hpp"

#include <optional>
#include <string>

namespace orograph {

/// Where the ray through a picture's middle meets level ground of the terrain's mean height; in an
/// eye's view, which may look over it, the first place straight beneath that does.
struct LevelAtMiddle {
  ProfilePoint at;
  bool is_in_middle = true;
};
/// None where there is none down to the picture's lower side.
std::optional<LevelAtMiddle> level_at_middle(const PlacedView& placed);

/// A number of a scale, three digits of it, in groups: "48 300".
std::string scale_number(double number);

/// A bar and the scale of a parallel view, in a row that is so wide at most. Returns its box.
Box2 draw_scale_bar(FurniturePen& pen, double mm_per_m, double text_mm, Vec2 upper_left_mm,
                    double most_mm);

/// An arrow as it would lie on the level ground there, `north_deg` clockwise from the frame's
/// north, in a square of `side_mm`. False where that is seen from the side, and nothing is drawn.
bool draw_north(FurniturePen& pen, const PlacedView& placed, ProfilePoint at, double north_deg,
                double text_mm, Vec2 upper_left_mm, double side_mm);

} // namespace orograph
