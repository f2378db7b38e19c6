// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/sight.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace orograph {

Sight::Sight(const Surface& surface, std::span<const StandingSolid> solids, const View& view)
    : ground_(surface, view), solids_(solids, view) {
  reach_m_ = std::max(
      {ground_.reach_m(), solids_.reach_m(), length(view.depth_origin_m), std::abs(view.eye_z_m)});
}

// Places are sums of a few products of such lengths, in double.
long double Sight::margin_m(ProfilePoint p, double slack_m) const {
  constexpr double kRounding = 16 * std::numeric_limits<double>::epsilon();
  return slack_m + kRounding * std::max({reach_m_, std::abs(p.u), std::abs(p.v), std::abs(p.z)});
}

Verdict Sight::by_ground(ProfilePoint p, double slack_m) const {
  return ground_.ask(p, margin_m(p, slack_m));
}

Verdict Sight::by_solids(ProfilePoint p, double slack_m, const Own& own) const {
  return solids_.ask(p, margin_m(p, slack_m), own);
}

Sight::Answer Sight::ask(ProfilePoint p, double slack_m, const Own& own) const {
  const Verdict ground = by_ground(p, slack_m), solids = by_solids(p, slack_m, own);
  const bool sure = ground.surely_hidden() || solids.surely_hidden() ||
                    (ground.surely_visible() && solids.surely_visible());
  return {ground.hidden, solids.hidden, !sure};
}

} // namespace orograph
