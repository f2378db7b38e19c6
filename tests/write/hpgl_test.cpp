// SPDX-License-Identifier: GPL-3.0-or-later
// HPGL as a reader of our own and Debian's hp2xx see it.
#include "geometry/error.hpp"
#include "tests/catch.hpp"
#include "tests/draw/made_drawing.hpp"
#include "tests/write/device_drawings.hpp"
#include "tests/write/seen_hpgl.hpp"
#include "write/write_drawing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <sstream>
#include <string>
#include <string_view>

using namespace orograph;

namespace {

std::string written(const Drawing& drawing, const Device& device, const std::string& name) {
  const TemporaryFolder folder;
  const WriteOptions options{.format = format_of_path(name), .device = device};
  write_drawing(drawing, folder.file(name), options);
  return content_of(folder.file(name));
}

std::string message_of(const Drawing& drawing, const Device& device) {
  const TemporaryFolder folder;
  try {
    write_drawing(drawing, folder.file("map.hpgl"), {.format = Format::hpgl, .device = device});
  } catch (const UsageError& error) {
    CHECK(folder.names().empty());
    return error.what();
  }
  return "none";
}

// A device that another file would tell.
Device small_instructions() {
  Device device = read_device("hp7475a");
  device.longest = 40;
  return device;
}

} // namespace

TEST_CASE("the whole of a small HPGL") {
  Drawing drawing;
  drawing.page = {420, 297, 25};
  drawing.layers = {empty_layer("border"), empty_layer("profiles")};
  drawing.layers[0].pen = Pen{.number = 3, .speed_mm_s = 104};
  drawing.layers[1].pen = Pen{.number = 1};
  add_stroke(drawing.layers[0], {{30, 30}, {40, 30}, {40, 31}});
  add_stroke(drawing.layers[0], {{40, 31}, {40, 41}});
  add_stroke(drawing.layers[1], {{100, 50}, {100, 60}});
  CHECK(written(drawing, read_device("hp7475a"), "map.hpgl") ==
        "IN;DF;PS0;SP3;VS10;PU603,10330;PR;PD402,0,0,-41;PA;PR;PD0,-402;PA;"
        "PU;SP1;VS;PU3416,9526;PR;PD0,-402;PA;PU;PU0,11040;SP0;IN;\n");
}

TEST_CASE("HPGL reads back within half a unit, by the pen that draws it") {
  struct Case {
    Device device;
    Page page;
    Box2 reach_mm; ///< on the page, a little less than the window
    std::function<Vec2(Vec2)> to_device;
  };
  const auto a4 = [](Vec2 p) { return Vec2{p.x - 10, 210 - p.y - 4}; };
  Device absolute = read_device("hp7475a");
  absolute.relative = false;
  Device down = read_device("generic");
  down.y_up = false;
  const std::vector<Case> cases{
      {read_device("hp7475a"), {297, 210, 14}, {{10.1, 14}, {284.6, 205.9}}, a4},
      {absolute, {297, 210, 14}, {{10.1, 14}, {284.6, 205.9}}, a4},
      {small_instructions(), {297, 210, 14}, {{10.1, 14}, {284.6, 205.9}}, a4},
      // Turned: the page's right is up.
      {read_device("hp7475a"),
       {210, 297, 14},
       {{4.1, 10.1}, {195.9, 284.6}},
       [](Vec2 p) {
         return Vec2{p.y - 10, p.x - 4};
       }},
      // In the middle of the paper.
      {read_device("dxy"),
       {280, 200, 0},
       {{2.1, 3.6}, {278, 196.4}},
       [](Vec2 p) {
         return Vec2{p.x + 8.5 - 10.5, 205 - p.y - 8.5};
       }},
      {read_device("generic"),
       {400, 300, 0},
       {{0, 0}, {400, 300}},
       [](Vec2 p) {
         return Vec2{p.x, 300 - p.y};
       }},
      {down, {400, 300, 0}, {{0, 0}, {400, 300}}, [](Vec2 p) { return p; }}};
  for (std::size_t i = 0; i < cases.size(); ++i)
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
      const auto& [device, page, reach_mm, to_device] = cases[i];
      const Drawing drawing =
          random_strokes(seed, page, reach_mm, seed % 3 == 0 ? 0 : *device.pens);
      INFO(i << ", seed " << seed);
      const SeenHpgl hpgl = seen_hpgl(written(drawing, device, "map.hpgl"), device.unit_mm);
      const double half = 0.5 * device.unit_mm + 1e-9;
      CHECK(fault_of_moves(drawing, hpgl.moves, to_device, half) == "");
      CHECK(hpgl.longest <= device.longest);
      const Box2 window = !device.papers.empty()
                              ? device.papers[0].window
                              : Box2{{0, 0}, {400 / device.unit_mm, 300 / device.unit_mm}};
      CHECK(hpgl.least.x >= window.low.x);
      CHECK(hpgl.least.y >= window.low.y);
      CHECK(hpgl.greatest.x <= window.high.x);
      CHECK(hpgl.greatest.y <= window.high.y);
    }
}

