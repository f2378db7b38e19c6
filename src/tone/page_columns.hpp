// SPDX-License-Identifier: GPL-3.0-or-later
// The page in narrow columns of X, in which ground is looked at.
#pragma once

#include "geometry/box.hpp"
#include "geometry/homography.hpp"
#include "geometry/segment.hpp"
#include "view/view.hpp"

#include <cmath>
#include <cstddef>
#include <vector>

namespace orograph {

/// One of a panorama's columns: one direction from the eye.
struct FanColumn {
  double x, width; ///< of X in its sector's visibility plane; x in its middle
  double azimuth;  ///< of its middle, from that of the page; radians
  double aside;    ///< from its sector's forward direction; radians
};

/// Columns of one width that tile a range of X; whatever is asked in one is asked in its middle.
/// Where the page shows rays beside the eye X has no ends: there they tile a range of u, and what
/// lies in one of them isn't in one direction from the eye, but looks as if it were from far above.
/// Those of a panorama are its sectors', one behind the other; X then counts the columns.
struct PageColumns {
  double begin = 0, width = 1; ///< of X, or of u
  std::size_t count = 0;
  double mm = 1;                   ///< about the width on the page
  bool of_u = false;               ///< else of X
  std::vector<FanColumn> fan = {}; ///< of a panorama all of them

  double middle(std::size_t i) const { return begin + (static_cast<double>(i) + 0.5) * width; }
  double edge(std::size_t i) const { return begin + static_cast<double>(i) * width; }

  /// In a plane of constant depth, u of the middle of the first column, and of the next ones'
  /// middles from there.
  double first_u_m(const View& view, double depth_m) const {
    if (of_u) return middle(0);
    return view.is_perspective() ? middle(0) * depth_m : middle(0) - view.x_per_v * depth_m;
  }
  double step_u_m(const View& view, double depth_m, std::size_t i = 0) const {
    if (!fan.empty()) return fan[i].width * depth_m;
    return view.is_perspective() && !of_u ? width * depth_m : width;
  }
  /// How u changes with depth along a column.
  double u_per_v(const View& view, std::size_t i) const {
    if (of_u) return 0;
    if (!fan.empty()) return fan[i].x;
    return view.is_perspective() ? middle(i) : -view.x_per_v;
  }
  /// In which column a place of a plane of constant depth is; any number where it is in none.
  double column_of(double x, double depth_m) const {
    return std::floor(((of_u ? x * depth_m : x) - begin) / width);
  }
};

/// Columns of a range without infinite ends, each about `mm` wide on a page of which `frame_mm` is
/// drawn on.
PageColumns page_columns(XRange range, bool of_u, const Box2& frame_mm, double mm);

} // namespace orograph
