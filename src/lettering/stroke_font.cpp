// SPDX-License-Identifier: GPL-3.0-or-later
#include "lettering/stroke_font.hpp"

#include "text/words.hpp"

#include <algorithm>
#include <cstddef>
#include <fstream>
#include <optional>
#include <sstream>
#include <utility>

#include "lettering/drawn_letters.hpp"

namespace orograph {
namespace {

constexpr double kBaseline = 9; // below the middle of a glyph's height, in the files
constexpr std::size_t kMostGlyphs = 200, kMostBytes = 1 << 20;
constexpr double kSmallOfCapital = 14.0 / 21;

int of_letter(char c) {
  return static_cast<unsigned char>(c) - 'R';
}

// "12345 11KYVBTD…": a number, how many pairs follow, and the pairs, of which the first is the left
// and the right side.
std::optional<StrokeGlyph> glyph_of(std::string_view pairs) {
  if (pairs.size() < 2) return std::nullopt;
  const double left = of_letter(pairs[0]), right = of_letter(pairs[1]);
  if (right < left) return std::nullopt;
  StrokeGlyph glyph{right - left, {}};
  bool is_down = false;
  for (std::size_t i = 2; i + 1 < pairs.size(); i += 2) {
    if (pairs.substr(i, 2) == " R") {
      is_down = false;
      continue;
    }
    if (!is_down) glyph.lines.emplace_back();
    is_down = true;
    glyph.lines.back().push_back({of_letter(pairs[i]) - left, kBaseline - of_letter(pairs[i + 1])});
  }
  std::erase_if(glyph.lines, [](const auto& line) { return line.size() < 2; });
  return glyph;
}

std::string bytes_of_file(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::string bytes(kMostBytes, '\0');
  file.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  bytes.resize(static_cast<std::size_t>(file.gcount()));
  return bytes;
}

StrokeGlyph smaller(StrokeGlyph glyph) {
  glyph.advance *= kSmallOfCapital;
  for (auto& line : glyph.lines)
    for (Vec2& p : line) p = kSmallOfCapital * p;
  return glyph;
}

} // namespace

std::map<char, StrokeGlyph> read_hershey(const std::string& path) {
  std::map<char, StrokeGlyph> glyphs;
  std::istringstream lines(bytes_of_file(path));
  std::string line;
  for (char name = ' '; name < '\x7f' && std::getline(lines, line); ++name) {
    if (line.size() < 8) return {};
    std::string_view number = std::string_view(line).substr(5, 3);
    const auto pairs = number_of<std::size_t>(next_word(number));
    if (!pairs || *pairs > kMostGlyphs) return {};
    std::string rest = line.substr(8);
    while (rest.size() < 2 * *pairs && std::getline(lines, line)) rest += line;
    const auto glyph = glyph_of(std::string_view(rest).substr(0, 2 * *pairs));
    if (!glyph) return {};
    glyphs[name] = *glyph;
  }
  return glyphs;
}

StrokeFont read_stroke_font(const std::string& folder) {
  StrokeFont font;
  for (auto& [name, glyph] : read_hershey(folder + "/futural.jhf"))
    font[static_cast<char32_t>(name)] = std::move(glyph);
  if (font.empty()) return font;
  // Alpha to omega stand on A to X and a to x; a final sigma isn't among them.
  constexpr char32_t kAlpha = U'Α', kSmallAlpha = U'α', kFinalSigma = U'ς' - kSmallAlpha;
  for (auto& [name, glyph] : read_hershey(folder + "/greeks.jhf")) {
    const bool is_small = name >= 'a' && name <= 'x';
    if (!is_small && !(name >= 'A' && name <= 'X')) continue;
    char32_t place = static_cast<char32_t>(name - (is_small ? 'a' : 'A'));
    if (place >= kFinalSigma) ++place;
    font[(is_small ? kSmallAlpha : kAlpha) + place] = std::move(glyph);
  }
  for (const DrawnLetter& letter : drawn_letters()) font[letter.character] = letter.glyph();
  for (const AlikeLetter& alike : alike_letters())
    if (const auto like = font.find(alike.like); like != font.end())
      font[alike.character] = alike.is_small_capital ? smaller(like->second) : like->second;
  return font;
}

std::u32string characters_of(std::string_view text) {
  std::u32string characters;
  for (std::size_t at = 0; at < text.size();) {
    const auto first = static_cast<unsigned char>(text[at]);
    const std::size_t bytes = first < 0x80 ? 1 : first < 0xE0 ? 2 : first < 0xF0 ? 3 : 4;
    char32_t character = bytes == 1 ? first : first & (0x7FU >> bytes);
    for (std::size_t i = 1; i < bytes && at + i < text.size(); ++i)
      character = character << 6 | (static_cast<unsigned char>(text[at + i]) & 0x3FU);
    characters += character;
    at += bytes;
  }
  return characters;
}

} // namespace orograph
