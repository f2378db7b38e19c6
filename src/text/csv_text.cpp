// SPDX-License-Identifier: GPL-3.0-or-later
#include "text/csv_text.hpp"

namespace orograph {

std::string csv_text(const std::string& text) {
  // Spreadsheets take what begins so for a formula, and run it.
  const bool is_formula = text.find_first_of("=+-@\t\r") == 0;
  if (!is_formula && text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string quoted = is_formula ? "\"'" : "\"";
  for (const char c : text) quoted += c == '"' ? "\"\"" : std::string(1, c);
  return quoted + "\"";
}

} // namespace orograph
