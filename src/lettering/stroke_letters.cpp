// SPDX-License-Identifier: GPL-3.0-or-later
// Letters with marks, of the letter and the mark.
#include "geometry/box.hpp"

#include <algorithm>
#include <utility>

#include "lettering/drawn_letters.hpp"
#include "lettering/font_letters.hpp"
#include "lettering/stroke_font.hpp"

namespace orograph {
namespace {

constexpr double kGap = 3; // between a letter and a mark above it
constexpr double kSmallHeight = 14, kTall = 18;
constexpr char32_t kCaron = U'\u030c', kCedilla = U'\u0327';

Box2 box_of(const StrokeGlyph& glyph) {
  Box2 box;
  for (const auto& line : glyph.lines)
    for (const Vec2 p : line) box.include(p);
  if (box.empty()) box = {{0, 0}, {glyph.advance, kSmallHeight}};
  return box;
}

void add_lines(StrokeGlyph& glyph, std::string_view drawn, Vec2 at) {
  for (auto& line : lines_of(drawn)) {
    for (Vec2& p : line) p = p + at;
    glyph.lines.push_back(std::move(line));
  }
}

// As a letter with a mark above has it.
char32_t without_dot(char32_t letter) {
  return letter == U'i' || letter == U'і' ? U'ı' : letter == U'j' || letter == U'ј' ? U'ȷ' : letter;
}

// Tall small letters have a caron behind them, as an apostrophe; a small g a cedilla above.
bool add_in_its_own_way(char32_t base, char32_t mark, StrokeGlyph& glyph) {
  const Box2 box = box_of(glyph);
  if (mark == kCaron && (base == U'd' || base == U'l' || base == U't' || base == U'L')) {
    add_lines(glyph, "2,0 3,3 3,5", {box.high.x - (base == U'L' ? 5 : 0), 16});
    if (base != U'L') glyph.advance += 3;
    return true;
  }
  if (mark == kCedilla && base == U'g') {
    add_lines(glyph, "1,6 -1,3 -1,1 0,0 1,1 0,2", {box.centre().x, kSmallHeight + kGap});
    return true;
  }
  return false;
}

} // namespace

bool add_mark(char32_t mark, StrokeGlyph& glyph) {
  const auto known = stroke_marks();
  const auto found = std::ranges::find(known, mark, &StrokeMark::mark);
  if (found == known.end()) return false;
  const Box2 box = box_of(glyph);
  const double middle = box.centre().x;
  switch (found->place) {
  case MarkPlace::above:
    add_lines(glyph, found->lines, {middle, box.high.y + kGap});
    break;
  case MarkPlace::below: // what hangs below the line has it lower
    add_lines(glyph, found->lines, {middle, std::min(0.0, box.low.y)});
    break;
  case MarkPlace::across:
    add_lines(glyph, found->lines, {middle, box.centre().y});
    break;
  case MarkPlace::behind:
    add_lines(glyph, found->lines, {box.high.x - 1, box.high.y - 2});
    break;
  }
  return true;
}

bool stroke_glyph(const StrokeFont& font, char32_t character, StrokeGlyph& glyph) {
  if (const auto own = font.find(character); own != font.end()) {
    glyph = own->second;
    return true;
  }
  DecomposedCharacter parts = decomposed(character);
  const auto marked = marked_letters();
  if (const auto found = std::ranges::find(marked, character, &MarkedLetter::character);
      found != marked.end())
    parts = {found->base, found->mark};
  if (parts.mark == 0) return false;
  const auto mark = std::ranges::find(stroke_marks(), parts.mark, &StrokeMark::mark);
  if (mark == stroke_marks().end()) return false;
  const bool is_above = mark->place == MarkPlace::above;
  if (!stroke_glyph(font, is_above ? without_dot(parts.base) : parts.base, glyph)) return false;
  if (add_in_its_own_way(parts.base, parts.mark, glyph)) return true;
  if (mark->place == MarkPlace::across && box_of(glyph).high.y > kTall) {
    // A bar crosses a tall letter's stem.
    const Box2 box = box_of(glyph);
    const double stem = parts.base == U'd' ? box.high.x
                        : parts.base == U'T' || parts.base == U't' || parts.base == U'l' ||
                                parts.base == U'H' || parts.base == U'O'
                            ? box.centre().x
                            : box.low.x;
    const bool is_capital = character == U'Đ' || character == U'Ð' || parts.base == U'O' ||
                            parts.base == U'L' || parts.base == U'l';
    add_lines(glyph, mark->lines,
              {stem, is_capital           ? box.centre().y
                     : parts.base == U't' ? 8.0
                                          : 17.0});
    return true;
  }
  return add_mark(parts.mark, glyph);
}

} // namespace orograph
