// SPDX-License-Identifier: GPL-3.0-or-later
// Large arrays in large pages of memory.
#pragma once

#include <cstddef>
#include <vector>

namespace orograph {

/// Asks the kernel to give memory that wasn't touched yet in pages of 2 MB: in those of 4 kB, each
/// of which it hands out at its first touch, 16 million heights took 45 ms. Changes nothing else.
void use_large_pages(void* begin, std::size_t bytes) noexcept;

/// `values.assign(count, value)` for an empty vector.
template <class Value>
void fill_on_large_pages(std::vector<Value>& values, std::size_t count, Value value) {
  values.reserve(count);
  use_large_pages(values.data(), count * sizeof(Value));
  values.assign(count, value);
}

} // namespace orograph
