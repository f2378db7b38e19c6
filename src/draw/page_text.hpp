// SPDX-License-Identifier: GPL-3.0-or-later
// A line of text on a page, and what its letters are.
#pragma once

#include "geometry/angle.hpp"
#include "geometry/box.hpp"
#include "geometry/vec.hpp"

#include <array>
#include <cstdint>
#include <string>

namespace orograph {

/// Letters of a font, filled; or single strokes, as a pen draws them.
enum class LetterKind { font, stroke };

/// What letters a drawing's texts have.
struct LetterSpec {
  LetterKind kind = LetterKind::font;
  std::string family = "DejaVu Sans"; ///< of fonts, as fontconfig knows them
  /// Where stroke letters are read from, as Debian's package hershey-fonts-data has them.
  std::string stroke_folder = "/usr/share/hershey-fonts";
};

/// Which point of its baseline a text has at its place.
enum class TextAnchor { start, middle, end };

/// How large a text is on the page, along its baseline and across.
struct TextExtent {
  double width_mm = 0;
  double ascent_mm = 0, descent_mm = 0; ///< above and below the baseline, the same for all texts of
                                        ///< a size; both above 0
};

/// One line of text. `Lettering::set` (lettering/lettering.hpp) makes it ready for the page: then
/// its text is valid UTF-8 without controls, its place on the page's step, and its extent is known.
struct PageText {
  std::string text;
  Vec2 at_mm;           ///< on the baseline: left end, middle or right end, by `anchor`
  double size_mm = 2.5; ///< the em; capitals are 0.7 of it high, small letters 0.5
  Angle angle = {};     ///< counterclockwise from the page's right: 60 degrees climbs
  TextAnchor anchor = TextAnchor::start;
  bool is_bold = false, is_italic = false;
  std::int32_t feature = -1; ///< number of its layer's; -1: none
  TextExtent extent = {};
  bool runs_leftwards = false; ///< as Arabic and Hebrew do; its start is on the left all the same

  /// The left end of its baseline.
  Vec2 start_mm() const;
  /// The corners of its box on the page, from the upper left one of its own clockwise.
  std::array<Vec2, 4> corners_mm() const;
  /// Of its corners, with the page's sides.
  Box2 box_mm() const;
  /// The same larger or smaller, about the page's corner.
  void scale(double factor);
};

} // namespace orograph
