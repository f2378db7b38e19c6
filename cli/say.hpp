// SPDX-License-Identifier: GPL-3.0-or-later
// What the command tells its user on stderr.
#pragma once

#include <fmt/format.h>

#include <string_view>
#include <utility>

namespace orograph {

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
