// SPDX-License-Identifier: GPL-3.0-or-later
#include "hidden_lines/instruments.hpp"

namespace orograph {

void round_to_float(std::vector<Segment>& segments) {
  for (Segment& s : segments)
    for (double* coordinate : {&s.x0, &s.y0, &s.x1, &s.y1})
      *coordinate = static_cast<double>(static_cast<float>(*coordinate));
  std::erase_if(segments, [](const Segment& s) { return !(s.x0 < s.x1); });
}

} // namespace orograph
