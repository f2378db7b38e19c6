// SPDX-License-Identifier: GPL-3.0-or-later
// Placing a picture on paper.
#pragma once

#include "draw/drawing.hpp"
#include "draw/page_request.hpp"
#include "geometry/box.hpp"
#include "geometry/homography.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace orograph {

struct Placement {
  Page page;
  Box2 room_mm;       ///< the page inside of its margins and of the request's room
  Homography to_page; ///< from picture-plane coordinates (x right, y up) to page mm
};

/// ISO sizes a0 to a6, b0 to b6 and "letter", "legal", "tabloid"; portrait, whatever the case of
/// `name`.
std::optional<Vec2> paper_size_mm(std::string_view name);
const std::vector<std::string>& paper_names();

/// The page for a picture of this window (picture-plane coordinates): the window as large as fits
/// inside the margins and what the request leaves to others there, or at the scale asked for, its
/// unit being a metre; centred, never stretched. `by_picture` takes the orientation in which it
/// comes out larger. A page without a height is as high as the picture needs, whatever the
/// orientation; one to be cropped ends, in either direction, where the picture and its margins end.
/// Throws UsageError where the margins leave less than 1 mm, a side is over 10 m, or the picture is
/// larger at its scale than the page, and then says which would do.
Placement place_on_page(const Box2& window, const PageRequest& request);

} // namespace orograph
