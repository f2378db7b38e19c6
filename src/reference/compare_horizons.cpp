// SPDX-License-Identifier: GPL-3.0-or-later
// Both horizons are walked at once, from end to end of their pieces.
#include "reference/compare_horizons.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace orograph {
namespace {

constexpr double kRelativeRounding = std::numeric_limits<double>::epsilon();

// Of a height at x on the source, and of a crossing's place (docs/how-it-works.md).
double height_rounding(const Segment& s, double x) {
  return 16 * kRelativeRounding *
         (std::max(std::abs(s.y0), std::abs(s.y1)) + std::abs(s.slope) * std::abs(x));
}
double place_rounding(double x) {
  return 16 * kRelativeRounding * std::abs(x);
}

// The stretch from `begin` to `end`, where one horizon is of source a and the other of b.
void judge(const HorizonPiece& a, const HorizonPiece& b, double begin, double end,
           const TieTolerance& tolerance, HorizonDifferences& found) {
  if (!(begin < end)) return; // of the true horizon's, which rounding has left no width
  if (end - begin <= place_rounding(std::max(std::abs(begin), std::abs(end)))) return;
  ++found.stretches;
  if (is_sky(a) || is_sky(b)) {
    ++found.wrong;
    return;
  }
  bool tied = true;
  double farthest_mm = 0;
  for (const double x : {begin, end}) {
    const double y = height_at(a.source, x);
    const double difference = std::abs(height_difference(a.source, b.source, x));
    if (difference >
        tolerance.at(x, y) + height_rounding(a.source, x) + height_rounding(b.source, x))
      tied = false;
    if (tolerance.page.w({x, y}) > 0)
      farthest_mm = std::max(farthest_mm, difference * tolerance.page.mm_per_y({x, y}));
  }
  if (tied)
    found.farthest_mm = std::max(found.farthest_mm, farthest_mm);
  else
    ++found.wrong;
}

} // namespace

HorizonDifferences& HorizonDifferences::operator+=(const HorizonDifferences& other) {
  ties_more += other.ties_more;
  ties_fewer += other.ties_fewer;
  marks += other.marks;
  fragments += other.fragments;
  stretches += other.stretches;
  wrong += other.wrong;
  farthest_mm = std::max(farthest_mm, other.farthest_mm);
  return *this;
}

HorizonDifferences compare_horizons(const Horizon& kept, const Horizon& least,
                                    const TieTolerance& tolerance) {
  HorizonDifferences found;
  std::size_t i = 0, k = 0;
  std::size_t more = 0, fewer = 0; // ends of either alone, since the two agreed last
  double x = -std::numeric_limits<double>::infinity();
  const auto agree = [&] { return kept[i].source.id == least[k].source.id; };
  while (i + 1 < kept.size() || k + 1 < least.size()) {
    const double end = std::min(kept[i].x_end, least[k].x_end);
    if (!agree()) judge(kept[i], least[k], x, end, tolerance, found);
    const bool of_kept = i + 1 < kept.size() && kept[i].x_end == end;
    const bool of_least = k + 1 < least.size() && least[k].x_end == end;
    if (of_kept) {
      if (kept[i].source.id != kept[i + 1].source.id)
        ++more;
      else
        ++(kept[i].inked != kept[i + 1].inked ? found.marks : found.fragments);
      ++i;
    }
    if (of_least) {
      ++fewer;
      ++k;
    }
    x = end;
    if (agree()) {
      found.ties_more += more > fewer ? more - fewer : 0;
      found.ties_fewer += fewer > more ? fewer - more : 0;
      more = fewer = 0;
    }
  }
  return found;
}

} // namespace orograph
