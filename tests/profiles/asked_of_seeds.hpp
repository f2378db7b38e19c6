// SPDX-License-Identifier: GPL-3.0-or-later
// A test's sums over random scenes.
#pragma once

#include "tests/catch.hpp"
#include "tests/support/random.hpp"

#include <cstdint>

namespace orograph {

/// `ask(random, sums)` makes a scene for each seed and checks it; `sums.seed` tells which.
template <class Sums, class Ask>
Sums asked_of_seeds(std::uint64_t count, const Ask& ask) {
  Sums sums;
  for (std::uint64_t seed = 1; seed <= last_seed(count); ++seed) {
    Random random(seed);
    sums.seed = seed;
    ask(random, sums);
  }
  return sums;
}

} // namespace orograph
