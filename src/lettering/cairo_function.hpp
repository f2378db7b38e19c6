// SPDX-License-Identifier: GPL-3.0-or-later
// Functions of Cairo and Pango, which are loaded when one of them is called first. With all that
// they need they are 27 of the 147 shared libraries of a program that is linked to them, and an
// eighth of the time that it takes to start; SVG, map formats and plotters need none of them.
#pragma once

#include <atomic>

namespace orograph {

/// The function of this name in Pango's library for Cairo, or in one of those that it brings:
/// Cairo, Pango and GLib. Throws Error where they can't be loaded.
void* find_cairo_function(const char* name);

/// Does what the function does that it is named after, by `OROGRAPH_CAIRO(cairo_create);` inside
/// namespace orograph: there the name means this object, and so nothing refers to the library.
/// Throws as above at its first call. Several threads may call it.
template <class Function>
class CairoFunction;

template <class Result, class... Arguments>
class CairoFunction<Result(Arguments...)> {
public:
  explicit constexpr CairoFunction(const char* name) : name_(name) {}

  Result operator()(Arguments... arguments) const {
    void* found = found_.load(std::memory_order_acquire);
    if (!found) {
      found = find_cairo_function(name_);
      found_.store(found, std::memory_order_release);
    }
    return reinterpret_cast<Result (*)(Arguments...)>(found)(arguments...);
  }

private:
  const char* name_;
  mutable std::atomic<void*> found_ = nullptr;
};

#define OROGRAPH_CAIRO(name) constinit const CairoFunction<decltype(::name)> name(#name)

} // namespace orograph
