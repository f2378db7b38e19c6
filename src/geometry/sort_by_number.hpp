// SPDX-License-Identifier: GPL-3.0-or-later
// Sorting many things by a whole number.
#pragma once

#include "geometry/on_all_cores.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace orograph {

/// Sorts by `number_of(thing)`, things of one number in the order that they came in: by 11 bits at
/// a time, from the lowest on. Cost: two passes for each 11 bits of the greatest number; a copy of
/// the things, in `sorted`. What is in order costs a look at it. REQUIRES fewer than 2^32 of them.
template <class Thing, class NumberOf>
void sort_by_number(std::vector<Thing>& things, const NumberOf& number_of,
                    std::vector<Thing>& sorted) {
  constexpr unsigned kBits = 11;
  constexpr std::uint64_t kMask = (1U << kBits) - 1;
  // In pieces, between which it can be stopped.
  constexpr std::size_t kPiece = 1U << 16U;
  const auto for_each_thing = [&](const auto& take) {
    for (std::size_t i = 0; i < things.size();) {
      throw_if_stopped();
      for (const std::size_t end = std::min(i + kPiece, things.size()); i < end; ++i)
        take(things[i]);
    }
  };
  std::uint64_t greatest = 0;
  bool is_in_order = true;
  for_each_thing([&](const Thing& thing) {
    const auto number = static_cast<std::uint64_t>(number_of(thing));
    is_in_order = is_in_order && number >= greatest;
    greatest = std::max(greatest, number);
  });
  if (is_in_order) return;
  sorted.clear();
  sorted.reserve(things.size());
  while (sorted.size() < things.size()) { // what takes longest is the system's first look at it
    throw_if_stopped();
    sorted.resize(std::min(sorted.size() + kPiece, things.size()));
  }
  for (unsigned shift = 0; shift < 64 && greatest >> shift > 0; shift += kBits) {
    const auto digit = [&](const Thing& thing) {
      return static_cast<std::size_t>(std::uint64_t{number_of(thing)} >> shift & kMask);
    };
    std::array<std::uint32_t, kMask + 2> first{};
    for_each_thing([&](const Thing& thing) { ++first[digit(thing) + 1]; });
    for (std::size_t i = 1; i < first.size(); ++i) first[i] += first[i - 1];
    for_each_thing([&](const Thing& thing) { sorted[first[digit(thing)]++] = thing; });
    things.swap(sorted);
  }
}
template <class Thing, class NumberOf>
void sort_by_number(std::vector<Thing>& things, const NumberOf& number_of) {
  std::vector<Thing> sorted;
  sort_by_number(things, number_of, sorted);
}

/// The same, but that things of one number are sorted by `before`.
template <class Thing, class NumberOf, class Before>
void sort_by_number_then(std::vector<Thing>& things, const NumberOf& number_of,
                         const Before& before) {
  sort_by_number(things, number_of);
  std::size_t step = 0;
  for (auto first = things.begin(); first != things.end();) {
    throw_if_stopped(step++);
    const auto end = std::find_if(first + 1, things.end(), [&](const Thing& thing) {
      return number_of(thing) != number_of(*first);
    });
    if (end - first > 1) std::sort(first, end, before);
    first = end;
  }
}

} // namespace orograph
