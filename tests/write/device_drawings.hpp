// SPDX-License-Identifier: GPL-3.0-or-later
// Drawings for plotters, and what a pen did with them as a reader of its language saw it.
#pragma once

#include "draw/drawing.hpp"
#include "geometry/vec.hpp"

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace orograph {

/// A move with the pen on the paper, in millimetres of the device.
struct SeenMove {
  int pen = 0;
  Vec2 from, to;
};

/// Strokes inside of the box, of one to three layers: long and tiny ones, dots, some that begin
/// where the last one ended. With `pens`, each layer has one of so many.
Drawing random_strokes(std::uint64_t seed, const Page& page, const Box2& inside_mm, int pens);

/// What is wrong with the moves as a picture of the drawing, or nothing: the pen goes from point to
/// point of each stroke in order, by the layer's pen, each within `tolerance_mm` along either axis
/// of where it should be, and nowhere else. Points that fall on one place of the pen's are one move
/// less.
std::string fault_of_moves(const Drawing& drawing, const std::vector<SeenMove>& moves,
                           const std::function<Vec2(Vec2 page_mm)>& to_device, double tolerance_mm);

} // namespace orograph
