// SPDX-License-Identifier: GPL-3.0-or-later
// The few bytes of a row that are marked.
#pragma once

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <span>

namespace orograph {

/// Calls take(i) with each of the bytes from `first` to `end` that has any of the bits `which`, in
/// order. Eight bytes are looked at in one.
template <class Take>
void for_each_marked(std::span<const std::uint8_t> bytes, int first, int end, std::uint8_t which,
                     const Take& take) {
  constexpr int kEight = 8;
  std::uint64_t every = 0;
  std::memset(&every, which, sizeof every);
  for (int i = first; i < end;) {
    if (i + kEight <= end) {
      std::uint64_t eight = 0;
      std::memcpy(&eight, &bytes[static_cast<std::size_t>(i)], sizeof eight);
      if ((eight & every) == 0) {
        i += kEight;
        continue;
      }
    }
    for (const int past = std::min(i + kEight, end); i < past; ++i)
      if (bytes[static_cast<std::size_t>(i)] & which) take(i);
  }
}

} // namespace orograph
