// SPDX-License-Identifier: GPL-3.0-or-later
// What a flat thing hides from the eye is a convex region of space, bounded by planes: so what it
// hides of a straight line is one part, found without projecting anything (docs/scenes.md).
#pragma once

#include "geometry/vec.hpp"
#include "view/view.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace orograph {

// Parts of a straight line, as shares of the way along it.

/// From `begin` to `end`, 0 at the line's first end and 1 at its last.
struct Share {
  double begin, end;
};

/// Brings shares in order and puts together what overlaps or meets. What is no longer than `sliver`
/// is dropped, and gaps that are no wider are closed.
inline void unite(std::vector<Share>& shares, double sliver) {
  std::sort(shares.begin(), shares.end(),
            [](const Share& a, const Share& b) { return a.begin < b.begin; });
  std::size_t count = 0;
  for (const Share& share : shares) {
    if (count > 0 && shares[count - 1].end >= share.begin - sliver)
      shares[count - 1].end = std::max(shares[count - 1].end, share.end);
    else
      shares[count++] = share;
  }
  shares.resize(count);
  std::erase_if(shares, [&](const Share& s) { return s.end - s.begin <= sliver; });
}

/// Calls `take` with every part of [begin, end] that is in none of the shares and longer than
/// `sliver`. REQUIRES that they are united.
template <class Take>
void for_each_rest(const std::vector<Share>& shares, double begin, double end, double sliver,
                   const Take& take) {
  for (const Share& share : shares) {
    if (std::min(share.begin, end) - begin > sliver) take(Share{begin, std::min(share.begin, end)});
    begin = std::max(begin, share.end);
  }
  if (end - begin > sliver) take(Share{begin, end});
}

/// In the profile frame (u, v, z), metres.
inline Vec3 as_vec(ProfilePoint p) {
  return {p.u, p.v, p.z};
}

/// Where rays of sight come from: the eye, or of a parallel view the direction they run in, away
/// from the viewer, of no certain length.
struct SightRays {
  Vec3 from;
  bool parallel = false;
};
SightRays sight_rays(const View& view);

/// A normal of the plane of the rays through a and b: exactly the opposite of that through b and a.
Vec3 ray_plane_normal(const SightRays& rays, Vec3 a, Vec3 b);

/// A half-space: what is at least `slack` (times the normal's length) on the normal's side.
struct ShadowPlane {
  Vec3 normal, point;
  double slack = 0;
  double at(Vec3 p) const { return dot(normal, p - point) - slack; }
};

/// The points that are inside all four.
struct Shadow {
  std::array<ShadowPlane, 4> planes;
};

/// The part of a line that is in the shadow, if any of it is. Where two shadows share a plane's
/// numbers, their parts meet in the very same share.
std::optional<Share> hidden_share(const Shadow& shadow, Vec3 from, Vec3 to);

/// What a triangle hides that is seen from outside: what is behind it, but for what touches it
/// within `touching_m`. `order` are numbers of its corners: of neighbours the same. REQUIRES
/// that corners run counterclockwise for the eye, and aren't in one line with it.
Shadow triangle_shadow(const SightRays& rays, const std::array<Vec3, 3>& corners,
                       const std::array<std::uint32_t, 3>& order, double touching_m);

/// What an edge of the ground hides, which is solid from there downwards: what is behind it, and
/// lower in the picture by more than `touching_m`. REQUIRES `left` left of `right` in the
/// visibility plane, both in front of the near plane, and a view that isn't straight down.
Shadow edge_shadow(const View& view, const SightRays& rays, Vec3 left, Vec3 right,
                   double touching_m);

/// What is buried under a triangle of the ground by more than `touching_m`, upright. REQUIRES
/// corners counterclockwise seen from above.
Shadow buried_under(std::array<Vec3, 3> corners, double touching_m);

} // namespace orograph
