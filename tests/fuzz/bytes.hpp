// SPDX-License-Identifier: GPL-3.0-or-later
// Made-up bytes taken as numbers, one after another.
#pragma once

#include "tests/fuzz/fuzz_targets.hpp"

#include <cmath>
#include <cstdint>
#include <limits>

namespace orograph {

/// Behind the last byte all bytes are 0, so that any bytes make something.
class Bytes {
public:
  explicit Bytes(FuzzBytes bytes) : bytes_(bytes) {}

  bool at_end() const { return at_ >= bytes_.size(); }
  std::uint8_t next() { return at_end() ? 0 : bytes_[at_++]; }
  /// Low and high included, of at most 256 values.
  int whole(int low, int high) { return low + next() % (high - low + 1); }
  /// One that floating point finds hard in one way or another, of magnitude 1e-18 to 1e18, or 0:
  /// small whole ones, fractions, some that are an ulp or two beside such, powers of two.
  double number() {
    const int kind = next() % 6;
    const double small = whole(-8, 8);
    switch (kind) {
    case 0:
    case 1:
      return small;
    case 2:
      return small + next() / 256.0;
    case 3:
      return small + small * std::numeric_limits<double>::epsilon() * whole(-3, 3);
    case 4:
      return std::ldexp(small, whole(-50, 50));
    default:
      return small / whole(1, 9);
    }
  }

private:
  FuzzBytes bytes_;
  std::size_t at_ = 0;
};

} // namespace orograph
