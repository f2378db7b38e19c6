// SPDX-License-Identifier: GPL-3.0-or-later
// What the command tells its user on stderr.
#pragma once

#include <fmt/format.h>

#include <cstdio>
#include <string_view>
#include <utility>

namespace orograph {

/// What libraries write to stderr by themselves (PROJ below libgeotiff, netCDF) is heard nowhere
/// from now on; what the command tells goes where it went. To be called once, at the beginning.
void keep_stderr_from_libraries();

/// Where the command tells: stderr, as it was at the beginning.
std::FILE* told_stream();

/// A line that begins with "orograph: ", printable and of at most 1000 bytes. What can't be said,
/// since stderr is closed or full, is lost, and nothing else is.
void say_line(std::string_view text);

template <class... Args>
void say(fmt::format_string<Args...> form, Args&&... args) {
  say_line(fmt::format(form, std::forward<Args>(args)...));
}

/// As the others, where there may be no memory to make a line of it: as it is. REQUIRES a literal.
void say_without_memory(std::string_view text) noexcept;

} // namespace orograph
