// SPDX-License-Identifier: GPL-3.0-or-later
// How deep what stands in TOML and JSON may be nested. The libraries that parse them go down, or
// take apart what they have built, by recursion: text of some hundred kilobytes would end them.
#pragma once

#include <string>
#include <string_view>

namespace orograph {

/// Throws Error, which begins with the path and the line and ends with `right`, where over 40 dots
/// stand between two of newline, comma and equals sign: names with dots are tables in tables. (What
/// is nested by brackets, the parser itself counts.) Cost O(bytes).
void check_toml_nesting(std::string_view text, const std::string& path, const char* right);

/// The same where lists and objects stand in each other over 100 deep.
void check_json_nesting(std::string_view text, const std::string& path, const char* right);

} // namespace orograph
