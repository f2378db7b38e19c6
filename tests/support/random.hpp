// SPDX-License-Identifier: GPL-3.0-or-later
// Random numbers that are the same on every machine: the engine's bits are fixed by the standard,
// its distributions aren't.
#pragma once

#include <cstdint>
#include <random>

namespace orograph {

class Random {
public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}

  /// In [low, high).
  double real(double low, double high) {
    return low + (high - low) * static_cast<double>(engine_() >> 11U) * 0x1p-53;
  }
  /// In [low, high].
  int whole(int low, int high) {
    const auto count = static_cast<std::uint64_t>(high - low) + 1;
    return low + static_cast<int>(engine_() % count);
  }
  bool chance(double share) { return real(0, 1) < share; }

private:
  std::mt19937_64 engine_;
};

} // namespace orograph
