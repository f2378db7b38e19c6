// SPDX-License-Identifier: GPL-3.0-or-later
#include "draw/colour.hpp"
#include "draw/drawing.hpp"
#include "draw/pen_order.hpp"
#include "geometry/error.hpp"
#include "tests/catch.hpp"
#include "tests/draw/made_drawing.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdint>
#include <cstdio>
#include <string>

using namespace orograph;

namespace {

std::string refusal_of(const std::string& text) {
  try {
    colour_of(text);
  } catch (const UsageError& error) {
    return error.what();
  }
  return "accepted";
}

} // namespace

TEST_CASE("every colour reads back from its digits, in letters of either case") {
  for (int step = 0; step < 256; ++step) {
    const Colour colour{static_cast<std::uint8_t>(step), static_cast<std::uint8_t>(255 - step),
                        static_cast<std::uint8_t>(7 * step % 256)};
    std::array<char, 8> digits{}; // another way than the code's
    std::snprintf(digits.data(), digits.size(), "#%02x%02x%02x", step, 255 - step, 7 * step % 256);
    const std::string text(digits.data());
    CHECK(hex_of(colour) == text);
    CHECK(colour_of(text) == colour);
    std::string capitals = text;
    std::ranges::transform(capitals, capitals.begin(),
                           [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
    CHECK(colour_of(capitals) == colour);
  }
}

TEST_CASE("colours have the values that CSS gives their names") {
  // CSS Color Module Level 4, section 6.1.
  CHECK(colour_of("black") == Colour{0, 0, 0});
  CHECK(colour_of("brown") == Colour{165, 42, 42});
  CHECK(colour_of("saddlebrown") == Colour{139, 69, 19});
  CHECK(colour_of("green") == Colour{0, 128, 0});
  CHECK(colour_of("steelblue") == Colour{70, 130, 180});
  CHECK(colour_of("SteelBlue") == Colour{70, 130, 180});
  CHECK(colour_of("orange") == Colour{255, 165, 0});
  CHECK(colour_of("purple") == Colour{128, 0, 128});
  CHECK(colour_of("grey") == colour_of("gray"));
  CHECK(colour_of("grey") == Colour{128, 128, 128});
  CHECK(std::ranges::is_sorted(colour_names()));
  for (const std::string_view name : colour_names()) CHECK_NOTHROW(colour_of(name));
}

TEST_CASE("texts that are no colour are refused with what would be right") {
  CHECK(refusal_of("bleu") == "there is no colour 'bleu': did you mean blue?");
  CHECK(refusal_of("darkrde") == "there is no colour 'darkrde': did you mean darkred?");
  for (const char* text : {"", "#", "#12345", "#1234567", "#12345g", "123456", "#12 456", "#+12345",
                           "rgb(1,2,3)", "#\n23456"}) {
    INFO(text);
    CHECK(refusal_of(text).find("hexadecimal digits, as in #8b5a2b") != std::string::npos);
    CHECK(refusal_of(text).find('\n') == std::string::npos);
  }
}

TEST_CASE("a layer keeps its colour when its strokes are ordered, and a pen's goes before it") {
  Drawing drawing;
  drawing.layers = {empty_layer("shores")};
  drawing.layers[0].colour = Colour{1, 2, 3};
  add_stroke(drawing.layers[0], {{10, 10}, {20, 20}});
  add_stroke(drawing.layers[0], {{20, 20}, {30, 10}});
  CHECK(!empty_layer("grey").ink());
  order_for_pen(drawing, PenOrder::sorted);
  CHECK(drawing.layers[0].ink() == Colour{1, 2, 3});
  drawing.layers[0].pen = Pen{.colour = {4, 5, 6}};
  CHECK(drawing.layers[0].ink() == Colour{4, 5, 6});
}
