// SPDX-License-Identifier: GPL-3.0-or-later
// Parts of profiles beside the whole ones.
#pragma once

#include "profiles/profile.hpp"
#include "tests/catch.hpp"
#include "tests/support/random.hpp"

#include <algorithm>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

namespace orograph {

// Of a part of a profile, with the vertices next to it: where the whole one begins to be in it, and
// where it ends.
inline std::pair<std::size_t, std::size_t> part_of(const Profile& profile, URange part) {
  const std::vector<double>& u = profile.u_m;
  const auto begin = std::lower_bound(u.begin(), u.end(), part.low_m),
             end = std::upper_bound(u.begin(), u.end(), part.high_m);
  return {static_cast<std::size_t>(begin - u.begin()), static_cast<std::size_t>(end - u.begin())};
}

struct Parts {
  std::size_t asked = 0, vertices = 0, gaps = 0, shorter = 0;
};

// Of parts of the profile at a depth, that they are those of the whole one, bit for bit.
template <class Whole, class Cutter>
void compare_parts(Random& random, const Whole& whole, const Cutter& cutter, double depth,
                   Parts& sum) {
  Profile all, some;
  whole.cut(depth, all);
  const double low = all.size() > 0 ? all.u_m.front() : -1,
               high = all.size() > 0 ? all.u_m.back() : 1, width = high - low + 1e-3;
  for (int i = 0; i < 4; ++i) {
    URange part{low + width * random.between(-0.3, 1.1), 0};
    if (all.size() > 0 && random.chance(0.3))
      part.low_m =
          all.u_m[static_cast<std::size_t>(random.whole(0, static_cast<int>(all.size()) - 1))];
    part.high_m = part.low_m + width * random.between(0, 0.5);
    cutter.cut(depth, std::span(&part, 1), some);
    const auto [a, a_end] = part_of(all, part);
    const auto [b, b_end] = part_of(some, part);
    CAPTURE(depth, part.low_m, part.high_m, all.size(), some.size());
    ++sum.asked;
    sum.vertices += a_end - a;
    sum.shorter += some.size() < all.size();
    REQUIRE(a_end - a == b_end - b);
    for (std::size_t k = 0; k < a_end - a; ++k) {
      REQUIRE(some.u_m[b + k] == all.u_m[a + k]);
      REQUIRE(some.z_m[b + k] == all.z_m[a + k]);
      if (k + 1 < a_end - a) REQUIRE(some.after[b + k] == all.after[a + k]);
    }
    // What is before the part's first vertex and behind its last one, unless the part doesn't
    // reach into it.
    const Span before = a > 0 ? all.after[a - 1] : Span::gap;
    if (a < all.size() && part.low_m < all.u_m[a] && part.high_m > part.low_m) {
      sum.gaps += before == Span::gap;
      REQUIRE((b > 0 ? some.after[b - 1] : Span::gap) == before);
      if (before != Span::gap) REQUIRE(some.u_m[b - 1] == all.u_m[a - 1]);
    }
    const Span behind = a_end > 0 && a_end < all.size() ? all.after[a_end - 1] : Span::gap;
    if (a_end > a && all.u_m[a_end - 1] < part.high_m) {
      REQUIRE(some.after[b_end - 1] == behind);
      if (behind != Span::gap) REQUIRE(some.u_m[b_end] == all.u_m[a_end]);
    }
  }
}

} // namespace orograph
