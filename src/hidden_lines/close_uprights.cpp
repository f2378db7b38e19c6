// SPDX-License-Identifier: GPL-3.0-or-later
#include "hidden_lines/close_uprights.hpp"

#include <cmath>

namespace orograph {

std::vector<std::uint32_t> too_close(std::span<const TurnedAway> along, double apart,
                                     bool rightmost_stays) {
  std::vector<std::uint32_t> out;
  const TurnedAway* stays = nullptr;
  for (std::size_t i = 0; i < along.size(); ++i) {
    const TurnedAway& next = along[i];
    if (!stays || !(std::abs(next.at - along[i - 1].at) < apart)) {
      stays = &next;
    } else if (rightmost_stays ? next.at > stays->at : next.at < stays->at) {
      out.push_back(stays->edge);
      stays = &next;
    } else {
      out.push_back(next.edge);
    }
  }
  return out;
}

} // namespace orograph
