// SPDX-License-Identifier: GPL-3.0-or-later
// G-code as a small interpreter sees it.
#include "geometry/error.hpp"
#include "tests/catch.hpp"
#include "tests/draw/made_drawing.hpp"
#include "tests/write/device_drawings.hpp"
#include "tests/write/seen_gcode.hpp"
#include "write/write_drawing.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <sstream>
#include <string>

using namespace orograph;

namespace {

std::string written(const Drawing& drawing, const Device& device) {
  const TemporaryFolder folder;
  write_drawing(drawing, folder.file("map.gcode"), {.format = Format::gcode, .device = device});
  return content_of(folder.file("map.gcode"));
}

} // namespace

TEST_CASE("G-code reads back within half a step, by the pen that draws it") {
  for (const char* name : {"grbl-servo", "grbl-z"})
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
      INFO(name << ", seed " << seed);
      Device device = read_device(name);
      if (seed % 2 == 1) device.decimals = 2;
      Drawing drawing = random_strokes(seed, {300, 200, 0}, {{0, 0}, {300, 200}}, 0);
      for (std::size_t i = 0; i < drawing.layers.size(); ++i)
        drawing.layers[i].pen = Pen{.number = static_cast<int>(i) + 1, .speed_mm_s = 20};
      const bool has_z = std::string(name) == "grbl-z";
      const SeenGcode gcode = seen_gcode(
          written(drawing, device), [&](double z, double s) { return has_z ? z < 2 : s < 79; });
      CHECK(fault_of_moves(
                drawing, gcode.moves,
                [](Vec2 p) {
                  return Vec2{p.x, 200 - p.y};
                },
                0.5 * device.step_mm() + 1e-9) == "");
      CHECK(gcode.fault == "");
      CHECK(gcode.longest <= device.longest);
      CHECK(gcode.waits == static_cast<int>(drawing.layers.size()) - 1);
      CHECK(gcode.feeds == std::set<double>{1200});
      CHECK(gcode.heights == std::set<double>{has_z ? 0.0 : 45.0});
      CHECK(gcode.ends_up);
    }
}

TEST_CASE("the whole of a small G-code") {
  Drawing drawing;
  drawing.page = {100, 50, 0};
  drawing.layers = {empty_layer("border"), empty_layer("profiles")};
  drawing.layers[0].pen = Pen{.number = 1, .height_percent = 0};
  drawing.layers[1].pen = Pen{.number = 2, .name = "red; M5", .speed_mm_s = 10};
  add_stroke(drawing.layers[0], {{10, 10}, {20.0004, 10}, {20.0006, 10}});
  add_stroke(drawing.layers[0], {{20.0006, 10}, {30, 12}});
  add_stroke(drawing.layers[1], {{30, 12}, {30, 15}});
  Device device = read_device("grbl-servo");
  device.wait = {"M0 ({pen} {name})"};
  CHECK(written(drawing, device) == "G21\nG90\nG94\nM3 S80\nG4 P0.3\nM3 S80\nG4 P0.15\n"
                                    "G0 X10 Y40\nM3 S30\nG4 P0.15\nG1 X20 Y40 F3000\nG1 X20.001 "
                                    "Y40\nG1 X30 Y38\nM3 S80\nG4 P0.15\nM0 (2 red M5)\n"
                                    "G0 X30 Y38\nM3 S45\nG4 P0.15\nG1 X30 Y35 F600\n"
                                    "M3 S80\nG4 P0.15\nG0 X0 Y0\nM5\n");
}

TEST_CASE("what a machine can't reach is refused") {
  Drawing drawing;
  drawing.page = {300, 200, 0};
  drawing.layers = {empty_layer("profiles")};
  add_stroke(drawing.layers[0], {{10, 50}, {284, 60}});
  Device device = read_device("grbl-z");
  device.window = Box2{{0, 0}, {284, 150}};
  CHECK_NOTHROW(written(drawing, device));
  device.window = Box2{{0, 0}, {283.9995, 150}};
  CHECK_THROWS_AS(written(drawing, device), UsageError);
  device = read_device("hp7475a");
  CHECK_THROWS_AS(written(drawing, device), UsageError); // another language
  device = read_device("grbl-z");
  device.wait = {"M0 (" + std::string(70, 'x') + ")"};
  CHECK_NOTHROW(written(drawing, device));
  drawing.layers[0].pen = Pen{.number = 1, .waits = true};
  CHECK_THROWS_AS(written(drawing, device), Error);
}
