// SPDX-License-Identifier: GPL-3.0-or-later
// Profiles along walls: segments with no extent in X.
#pragma once

#include "horizon/clip.hpp"

#include <span>
#include <vector>

namespace orograph {

/// What of each upright segment (x0 == x1; a profile's way up or down a wall that the eye sees) is
/// above `horizon`, as pieces numbered by `uprights`. Where the horizon has a step at that X, its
/// lower side counts: the wall's own top stands on the higher one. `beside` is what is that close
/// in X counts as being at it.
template <class AnyHorizon> // Horizon or BlockedHorizon
std::vector<Piece> visible_uprights(std::span<const Segment> uprights, const AnyHorizon& horizon,
                                    double beside);

/// Puts uprights and their visible pieces where they belong among a profile's segments and pieces:
/// in order of ids.
void insert_uprights(std::span<const Segment> uprights, std::span<const Piece> visible_uprights,
                     std::vector<Segment>& segments, std::vector<Piece>& visible);

} // namespace orograph
