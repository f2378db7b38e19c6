// SPDX-License-Identifier: GPL-3.0-or-later
#include "text/csv_text.hpp"

#include "text/printable.hpp"

#include <string_view>

namespace orograph {
namespace {

// What a cell may hold, in quotes, but a line that is printed may not.
constexpr const char* kEnds = "\t\r\n";

std::string printable_lines(std::string_view text) {
  std::string out;
  for (std::size_t end = 0; (end = text.find_first_of(kEnds)) != text.npos;
       text.remove_prefix(end + 1)) {
    out += printable(text.substr(0, end));
    out += text[end];
  }
  return out + printable(text);
}

} // namespace

std::string csv_text(const std::string& given) {
  const std::string text = printable_lines(given);
  // Spreadsheets take what begins so for a formula, and run it.
  const bool is_formula = text.find_first_of("=+-@\t\r") == 0;
  if (!is_formula && text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string quoted = is_formula ? "\"'" : "\"";
  for (const char c : text) quoted += c == '"' ? "\"\"" : std::string(1, c);
  return quoted + "\"";
}

} // namespace orograph
