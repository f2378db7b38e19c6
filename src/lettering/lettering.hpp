// SPDX-License-Identifier: GPL-3.0-or-later
// Texts on a page: how large they are, and what a pen draws of them.
#pragma once

#include "draw/drawing.hpp"
#include "draw/page_text.hpp"

#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace orograph {

/// The text as it is drawn on one line: UTF-8 without controls. Bytes that aren't are U+FFFD, line
/// breaks and other controls blanks, and there are none at its ends.
std::string on_one_line(std::string_view text);

/// Letters of one kind. It reads its font when it first needs it; in one thread at a time.
class Lettering {
public:
  /// Throws nothing: a font that isn't there is replaced, and a folder of stroke letters that isn't
  /// there too, by outlines of the font. `notes` tells of both.
  explicit Lettering(const LetterSpec& spec);
  ~Lettering();
  Lettering(Lettering&&) noexcept;
  Lettering& operator=(Lettering&&) noexcept;

  const LetterSpec& spec() const;

  /// The text on one line, its place on the page's step, its extent as its letters are. An empty
  /// one has no width.
  PageText set(PageText text);
  /// The same with no more letters than `most_mm` has room for: it is set smaller, down to three
  /// quarters, and then ends with "…". Empty where not even that has room.
  PageText set_within(PageText text, double most_mm);

  /// Adds what a pen draws of a text that is set, on the page's step: single strokes where
  /// `spec().kind` says so and the stroke letters have all of its characters; else outlines.
  void draw(const PageText& text, Layer& layer);

  /// A sentence each: which font is replaced by which, which characters are set as outlines, which
  /// no font has. Of what was set up to now.
  std::vector<std::string> notes() const;

private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

/// Makes strokes of all of a drawing's texts, as `Lettering::draw` does with stroke letters, in
/// their layers.
void texts_to_strokes(Drawing& drawing, Lettering& lettering);

} // namespace orograph
