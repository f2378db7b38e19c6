// SPDX-License-Identifier: GPL-3.0-or-later
// Files of devices: ours, and what is wrong with others'.
#include "geometry/error.hpp"
#include "tests/catch.hpp"
#include "tests/draw/made_drawing.hpp"
#include "write/device.hpp"

#include <string>

using namespace orograph;

namespace {

const std::string kHpgl = "language = 'hpgl'\nname = 'mine'\nunit = 0.1\n";
const std::string kGcode =
    "language = 'gcode'\nname = 'mine'\nunit = 1\npen_up = ['M5']\npen_down = 'M3'\n";

std::string message_of_device(const std::string& toml) {
  const TemporaryFolder folder;
  fill_file(folder.file("d.toml"), toml);
  try {
    read_device(folder.file("d.toml"));
  } catch (const Error& error) {
    const std::string message = error.what();
    CHECK(message.find(folder.file("d.toml")) == 0);
    CHECK(message.find('\n') == std::string::npos);
    return message.substr(folder.file("d.toml").size());
  }
  return "none";
}

} // namespace

TEST_CASE("all devices of ours can be read, and so can few words") {
  REQUIRE(device_names().size() == 5);
  for (const std::string& name : device_names()) {
    const Device device = read_device(name);
    INFO(name);
    CHECK((device.language == Device::Language::gcode) == name.starts_with("grbl"));
    for (const DevicePaper& paper : device.papers) {
      // The window lies on the paper.
      CHECK(paper.origin_mm.x + device.unit_mm * paper.window.low.x >= 0);
      CHECK(paper.origin_mm.y + device.unit_mm * paper.window.low.y >= 0);
      CHECK(paper.origin_mm.x + device.unit_mm * paper.window.high.x <= paper.size_mm.x);
      CHECK(paper.origin_mm.y + device.unit_mm * paper.window.high.y <= paper.size_mm.y);
      if (!paper.park) continue;
      CHECK(paper.park->x >= paper.window.low.x);
      CHECK(paper.park->y >= paper.window.low.y);
      CHECK(paper.park->x <= paper.window.high.x);
      CHECK(paper.park->y <= paper.window.high.y);
    }
  }
  CHECK(read_device("hp7475a").papers.size() == 2);
  CHECK(message_of_device(kHpgl) == "none");
  CHECK(message_of_device(kGcode) == "none");
  CHECK_THROWS_AS(read_device("hp7440"), UsageError);
}

TEST_CASE("what is wrong with a device's file is told with its line") {
  for (const auto& [toml, message] : std::initializer_list<std::pair<std::string, std::string>>{
           {"language = ", ", line 1: this isn't TOML"},
           {"name = 'x'\nunit = 1", ", line 1: a device has no language"},
           {"language = 'hpgl3'", ", line 1: language is text: give hpgl or gcode"},
           {kHpgl + "unlt = 2", ", line 4: unknown key 'unlt': did you mean unit?"},
           {kHpgl + "pens = 0", ", line 4: pens is the number 0"},
           {kHpgl + "decimals = 3", ", line 4: decimals has no meaning in hpgl: leave it out"},
           {kHpgl + "window = [0, 0, 0, 9]", ", line 4: window is a list of 4 values"},
           {kHpgl + "window = [0, 0, 9]", ", line 4: window is a list of 3 values"},
           {kHpgl + "longest = 39", ", line 4: longest is the number 39: give bytes, 40 or more"},
           {kHpgl + "start = 7", ", line 4: start is the number 7"},
           {kHpgl + "start = ['IN;', 7]", ", line 4: a value in start is the number 7"},
           {kHpgl + "start = 'ü'", ", line 4: start isn't plain text"},
           {kHpgl + "start = ''", ", line 4: start isn't plain text"},
           {kHpgl + "wait = 'NR{pem};'", ", line 4: wait knows no {pem}: it knows {pen}, {name}"},
           {kHpgl + "y = 'left'", ", line 4: y is text: give up or down"},
           {kHpgl + "speeds = [9, 3]", ", line 4: speeds is a list of 2 values"},
           {kHpgl + "[[paper]]\nname = 'a4'\nsize = [0, 210]", ", line 6: size is a list"},
           {kHpgl + "[[paper]]\nname = 'a4'\nsize = [297, 210]", ", line 4: a paper has no origin"},
           {kHpgl + "window = [0, 0, 9, 9]\n[[paper]]\nname = 'a4'",
            ", line 4: a window beside papers"},
           {"language = 'gcode'\nname = 'mine'\nunit = 1", ", line 1: a device has no pen_up"},
           {kGcode + "pens = 2", ", line 6: pens has no meaning in gcode"},
           {kGcode + "decimals = 5", ", line 6: decimals is the number 5"},
           {kGcode + "feed = 0", ", line 6: feed is the number 0"},
           {kGcode + "height = 101", ", line 6: height is the number 101"},
           {kGcode + "moves = ['G0 X{x}', 'G1 X{x} Y{y}']", ", line 6: moves is a list"},
           {kGcode + "moves = ['G0 X{x} Y{y}']", ", line 6: moves is a list"},
           {kGcode + "end = '{'", ", line 6: end knows no {: leave it out"}}) {
    INFO(toml);
    INFO(message_of_device(toml));
    CHECK(message_of_device(toml).find(message) == 0);
  }
}
