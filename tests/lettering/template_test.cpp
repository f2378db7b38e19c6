// SPDX-License-Identifier: GPL-3.0-or-later
// Templates: what they say, and errors that name file and line.
#include "geometry/error.hpp"
#include "placing/template_file.hpp"
#include "tests/catch.hpp"
#include "tests/dem/temp_folder.hpp"

#include <fstream>
#include <string>
#include <utility>

namespace orograph::template_test {
namespace {

Template read(const std::string& text) {
  const TempFolder folder;
  const std::string path = folder.file("t.toml");
  std::ofstream(path) << text;
  return read_template(path);
}

std::string error_of(const std::string& text) {
  try {
    read(text);
  } catch (const Error& error) {
    return error.what();
  }
  return {};
}

} // namespace

TEST_CASE("A template says texts, sizes, letters and furniture, and no more than that") {
  const Template full = read("furniture = ['map', 'viewpoint']\ntitle = ''\nsubtitle = 'b'\n"
                             "source = 'c'\ndate = 'd'\nfont = 'Serif'\nletters = 'stroke'\n"
                             "title-size = 7\nsubtitle-size = 4.5\ntext-size = 3\ngap = 0\n");
  REQUIRE(full.pieces);
  CHECK(full.pieces->size() == 8);
  CHECK(full.title == "");
  CHECK(full.date == "d");
  CHECK(full.letters == LetterKind::stroke);
  CHECK(full.subtitle_mm == 4.5);
  CHECK(full.gap_mm == 0.0);
  const Template empty = read("");
  CHECK_FALSE(empty.pieces);
  CHECK_FALSE(empty.title);
  CHECK_FALSE(empty.text_mm);
  CHECK(read("furniture = 'none'").pieces->empty());
  CHECK(read("furniture = []").pieces->empty());
}

TEST_CASE("What is wrong in a template is told with its line") {
  for (const auto& [text, words] :
       {std::pair{"title = 'a'\nfurniture = 'nort'", "line 2: there is no furniture 'nort'"},
        std::pair{"\n\ntext-size = 0", "line 3"}, std::pair{"title = 7", "line 1"},
        std::pair{"colour = 'red'", "line 1"}, std::pair{"title-size = 'x'", "line 1"},
        std::pair{"letters = 'thin'", "line 1"}, std::pair{"font = ''", "line 1"},
        std::pair{"furniture = [1]", "line 1"}, std::pair{"a = [", "line 1"}}) {
    const std::string error = error_of(text);
    INFO(text << ": " << error);
    CHECK(error.find(words) != std::string::npos);
    CHECK(error.find("t.toml") != std::string::npos);
    CHECK(error.find('\n') == std::string::npos);
  }
}

TEST_CASE("Lists of furniture may name sets and pieces, whichever are there already") {
  CHECK(furniture_of("none", "x").empty());
  CHECK(furniture_of("map", "x").size() == 7);
  CHECK(furniture_of("map,title,viewpoint", "x").size() == 8);
  CHECK_THROWS_AS(furniture_of("", "x"), UsageError);
  CHECK_THROWS_AS(furniture_of("map,", "x"), UsageError);
  CHECK_THROWS_AS(furniture_of("Map", "x"), UsageError);
}

} // namespace orograph::template_test
