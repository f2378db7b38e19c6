// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/say.hpp"

#include "text/printable.hpp"

#include <unistd.h>

#include <cstdio>

namespace orograph {
namespace {

// Longer than any message of our own; what makes one longer is a name or a value of the user's.
constexpr std::size_t kLongestLine = 1000;

} // namespace

void say_line(std::string_view text) {
  const std::string line = "orograph: " + shortened(printable(text), kLongestLine) + "\n";
  std::fwrite(line.data(), 1, line.size(), stderr);
}

void say_without_memory(std::string_view text) noexcept {
  for (const std::string_view part : {std::string_view("orograph: "), text, std::string_view("\n")})
    if (::write(STDERR_FILENO, part.data(), part.size()) < 0) return;
}

} // namespace orograph
