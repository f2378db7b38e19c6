// SPDX-License-Identifier: GPL-3.0-or-later
// Any bytes become text that XML may hold.
#include "draw/xml_text.hpp"
#include "tests/catch.hpp"

using namespace orograph;

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
