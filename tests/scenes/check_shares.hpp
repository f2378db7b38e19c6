// SPDX-License-Identifier: GPL-3.0-or-later
// What is said to be visible of lines among solids, asked of the reference.
#pragma once

#include "geometry/profile_point.hpp"
#include "horizon/clip_profile.hpp"
#include "reference/sight.hpp"
#include "solids/standing_solid.hpp"
#include "tests/support/random.hpp"
#include "view/view.hpp"

#include <cstdint>
#include <functional>
#include <limits>
#include <span>
#include <string>
#include <vector>

namespace orograph {

/// Of a line from its first end (0) to its last (1); along it in space, in any view.
struct LineShare {
  double begin = 0, end = 1;
};

/// The visible shares of edge `edge` of standing solid `solid`, in order and apart; of edges that
/// aren't drawn, none.
using VisibleShares = std::function<std::vector<LineShare>(std::size_t solid, std::size_t edge)>;
/// The shares of a straight line on the ground that solids hide, in order and apart.
using SharesBySolids = std::function<std::vector<LineShare>(ProfilePoint from, ProfilePoint to)>;

struct ShareTally {
  std::uint64_t lines = 0, shares = 0;
  std::uint64_t asked = 0, unsure = 0;
  std::uint64_t visible = 0; ///< of those asked, surely
  std::uint64_t drawn_but_hidden = 0, missing = 0;
  std::uint64_t disordered = 0; ///< lists that are no shares in order and apart
  std::string first_wrong;      ///< where; empty: nothing is wrong

  std::uint64_t wrong() const { return drawn_but_hidden + missing + disordered; }
  void add(const ShareTally& more);
};

struct ShareCheck {
  double slack_m = 0;     ///< see Sight::ask
  double nearest_m = 0;   ///< no depths below it are asked; in perspective more than 0
  double near_end = 1e-6; ///< how far from an end of a share points lie on either side of it
  int anywhere = 3;       ///< random points on each line
  XRange x = {-std::numeric_limits<double>::infinity(),
              std::numeric_limits<double>::infinity()}; ///< no points beside it are asked
};
/// The near plane, and a slack of 1e-10 of what coordinates reach.
ShareCheck share_check(const View& view, std::span<const StandingSolid> solids);

/// Asks of all edges: points anywhere, on both sides of each share's ends, in the middle of shares
/// and of gaps.
///  - Wires are drawn where they are visible.
///  - A smooth edge is drawn only between a triangle that faces the eye and one that doesn't.
///  - An edge whose triangles both face away is hidden.
///  - Where rounding or the slack decides how a triangle faces, that is unsure.
ShareTally check_edges(const Sight& sight, const View& view, std::span<const StandingSolid> solids,
                       const VisibleShares& visible_shares, Random& random,
                       const ShareCheck& check);

/// Asks of one line on the ground what solids hide of it; what the ground hides is left open. Where
/// the line touches a solid it is unsure.
ShareTally check_ground_line(const Sight& sight, ProfilePoint from, ProfilePoint to,
                             const SharesBySolids& hidden_shares, Random& random,
                             const ShareCheck& check);

} // namespace orograph
