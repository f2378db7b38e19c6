// SPDX-License-Identifier: GPL-3.0-or-later
// Whether a program of tests is for finding faults of memory, and not for judging many scenes.
#pragma once

extern "C" [[gnu::weak]] void __asan_init();

namespace orograph {

/// Whether this runs slowly: it isn't optimized, or it is linked with an engine that the address
/// sanitizer looks at.
inline bool is_slow_build() {
#ifdef NDEBUG
  return __asan_init != nullptr;
#else
  return true;
#endif
}

} // namespace orograph
