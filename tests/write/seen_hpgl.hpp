// SPDX-License-Identifier: GPL-3.0-or-later
// HPGL as a small reader of our own sees it.
#pragma once

#include "tests/write/device_drawings.hpp"

#include <algorithm>
#include <sstream>
#include <string>
#include <vector>

namespace orograph {

struct SeenHpgl {
  std::vector<SeenMove> moves;                ///< in mm
  std::size_t longest = 0;                    ///< instruction, bytes
  Vec2 least{1e9, 1e9}, greatest{-1e9, -1e9}; ///< units, wherever the pen went
  std::vector<std::string> words;             ///< the instructions but those that move
};

inline SeenHpgl seen_hpgl(const std::string& hpgl, double unit_mm) {
  SeenHpgl all;
  Vec2 at;
  bool down = false, relative = false;
  int pen = 0;
  const auto go = [&](Vec2 to) {
    if (down) all.moves.push_back({pen, unit_mm * at, unit_mm * to});
    at = to;
    all.least = {std::min(all.least.x, at.x), std::min(all.least.y, at.y)};
    all.greatest = {std::max(all.greatest.x, at.x), std::max(all.greatest.y, at.y)};
  };
  std::istringstream text(hpgl);
  for (std::string instruction; std::getline(text, instruction, ';');) {
    if (instruction == "\n") break;
    all.longest = std::max(all.longest, instruction.size() + 1);
    const std::string name = instruction.substr(0, 2);
    if (name == "PU") down = false;
    if (name == "PD") down = true;
    if (name == "PR") relative = true;
    if (name == "PA") relative = false;
    if (name == "SP") pen = std::stoi(instruction.substr(2));
    if (name != "PU" && name != "PD" && name != "PR" && name != "PA") {
      all.words.push_back(instruction);
      continue;
    }
    std::istringstream numbers(instruction.substr(2));
    char comma = 0;
    for (double x = 0, y = 0; numbers >> x >> comma >> y; numbers >> comma)
      go(relative ? at + Vec2{x, y} : Vec2{x, y});
  }
  return all;
}

} // namespace orograph
