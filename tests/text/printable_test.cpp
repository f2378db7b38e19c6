// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/catch.hpp"
#include "text/printable.hpp"

#include <string>
#include <string_view>

namespace orograph::printable_test {

TEST_CASE("text that a terminal may get stays as it is") {
  for (const std::string_view text :
       {"", "Mont Blanc", "Ötztal: 3 m", "富士山", "🏔 summit", "\xC2\xA0"})
    CHECK(printable(text) == text);
}

TEST_CASE("controls, ends of lines and bytes that aren't UTF-8 are question marks, one for each") {
  CHECK(printable("\x1b[31mred\x1b[0m") == "?[31mred?[0m");
  CHECK(printable(std::string_view("a\0b\x7f\n\t", 6)) == "a?b???");
  CHECK(printable("\xC2\x9B"
                  "31m") == "?31m"); // the control of the second set that begins commands
  CHECK(printable("a\xE2\x80\xA8z\xE2\x80\xA9") == "a?z?"); // line, paragraph
  // A byte alone, too long a form, a surrogate, beyond the last character, cut off.
  CHECK(printable("\xFF\x80") == "??");
  CHECK(printable("\xC0\xAF") == "??");
  CHECK(printable("\xE0\x80\xAF") == "???");
  CHECK(printable("\xED\xA0\x80") == "???");
  CHECK(printable("\xF4\x90\x80\x80") == "????");
  CHECK(printable("h\xC3") == "h?");
  CHECK(printable("\xE5\xAF"
                  "z") == "??z");
}

TEST_CASE("a long text is cut in the middle, between characters") {
  const std::string hundred(100, 'x');
  CHECK(shortened(hundred, 100) == hundred);
  const std::string text = "begin" + std::string(3000, 'x') + "end";
  const std::string cut = shortened(text, 100);
  CHECK(cut.size() == 100);
  CHECK(cut.starts_with("beginxxx"));
  CHECK(cut.ends_with("xxxend"));
  CHECK(cut.find("x … x") != std::string::npos);
  for (std::size_t most = 100; most < 110; ++most) {
    std::string mountains;
    for (int i = 0; i < 200; ++i) mountains += "山";
    const std::string mountain_cut = shortened(mountains, most);
    CHECK(mountain_cut.size() <= most);
    CHECK(printable(mountain_cut) == mountain_cut);
  }
}

} // namespace orograph::printable_test
