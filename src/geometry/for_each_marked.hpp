// SPDX-License-Identifier: GPL-3.0-or-later
// The few bytes of a row that are marked.
#pragma once

#include <bit>
#include <cstdint>
#include <cstring>
#include <span>

namespace orograph {

/// Calls take(i, mark) with each of the bits `which` that the bytes from `first` to `end` have: by
/// bytes, in a byte from the lowest bit on. Eight bytes are looked at in one, and no byte has to be
/// asked by a branch, which nobody could foresee.
template <class Take>
void for_each_mark(std::span<const std::uint8_t> bytes, int first, int end, std::uint8_t which,
                   const Take& take) {
  static_assert(std::endian::native == std::endian::little);
  constexpr int kEight = 8;
  std::uint64_t every = 0;
  std::memset(&every, which, sizeof every);
  for (int i = first; i < end; i += kEight) {
    const std::uint8_t* const at = &bytes[static_cast<std::size_t>(i)];
    std::uint64_t eight = 0;
    if (i + kEight <= end)
      std::memcpy(&eight, at, sizeof eight);
    else
      std::memcpy(&eight, at, static_cast<std::size_t>(end - i));
    for (eight &= every; eight != 0; eight &= eight - 1) {
      const int bit = std::countr_zero(eight);
      take(i + bit / kEight, static_cast<std::uint8_t>(1U << (bit % kEight)));
    }
  }
}

/// Calls take(i) with each of the bytes that has any of those bits, in order.
template <class Take>
void for_each_marked(std::span<const std::uint8_t> bytes, int first, int end, std::uint8_t which,
                     const Take& take) {
  int last = first - 1;
  for_each_mark(bytes, first, end, which, [&](int i, std::uint8_t) {
    if (i != last) take(i);
    last = i;
  });
}

} // namespace orograph
