// SPDX-License-Identifier: GPL-3.0-or-later
// Texts of all sorts: on one line, as large as they say, within their room, and what letters there
// are none of is told.
#include "draw/round_drawing.hpp"
#include "tests/catch.hpp"
#include "tests/support/random.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "lettering/lettering.hpp"
#include "lettering/stroke_font.hpp"

namespace orograph::lettering_test {
namespace {

const std::vector<std::string> kTexts{
    "Piz Palü",
    "L'Aiguille \"Verte\" <&> 4122",
    "Łódź, Žďár, Győr, Țepeș, Đà Nẵng, Þingvellir, Straße, Æbelø",
    "Όλυμπος Эльбрус",
    "הר חרמון 2814",
    "جبل توبقال",
    "富士山",
    "⛰ 🏔",
    "a\tb\nc\rd",
    std::string("nul\0in it", 9),
    "bytes \xFF\xC3 that aren't UTF-8",
    "\xED\xA0\x80",
    "",
    "   ",
    std::string(300, 'W'),
};

LetterSpec letters_of(LetterKind kind) {
  LetterSpec spec;
  spec.kind = kind;
  return spec;
}

bool says(const std::vector<std::string>& notes, const std::string& words) {
  return std::any_of(notes.begin(), notes.end(), [&](const std::string& note) {
    return note.find(words) != std::string::npos && note.find('\n') == std::string::npos;
  });
}

// The farthest that a point is outside of a text's box, in the text's own directions.
double outside_mm(const PageText& text, const Layer& layer) {
  const Vec2 along{cos(text.angle), -sin(text.angle)}, down{-along.y, along.x};
  double most = -1e9;
  for (const Vec2 p : layer.page_mm) {
    const Vec2 off = p - text.start_mm();
    const double x = dot(off, along), y = dot(off, down);
    most = std::max({most, -x, x - text.extent.width_mm, -y - text.extent.ascent_mm,
                     y - text.extent.descent_mm});
  }
  return most;
}

} // namespace

TEST_CASE("A text on one line has no controls and no bytes that aren't UTF-8") {
  CHECK(on_one_line("a\tb\nc\rd") == "a b c d");
  CHECK(on_one_line(std::string("a\0b", 3)) == "a b");
  CHECK(on_one_line("  a  ") == "a");
  CHECK(on_one_line("\n") == "");
  CHECK(on_one_line("\xFFx") == "\xEF\xBF\xBDx");
  CHECK(on_one_line("\xC3") == "\xEF\xBF\xBD");
  CHECK(on_one_line("\xED\xA0\x80").find("\xED\xA0") == std::string::npos); // half of a pair
  CHECK(on_one_line("\xEF\xBF\xBE") == "\xEF\xBF\xBD");                     // no character
  CHECK(on_one_line("Grüße \"<&>'") == "Grüße \"<&>'");
}

TEST_CASE("A text is as large as it says, in both kinds of letters and at any angle") {
  for (const LetterKind kind : {LetterKind::font, LetterKind::stroke}) {
    Lettering lettering(letters_of(kind));
    for (const std::string& raw : kTexts)
      for (const double angle_deg : {0.0, 60.0, -90.0}) {
        const PageText text = lettering.set({.text = raw,
                                             .at_mm = {50.00004, 60},
                                             .size_mm = 3,
                                             .angle = Angle::degrees(angle_deg),
                                             .anchor = TextAnchor::middle});
        INFO(text.text);
        CHECK(text.at_mm.x == 50);
        CHECK(std::isfinite(text.extent.width_mm));
        CHECK(text.extent.ascent_mm > 0);
        CHECK(text.extent.descent_mm > 0);
        CHECK((text.extent.width_mm > 0) == !text.text.empty());
        const PageText twice =
            lettering.set({.text = raw, .at_mm = {0, 0}, .size_mm = 6, .anchor = TextAnchor::end});
        CHECK(std::abs(twice.extent.width_mm - 2 * text.extent.width_mm) < 1e-3);
        Layer layer;
        lettering.draw(text, layer);
        CHECK(layer.strokes.empty() == text.text.empty());
        // Outlines of a fallback's letters, and a swash, may reach beyond their font's own height.
        if (!layer.page_mm.empty()) CHECK(outside_mm(text, layer) < 0.3 * text.size_mm);
        for (const Vec2 p : layer.page_mm) {
          CHECK(rounded_to_page_step(p.x) == p.x);
          CHECK(rounded_to_page_step(p.y) == p.y);
        }
      }
  }
}

TEST_CASE("Capitals of both kinds are about as high") {
  for (const LetterKind kind : {LetterKind::font, LetterKind::stroke}) {
    Lettering lettering(letters_of(kind));
    Layer layer;
    lettering.draw(lettering.set({.text = "H", .at_mm = {0, 100}, .size_mm = 10}), layer);
    double top = 100;
    for (const Vec2 p : layer.page_mm) top = std::min(top, p.y);
    CHECK(100 - top > 6.8);
    CHECK(100 - top < 7.5);
  }
}

TEST_CASE("Europe's letters are strokes, those with marks their letters' own and the marks'") {
  const StrokeFont font = read_stroke_font(LetterSpec().stroke_folder);
  REQUIRE(font.size() > 95);
  for (const char32_t character :
       characters_of("AZaz09 ÀÁÂÃÄÅÆÇÈÉÊËÌÍÎÏÐÑÒÓÔÕÖØÙÚÛÜÝÞßàáâãäåæçèéêëìíîïðñòóôõöøùúûüýþÿ"
                     "ĀāĂăĄąĆćČčĎďĐđĒēĖėĘęĚěĞğĢģĦħĪīĮįİıĶķĹĺĻļĽľŁłŃńŅņŇňŌōŐőŒœŔŕŘřŚśŞşŠšŢţŤťŪūŮů"
                     "ŰűŲųŴŵŶŷŸŹźŻżŽžȘșȚțẸẹếệơƯ–—‘’“”„«»…·°′″×±−€"
                     "ΑΒΓΔΕΖΗΘΙΚΛΜΝΞΟΠΡΣΤΥΦΧΨΩαβγδεζηθικλμνξοπρςστυφχψωάέήίόύώ"
                     "АБВГДЕЖЗИЙКЛМНОПРСТУФХЦЧШЩЪЫЬЭЮЯЁЇЄІабвгдежзийклмнопрстуфхцчшщъыьэюяёїєі")) {
    StrokeGlyph glyph;
    INFO("U+" << static_cast<unsigned>(character));
    REQUIRE(stroke_glyph(font, character, glyph));
    CHECK(glyph.advance > 0);
    CHECK(glyph.lines.empty() == (character == U' '));
  }
  StrokeGlyph e, with;
  REQUIRE(stroke_glyph(font, U'e', e));
  REQUIRE(stroke_glyph(font, U'é', with));
  CHECK(with.advance == e.advance);
  REQUIRE(with.lines.size() == e.lines.size() + 1);
  for (const Vec2 p : with.lines.back()) CHECK(p.y > 14); // above a small letter
  StrokeGlyph none;
  CHECK_FALSE(stroke_glyph(font, U'富', none));
}

TEST_CASE("A mark of its own goes to the letter before it") {
  Lettering lettering(letters_of(LetterKind::stroke));
  Layer composed, apart;
  lettering.draw(lettering.set({.text = "né", .at_mm = {0, 50}}), composed);
  lettering.draw(lettering.set({.text = "ne\u0301", .at_mm = {0, 50}}), apart);
  CHECK((composed.page_mm == apart.page_mm));
  CHECK(lettering.notes().empty());
}

TEST_CASE("What letters there are none of is told in a line, and something is drawn") {
  LetterSpec spec = letters_of(LetterKind::stroke);
  spec.family = "No Such Font";
  Lettering lettering(spec);
  Layer layer;
  lettering.draw(lettering.set({.text = "Mt 富", .at_mm = {50, 50}}), layer);
  CHECK(layer.strokes.size() > 3);
  CHECK(says(lettering.notes(), "stroke letters lack '富'"));
  CHECK(says(lettering.notes(), "the font 'No Such Font' isn't there"));
  CHECK_FALSE(says(lettering.notes(), "'M'"));

  Lettering font(letters_of(LetterKind::font));
  font.set({.text = "\U00010FFF\U00010FFF", .at_mm = {}}); // a place that no font fills
  CHECK(says(font.notes(), "no font here has '\U00010FFF'"));

  spec.stroke_folder = "/no/such/folder";
  Lettering without(spec);
  Layer outlines;
  without.draw(without.set({.text = "Mt", .at_mm = {50, 50}}), outlines);
  CHECK(outlines.strokes.size() == 2); // closed
  CHECK(says(without.notes(), "no stroke letters in /no/such/folder"));
}

TEST_CASE("A text that has too little room is set smaller, and then cut, which is told") {
  for (const LetterKind kind : {LetterKind::font, LetterKind::stroke}) {
    Lettering lettering(letters_of(kind));
    Random random(1);
    for (int i = 0; i < rounds(200); ++i) {
      const std::string& raw =
          kTexts[static_cast<std::size_t>(random.whole(0, static_cast<int>(kTexts.size()) - 1))];
      const double most_mm = random.between(0.1, 60);
      const PageText text =
          lettering.set_within({.text = raw, .at_mm = {10, 10}, .size_mm = 3}, most_mm);
      INFO(raw << " in " << most_mm);
      CHECK(text.extent.width_mm <= most_mm);
      CHECK(text.size_mm >= 0.74 * 3);
      if (text.text != on_one_line(raw)) CHECK((text.text.empty() || text.text.ends_with("…")));
    }
    CHECK(says(lettering.notes(), "there is no room for all of"));
    Lettering other(letters_of(kind));
    const PageText whole = other.set({.text = "A few words", .at_mm = {10, 10}, .size_mm = 3});
    const PageText smaller = other.set_within(
        {.text = "A few words", .at_mm = {10, 10}, .size_mm = 3}, 0.8 * whole.extent.width_mm);
    CHECK(smaller.text == "A few words");
    CHECK(smaller.size_mm < 3);
    CHECK(other.notes().empty());
  }
}

TEST_CASE("A file that isn't one of Hershey's has no letters") {
  CHECK(read_hershey("/no/such/file.jhf").empty());
  CHECK(read_hershey(std::string(OROGRAPH_SOURCE_DIR) + "/README.md").empty());
  CHECK(read_hershey("/usr/share/hershey-fonts").empty());
  CHECK(read_stroke_font(OROGRAPH_SOURCE_DIR).empty());
}

} // namespace orograph::lettering_test
