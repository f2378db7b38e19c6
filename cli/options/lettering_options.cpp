// SPDX-License-Identifier: GPL-3.0-or-later
// The letters of all that is written on a page, and what stands around a picture.
#include "cli/options/check_settings.hpp"
#include "cli/options/option_group.hpp"
#include "cli/options/option_groups.hpp"
#include "geometry/error.hpp"
#include "map/check_spec.hpp"
#include "placing/template_file.hpp"
#include "text/words.hpp"
#include "write/write_drawing.hpp"

#include <fmt/format.h>

#include <string>
#include <utility>
#include <vector>

namespace orograph {
namespace {

void add_furniture_options(OptionGroup& group, RenderSettings& s) {
  std::vector<std::string> words{"none", "map", "panorama"};
  words.insert(words.end(), furniture_names().begin(), furniture_names().end());
  group
      .value("--furniture LIST",
             "What stands around the picture, which leaves it room. The title is --title, if one "
             "is given",
             fmt::format("none, or some of map, panorama, {}", joined(furniture_names(), ", ")),
             "nothing, and the picture has all of the page",
             [&s](const std::string& text) {
               s.map.furniture.pieces = furniture_of(text, "--furniture");
               return true;
             })
      .words(words);
  group.text("--subtitle TEXT", "Second line of the title", "", s.map.furniture.subtitle);
  group.text("--source TEXT", "Where the data are from, as furniture prints it", "",
             s.map.furniture.source);
  group.text("--date TEXT", "Date that furniture prints behind the source", "",
             s.map.furniture.date);
  group
      .name("--template FILE",
            "Furniture, texts, sizes and fonts from a TOML file (docs/letters.md); options go "
            "before what it says",
            "a file name", "", s.template_file)
      .files({"toml"});
}

// What no option says.
void take_template(RenderSettings& s, const GivenOptions& given) {
  if (s.template_file.empty()) return;
  const Template from = read_template(s.template_file);
  FurnitureSpec& furniture = s.map.furniture;
  const auto take = [&](const char* option, const auto& value, auto& into) {
    if (value && !given.contains(option)) into = *value;
  };
  take("--furniture", from.pieces, furniture.pieces);
  take("--title", from.title, s.map.title);
  take("--subtitle", from.subtitle, furniture.subtitle);
  take("--source", from.source, furniture.source);
  take("--date", from.date, furniture.date);
  take("--font", from.font, s.map.letters.family);
  take("--text", from.letters, s.text);
  take("", from.title_mm, furniture.title_mm); // no option says these
  take("", from.subtitle_mm, furniture.subtitle_mm);
  take("", from.text_mm, furniture.text_mm);
  take("", from.gap_mm, furniture.gap_mm);
}

void check_printed(RenderSettings& s, const GivenOptions& given) {
  FurnitureSpec& furniture = s.map.furniture;
  if (is_tied_to_ground(s.write.format)) { // which has no page
    if (furniture.any())
      refuse(given, "--furniture", "in a format tied to the ground, which has no page",
             "leave it out, or write a picture, as in --of svg");
    furniture.pieces.clear();
  }
  for (const auto& [option, piece] :
       {std::pair{"--subtitle", Furniture::subtitle}, std::pair{"--source", Furniture::source},
        std::pair{"--date", Furniture::source}})
    if (insists_on(given, option) && !furniture.has(piece) && !is_tied_to_ground(s.write.format))
      throw UsageError(fmt::format("{} is printed nowhere", option),
                       fmt::format("give --furniture map, panorama, or a list with {}",
                                   furniture_names()[static_cast<std::size_t>(piece)]));
}

} // namespace

void add_lettering_options(std::vector<Option>& options, RenderSettings& s) {
  OptionGroup group(options, "Letters and furniture");
  LetterSpec& letters = s.map.letters;
  group.choice("--text", "Letters of a font, or single strokes, as a pen draws them",
               {{"font", LetterKind::font}, {"stroke", LetterKind::stroke}}, s.text,
               "font; stroke in formats for devices and CAD, with pens, and where paper is cut");
  group.name("--font FAMILY",
             "Font of texts, and of what stroke letters lack; what isn't there is replaced, and "
             "that is said",
             "a font's name, as fc-list gives it",
             letters.family + ", which Debian has in fonts-dejavu-core", letters.family);
  group.name("--stroke-letters FOLDER", "Where stroke letters are, Hershey's .jhf files", "",
             letters.stroke_folder + ", as Debian has them", letters.stroke_folder);
  add_furniture_options(group, s);
}

void check_lettering(RenderSettings& settings, const GivenOptions& given) {
  take_template(settings, given);
  check_printed(settings, given);
  check_furniture(settings.map);
  const bool is_cut = settings.sheets || settings.clip_to_mm;
  const bool is_for_pen = has_one_width(settings.write.format) || !settings.pens.empty() || is_cut;
  settings.map.letters.kind =
      has_one_width(settings.write.format)
          ? LetterKind::stroke
          : settings.text.value_or(is_for_pen ? LetterKind::stroke : LetterKind::font);
}

} // namespace orograph
