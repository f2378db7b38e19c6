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
/// and level ground is left out where its shores are drawn instead.
class ProfileStrokes {
public:
  /// Of profiles of a sector of `view`. REQUIRES that all outlive this.
  ProfileStrokes(const View& view, const Sector& sector, bool draws_level, StrokeBuilder& builder)
      : view_(view), sector_(sector), draws_level_(draws_level), builder_(builder) {}

  /// `visible` in order along the profile.
  void add(const Profile& profile, std::int32_t number, std::span<const VisibleRun> visible);

private:
  const View& view_;
  const Sector& sector_;
  bool draws_level_;
  StrokeBuilder& builder_;
};

} // namespace orograph
