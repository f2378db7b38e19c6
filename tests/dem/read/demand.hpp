// SPDX-License-Identifier: GPL-3.0-or-later
// What has to be done for a test, and isn't what it asks about.
#pragma once

#include <stdexcept>

namespace orograph {

/// Throws where it isn't `done`.
inline void demand(bool done, const char* what) {
  if (!done) throw std::runtime_error(what);
}

} // namespace orograph
