// SPDX-License-Identifier: GPL-3.0-or-later
// The visible pieces of profiles as strokes.
#pragma once

#include "draw/stroke_builder.hpp"
#include "horizon/clip.hpp"
#include "profiles/profile.hpp"
#include "view/view.hpp"

#include <cstdint>
#include <vector>

namespace orograph {

/// Feeds the visible pieces of one profile after another to a builder: pieces that meet are one
/// stroke, and level ground is left out where its shores are drawn instead.
class ProfileStrokes {
public:
  /// REQUIRES that view and builder outlive this.
  ProfileStrokes(const View& view, bool draws_level, StrokeBuilder& builder)
      : view_(view), draws_level_(draws_level), builder_(builder) {}

  void add(const Profile& profile, std::int32_t number, const std::vector<Segment>& segments,
           const std::vector<Piece>& visible);

private:
  StrokePoint point(const Profile& profile, std::uint32_t left, double t) const;

  const View& view_;
  bool draws_level_;
  StrokeBuilder& builder_;
};

} // namespace orograph
