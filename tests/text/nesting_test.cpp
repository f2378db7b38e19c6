// SPDX-License-Identifier: GPL-3.0-or-later
// What is nested too deep for the libraries that parse it is refused before they see it.
#include "geometry/error.hpp"
#include "tests/catch.hpp"
#include "text/nesting.hpp"

using namespace orograph;

namespace {

std::string repeated(const std::string& text, int times) {
  std::string all;
  for (int i = 0; i < times; ++i) all += text;
  return all;
}

} // namespace

TEST_CASE("a name in TOML has at most 40 dots") {
  check_toml_nesting("a" + repeated(".a", 40) + " = 1", "a.toml", "do");
  CHECK_THROWS_WITH(check_toml_nesting("\na" + repeated(".a", 41) + " = 1", "a.toml", "do"),
                    "a.toml, line 2: there are over 40 dots in a row: do");
  // Numbers of a list aren't nested, nor are names on their own lines.
  check_toml_nesting("a = [" + repeated("0.5, ", 3000) + "]", "a.toml", "do");
  check_toml_nesting(repeated("a.b.c = 0.5\n", 3000), "a.toml", "do");
}

TEST_CASE("JSON is nested at most 100 deep") {
  check_json_nesting(repeated("[", 100) + repeated("]", 100), "a.json", "do");
  CHECK_THROWS_WITH(check_json_nesting("\n" + repeated("[{", 51), "a.json", "do"),
                    "a.json, line 2: lists and objects are nested over 100 deep: do");
  // Side by side, and in text, they aren't nested.
  check_json_nesting(repeated("[{}],", 3000), "a.json", "do");
  check_json_nesting("\"" + repeated("\\\"[", 3000) + "\"", "a.json", "do");
  // Text ends where its backslashes are escaped themselves.
  CHECK_THROWS_AS(check_json_nesting("\"\\\\\"" + repeated("[", 101), "a.json", "do"), Error);
}
