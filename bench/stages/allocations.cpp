// SPDX-License-Identifier: GPL-3.0-or-later
// All forms are replaced: those that aren't end up in these with the standard library's own, but
// not with a sanitizer's.
#include "bench/stages/allocations.hpp"

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdlib>
#include <new>

namespace {

std::atomic<std::uint64_t> all_count{0}, all_bytes{0};

using Size = std::size_t;
using Align = std::align_val_t;
using NoThrow = const std::nothrow_t&;

void* counted(void* memory, Size bytes) noexcept {
  if (memory == nullptr) return memory;
  all_count.fetch_add(1, std::memory_order_relaxed);
  all_bytes.fetch_add(bytes, std::memory_order_relaxed);
  return memory;
}
void* allocated(Size bytes) noexcept {
  return counted(std::malloc(std::max<Size>(bytes, 1)), bytes);
}
void* allocated(Size bytes, Align alignment) noexcept {
  const auto step = static_cast<Size>(alignment); // a power of two
  const Size rounded = (std::max<Size>(bytes, 1) + step - 1) / step * step;
  return counted(std::aligned_alloc(step, rounded), bytes);
}
void* proven(void* memory) {
  if (memory == nullptr) throw std::bad_alloc();
  return memory;
}

} // namespace

// clang-format off
void* operator new(Size n) { return proven(allocated(n)); }
void* operator new[](Size n) { return proven(allocated(n)); }
void* operator new(Size n, Align a) { return proven(allocated(n, a)); }
void* operator new[](Size n, Align a) { return proven(allocated(n, a)); }
void* operator new(Size n, NoThrow) noexcept { return allocated(n); }
void* operator new[](Size n, NoThrow) noexcept { return allocated(n); }
void* operator new(Size n, Align a, NoThrow) noexcept { return allocated(n, a); }
void* operator new[](Size n, Align a, NoThrow) noexcept { return allocated(n, a); }
void operator delete(void* p) noexcept { std::free(p); }
void operator delete[](void* p) noexcept { std::free(p); }
void operator delete(void* p, Size) noexcept { std::free(p); }
void operator delete[](void* p, Size) noexcept { std::free(p); }
void operator delete(void* p, Align) noexcept { std::free(p); }
void operator delete[](void* p, Align) noexcept { std::free(p); }
void operator delete(void* p, Size, Align) noexcept { std::free(p); }
void operator delete[](void* p, Size, Align) noexcept { std::free(p); }
void operator delete(void* p, NoThrow) noexcept { std::free(p); }
void operator delete[](void* p, NoThrow) noexcept { std::free(p); }
void operator delete(void* p, Align, NoThrow) noexcept { std::free(p); }
void operator delete[](void* p, Align, NoThrow) noexcept { std::free(p); }
// clang-format on

namespace orograph {

Allocations allocations_so_far() {
  return {all_count.load(std::memory_order_relaxed), all_bytes.load(std::memory_order_relaxed)};
}

} // namespace orograph
