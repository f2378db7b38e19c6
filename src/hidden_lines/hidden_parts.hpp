// SPDX-License-Identifier: GPL-3.0-or-later
// What of lines the eye doesn't see: what is left of them without their visible parts.
#pragma once

#include "hidden_lines/line_parts.hpp"
#include "hidden_lines/line_pictures.hpp"
#include "horizon/clip_profile.hpp"
#include "profiles/profile.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace orograph {

/// Kinds of lines of which hidden parts are wanted.
class HiddenKinds {
public:
  void add(LineKind kind) { bits_ |= bit(kind); }
  bool has(LineKind kind) const { return (bits_ & bit(kind)) != 0; }
  bool any() const { return bits_ != 0; }

private:
  static std::uint32_t bit(LineKind kind) {
    return std::uint32_t{1} << static_cast<std::uint32_t>(kind);
  }
  std::uint32_t bits_ = 0;
};

/// What of the first `count` lines, those of `kinds` that are drawn, is in front of the near plane
/// and not in `visible`, which is joined and by line; by line as well. What lies beside the page
/// is in it: nobody has looked there. Slits that rounding leaves between visible parts aren't.
/// Cost: a picture of each of those lines.
std::vector<LinePart> hidden_parts(const LinePictures& lines, std::size_t count,
                                   const HiddenKinds& kinds, const std::vector<LinePart>& visible);

/// The same of a profile's visible runs, which are in order along it; gaps are no part of it.
std::vector<VisibleRun> hidden_runs(const Profile& profile, std::span<const VisibleRun> visible);

} // namespace orograph
