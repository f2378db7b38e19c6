// SPDX-License-Identifier: GPL-3.0-or-later
// Every other form of operator new and delete ends up in one of these.
#include "bench/stages/allocations.hpp"

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdlib>
#include <new>

namespace {

std::atomic<std::uint64_t> all_count{0}, all_bytes{0};

void* counted(void* memory, std::size_t bytes) {
  if (memory == nullptr) throw std::bad_alloc();
  all_count.fetch_add(1, std::memory_order_relaxed);
  all_bytes.fetch_add(bytes, std::memory_order_relaxed);
  return memory;
}

} // namespace

void* operator new(std::size_t bytes) {
  return counted(std::malloc(std::max<std::size_t>(bytes, 1)), bytes);
}
void* operator new(std::size_t bytes, std::align_val_t alignment) {
  const auto step = static_cast<std::size_t>(alignment); // a power of two
  const std::size_t rounded = (std::max<std::size_t>(bytes, 1) + step - 1) / step * step;
  return counted(std::aligned_alloc(step, rounded), bytes);
}
void operator delete(void* memory) noexcept {
  std::free(memory);
}
void operator delete(void* memory, std::size_t) noexcept {
  std::free(memory);
}
void operator delete(void* memory, std::align_val_t) noexcept {
  std::free(memory);
}
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept {
  std::free(memory);
}

namespace orograph {

Allocations allocations_so_far() {
  return {all_count.load(std::memory_order_relaxed), all_bytes.load(std::memory_order_relaxed)};
}

} // namespace orograph
