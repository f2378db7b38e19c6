// SPDX-License-Identifier: GPL-3.0-or-later
// The visible pieces of profiles as strokes.
#pragma once

#include "draw/stroke_builder.hpp"
#include "horizon/clip_profile.hpp"
#include "placing/placed_view.hpp"
#include "profiles/profile.hpp"

#include <cstdint>
#include <span>

namespace orograph {

/// Feeds the visible runs of one profile after another to a builder: runs that meet are one stroke,
/// level ground is left out where its shores are drawn instead, and where lines have places and
/// widths of their own, they are drawn there and as wide.
class ProfileStrokes {
public:
  /// Of profiles of a sector of `view`. REQUIRES that all outlive this.
  ProfileStrokes(const View& view, const Sector& sector, bool draws_level, StrokeBuilder& builder)
      : view_(view), sector_(sector), draws_level_(draws_level), builder_(builder) {}

  /// What is drawn of the planned profile's visible runs, which are in order along it.
  void add(const Profile& profile, const PlannedProfile& planned,
           std::span<const VisibleRun> visible);

private:
  const View& view_;
  const Sector& sector_;
  bool draws_level_;
  StrokeBuilder& builder_;
};

} // namespace orograph
