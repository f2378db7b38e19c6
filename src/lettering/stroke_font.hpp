// SPDX-License-Identifier: GPL-3.0-or-later
// Single-stroke letters from Hershey's fonts, which Dr. A. V. Hershey made at the U. S. National
// Bureau of Standards; their files have the format of James Hurt, Cognition, Inc.
#pragma once

#include "geometry/vec.hpp"

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace orograph {

/// Units in which stroke letters are drawn: capitals are 21 high, small ones 14, x is from the
/// letter's left side and y up from the baseline.
struct StrokeGlyph {
  double advance = 0;
  std::vector<std::vector<Vec2>> lines;
};
constexpr double kStrokeUnitsPerEm = 30;

/// By their characters.
using StrokeFont = std::map<char32_t, StrokeGlyph>;

/// Reads a file of glyphs; its first is a blank, and the others follow as ASCII has them. Empty
/// where the file isn't there or isn't such a file.
std::map<char, StrokeGlyph> read_hershey(const std::string& path);

/// Letters of Europe's alphabets from a folder with Hershey's files: Latin, Greek and Cyrillic
/// ones, figures, punctuation. Latin letters with marks aren't in it: `stroke_glyph` composes them.
/// Empty where the folder has no Latin letters.
StrokeFont read_stroke_font(const std::string& folder);

/// A character's glyph, with its marks set on it; false where the font has none.
bool stroke_glyph(const StrokeFont& font, char32_t character, StrokeGlyph& glyph);

/// Sets a combining mark on a glyph; false where it is none that is known.
bool add_mark(char32_t mark, StrokeGlyph& glyph);

/// A text's characters. REQUIRES valid UTF-8.
std::u32string characters_of(std::string_view text);

} // namespace orograph
