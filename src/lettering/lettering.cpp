// SPDX-License-Identifier: GPL-3.0-or-later
#include "lettering/lettering.hpp"

#include "draw/round_drawing.hpp"
#include "text/printable.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>

#include "lettering/font_letters.hpp"
#include "lettering/stroke_font.hpp"

namespace orograph {
namespace {

// Of stroke letters, in ems: what marks on capitals and descenders need.
constexpr double kStrokeAscent = 0.95, kStrokeDescent = 0.25;
constexpr double kSlant = 0.2;          // of italics
constexpr double kPenOfEm = 0.04;       // a large text's strokes are so wide, over its size
constexpr double kLeastOfSize = 0.75;   // that a text is set smaller to have room
constexpr std::size_t kMostMissing = 8; // of characters that are told

constexpr std::string_view kReplacement = "\xEF\xBF\xBD";

std::string utf8_of(char32_t c) {
  std::string bytes;
  const auto add = [&](unsigned value) { bytes += static_cast<char>(value); };
  if (c < 0x80) {
    add(c);
  } else if (c < 0x800) {
    add(0xC0 | c >> 6);
    add(0x80 | (c & 0x3F));
  } else if (c < 0x10000) {
    add(0xE0 | c >> 12);
    add(0x80 | (c >> 6 & 0x3F));
    add(0x80 | (c & 0x3F));
  } else {
    add(0xF0 | c >> 18);
    add(0x80 | (c >> 12 & 0x3F));
    add(0x80 | (c >> 6 & 0x3F));
    add(0x80 | (c & 0x3F));
  }
  return bytes;
}

Vec2 rounded(Vec2 p) {
  return {rounded_to_page_step(p.x), rounded_to_page_step(p.y)};
}

// Adds what isn't there yet.
void add_once(std::string_view character, std::vector<std::string>& to) {
  if (std::ranges::find(to, character) == to.end()) to.emplace_back(character);
}

std::string list_of(const std::vector<std::string>& characters) {
  std::string list;
  for (std::size_t i = 0; i < std::min(characters.size(), kMostMissing); ++i)
    list += fmt::format("{}'{}'", i == 0 ? "" : " ", characters[i]);
  if (characters.size() > kMostMissing)
    list += fmt::format(" and {} others", characters.size() - kMostMissing);
  return list;
}

} // namespace

struct Lettering::Parts {
  LetterSpec spec;
  std::optional<FontLetters> font;
  std::optional<StrokeFont> strokes;
  std::vector<std::string> not_in_strokes, not_in_fonts, cut;

