// SPDX-License-Identifier: GPL-3.0-or-later
// Lines on a page, and which of them is the first on a straight way.
#pragma once

#include "draw/drawing.hpp"

#include <array>
#include <initializer_list>
#include <optional>
#include <string_view>
#include <vector>

namespace orograph {

class PageLines {
public:
  explicit PageLines(const Page& page);
  /// Of those layers of a drawing that have one of the names.
  PageLines(const Drawing& drawing, std::initializer_list<std::string_view> names);

  void add(Vec2 from_mm, Vec2 to_mm);
  /// How far it is to the first line, no farther than `reach_mm`. REQUIRES a unit direction.
  std::optional<double> first_met(Vec2 from_mm, Vec2 direction, double reach_mm) const;

private:
  using Line = std::array<Vec2, 2>;
  // The squares of a millimetre, clamped to the page, that two points span.
  template <class Take>
  void each_square(Vec2 a_mm, Vec2 b_mm, const Take& take) const;

  int columns_, rows_;
  std::vector<std::vector<Line>> squares_;
};

} // namespace orograph
