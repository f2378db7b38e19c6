// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers on the page against the standard library's own printing; any bytes become text that XML
// may hold.
#include "draw/round_drawing.hpp"
#include "tests/catch.hpp"
#include "tests/support/random.hpp"
#include "write/format_text.hpp"

#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <limits>
#include <string>

using namespace orograph;

namespace {

std::string printed(double value_mm) {
  std::array<char, kPageNumberBytes> text;
  return {text.data(), print_page_number(value_mm, text.data())};
}

std::string by_definition(double value_mm) {
  std::array<char, 400> text;
  std::string all(text.data(), std::to_chars(text.data(), text.data() + text.size(), value_mm,
                                             std::chars_format::fixed, 4)
                                   .ptr);
  all.erase(all.find_last_not_of('0') + 1);
  if (all.back() == '.') all.pop_back();
  return all;
}

// Counted, because a check for each of millions would take long.
struct Wrong {
  int count = 0;
  std::string first;

  void see(double value_mm) {
    if (printed(value_mm) == by_definition(value_mm)) return;
    if (count++ == 0) first = by_definition(value_mm) + " is printed as " + printed(value_mm);
  }
  void see_around(double value_mm) {
    for (const double v : {value_mm, -value_mm}) {
      see(v);
      see(std::nextafter(v, std::numeric_limits<double>::infinity()));
      see(std::nextafter(v, -std::numeric_limits<double>::infinity()));
    }
  }
};

} // namespace

TEST_CASE("page numbers have up to 4 decimals and no zeros after them") {
  CHECK(printed(0) == "0");
  CHECK(printed(-0.0) == "-0");
  CHECK(printed(0.0001) == "0.0001");
  CHECK(printed(-0.05) == "-0.05");
  CHECK(printed(100) == "100");
  CHECK(printed(210.1200) == "210.12");
  CHECK(printed(12345.6789) == "12345.6789");
  CHECK(printed(1e300).size() == 301);
}

TEST_CASE("page numbers are the standard library's fixed notation, trimmed") {
  Wrong wrong;
  Random random(1);
  for (int i = 0; i < 400000; ++i) {
    wrong.see(rounded_to_page_step(random.between(-50, 1300)));
    wrong.see(rounded_to_page_step(random.between(-1, 1) * std::pow(10, random.whole(-4, 11))));
    wrong.see(random.between(-1, 1) * std::pow(10, random.whole(-6, 20)));
  }
  INFO(wrong.first);
  CHECK(wrong.count == 0);
}

TEST_CASE("page numbers halfway between two steps, and at the limits, are the library's") {
  Wrong wrong;
  Random random(2);
  for (int i = 0; i < 20000; ++i) { // halves that a double holds, quarters, and their neighbours
    const double whole = random.whole(0, 1 << 28);
    wrong.see_around((whole + 0.5) / 32);
    wrong.see_around((whole + 0.5) / 1e4);
    wrong.see_around((whole + 0.25) / 1e4);
    wrong.see_around((whole + 0.75) / 1e4);
    wrong.see_around(whole / 1e4);
    wrong.see_around(0.5e-4 * i);
  }
  for (int exponent = -1074; exponent < 1024; ++exponent) wrong.see_around(std::ldexp(1, exponent));
  for (int exponent = -320; exponent < 308; ++exponent) wrong.see_around(std::pow(10, exponent));
  wrong.see_around(std::numeric_limits<double>::max() / 2);
  wrong.see(std::numeric_limits<double>::max());
  wrong.see(std::numeric_limits<double>::denorm_min());
  while (wrong.count == 0 && random.share() > 1e-5) { // any bits
    const auto low = static_cast<std::uint64_t>(random.whole(0, std::numeric_limits<int>::max()));
    const auto high = static_cast<std::uint64_t>(random.whole(0, std::numeric_limits<int>::max()));
    const double value = std::bit_cast<double>(low | high << 33U);
    if (std::isfinite(value)) wrong.see(value);
  }
  INFO(wrong.first);
  CHECK(wrong.count == 0);
}

TEST_CASE("marked characters are escaped and others kept") {
  CHECK(xml_escaped("a < b > c & \"d\" 'e'") == "a &lt; b &gt; c &amp; &quot;d&quot; 'e'");
  CHECK(xml_escaped("Höhe 山 🏔") == "Höhe 山 🏔");
  CHECK(xml_escaped("").empty());
}

TEST_CASE("what is no UTF-8, or no character of XML, is replaced") {
  const std::string mark = "\xEF\xBF\xBD";
  CHECK(clean_utf8("a\xFF"
                   "b") == "a" + mark + "b");
  CHECK(clean_utf8("tab\tline\n") == "tab\tline\n");
  CHECK(clean_utf8(std::string("a\0b", 3)) == "a" + mark + "b");
  CHECK(clean_utf8("\x1B[1m") == mark + "[1m");
  CHECK(clean_utf8("cut \xC3") == "cut " + mark);                     // half a character
  CHECK(clean_utf8("\xC0\xAF") == mark + mark);                       // overlong
  CHECK(clean_utf8("\xE0\x80\xAF") == mark + mark + mark);            // overlong
  CHECK(clean_utf8("\xED\xA0\x80") == mark + mark + mark);            // a surrogate
  CHECK(clean_utf8("\xEF\xBF\xBF") == mark + mark + mark);            // U+FFFF
  CHECK(clean_utf8("\xF4\x90\x80\x80") == mark + mark + mark + mark); // past U+10FFFF
  CHECK(clean_utf8("\xF4\x8F\xBF\xBF") == "\xF4\x8F\xBF\xBF");        // U+10FFFF
}
