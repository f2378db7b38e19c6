// SPDX-License-Identifier: GPL-3.0-or-later
// One sector with the surface as occluder, in strips of X on all cores: each strip of its own,
// front to back, and all profiles and lines of the sector by strips.
#pragma once

#include "hidden_lines/line_pass.hpp"
#include "hidden_lines/sector_in_work.hpp"
#include "hidden_lines/strips.hpp"
#include "horizon/blocked_horizon.hpp"
#include "horizon/clip_profile.hpp"

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace orograph {
/// Takes slabs of lines and profiles in the order of their depth. What it refers to of `work` must
/// outlive it.
class StripPass {
public:
  /// `which`: the lines that reach into the strip; `near_cut` stands in front of everything.
  StripPass(const SectorInWork& work, const Strip& strip, std::span<const LineAtDepth> which,
            std::span<const Segment> near_cut);
  StripPass(const StripPass&) = delete;
  StripPass& operator=(const StripPass&) = delete;

  /// Lines up to a depth.
  void take_lines(double to_m);
  /// What of a profile is visible in the strip, into `visible`. REQUIRES that lines were taken up
  /// to its depth.
  void take_profile(const ProfileInWork& profile, std::vector<VisibleRun>& visible);
  /// Lines behind the last profile.
  void finish();

  /// All that was visible so far.
  const std::vector<LinePart>& visible_parts() const { return lines_.visible_parts(); }
  const LinePictures& pictures() const { return pictures_; }
  const BlockedHorizon& horizon() const { return horizon_; }
  const ProfileClipCounts& counts() const { return counts_; }

private:
  void take_slab(double to_m);

  const SectorInWork& work_;
  XRange range_;
  LinePictures pictures_;
  LinePass lines_;
  BlockedHorizon horizon_;
  SlabPlanes planes_;
  ProfileClipCounts counts_;
};

/// All strips of a sector, left to right; they don't depend on each other.
std::vector<std::unique_ptr<StripPass>> strips_of(const SectorInWork& work);

/// Profiles are cut, clipped strip by strip, and laid out, a batch of them after another, on all
/// threads that the caller's arena has. The result is the same with any number of threads. Seconds
/// of the stages are those of all threads together.
SectorParts strips_pass(const SectorInWork& work, const LayOut& lay_out, const Show& show,
                        Counts& counts, StageSeconds& seconds);

} // namespace orograph
