// SPDX-License-Identifier: GPL-3.0-or-later
// Which of a panorama's sectors a line is in: it is in one or two of 72.
#pragma once

#include "dem/surface.hpp"
#include "hidden_lines/line_pictures.hpp"
#include "placing/placed_view.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace orograph {

/// For each sector of a panorama the numbers of the lines that may reach into what the page shows
/// of it, rising: all that do, and some beside it. `points`: of lines on the ground, in the view's
/// profile frame. Cost: one pass over the lines.
std::vector<std::vector<std::uint32_t>> lines_by_sector(const Surface& surface,
                                                        std::span<const ProfilePoint> points,
                                                        const PlacedView& placed,
                                                        const std::vector<EdgeLine>& lines);

} // namespace orograph