// hp2xx draws pens 1 to 7 so, unless told.
constexpr const char* kColours[] = {"rgb(0,0,0)",    "rgb(255,0,0)",   "rgb(0,255,0)",
                                    "rgb(0,0,255)",  "rgb(0,255,255)", "rgb(255,0,255)",
                                    "rgb(255,255,0)"};

TEST_CASE("hp2xx reads the same strokes from HPGL") {
  const TemporaryFolder folder;
  const Device device = read_device("generic");
  Drawing drawing = random_strokes(5, {400, 300, 0}, {{0, 0}, {400, 300}}, 7);
  for (Layer& layer : drawing.layers) // it leaves dots out
    std::erase_if(layer.strokes,
                  [&](const Stroke& stroke) { return line_length_mm(layer.points(stroke)) < 0.1; });
  write_drawing(drawing, folder.file("map.hpgl"), {.format = Format::hpgl, .device = device});
  REQUIRE(std::system(fmt::format("hp2xx -q -t -m svg -f {} {} >/dev/null 2>&1",
                                  folder.file("map.svg"), folder.file("map.hpgl"))
                          .c_str()) == 0);
  // A group for each pen, by its colour, of paths with y down.
  std::vector<SeenMove> moves;
  std::istringstream svg(content_of(folder.file("map.svg")));
  int pen = -1;
  Vec2 at;
  double height = 0; // in points, as all numbers here
  for (std::string word; svg >> word;) {
    if (word.starts_with("viewBox=")) svg >> word >> word >> height;
    if (const auto at_colour = word.find("stroke:rgb"); at_colour != std::string::npos)
      for (std::size_t i = 0; i < std::size(kColours); ++i)
        if (word.find(kColours[i]) != std::string::npos) pen = static_cast<int>(i) + 1;
    if (word != "L" && word.find("d=\"M") == std::string::npos) continue;
    double x = 0, y = 0;
    char comma = 0;
    svg >> x >> comma >> y;
    const Vec2 to{x / 72 * 25.4, (height - y) / 72 * 25.4};
    if (word == "L") moves.push_back({pen, at, to});
    at = to;
  }
  CHECK(moves.size() > 100);
  Drawing by_pen = drawing;
  std::stable_sort(by_pen.layers.begin(), by_pen.layers.end(),
                   [](const Layer& a, const Layer& b) { return a.pen->number < b.pen->number; });
  // hp2xx prints to the 1/1000 of a point.
  CHECK(fault_of_moves(
            by_pen, moves,
            [](Vec2 p) {
              return Vec2{p.x, 300 - p.y};
            },
            0.5 * device.unit_mm + 0.001 / 72 * 25.4) == "");
}

TEST_CASE("what a device can't draw is refused, with what it can") {
  Drawing drawing;
  drawing.page = {297, 210, 0};
  drawing.layers = {empty_layer("profiles")};
  add_stroke(drawing.layers[0], {{10, 50}, {284, 60}});
  CHECK(message_of(drawing, read_device("hp7475a")) == "none");
  add_stroke(drawing.layers[0], {{284, 50}, {289.1, 60}});
  CHECK(message_of(drawing, read_device("hp7475a")) ==
        "lines reach 4.4 mm beyond the window of the HP 7475A on a4: "
        "`page` 297x210 (a4) with `margin_mm` 14 fits");
  drawing.page = {594, 420, 0};
  CHECK(message_of(drawing, read_device("hp7475a")) ==
        "the page of 594 x 420 mm is larger than any paper of the HP 7475A: "
        "`page` 420x297 (a3) with `margin_mm` 15 fits");
  Device cutter = read_device("generic");
  cutter.window = Box2{{0, 0}, {8000, 20000}};
  CHECK(message_of(drawing, cutter) ==
        "lines reach 89.1 mm beyond the window of the HPGL plotter: `page` 200x500 fits");
  drawing.layers[0].pen = Pen{.number = 9};
  CHECK(message_of(drawing, read_device("generic")) ==
        "pen 9 of the HPGL plotter, which has 8: give `pens` numbers up to 8");
  drawing.layers[0].pen = Pen{.number = 2, .waits = true};
  CHECK(message_of(drawing, read_device("generic")).find("no word to wait") != std::string::npos);
  // Where the pen goes through the air is no ink.
  drawing.layers = {empty_layer("pen-up")};
  drawing.layers[0].is_pen_way = true;
  drawing.page = {297, 210, 0};
  add_stroke(drawing.layers[0], {{0, 0}, {297, 210}});
  CHECK(message_of(drawing, read_device("hp7475a")) == "none");
}
