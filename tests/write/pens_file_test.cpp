// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/error.hpp"
#include "tests/catch.hpp"
#include "tests/draw/made_drawing.hpp"
#include "write/pens_file.hpp"
#include "write/write_drawing.hpp"

#include <array>
#include <string>

using namespace orograph;

namespace {

constexpr std::array<std::string_view, 3> kLayers{"profiles", "shores", "border"};

std::string message_of_pens(const std::string& toml) {
  const TemporaryFolder folder;
  fill_file(folder.file("p.toml"), toml);
  try {
    read_pens(folder.file("p.toml"), kLayers);
  } catch (const Error& error) {
    const std::string message = error.what();
    CHECK(message.find(folder.file("p.toml")) == 0);
    CHECK(message.find('\n') == std::string::npos);
    return message.substr(folder.file("p.toml").size());
  }
  return "none";
}

} // namespace

TEST_CASE("a file of pens, all that may stand in it") {
  const TemporaryFolder folder;
  fill_file(folder.file("p.toml"),
            "[[pen]]\nnumber = 3\nname = 'red'\ncolour = '#fF0a00'\nwidth = 0.25\nspeed = 30\n"
            "height = 45\npause = true\nlayers = ['border', 'profiles']\n"
            "[[pen]]\nnumber = 1\nwidth = 0.1\n"
            "[[pen]]\nwidth = 0.2\ncolour = 'darkred'\nlayers = ['shores']\nfield = 'class'\n"
            "values = ['path', 3, 2.5]\ndash = [2, 0.5]\n");
  const auto pens = read_pens(folder.file("p.toml"), kLayers);
  REQUIRE(pens.size() == 3);
  CHECK(pens[0].pen.number == 3);
  CHECK(pens[0].pen.name == "red");
  CHECK(pens[0].pen.colour == std::array<std::uint8_t, 3>{255, 10, 0});
  CHECK(pens[0].pen.width_mm == 0.25);
  CHECK(pens[0].pen.speed_mm_s == 30);
  CHECK(pens[0].pen.height_percent == 45);
  CHECK(pens[0].pen.waits);
  CHECK(pens[0].layers == std::vector<std::string>{"border", "profiles"});
  CHECK(pens[1].pen.name.empty());
  CHECK(!pens[1].pen.speed_mm_s);
  CHECK(!pens[1].pen.waits);
  CHECK(pens[1].field.empty());
  CHECK(!pens[1].dash);
  CHECK(pens[1].place == folder.file("p.toml") + ", line 10");
  CHECK(pens[2].pen.number == 2);
  CHECK(pens[2].pen.colour == Colour{139, 0, 0});
  CHECK(pens[2].field == "class");
  CHECK(pens[2].values == std::vector<std::string>{"path", "3", "2.5"});
  REQUIRE(pens[2].dash);
  CHECK(pens[2].dash->dash_mm == 2);
  CHECK(pens[2].dash->gap_mm == 0.5);
  CHECK(pens_of("shores", pens).size() == 1); // but for those with a field
  CHECK(pens_of("shores", pens)[0].number == 1);
  CHECK(pens_of("border", pens)[0].number == 3);
}

TEST_CASE("what is wrong with a file of pens is told with its line") {
  const std::string one = "[[pen]]\nnumber = 1\nwidth = 0.1\n";
  for (const auto& [toml, message] : std::initializer_list<std::pair<std::string, std::string>>{
           {"", " holds no pen: give each pen a table [[pen]]"},
           {"[pen]\nnumber = 1", ", line 1: pen is a table: give tables, as in [[pen]]"},
           {"pen = []", " holds no pen"},
           {"[[pens]]", ", line 1: unknown key 'pens': did you mean pen?"},
           {"[[pen]]\nnumber = 1", ", line 1: a pen has no width"},
           {"[[pen]]\nnumber = 0\nwidth = 1", ", line 2: number is the number 0"},
           {"[[pen]]\nnumber = 1001\nwidth = 1", ", line 2: number is the number 1001"},
           {one + "widht = 2", ", line 4: unknown key 'widht': did you mean width?"},
           {"[[pen]]\nnumber = 1\nwidth = 11", ", line 3: width is the number 11"},
           {one + "colour = 'rde'", ", line 4: there is no colour 'rde': did you mean red?"},
           {one + "colour = '#12345g'",
            ", line 4: there is no colour '#12345g': give red, green and blue"},
           {one + "colour = 7", ", line 4: colour is the number 7: give red, green and blue"},
           {one + "speed = 0", ", line 4: speed is the number 0"},
           {one + "height = 101", ", line 4: height is the number 101"},
           {one + "pause = 1", ", line 4: pause is the number 1: give true or false"},
           {one + "layers = 'shores'", ", line 4: layers is text"},
           {one + "layers = []", ", line 4: layers is a list of 0 values"},
           {one + "layers = ['shore']",
            ", line 4: there is no layer 'shore': did you mean shores?"},
           {one + "layers = ['names']", ", line 4: there is no layer 'names'"},
           {one + "layers = [1]", ", line 4: a value in layers is the number 1"},
           {one + one, ", line 5: a second pen 1: give each a number of its own"},
           {"[[pen]]\nnumber = 2\nwidth = 1\n[[pen]]\nnumber = 1\nwidth = 1\n[[pen]]\nwidth = 1",
            ", line 7: a second pen 2: give each a number of its own"},
           {"[[pen]]\nnumber = 1000\nwidth = 1\n[[pen]]\nwidth = 1",
            ", line 4: a pen has no number: give a whole number from 1 to 1000"},
           {one + "values = ['river']", ", line 1: a pen has no field: give the name of a field"},
           {one + "field = 'class'",
            ", line 1: a pen has no values: give a list of texts or numbers, as in values = "
            "[\"river\", \"stream\"]"},
           {one + "field = ''\nvalues = ['river']", ", line 4: field is text"},
           {one + "field = ['class']\nvalues = ['river']", ", line 4: field is a list of 1 value"},
           {one + "field = 'class'\nvalues = 'river'", ", line 5: values is text"},
           {one + "field = 'class'\nvalues = []", ", line 5: values is a list of 0 values"},
           {one + "field = 'class'\nvalues = [['a']]", ", line 5: a value in values is a list"},
           {one + "felid = 'class'", ", line 4: unknown key 'felid': did you mean field?"},
           {one + "dash = 2", ", line 4: dash is the number 2: give the lengths of a dash and of a "
                              "gap, mm, 0.01 to 1000, as in dash = [2, 1]"},
           {one + "dash = [2]", ", line 4: dash is a list of 1 value"},
           {one + "dash = [2, 1, 2]", ", line 4: dash is a list of 3 values"},
           {one + "dash = [2, 0]", ", line 4: dash is a list of 2 values"},
           {one + "dash = [-2, 1]", ", line 4: dash is a list of 2 values"},
           {one + "dash = ['2', 1]", ", line 4: a value in dash is text"},
           {"[[pen]\n", ", line 1: this isn't TOML"}}) {
    INFO(toml << message_of_pens(toml));
    CHECK(message_of_pens(toml).find(message) == 0);
  }
}

