// SPDX-License-Identifier: GPL-3.0-or-later
#include "lettering/cairo_function.hpp"

#include "geometry/error.hpp"

#include <dlfcn.h>

#include <string>

namespace orograph {
namespace {

[[noreturn]] void refuse() {
  const char* const reason = dlerror();
  throw Error("Cairo and Pango can't be loaded (" +
                  std::string(reason ? reason : "no reason told") + ")",
              "install libpangocairo-1.0-0, or write SVG without letters of fonts");
}

} // namespace

void* find_cairo_function(const char* name) {
  // Stays loaded: its threads and caches outlive any drawing.
  static void* const library = dlopen("libpangocairo-1.0.so.0", RTLD_LAZY | RTLD_LOCAL);
  if (!library) refuse();
  void* const found = dlsym(library, name);
  if (!found) refuse();
  return found;
}

} // namespace orograph
