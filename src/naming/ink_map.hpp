// SPDX-License-Identifier: GPL-3.0-or-later
// Where a drawing has ink, in squares: how calm the paper is that a text would stand on.
#pragma once

#include "draw/drawing.hpp"
#include "geometry/box.hpp"

#include <cstddef>
#include <span>
#include <vector>

namespace orograph {

class InkMap {
public:
  /// Of the layers' strokes. Cost: some nanoseconds a square that ink goes through.
  InkMap(const Page& page, std::span<const Layer> layers);

  /// The share of a box's squares through which lines go; 1 beyond the page.
  double share(const Box2& box_mm) const;

private:
  std::size_t columns_, rows_;
  std::vector<bool> has_ink_;
};

} // namespace orograph
