// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/free_memory.hpp"

#include "geometry/error.hpp"

#include <fmt/format.h>
#include <sys/resource.h>

#include <algorithm>
#include <fstream>
#include <string>

namespace orograph {
namespace {

// The number after a word, or the first one where no word is asked for.
std::optional<std::uint64_t> number_in(const char* path, const std::string& word) {
  std::ifstream file(path);
  std::string name;
  std::uint64_t number = 0;
  if (word.empty()) return file >> number ? std::optional(number) : std::nullopt;
  while (file >> name)
    if (name == word) return file >> number ? std::optional(number) : std::nullopt;
  return std::nullopt;
}

} // namespace

std::optional<std::uint64_t> free_memory_bytes() {
  std::optional<std::uint64_t> least;
  const auto limit_to = [&](std::uint64_t bytes) {
    least = std::min(least.value_or(bytes), bytes);
  };
  if (const auto kilobytes = number_in("/proc/meminfo", "MemAvailable:"))
    limit_to(*kilobytes * 1024);
  // A container's own, where it has one ("max" isn't a number).
  const auto most = number_in("/sys/fs/cgroup/memory.max", {}),
             used = number_in("/sys/fs/cgroup/memory.current", {});
  if (most && used) limit_to(*most > *used ? *most - *used : 0);
  rlimit address_space{};
  if (getrlimit(RLIMIT_AS, &address_space) == 0 && address_space.rlim_cur != RLIM_INFINITY)
    limit_to(address_space.rlim_cur);
  return least;
}

void check_memory(double bytes, std::optional<std::uint64_t> most, std::string_view what,
                  std::string_view right) {
  if (!most || bytes <= static_cast<double>(*most)) return;
  throw Error(fmt::format("{} takes {:.2g} GB of memory, and {:.2g} GB may be taken", what,
                          bytes / 1e9, static_cast<double>(*most) / 1e9),
              fmt::format("{}, or let it take more with `max_memory`", right));
}

} // namespace orograph
