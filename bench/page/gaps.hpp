// SPDX-License-Identifier: GPL-3.0-or-later
// Gaps between the two profiles beside a point of the page.
#pragma once

#include "bench/page/page_ground.hpp"
#include "bench/page/page_lines.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace orograph {

/// What is next to a point on the two ways across: profiles; or, on one of them, a line of another
/// layer, the frame's end, or ground that lies farther off or nearer without a line between.
enum class Beside { profiles, silhouette, border, jump };
inline constexpr std::size_t kBesideKinds = 4;

struct Gap {
  Beside beside = Beside::profiles;
  /// From profile to profile, across the lines' direction at the point, over the spacing asked for.
  /// Where there is none within ten spacings on a side, these count. 0 where it is no such gap.
  double spacings = 0;
};

/// The lines of a drawing that gaps are judged by.
struct GapLines {
  explicit GapLines(const Drawing& drawing);
  PageLines profiles, silhouettes, border;
};

/// At a point with ground. Profiles run where depth stays the same, so that the way across is where
/// it changes most; that is asked of the ground a quarter of a spacing around, not of the lines,
/// which may end or begin anywhere.
Gap gap_at(const PageGround& ground, const GapLines& lines, const Box2& frame_mm, double spacing_mm,
           Vec2 at_mm);

/// The gaps at so many random points of visible ground that isn't level, evenly over the page.
/// Fewer where there is next to none. The same for the same seed. On all cores.
std::vector<Gap> gaps_of(const PageGround& ground, const GapLines& lines, const Box2& frame_mm,
                         double spacing_mm, std::size_t points, std::uint64_t seed);

struct Evenness {
  std::array<std::size_t, kBesideKinds> points{}; ///< by `Beside`
  double even_share = 0;             ///< of those between profiles: gaps within kEvenGap
  std::array<double, 5> quantiles{}; ///< of their gaps, at kQuantiles
};
struct GapRange {
  double low, high;
};
inline constexpr GapRange kEvenGap{0.5, 1.6};
inline constexpr std::array kQuantiles{0.05, 0.25, 0.5, 0.75, 0.95};

/// Shares and quantiles are NaN where no point is between profiles.
Evenness evenness_of(const std::vector<Gap>& gaps);

} // namespace orograph
