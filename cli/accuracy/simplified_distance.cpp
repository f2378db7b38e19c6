// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/accuracy/simplified_distance.hpp"

#include <algorithm>
#include <numbers>
#include <optional>

namespace orograph {
namespace {

double distance(Vec2 p, Vec2 a, Vec2 b) {
  const Vec2 along = b - a, to = p - a;
  const double square = dot(along, along);
  const double t = square > 0 ? std::clamp(dot(to, along) / square, 0.0, 1.0) : 0;
  return length(to - t * along);
}

// The points that were kept are points of the whole stroke, in order. Of each stretch between two
// of them, the whole stroke's point farthest from the straight line is the Hausdorff distance: the
// line has no point farther from the stretch, which goes from one of its ends to the other.
// None where the strokes aren't the same line.
std::optional<double> distance(std::span<const Vec2> kept, std::span<const Vec2> whole) {
  if (!(kept.front() == whole.front()) || !(kept.back() == whole.back())) return std::nullopt;
  double largest = 0;
  std::size_t at = 0;
  for (std::size_t i = 1; i < kept.size(); ++i) {
    double stretch = 0;
    for (++at; at < whole.size() && !(whole[at] == kept[i]); ++at)
      stretch = std::max(stretch, distance(whole[at], kept[i - 1], kept[i]));
    if (at == whole.size()) return std::nullopt;
    largest = std::max(largest, stretch);
  }
  return largest;
}

} // namespace

SimplifiedDistance simplified_distance(const Drawing& simplified, const Drawing& whole) {
  SimplifiedDistance out;
  for (std::size_t l = 0; l < simplified.layers.size(); ++l) {
    const Layer &few = simplified.layers[l], &all = whole.layers[l];
    std::size_t next =
        0; // strokes come in the same order; rounding may have dropped some of either
    for (const Stroke& stroke : few.strokes) {
      std::optional<double> found;
      for (std::size_t i = next; i < all.strokes.size() && !found; ++i) {
        if (all.strokes[i].profile != stroke.profile) continue;
        found = distance(few.points(stroke), all.points(all.strokes[i]));
        if (found) next = i + 1;
      }
      ++(found ? out.strokes : out.unmatched);
      if (found) out.largest_mm = std::max(out.largest_mm, *found);
    }
  }
  constexpr double kRounding_mm = 0.5 * std::numbers::sqrt2 * kPageStep_mm;
  out.largest_mm = std::max(0.0, out.largest_mm - kRounding_mm);
  return out;
}

} // namespace orograph
