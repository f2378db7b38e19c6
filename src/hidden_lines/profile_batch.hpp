// SPDX-License-Identifier: GPL-3.0-or-later
// Profiles on their way from the cut to the drawing, some at a time.
#pragma once

#include "draw/drawing.hpp"
#include "geometry/segment.hpp"
#include "horizon/clip.hpp"
#include "horizon/clip_profile.hpp"
#include "profiles/profile.hpp"

#include <cstddef>
#include <vector>

#include "placing/placed_view.hpp"

namespace orograph {

/// A profile and what is found of it. Memory is reused from profile to profile.
struct ProfileInWork {
  PlannedProfile planned{};
  Profile profile;
  ProjectedProfile projected;
  std::vector<Segment> uprights;                 ///< along walls
  std::vector<std::vector<VisibleRun>> by_strip; ///< in each strip's range
  std::vector<std::size_t> horizon_sizes;        ///< of each strip, in front of the profile
  std::vector<VisibleRun> visible;               ///< along all of the profile
  Layer strokes;                                 ///< rounded
  double left_out_mm = 0;
  std::size_t dropped_strokes = 0;
};

/// Puts the strips' visible runs together: what is cut where two strips meet is one again.
void join_strips(ProfileInWork& work);

/// The same as segments and pieces of them, for those who watch.
struct PiecesOfProfile {
  std::vector<Segment> segments;
  std::vector<Piece> visible;
};
PiecesOfProfile pieces_of(const ProfileInWork& work, const View& view);

} // namespace orograph