  FontLetters& font_letters() {
    if (!font) font.emplace(spec.family);
    return *font;
  }
  const StrokeFont& stroke_font() {
    if (!strokes) strokes = read_stroke_font(spec.stroke_folder);
    return *strokes;
  }
  // The text's glyphs, side by side; none where one of its characters has none.
  std::optional<StrokeGlyph> glyphs(std::string_view text, bool tells) {
    if (spec.kind != LetterKind::stroke || stroke_font().empty()) return std::nullopt;
    StrokeGlyph line;
    std::size_t last = 0; // where the last letter's lines begin
    bool has_all = true;
    StrokeGlyph glyph;
    double at = 0;
    for (const char32_t character : characters_of(text)) {
      StrokeGlyph next;
      if (stroke_glyph(stroke_font(), character, next)) {
        at += glyph.advance;
        glyph = std::move(next);
      } else if (StrokeGlyph with = glyph; !line.lines.empty() && add_mark(character, with)) {
        line.lines.resize(last); // the letter is drawn again, with its mark
        glyph = std::move(with);
      } else {
        has_all = false;
        if (tells) add_once(utf8_of(character), not_in_strokes);
        continue;
      }
      last = line.lines.size();
      for (auto strokes_of : glyph.lines) {
        for (Vec2& p : strokes_of) p.x += at;
        line.lines.push_back(std::move(strokes_of));
      }
    }
    line.advance = at + glyph.advance;
    return has_all ? std::optional(std::move(line)) : std::nullopt;
  }
  void measure(PageText& text, bool tells) {
    const double size_mm = text.size_mm;
    if (const auto line = glyphs(text.text, tells)) {
      text.extent = {line->advance / kStrokeUnitsPerEm * size_mm, kStrokeAscent * size_mm,
                     kStrokeDescent * size_mm};
      return;
    }
    FontLetters& letters = font_letters();
    const FontExtent of = letters.extent(text.text, text.is_bold, text.is_italic);
    if (tells)
      for (const char32_t missing : characters_of(letters.missing_of(text.text)))
        add_once(utf8_of(missing), not_in_fonts);
    text.extent = {of.width * size_mm, of.ascent * size_mm, of.descent * size_mm};
    text.runs_leftwards = of.runs_leftwards;
  }
};

std::string on_one_line(std::string_view text) {
  std::string line;
  for (std::size_t at = 0; at < text.size();) {
    const auto first = static_cast<unsigned char>(text[at]);
    const std::size_t bytes = first < 0x80                    ? 1
                              : first >= 0xC2 && first < 0xE0 ? 2
                              : first >= 0xE0 && first < 0xF0 ? 3
                              : first >= 0xF0 && first < 0xF5 ? 4
                                                              : 0;
    bool is_whole = bytes > 0 && at + bytes <= text.size();
    for (std::size_t i = 1; is_whole && i < bytes; ++i)
      is_whole = (static_cast<unsigned char>(text[at + i]) & 0xC0) == 0x80;
    if (!is_whole) {
      line += kReplacement;
      ++at;
      continue;
    }
    const std::string_view character = text.substr(at, bytes);
    const char32_t code = characters_of(character).front();
    at += bytes;
    const bool is_control =
        code < 0x20 || (code >= 0x7F && code < 0xA0) || code == 0x2028 || code == 0x2029;
    const bool is_none = (bytes == 3 && code < 0x800) || (bytes == 4 && code < 0x10000) ||
                         (code >= 0xD800 && code < 0xE000) || (code & 0xFFFE) == 0xFFFE ||
                         code > 0x10FFFF;
    if (is_control)
      line += ' ';
    else
      line += is_none ? kReplacement : character;
  }
  const std::size_t begin = line.find_first_not_of(' ');
  if (begin == std::string::npos) return {};
  return line.substr(begin, line.find_last_not_of(' ') - begin + 1);
}

Lettering::Lettering(const LetterSpec& spec) : parts_(std::make_unique<Parts>()) {
  parts_->spec = spec;
}
Lettering::~Lettering() = default;
Lettering::Lettering(Lettering&&) noexcept = default;
Lettering& Lettering::operator=(Lettering&&) noexcept = default;

const LetterSpec& Lettering::spec() const {
  return parts_->spec;
}

PageText Lettering::set(PageText text) {
  text.text = on_one_line(text.text);
  text.at_mm = rounded(text.at_mm);
  parts_->measure(text, true);
  return text;
}

PageText Lettering::set_within(PageText text, double most_mm) {
  text = set(std::move(text));
  if (text.extent.width_mm <= most_mm) return text;
  const double share = std::max(kLeastOfSize, most_mm / text.extent.width_mm);
  // Rounded down, so that it fits.
  text.size_mm = std::floor(share * text.size_mm * 100) / 100;
  parts_->measure(text, false);
  if (text.extent.width_mm <= most_mm) return text;
  add_once(shortened(printable(text.text), 100), parts_->cut);
  const std::u32string characters = characters_of(text.text);
  // The longest beginning that fits: widths rise with letters, but for ligatures.
  std::size_t fits = 0, too_many = characters.size();
  std::optional<PageText> best;
  while (fits + 1 < too_many) {
    const std::size_t count = fits + (too_many - fits) / 2;
    std::string begun;
    for (const char32_t c : characters.substr(0, count)) begun += utf8_of(c);
    while (begun.ends_with(' ')) begun.pop_back();
    PageText tried = text;
    tried.text = begun + "…";
    parts_->measure(tried, false);
    if (tried.extent.width_mm <= most_mm) {
      best = std::move(tried);
      fits = count;
    } else {
      too_many = count;
    }
  }
  if (best) return *best;
  text.text.clear();
  parts_->measure(text, false);
  return text;
}

void Lettering::draw(const PageText& text, Layer& layer) {
  if (text.text.empty()) return;
  const Vec2 start = text.start_mm(), along{cos(text.angle), -sin(text.angle)};
  const Vec2 down{-along.y, along.x};
  const auto strokes = parts_->glyphs(text.text, true);
  // y of stroke letters is up, of outlines down.
  const double scale = strokes ? text.size_mm / kStrokeUnitsPerEm : text.size_mm;
  const double sign = strokes ? -1 : 1;
  const double slant = strokes && text.is_italic ? kSlant : 0;
  const auto lines = strokes
                         ? strokes->lines
                         : parts_->font_letters().outlines(text.text, text.is_bold, text.is_italic);
  const double pen_mm =
      0.01 * std::floor(100 * kPenOfEm * text.size_mm * (strokes && text.is_bold ? 1.6 : 1));
  for (const auto& line : lines) {
    Stroke stroke{.first_point = static_cast<std::uint32_t>(layer.page_mm.size()),
                  .feature = text.feature};
    if (strokes && pen_mm > layer.pen_width_mm) stroke.width_mm = pen_mm;
    for (const Vec2 p : line) {
      const Vec2 at =
          rounded(start + scale * (p.x + slant * p.y) * along + scale * sign * p.y * down);
      const bool is_first = layer.page_mm.size() == stroke.first_point;
      if (is_first || layer.page_mm.back() != at) layer.page_mm.push_back(at);
    }
    stroke.point_count = static_cast<std::uint32_t>(layer.page_mm.size()) - stroke.first_point;
    if (stroke.point_count < 2)
      layer.page_mm.resize(stroke.first_point);
    else
      layer.strokes.push_back(stroke);
  }
}

std::vector<std::string> Lettering::notes() const {
  std::vector<std::string> notes;
  const LetterSpec& spec = parts_->spec;
  std::string family = spec.family;
  if (parts_->font) {
    const std::string other = parts_->font->replaced_by();
    if (!other.empty()) {
      notes.push_back(fmt::format("the font '{}' isn't there: texts are in {}", family, other));
      family = other;
    }
  }
  if (parts_->strokes && parts_->strokes->empty())
    notes.push_back(fmt::format("there are no stroke letters in {} (Debian's package "
                                "hershey-fonts-data): texts are outlines of {}",
                                spec.stroke_folder, family));
  if (!parts_->not_in_strokes.empty())
    notes.push_back(fmt::format("stroke letters lack {}: texts with them are outlines of {}",
                                list_of(parts_->not_in_strokes), family));
  if (!parts_->not_in_fonts.empty())
    notes.push_back(
        fmt::format("no font here has {}: boxes stand for them", list_of(parts_->not_in_fonts)));
  if (!parts_->cut.empty())
    notes.push_back(fmt::format("there is no room for all of {}", list_of(parts_->cut)));
  return notes;
}

void texts_to_strokes(Drawing& drawing, Lettering& lettering) {
  for (Layer& layer : drawing.layers) {
    for (const PageText& text : layer.texts) lettering.draw(text, layer);
    layer.texts.clear();
    drop_repeated_strokes(layer);
  }
}

} // namespace orograph
