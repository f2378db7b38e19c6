// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/catch.hpp"
#include "text/words.hpp"

#include <array>

using namespace orograph;

TEST_CASE("edit distance counts single edits") {
  CHECK(edit_distance("fov", "fov", 9) == 0);
  CHECK(edit_distance("fow", "fov", 9) == 1);
  CHECK(edit_distance("", "fov", 9) == 3);
  CHECK(edit_distance("kitten", "sitting", 9) == 3);
  CHECK(edit_distance("kitten", "sitting", 2) == 2);
  CHECK(edit_distance("", "fov", 2) == 2);
  CHECK(edit_distance("", "", 0) == 0);
}

TEST_CASE("the nearest word is at most three edits away, and fewer than it has letters") {
  const std::array<std::string_view, 3> words{"apex", "base", "vertices"};
  CHECK(nearest_word("bsae", words) == "base");
  CHECK(nearest_word("vertex", words) == "vertices");
  CHECK(nearest_word("xyz", words).empty());
  CHECK(nearest_word("profile", words).empty());
  CHECK(nearest_word("b", std::array<std::string_view, 1>{"z"}).empty());
}
