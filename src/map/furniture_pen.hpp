// SPDX-License-Identifier: GPL-3.0-or-later
// Draws furniture: lines and texts in one layer, and the boxes that pieces have.
#pragma once

#include "draw/drawing.hpp"
#include "map/map_facts.hpp"
#include "placing/furniture_room.hpp"

#include <initializer_list>
#include <string>
#include <utility>
#include <vector>

#include "lettering/lettering.hpp"

namespace orograph {

/// Borrows layer, letters and list.
class FurniturePen {
public:
  FurniturePen(Layer& layer, Lettering& lettering, std::vector<FurnitureFacts>& facts)
      : layer_(layer), lettering_(lettering), facts_(facts) {}

  /// On the page's step.
  void line(std::initializer_list<Vec2> points);
  /// A text in a row: that wide at most, its left end at the row's left side. Where it is cut, that
  /// is told. Returns its box.
  Box2 row(std::string text, double size_mm, Vec2 upper_left_mm, double most_mm,
           bool is_bold = false);
  /// The text as it would be drawn.
  PageText set(PageText text) { return lettering_.set(std::move(text)); }
  PageText set_within(PageText text, double most_mm) {
    return lettering_.set_within(std::move(text), most_mm);
  }
  /// REQUIRES that it is set.
  void add(PageText text) {
    now_.texts.push_back(text.text);
    layer_.texts.push_back(std::move(text));
  }
  /// The box of a piece, of which are all texts since the piece before it.
  void tell(const char* piece, const Box2& box_mm) {
    now_.piece = piece;
    now_.box_mm = box_mm;
    facts_.push_back(std::exchange(now_, {}));
  }
  /// A piece that isn't drawn.
  void leave_out(const char* piece) {
    now_.piece = piece;
    facts_.push_back(std::exchange(now_, {}));
  }

private:
  Layer& layer_;
  Lettering& lettering_;
  std::vector<FurnitureFacts>& facts_;
  FurnitureFacts now_; ///< the piece at work
};

} // namespace orograph
