// SPDX-License-Identifier: GPL-3.0-or-later
#include "horizon/horizon.hpp"

namespace orograph {

void ink(Horizon& horizon, std::size_t at, double begin, double end, bool collapse) {
  HorizonPiece before = horizon[at], after = horizon[at];
  before.x_end = horizon[at].x_begin = begin;
  after.x_begin = horizon[at].x_end = end;
  horizon[at].inked = true;
  const auto place = [&](std::size_t i) {
    return horizon.begin() + static_cast<std::ptrdiff_t>(i);
  };
  if (after.x_begin < after.x_end) {
    horizon.insert(place(at + 1), after);
  } else if (collapse && at + 1 < horizon.size() && continues(horizon[at], horizon[at + 1])) {
    horizon[at].x_end = horizon[at + 1].x_end;
    horizon[at].low = std::min(horizon[at].low, horizon[at + 1].low);
    horizon.erase(place(at + 1));
  }
  if (before.x_begin < before.x_end) {
    horizon.insert(place(at), before);
  } else if (collapse && at > 0 && continues(horizon[at - 1], horizon[at])) {
    horizon[at - 1].x_end = horizon[at].x_end;
    horizon[at - 1].low = std::min(horizon[at - 1].low, horizon[at].low);
    horizon.erase(place(at));
  }
}

} // namespace orograph
