// SPDX-License-Identifier: GPL-3.0-or-later
// What of a thin sheet an eye sees, by its definition: a point that no other point of the sheet
// stands in front of, on the upper side or on the underside. Shares no code with the pass.
#pragma once

#include "geometry/profile_point.hpp"
#include "view/view.hpp"

#include <array>
#include <vector>

namespace orograph {

class SheetWalk {
public:
  /// In the profile frame of `view`; nothing nearer than `from_m` stands in front of anything in
  /// perspective. Cost of a point: all triangles.
  SheetWalk(std::vector<std::array<ProfilePoint, 3>> triangles, const View& view, double from_m)
      : triangles_(std::move(triangles)), view_(view), from_m_(from_m) {}

  enum class Sight {
    hidden,
    upper, ///< side of the sheet that is seen
    underside,
    edge,  ///< seen; no ground in front of it meets it
    unsure ///< the way to the eye passes the sheet, or leads along it, within a tolerance
  };
  /// Of a point on the sheet. `tolerance_m` is a height.
  Sight sight(ProfilePoint point, double tolerance_m) const;

private:
  std::vector<std::array<ProfilePoint, 3>> triangles_;
  const View& view_;
  double from_m_;
};

} // namespace orograph
