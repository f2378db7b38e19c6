// SPDX-License-Identifier: GPL-3.0-or-later
// Clipping of whole profiles, vertex after vertex, against a horizon in blocks: the quick form of
// `clip` for what is compared with the horizon and doesn't raise it. And of profiles along walls,
// segments with no extent in X.
#pragma once

#include "geometry/segment.hpp"
#include "horizon/blocked_horizon.hpp"
#include "horizon/clip.hpp"
#include "horizon/compare.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace orograph {

/// A visible stretch of a profile: from the span behind vertex `first`, at the share `t_begin` of
/// it, to the span behind vertex `last`, at `t_end`.
struct VisibleRun {
  std::uint32_t first, last;
  double t_begin, t_end;
  bool operator==(const VisibleRun&) const = default;
};

/// What was found on the way.
struct ProfileClipCounts {
  std::size_t ties = 0;
  std::size_t steps = 0; ///< spans compared with pieces
};

/// Appends to `visible`, left to right, what of the profile within `range` is above the horizon,
/// which stays as it is but for marks where a line is tied with it and drawn; none of a profile
/// that isn't drawn. Cut at `range`'s ends a span is the same span, so neighbouring ranges can be
/// put together again. The pieces are those of `clip` with Role::compared. Cost: about 2 ns a
/// vertex where a block of the horizon is above or below all of the profile in it, and that of
/// `clip` elsewhere; no allocation once warm.
void clip_profile(const ProjectedProfile& profile, XRange range, BlockedHorizon& horizon,
                  const TieTolerance& tolerance, bool is_drawn, std::vector<VisibleRun>& visible,
                  ProfileClipCounts& counts);

/// The same of one of its runs, or of a part of one.
void clip_run(const ProjectedProfile& profile, VertexRun run, XRange range, BlockedHorizon& horizon,
              const TieTolerance& tolerance, bool is_drawn, std::vector<VisibleRun>& visible,
              ProfileClipCounts& counts);

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
