// SPDX-License-Identifier: GPL-3.0-or-later
#include "text/aligned_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>

namespace orograph {
namespace {

// Characters, not bytes: "±" is one.
std::size_t width_of(const std::string& text) {
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return (c & 0xC0) != 0x80; }));
}

} // namespace

std::string aligned_table(const std::vector<std::vector<std::string>>& rows) {
  std::vector<std::size_t> widths(rows.front().size(), 0);
  for (const auto& cells : rows)
    for (std::size_t i = 0; i < cells.size(); ++i)
      widths[i] = std::max(widths[i], width_of(cells[i]));
  std::string text;
  for (const auto& cells : rows) {
    std::string line;
    for (std::size_t i = 0; i < cells.size(); ++i) {
      const std::string padding(widths[i] - width_of(cells[i]), ' ');
      line += i == 0 ? fmt::format("{}{}", cells[i], padding)
                     : fmt::format("  {}{}", padding, cells[i]);
    }
    text += line + "\n";
  }
  return text;
}

} // namespace orograph
