// SPDX-License-Identifier: GPL-3.0-or-later
// What of a page is taken by texts and their lines, so that nothing is put on them.
#pragma once

#include "draw/page_text.hpp"
#include "geometry/box.hpp"
#include "geometry/vec.hpp"

#include <array>
#include <vector>

namespace orograph {

/// A rectangle on the page, turned in any way: its corners, one after the other round it.
using TurnedBox = std::array<Vec2, 4>;

/// That of a text that is set, `margin_mm` larger on each side.
TurnedBox box_of(const PageText& text, double margin_mm = 0);
/// That of a straight line, `margin_mm` wide on each side and beyond its ends.
TurnedBox box_of(Vec2 from_mm, Vec2 to_mm, double margin_mm);
Box2 bounds_of(const TurnedBox& box);
bool is_inside(const Box2& box, const Box2& room);
/// Whether they have more than an edge in common.
bool overlap(const TurnedBox& a, const TurnedBox& b);

class TakenRoom {
public:
  bool is_free(const TurnedBox& box) const;
  void take(const TurnedBox& box);

private:
  struct Taken {
    TurnedBox box;
    Box2 bounds;
  };
  std::vector<Taken> boxes_;
};

} // namespace orograph