TEST_CASE("a pen that a device hasn't, or can't wait for, is told with its line") {
  const TemporaryFolder folder;
  fill_file(folder.file("p.toml"),
            "[[pen]]\nnumber = 6\nwidth = 1\n[[pen]]\nwidth = 1\nnumber = 7\n");
  const Device six = read_device("hp7475a"), eight = read_device("dxy"),
               hand = read_device("grbl-z");
  CHECK_THROWS_WITH(read_pens(folder.file("p.toml"), kLayers, &six),
                    folder.file("p.toml") + ", line 6: pen 7 of the HP 7475A, which has 6: give "
                                            "numbers up to 6");
  CHECK(read_pens(folder.file("p.toml"), kLayers, &eight).size() == 2);
  CHECK(read_pens(folder.file("p.toml"), kLayers, &hand).size() == 2);
  fill_file(folder.file("p.toml"), "[[pen]]\nnumber = 6\nwidth = 1\npause = true\n");
  CHECK_THROWS_WITH(read_pens(folder.file("p.toml"), kLayers, &six),
                    folder.file("p.toml") + ", line 4: the HP 7475A has no word to wait for a pen: "
                                            "give a device with the key wait, or leave pause out");
  CHECK(read_pens(folder.file("p.toml"), kLayers, &hand).size() == 1);
}

TEST_CASE("SVG's layers carry AxiDraw's words for their pens") {
  Drawing drawing;
  drawing.layers = {empty_layer("fine"), empty_layer("pen 2"), empty_layer("third")};
  drawing.layers[0].pen = Pen{
      .number = 1, .colour = {1, 2, 171}, .speed_mm_s = 50, .height_percent = 39.6, .waits = true};
  drawing.layers[1].pen = Pen{.number = 2, .speed_mm_s = 500};
  drawing.layers[2].pen = Pen{.number = 7, .height_percent = 0};
  for (Layer& layer : drawing.layers) add_stroke(layer, {{20, 20}, {30, 30}});
  const TemporaryFolder folder;
  write_drawing(drawing, folder.file("map.svg"), {});
  const std::string svg = content_of(folder.file("map.svg"));
  // A percent is 8.6979 inches a second through 110.
  CHECK(svg.find("inkscape:label=\"!1+S25+H40 fine\"") != std::string::npos);
  CHECK(svg.find("inkscape:label=\"2+S110 pen 2\"") != std::string::npos);
  CHECK(svg.find("inkscape:label=\"7+H0 third\"") != std::string::npos);
  CHECK(svg.find("stroke=\"#0102ab\"") != std::string::npos);
}

TEST_CASE("of several drawings all are written, or none") {
  const TemporaryFolder folder;
  const std::vector<Drawing> drawings{made_drawing(2), made_drawing(3)};
  const std::vector<std::string> paths{folder.file("1.svg"), folder.file("2.svg")};
  fill_file(paths[1], "old");
  CHECK_THROWS_AS(write_drawings(drawings, paths, {}), Error);
  CHECK(folder.names() == std::vector<std::string>{"2.svg"});
  write_drawings(drawings, paths, {.overwrite = true});
  CHECK(folder.names().size() == 2);
  CHECK(content_of(paths[1]).ends_with("</svg>\n"));
}
