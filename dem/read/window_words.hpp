// SPDX-License-Identifier: GPL-3.0-or-later
// Windows (`--bbox`) in messages.
#pragma once

#include "geometry/box.hpp"

#include <string>

namespace orograph {

/// "west,south to east,north".
std::string in_words(const Box2& box);

/// Throws Error if the window is empty or NaN. `extent` is the terrain's own, for the hint.
void check_window(const Box2& window, const Box2& extent);

/// Throws Error: the window holds nothing of `path`.
[[noreturn]] void refuse_window(const Box2& window, const Box2& extent, const std::string& path);

} // namespace orograph
