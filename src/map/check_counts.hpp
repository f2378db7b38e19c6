// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace orograph {

/// Random points asked of the ray walk (`MapSpec::check`).
struct CheckCounts {
  std::uint64_t asked = 0;
  std::uint64_t ties = 0;    ///< within the visibility tolerance and rounding: not judged
  std::uint64_t hidden = 0;  ///< drawn, but hidden
  std::uint64_t missing = 0; ///< visible, but not drawn
};

inline CheckCounts operator+(const CheckCounts& a, const CheckCounts& b) {
  return {a.asked + b.asked, a.ties + b.ties, a.hidden + b.hidden, a.missing + b.missing};
}

} // namespace orograph
