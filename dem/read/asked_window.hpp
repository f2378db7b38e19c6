// SPDX-License-Identifier: GPL-3.0-or-later
// The window of a terrain that is asked for, and how messages speak of it and of files.
#pragma once

#include "dem/read/read_options.hpp"
#include "geometry/box.hpp"

#include <optional>
#include <string>
#include <vector>

namespace orograph {

struct MapFrame;

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

/// "a.tif", or "a.tif and 3 more". REQUIRES at least one.
std::string in_brief(const std::vector<std::string>& paths);

/// As a command line has them; "FILES" where there are more than a line holds.
std::string in_command(const std::vector<std::string>& paths);

} // namespace orograph
