// SPDX-License-Identifier: GPL-3.0-or-later
// The letters of all that is written on a page.
#include "cli/options/check_lettering.hpp"
#include "cli/options/option_groups.hpp"

#include <utility>
#include <vector>

namespace orograph {
namespace {

constexpr auto kGroup = "Letters";

} // namespace

void add_lettering_options(std::vector<Option>& options, RenderSettings& s) {
  LetterSpec& letters = s.map.letters;
  options.push_back(
      with_choice({.group = kGroup,
                   .name = "--text",
                   .help = "Letters of a font, or single strokes, as a pen draws them",
                   .by_default = "font; stroke in formats for devices and CAD, with "
                                 "pens, and where paper is cut"},
                  std::vector<std::pair<std::string, std::optional<LetterKind>>>{
                      {"font", LetterKind::font}, {"stroke", LetterKind::stroke}},
                  s.text));
  options.push_back({.group = kGroup,
                     .name = "--font",
                     .value = "FAMILY",
                     .help = "Font of texts, and of what stroke letters lack; what isn't there is "
                             "replaced, and that is said",
                     .allowed = "a font's name, as fc-list gives it",
                     .by_default = letters.family,
                     .take = [&letters](const std::string& text) {
                       letters.family = text;
                       return !text.empty();
                     }});
  options.push_back({.group = kGroup,
                     .name = "--stroke-letters",
                     .value = "FOLDER",
                     .help = "Where stroke letters are, Hershey's .jhf files",
                     .by_default = letters.stroke_folder,
                     .take = stored_name(letters.stroke_folder)});
}

void check_lettering(RenderSettings& settings) {
  const bool is_cut = settings.sheets || settings.clip_to_mm;
  const bool is_for_pen = has_one_width(settings.write.format) || !settings.pens.empty() || is_cut;
  settings.map.letters.kind =
      has_one_width(settings.write.format)
          ? LetterKind::stroke
          : settings.text.value_or(is_for_pen ? LetterKind::stroke : LetterKind::font);
}

} // namespace orograph
