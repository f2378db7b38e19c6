// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/exact_memory.hpp"

#include <gmp.h>

#include <cstddef>
#include <cstdlib>
#include <new>

namespace orograph {
namespace {

// GMP is C, but Debian's has what exceptions pass through it by, and leaves a number as it was
// until it has the memory.
void* memory_or_throw(void* memory, std::size_t size) {
  void* const found = std::realloc(memory, size > 0 ? size : 1);
  if (found == nullptr) throw std::bad_alloc();
  return found;
}

void* allocate(std::size_t size) {
  return memory_or_throw(nullptr, size);
}

void* reallocate(void* memory, std::size_t, std::size_t size) {
  return memory_or_throw(memory, size);
}

} // namespace

// What gives memory back stays: a library that GDAL brings has its own, which also forgets keys.
void set_exact_numbers_for_this_program() {
  void (*give_back)(void*, std::size_t) = nullptr;
  mp_get_memory_functions(nullptr, nullptr, &give_back);
  mp_set_memory_functions(allocate, reallocate, give_back);
}

} // namespace orograph
