// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/page/gaps.hpp"

#include "geometry/on_all_cores.hpp"
#include "tests/support/random.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>

namespace orograph {
namespace {

constexpr double kReach = 10, kAround = 0.25; // spacings
// Lines may be simplified by so much: where one runs along a brow, the ground just before it
// counts.
constexpr double kLinesAreOff_mm = 0.03;
constexpr std::size_t kTriesOfPoint = 100;

// A number that is linear on a plane's picture, and falls or rises with depth.
double depth_on_page(const ShownGround& shown) {
  return shown.sector->view.is_perspective() ? 1 / shown.at.v : shown.at.v;
}

// How it changes from the point along a page's axis, per mm; none where ground is on neither side.
std::optional<double> change_along(const PageGround& ground, Vec2 at_mm, Vec2 step_mm) {
  double from_mm = 0, to_mm = 0, from = 0, to = 0;
  from = to = depth_on_page(*ground.at(at_mm));
  const Vec2 before_mm = at_mm - step_mm, behind_mm = at_mm + step_mm;
  if (!ground.jumps_between(at_mm, before_mm)) {
    from_mm = -length(step_mm);
    from = depth_on_page(*ground.at(before_mm));
  }
  if (!ground.jumps_between(at_mm, behind_mm)) {
    to_mm = length(step_mm);
    to = depth_on_page(*ground.at(behind_mm));
  }
  if (from_mm == to_mm) return std::nullopt;
  return (to - from) / (to_mm - from_mm);
}

std::optional<Vec2> across(const PageGround& ground, Vec2 at_mm, double spacing_mm) {
  const auto x = change_along(ground, at_mm, {kAround * spacing_mm, 0}),
             y = change_along(ground, at_mm, {0, kAround * spacing_mm});
  if (!x || !y) return std::nullopt;
  const double steepness = length(Vec2{*x, *y});
  if (!(steepness > 0)) return std::nullopt;
  return (1 / steepness) * Vec2{*x, *y};
}

// How far it is to the frame's end.
double to_frame_mm(const Box2& frame_mm, Vec2 from_mm, Vec2 direction) {
  const auto way = [](double from, double low, double high, double step) {
    if (step == 0) return std::numeric_limits<double>::infinity();
    return ((step > 0 ? high : low) - from) / step;
  };
  return std::min(way(from_mm.x, frame_mm.low.x, frame_mm.high.x, direction.x),
                  way(from_mm.y, frame_mm.low.y, frame_mm.high.y, direction.y));
}

struct OneWay {
  Beside beside;
  double mm;
};

OneWay one_way(const PageGround& ground, const GapLines& lines, const Box2& frame_mm,
               double reach_mm, Vec2 from_mm, Vec2 direction) {
  const double profile_mm =
      lines.profiles.first_met(from_mm, direction, reach_mm).value_or(reach_mm);
  const double silhouette_mm = lines.silhouettes.first_met(from_mm, direction, profile_mm)
                                   .value_or(std::numeric_limits<double>::infinity());
  const double border_mm = std::min(lines.border.first_met(from_mm, direction, profile_mm)
                                        .value_or(std::numeric_limits<double>::infinity()),
                                    to_frame_mm(frame_mm, from_mm, direction));
  if (border_mm < std::min(profile_mm, silhouette_mm)) return {Beside::border, border_mm};
  if (silhouette_mm < profile_mm) return {Beside::silhouette, silhouette_mm};
  const double sure_mm = std::max(0.0, profile_mm - kLinesAreOff_mm);
  if (ground.jumps_between(from_mm, from_mm + sure_mm * direction))
    return {Beside::jump, profile_mm};
  return {Beside::profiles, profile_mm};
}

} // namespace

GapLines::GapLines(const Drawing& drawing)
    : profiles(drawing, {"profiles"}), silhouettes(drawing, {"silhouettes", "skyline", "solids"}),
      border(drawing, {"border", "shores", "voids"}) {}

Gap gap_at(const PageGround& ground, const GapLines& lines, const Box2& frame_mm, double spacing_mm,
           Vec2 at_mm) {
  const std::optional<Vec2> direction = across(ground, at_mm, spacing_mm);
  if (!direction) return {Beside::jump};
  double gap_mm = 0;
  for (const double side : {-1.0, 1.0}) {
    const OneWay way =
        one_way(ground, lines, frame_mm, kReach * spacing_mm, at_mm, side * *direction);
    if (way.beside != Beside::profiles) return {way.beside};
    gap_mm += way.mm;
  }
  return {Beside::profiles, gap_mm / spacing_mm};
}

std::vector<Gap> gaps_of(const PageGround& ground, const GapLines& lines, const Box2& frame_mm,
                         double spacing_mm, std::size_t points, std::uint64_t seed) {
  std::vector<std::optional<Gap>> tried(points);
  on_all_cores(points, [&](std::size_t i) {
    Random random(seed * 1000003 + i);
    for (std::size_t k = 0; k < kTriesOfPoint && !tried[i]; ++k) {
      const double x_mm = random.between(frame_mm.low.x, frame_mm.high.x),
                   y_mm = random.between(frame_mm.low.y, frame_mm.high.y);
      const std::optional<ShownGround> shown = ground.at({x_mm, y_mm});
      if (shown && !shown->is_level)
        tried[i] = gap_at(ground, lines, frame_mm, spacing_mm, {x_mm, y_mm});
    }
  });
  std::vector<Gap> gaps;
  for (const std::optional<Gap>& gap : tried)
    if (gap) gaps.push_back(*gap);
  return gaps;
}

Evenness evenness_of(const std::vector<Gap>& gaps) {
  Evenness found;
  std::vector<double> between;
  for (const Gap& gap : gaps) {
    ++found.points[static_cast<std::size_t>(gap.beside)];
    if (gap.beside == Beside::profiles) between.push_back(gap.spacings);
  }
  std::ranges::sort(between);
  const auto count = static_cast<double>(between.size());
  const auto even = std::ranges::count_if(
      between, [](double gap) { return gap >= kEvenGap.low && gap <= kEvenGap.high; });
  found.even_share = static_cast<double>(even) / count;
  for (std::size_t i = 0; i < kQuantiles.size(); ++i)
    found.quantiles[i] =
        between.empty()
            ? std::numeric_limits<double>::quiet_NaN()
            : between[static_cast<std::size_t>(std::lround(kQuantiles[i] * (count - 1)))];
  return found;
}

} // namespace orograph
