// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/large_pages.hpp"

#include <sys/mman.h>

#include <cstdint>

namespace orograph {

void use_large_pages(void* begin, std::size_t bytes) noexcept {
  constexpr std::uintptr_t kPage = 4096; // smaller where there are larger ones: then it is refused
  constexpr std::size_t kWorthIt = 4 << 20;
  if (bytes < kWorthIt) return;
  const auto from = reinterpret_cast<std::uintptr_t>(begin);
  const std::uintptr_t first = (from + kPage - 1) / kPage * kPage,
                       end = (from + bytes) / kPage * kPage;
  ::madvise(reinterpret_cast<void*>(first), end - first, MADV_HUGEPAGE);
}

} // namespace orograph
