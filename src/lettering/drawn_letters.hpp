// SPDX-License-Identifier: GPL-3.0-or-later
// Stroke letters beside Hershey's: those that a pair of others gives, those that look like another,
// and marks.
#pragma once

#include <span>
#include <string_view>

#include "lettering/stroke_font.hpp"

namespace orograph {

/// Lines as "x,y x,y; x,y x,y".
std::vector<std::vector<Vec2>> lines_of(std::string_view drawn);

struct DrawnLetter {
  char32_t character;
  double advance;
  std::string_view lines;

  StrokeGlyph glyph() const { return {advance, lines_of(lines)}; }
};
std::span<const DrawnLetter> drawn_letters();

/// A character that is drawn as another is, or as that as a small capital.
struct AlikeLetter {
  char32_t character, like;
  bool is_small_capital = false;
};
/// In an order in which those that others are like come first.
std::span<const AlikeLetter> alike_letters();

/// Where a mark stands on a letter.
enum class MarkPlace {
  above,  ///< its own 0, 0 in the middle above
  below,  ///< the same beneath
  across, ///< in the letter's middle
  behind, ///< to the upper right
};
struct StrokeMark {
  char32_t mark;
  MarkPlace place;
  std::string_view lines;
};
std::span<const StrokeMark> stroke_marks();

/// A letter that is another with a mark, though Unicode doesn't say so, as ø is.
struct MarkedLetter {
  char32_t character, base, mark;
};
std::span<const MarkedLetter> marked_letters();

} // namespace orograph
