// SPDX-License-Identifier: GPL-3.0-or-later
// G-code as a small interpreter sees it.
#pragma once

#include "tests/write/device_drawings.hpp"

#include <algorithm>
#include <functional>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace orograph {

struct SeenGcode {
  std::vector<SeenMove> moves; ///< G1 in the plane, and where the pen touches without one
  std::size_t longest = 0;     ///< line, bytes
  int waits = 0;
  std::set<double> feeds, heights; ///< with the pen down
  bool ends_up = false;
  std::string fault; ///< what no machine should be told, if anything
};

// Which words lower the pen differs: `is_down` says it of a machine's Z and S.
inline SeenGcode seen_gcode(const std::string& gcode,
                            const std::function<bool(double z, double s)>& is_down) {
  SeenGcode all;
  Vec2 at;
  double z = 99, s = 99, feed = 0;
  bool down = false, has_drawn = false;
  int pen = 1;
  std::istringstream text(gcode);
  for (std::string line; std::getline(text, line);) {
    all.longest = std::max(all.longest, line.size());
    std::istringstream words(line);
    Vec2 to = at;
    int g = -1;
    bool moves = false;
    for (std::string word; words >> word;) {
      const double value = std::stod(word.substr(1));
      if (word[0] == 'G') g = static_cast<int>(value);
      if (word[0] == 'F') feed = value;
      if (word[0] == 'Z') z = value;
      if (word[0] == 'S') s = value;
      if (word[0] == 'X') to.x = value;
      if (word[0] == 'Y') to.y = value;
      moves = moves || word[0] == 'X' || word[0] == 'Y';
      if (word == "M0") {
        if (down) all.fault = "waits with the pen down";
        ++all.waits;
        ++pen;
      }
    }
    if (g == 2 || g == 3) all.fault = "an arc";
    const bool was_down = down;
    down = is_down(z, s);
    if (!was_down && down) has_drawn = false;
    if (was_down && !down && !has_drawn) all.fault = "the pen goes down for nothing";
    if (down) all.heights.insert(z == 99 ? s : z);
    if (!moves) continue;
    if ((g == 1) != down) all.fault = "fast on paper, or slow above it";
    if (down) {
      all.moves.push_back({pen, at, to});
      all.feeds.insert(feed);
      has_drawn = true;
    }
    at = to;
  }
  all.ends_up = !down;
  return all;
}

} // namespace orograph
