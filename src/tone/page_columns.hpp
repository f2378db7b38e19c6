// SPDX-License-Identifier: GPL-3.0-or-later
// The page in narrow columns of X, in which ground is looked at.
#pragma once

#include "geometry/box.hpp"
#include "geometry/homography.hpp"
#include "geometry/segment.hpp"
#include "view/view.hpp"

#include <cstddef>

namespace orograph {

/// Columns of one width that tile a range of X; whatever is asked in one is asked in its middle.
struct PageColumns {
  double begin = 0, width = 1; ///< of X
  std::size_t count = 0;
  double mm = 1; ///< about the width on the page

  double middle(std::size_t i) const { return begin + (static_cast<double>(i) + 0.5) * width; }
  double edge(std::size_t i) const { return begin + static_cast<double>(i) * width; }
};

/// Columns of a range without infinite ends, each about `mm` wide on a page of which `frame_mm` is
/// drawn on.
PageColumns page_columns(XRange range, const Box2& frame_mm, double mm);

} // namespace orograph
