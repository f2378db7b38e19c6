// SPDX-License-Identifier: GPL-3.0-or-later
// What a program has asked operator new for.
#pragma once

#include <cstdint>

namespace orograph {

struct Allocations {
  std::uint64_t count = 0, bytes = 0;
};

inline Allocations operator-(const Allocations& a, const Allocations& b) {
  return {a.count - b.count, a.bytes - b.bytes};
}

/// Since the program's start, by all of its threads. Counts in a program that is linked with
/// allocations.cpp, which replaces operator new; what C libraries take by malloc isn't counted.
Allocations allocations_so_far();

} // namespace orograph
