// SPDX-License-Identifier: GPL-3.0-or-later
// Lengths on the page along straight lines in space.
#pragma once

#include "geometry/box.hpp"
#include "geometry/homography.hpp"
#include "profiles/slab_lines.hpp"
#include "view/view.hpp"

#include <optional>

namespace orograph {

/// A straight line's picture, as far as it is inside a frame.
class LineOnPage {
public:
  /// None where nothing of the line is inside the frame, or its picture is a point.
  static std::optional<LineOnPage> of(const ProfileLine& line, const View& view,
                                      const Homography& to_page, const Box2& frame_mm);

  double length_mm() const { return length_mm_; }
  /// Share along the line (0 at `from`, 1 at `to`) of the place that is `mm` from where the picture
  /// comes into the frame, and the other way round.
  double share_at(double mm) const;
  double mm_at(double share) const;

private:
  double w_from_ = 1, w_to_ = 1; ///< homogeneous weights of the ends
  double begin_ = 0, end_ = 1;   ///< shares of the way along the whole picture
  double length_mm_ = 0;
};

/// The page point of a point in the profile frame, in mm. REQUIRES that it has a picture.
inline Vec2 page_mm(ProfilePoint p, const View& view, const Homography& to_page) {
  return to_page(project(view, p));
}

} // namespace orograph
