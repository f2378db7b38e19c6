// SPDX-License-Identifier: GPL-3.0-or-later
// Letters of fonts, by Pango: sizes, outlines, and texts on a Cairo surface.
#pragma once

#include "draw/page_text.hpp"

#include <memory>
#include <string>
#include <string_view>
#include <vector>

struct _cairo; // Cairo's own name for what it calls cairo_t

namespace orograph {

/// What a text is, in ems.
struct FontExtent {
  double width = 0;
  double ascent = 0, descent = 0; ///< the font's
  bool runs_leftwards = false;    ///< its first letter with a direction
};

/// Of one family. In one thread at a time. Bold and italic are the family's, or made of it.
class FontLetters {
public:
  explicit FontLetters(const std::string& family);
  ~FontLetters();
  FontLetters(FontLetters&&) noexcept;
  FontLetters& operator=(FontLetters&&) noexcept;

  FontExtent extent(std::string_view text, bool is_bold, bool is_italic);
  /// Closed outlines of its letters in ems, from the left end of its baseline, y down, curves made
  /// straight within a thousandth.
  std::vector<std::vector<Vec2>> outlines(std::string_view text, bool is_bold, bool is_italic);
  /// Draws it with the pen's source, `scale` being its units to a millimetre. The pen's matrix is
  /// as it was.
  void draw(::_cairo* pen, const PageText& text, double scale);
  /// Of `text`, those characters that no font here has, each once.
  std::string missing_of(std::string_view text);
  /// The family that is drawn where the one asked for isn't there; else empty.
  std::string replaced_by() const;

private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

/// A character as a base and the mark above or below it; no mark where it has none.
struct DecomposedCharacter {
  char32_t base = 0, mark = 0;
};
DecomposedCharacter decomposed(char32_t character);

} // namespace orograph
