// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/horizon/check_clip.hpp"

#include "horizon/clip.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace orograph {
namespace {

long double height_of(const Segment& s, long double x) {
  const long double share = (x - s.x0) / (static_cast<long double>(s.x1) - s.x0);
  return s.y0 + share * (static_cast<long double>(s.y1) - s.y0);
}

struct Front {
  long double height = -std::numeric_limits<long double>::infinity();
  const Segment* segment = nullptr;
};

// Of each nearer list, the segments that hold x are the last that begins at or before it and, at a
// shared end, the one before that.
Front greatest_in_front(const FlatScene& scene, std::size_t list, long double x) {
  Front front;
  for (std::size_t nearer = 0; nearer < list; ++nearer) {
    const auto& segments = scene[nearer];
    auto after = std::upper_bound(segments.begin(), segments.end(), x,
                                  [](long double at, const Segment& s) { return at < s.x0; });
    for (int back = 0; back < 2 && after != segments.begin(); ++back) {
      const Segment& s = *--after;
      if (x <= s.x1 && height_of(s, x) > front.height) front = {height_of(s, x), &s};
    }
  }
  return front;
}

// A few ulp of the heights, and of x times the slope (docs/how-it-works.md).
double rounding_of(const Segment& s) {
  const double slope = std::abs((s.y1 - s.y0) / (s.x1 - s.x0));
  return 8 * std::numeric_limits<double>::epsilon() *
         (std::max(std::abs(s.y0), std::abs(s.y1)) +
          slope * std::max(std::abs(s.x0), std::abs(s.x1)));
}

enum class Claim { visible, hidden, tied };

// Asks at the middle of a piece, just inside both ends, and at ten random places.
void ask(const FlatScene& scene, std::size_t list, const Piece& piece, Claim claim,
         double tolerance, Random& random, Tally& tally) {
  const Segment& s = scene[list][piece.segment];
  const long double begin = piece.x_begin, length = piece.x_end - begin;
  const auto ask_at = [&](long double share) {
    const long double x = begin + share * length;
    // In a piece of an ulp or two, there may be no number but its ends, where lines of others end.
    if (!(x > piece.x_begin && x < piece.x_end)) return;
    const Front front = greatest_in_front(scene, list, x);
    const long double above = height_of(s, x) - front.height;
    const double rounding = rounding_of(s) + (front.segment ? rounding_of(*front.segment) : 0);
    ++tally.asked;
    // The horizon may be lower than all that is in front by the tolerance, where a tied list didn't
    // raise it; what is tied to it may be lower still by as much.
    if (claim == Claim::tied) {
      tally.wrong += above >= -2 * tolerance - rounding && above <= tolerance + rounding ? 0 : 1;
    } else if (std::abs(above) <= tolerance + rounding) {
      ++tally.ties;
    } else {
      tally.wrong += (above > 0) == (claim == Claim::visible) ? 0 : 1;
    }
  };
  ask_at(0.5L);
  ask_at(1e-6L);
  ask_at(1 - 1e-6L);
  for (int i = 0; i < 10; ++i) ask_at(random.between(0, 1));
}

} // namespace

Tally check_clip(const FlatScene& scene, double tolerance_mm, const Homography& page,
                 double greatest_y, std::uint64_t seed) {
  const double tolerance = greatest_y;
  Horizon horizon = initial_horizon();
  ClipWorkspace workspace;
  workspace.keep_hidden = true;
  ClipOptions options;
  options.tolerance = {tolerance_mm, page, greatest_y};
  Random random(seed);
  Tally tally;
  for (std::size_t list = 0; list < scene.size(); ++list) {
    clip(scene[list], horizon, options, workspace);
    for (const Piece& p : workspace.visible)
      ask(scene, list, p, Claim::visible, tolerance, random, tally);
    for (const Piece& p : workspace.hidden)
      ask(scene, list, p, Claim::hidden, tolerance, random, tally);
    for (const Piece& p : workspace.tied)
      ask(scene, list, p, Claim::tied, tolerance, random, tally);

    // Visible, hidden and tied pieces tile the segments: exactly in X; along the segment as well as
    // X tells, since a crossing keeps its own place there though its X is rounded.
    tally.visible += workspace.visible.size();
    tally.hidden += workspace.hidden.size();
    std::vector<Piece> all = workspace.visible;
    all.insert(all.end(), workspace.hidden.begin(), workspace.hidden.end());
    all.insert(all.end(), workspace.tied.begin(), workspace.tied.end());
    std::sort(all.begin(), all.end(), [](const Piece& a, const Piece& b) {
      return a.segment != b.segment ? a.segment < b.segment : a.x_begin < b.x_begin;
    });
    std::size_t at = 0;
    for (std::uint32_t number = 0; number < scene[list].size(); ++number) {
      const Segment& s = scene[list][number];
      const double ulp = std::numeric_limits<double>::epsilon();
      const double slack =
          4 * ulp + 2 * ulp * std::max(std::abs(s.x0), std::abs(s.x1)) / (s.x1 - s.x0);
      double x = s.x0, t = 0;
      for (; at < all.size() && all[at].segment == number; ++at) {
        tally.wrong += all[at].x_begin == x && std::abs(all[at].t_begin - t) <= slack ? 0 : 1;
        x = all[at].x_end;
        t = all[at].t_end;
      }
      tally.wrong += x == s.x1 && t == 1 ? 0 : 1;
    }
    tally.wrong += all.size() - at;
  }
  return tally;
}

} // namespace orograph
