// SPDX-License-Identifier: GPL-3.0-or-later
// Windows (`--bbox`, `--bbox-lonlat`), and what is said of them.
#pragma once

#include "dem/read/read_options.hpp"
#include "dem/terrain.hpp"
#include "geometry/box.hpp"

#include <optional>
#include <string>

namespace orograph {

/// "west,south to east,north".
std::string in_words(const Box2& box);

/// Throws Error if the window is empty or NaN. `extent` is the terrain's own, for the hint.
void check_window(const Box2& window, const Box2& extent);

/// Throws Error: the window holds nothing of `path`.
[[noreturn]] void refuse_window(const Box2& window, const Box2& extent, const std::string& path);

/// The window that the options ask for, in map coordinates; none where they ask for none. One in
/// longitude and latitude becomes the smallest box that holds it. Throws Error where the terrain's
/// CRS doesn't tell of longitude and latitude, or doesn't have these.
std::optional<Box2> wanted_window(const ReadOptions& options, const MapFrame& map,
                                  const std::string& path);

} // namespace orograph
