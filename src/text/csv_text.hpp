// SPDX-License-Identifier: GPL-3.0-or-later
// Texts in tables.
#pragma once

#include <string>

namespace orograph {

/// A text as a cell of CSV, in quotes where it needs them (RFC 4180). A text that a spreadsheet
/// would take for a formula has a ' in front, which spreadsheets take for "this is text". Controls
/// but tabs and ends of lines are '?', since tables go to terminals as well.
std::string csv_text(const std::string& text);

} // namespace orograph
