// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/command_line.hpp"
#include "geometry/large_pages.hpp"

#include <malloc.h>
#include <sys/resource.h>

#include <cstdio>
#include <cstdlib>

namespace {

bool is_unlimited(__rlimit_resource_t resource) {
  rlimit limit{};
  return getrlimit(resource, &limit) == 0 && limit.rlim_cur == RLIM_INFINITY;
}

// Keeps memory that is freed for what comes next, and has the first gigabyte of it in large pages:
// to get pages of 4 kB, many of them again and again, took a seventh to half of a drawing's time
// (decision 66). What is reserved is addresses; where those are limited, nothing is changed.
void keep_memory_in_large_pages() {
  if (!is_unlimited(RLIMIT_AS) || !is_unlimited(RLIMIT_DATA)) return;
  mallopt(M_MMAP_MAX, 0);
  mallopt(M_TRIM_THRESHOLD, -1);
  constexpr std::size_t kReserved = std::size_t{1} << 30;
  void* const reserved = std::malloc(kReserved);
  if (reserved) orograph::use_large_pages(reserved, kReserved);
  std::free(reserved);
}

} // namespace

int main(int argc, char** argv) {
  keep_memory_in_large_pages();
  const int status = orograph::run_command_line(argc, argv);
  // What would follow is that libraries close what the system closes in any case: a tenth of the
  // time of a small drawing.
  std::fflush(nullptr);
  std::_Exit(status);
}
