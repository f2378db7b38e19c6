// SPDX-License-Identifier: GPL-3.0-or-later
// Random numbers that are the same everywhere: the engine is fixed by the standard, the
// distributions of the standard library aren't.
#pragma once

#include "tests/support/slow_build.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <initializer_list>
#include <random>
#include <utility>
#include <vector>

namespace orograph {

/// One in so many random scenes is looked at each time.
constexpr std::uint64_t kShare = 4;

/// Of random scenes numbered from 1, all of which passed once (`count`): a quarter, since a
/// change that breaks a kind of scene breaks many; in slow builds, which are there for the
/// sanitizers, a tenth: their faults show in any scene. Never fewer than 4.
inline std::uint64_t last_seed(std::uint64_t count) {
  return std::max<std::uint64_t>(std::min<std::uint64_t>(count, 4),
                                 count / (is_slow_build() ? 10 : kShare));
}

/// The same of rounds with one engine's random numbers.
inline int rounds(int count) {
  return static_cast<int>(last_seed(static_cast<std::uint64_t>(count)));
}

/// How often a test must have met what it is about, told for all scenes. So few as the sanitizers
/// have needn't have met it.
inline double enough(double count) {
  return is_slow_build() ? 0 : count / kShare;
}

class Random {
public:
  explicit Random(std::uint64_t seed) : engine_(seed + scenes_from()) {}

  /// In [0, 1).
  double share() { return static_cast<double>(engine_() >> 11U) * 0x1p-53; }
  double between(double low, double high) { return low + share() * (high - low); }
  /// Low and high included.
  int whole(int low, int high) {
    const auto count = static_cast<std::uint64_t>(high - low) + 1;
    return low + static_cast<int>(engine_() % count);
  }
  bool chance(double probability) { return share() < probability; }
  template <class Value>
  Value pick(std::initializer_list<Value> values) {
    return values.begin()[whole(0, static_cast<int>(values.size()) - 1)];
  }

private:
  /// OROGRAPH_SEED, which makes all scenes others (docs/stability.md); 0 without it.
  static std::uint64_t scenes_from() {
    static const char* const text = std::getenv("OROGRAPH_SEED");
    static const std::uint64_t from = text ? std::strtoull(text, nullptr, 10) : 0;
    return from;
  }

  std::mt19937_64 engine_;
};

template <class Value>
void shuffle(Random& random, std::vector<Value>& values) {
  for (std::size_t i = values.size(); i > 1; --i)
    std::swap(values[i - 1],
              values[static_cast<std::size_t>(random.whole(0, static_cast<int>(i) - 1))]);
}

} // namespace orograph
