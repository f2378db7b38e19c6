// SPDX-License-Identifier: GPL-3.0-or-later
#include "text/nesting.hpp"

#include "geometry/error.hpp"

#include <fmt/format.h>

#include <cstddef>

namespace orograph {
namespace {

// The TOML parser takes 256 brackets in each other, each with names of so many dots: with 60 dots
// a scene still goes through a stack of 8 MB, with 80 it doesn't.
constexpr std::size_t kMostDots = 40;

constexpr std::size_t kMostDeep = 100; // a report and a row of a sweep are less than ten deep

} // namespace

void check_toml_nesting(std::string_view text, const std::string& path, const char* right) {
  std::size_t line = 1, dots = 0;
  for (const char c : text) {
    if (c == '\n') ++line;
    if (c == '\n' || c == ',' || c == '=') dots = 0;
    if (c == '.' && ++dots > kMostDots)
      throw Error(
          fmt::format("{}, line {}: there are over {} dots in a row", path, line, kMostDots),
          right);
  }
}

void check_json_nesting(std::string_view text, const std::string& path, const char* right) {
  std::size_t line = 1, depth = 0;
  bool in_string = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (c == '\n') ++line;
    if (c == '"') in_string = !in_string;
    if (in_string) {
      if (c == '\\') ++i; // with what it escapes
      continue;
    }
    if ((c == ']' || c == '}') && depth > 0) --depth;
    if ((c == '[' || c == '{') && ++depth > kMostDeep)
      throw Error(fmt::format("{}, line {}: lists and objects are nested over {} deep", path, line,
                              kMostDeep),
                  right);
  }
}

} // namespace orograph
