// SPDX-License-Identifier: GPL-3.0-or-later
// Labels of lines on the ground: heights on contours, numbers at the ends of graticule and grid.
#pragma once

#include "draw/drawing.hpp"
#include "geometry/box.hpp"

#include <functional>
#include <optional>
#include <vector>

#include "naming/ink_map.hpp"
#include "naming/taken_room.hpp"

namespace orograph {

/// Makes a text ready for the page, with its extent.
using SetText = std::function<PageText(PageText)>;

/// The lines that are labelled: page points, and beside them as map points those of the view's
/// profile frame; strokes that know their features.
struct LinesToLabel {
  Layer contours, graticule, grid; ///< index contours; without strokes where they have no labels
};

/// Heights on index contours: where a line is straight and the fewest others are beside it, one for
/// every so many millimetres of it, turned along it so that the text's upper side is where the
/// ground rises. `uphill_mm` tells that for a point of the profile frame as a direction on the
/// page; none: level ground. None touches what is taken; what they take is added.
std::vector<PageText> contour_labels(const Layer& lines, double size_mm, const Box2& room_mm,
                                     const InkMap& ink, const SetText& set,
                                     const std::function<std::optional<Vec2>(Vec3)>& uphill_mm,
                                     TakenRoom& taken);

/// Longitudes and latitudes, or eastings and northings, level, beyond the ends of lines, one at
/// each end that `leaves` says is at the terrain's border: of a point of the profile frame and its
/// neighbour on the line. At most two for a line, those that are farthest apart; none touches what
/// is taken, or leaves the room.
std::vector<PageText> coordinate_labels(const Layer& lines, double size_mm, const Box2& room_mm,
                                        const SetText& set,
                                        const std::function<bool(Vec3, Vec3)>& leaves,
                                        TakenRoom& taken);

/// "7°30′E", with as many seconds as it takes.
std::string angle_label(double deg, bool is_longitude);

} // namespace orograph
