// SPDX-License-Identifier: GPL-3.0-or-later
// Texts in every format of pages, on sheets, with pens, and cut.
#include "orograph.hpp"
#include "tests/catch.hpp"
#include "tests/dem/temp_folder.hpp"

#include <fstream>
#include <iterator>
#include <string>

#include "lettering/lettering.hpp"

namespace orograph::text_formats_test {
namespace {

Drawing lettered(const std::string& words, LetterKind kind = LetterKind::font) {
  Drawing drawing;
  drawing.letters.kind = kind;
  drawing.page = {100, 60, 5};
  Layer layer;
  layer.name = "labels";
  layer.page_mm = {{10, 10}, {20, 10}};
  layer.strokes = {{.first_point = 0, .point_count = 2}};
  Lettering lettering(drawing.letters);
  layer.texts.push_back(lettering.set({.text = words,
                                       .at_mm = {50, 30},
                                       .size_mm = 4,
                                       .angle = Angle::degrees(30),
                                       .anchor = TextAnchor::middle,
                                       .is_bold = true}));
  drawing.layers.push_back(layer);
  return drawing;
}

std::string written(const Drawing& drawing, Format format) {
  const TempFolder folder;
  const std::string path = folder.file("drawing");
  WriteOptions options;
  options.format = format;
  options.dpi = 100;
  write_drawing(drawing, path, options);
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

} // namespace

TEST_CASE("Each format of pages has the text, the same bytes each time") {
  const Drawing with = lettered("Mont Blanc");
  Drawing without = with;
  without.layers[0].texts.clear();
  for (const Format format : {Format::svg, Format::pdf, Format::ps, Format::eps, Format::png,
                              Format::hpgl, Format::gcode, Format::dxf}) {
    INFO(format_names()[static_cast<std::size_t>(format)]);
    const std::string bytes = written(with, format);
    CHECK((bytes == written(with, format)));
    CHECK((bytes != written(without, format)));
  }
  CHECK(has(written(with, Format::pdf), "/FontFile"));
  CHECK_FALSE(has(written(without, Format::pdf), "/FontFile"));
  CHECK(has(written(with, Format::ps), "%%BeginResource: font"));
  CHECK(has(written(with, Format::eps), "%%BeginResource: font"));
}

TEST_CASE("SVG holds texts as texts, escaped") {
  const std::string svg = written(lettered("L'\"a\" <b> & c\x01\n 🏔"), Format::svg);
  CHECK(has(svg, "L'&quot;a&quot; &lt;b&gt; &amp; c"));
  CHECK(has(svg, "🏔</text>"));
  CHECK_FALSE(has(svg, "\x01"));
  CHECK(has(svg, "text-anchor=\"middle\""));
  CHECK(has(svg, "transform=\"rotate(-30 50 30)\""));
  CHECK(has(svg, "xml:space=\"preserve\""));
  Drawing hebrew = lettered("הר חרמון");
  hebrew.layers[0].texts[0].anchor = TextAnchor::start;
  CHECK(has(written(hebrew, Format::svg), "direction=\"rtl\" text-anchor=\"end\""));
}

TEST_CASE("Texts as strokes are strokes in every format, and leave no text") {
  Drawing drawing = lettered("Mont Blanc", LetterKind::stroke);
  Lettering lettering(drawing.letters);
  texts_to_strokes(drawing, lettering);
  CHECK(drawing.layers[0].texts.empty());
  CHECK(drawing.layers[0].strokes.size() > 10);
  CHECK(find_fault(drawing).value_or("") == "");
  CHECK_FALSE(has(written(drawing, Format::svg), "<text"));
  CHECK_FALSE(has(written(drawing, Format::pdf), "/FontFile"));
}

TEST_CASE("A text is on each sheet that it touches, at its own place there") {
  const Drawing drawing = lettered("Mont Blanc");
  const Page sheet{60, 60, 5};
  const SheetsRequest request{2, 1, 10};
  Drawing whole = drawing;
  whole.page = page_of_sheets(sheet, request);
  const auto sheets = sheets_of(whole, sheet, request);
  REQUIRE(sheets.size() == 2);
  REQUIRE(sheets[0].layers[0].texts.size() == 1); // from 38 to 62
  REQUIRE(sheets[1].layers[0].texts.size() == 1);
  CHECK(sheets[0].layers[0].texts[0].at_mm.x == 50);
  CHECK(sheets[1].layers[0].texts[0].at_mm.x == 10); // sheets are 50 - 10 apart
  const Drawing overview = overview_of(whole, sheet, request);
  CHECK(overview.layers[0].texts[0].size_mm < 4);
  Drawing cut = drawing;
  cut_to(cut, {{5, 5}, {30, 55}});
  CHECK(cut.layers[0].texts.empty());
}

TEST_CASE("A pen takes a layer's texts with its strokes") {
  Drawing drawing = lettered("Mont Blanc");
  PenOfLayers pen;
  pen.pen.number = 3;
  assign_pens(drawing, std::vector<PenOfLayers>{pen});
  REQUIRE(drawing.layers.size() == 1);
  CHECK(drawing.layers[0].texts.size() == 1);
  Drawing other = lettered("Mont Blanc");
  pen.layers = {"shores"};
  CHECK_THROWS_AS(assign_pens(other, std::vector<PenOfLayers>{pen}), UsageError);
}

TEST_CASE("Texts stay where strokes are brought into the pen's order") {
  for (const PenOrder order : {PenOrder::drawing, PenOrder::sorted, PenOrder::best}) {
    Drawing drawing = lettered("Mont Blanc");
    order_for_pen(drawing, order);
    CHECK(drawing.layers[0].texts.size() == 1);
  }
}

TEST_CASE("A text outside of the margins is a fault") {
  Drawing drawing = lettered("Mont Blanc");
  CHECK(find_fault(drawing).value_or("") == "");
  drawing.layers[0].texts[0].at_mm.x = 8;
  CHECK(has(find_fault(drawing).value_or(""), "lies outside the margins"));
}

} // namespace orograph::text_formats_test
