// SPDX-License-Identifier: GPL-3.0-or-later
// Text from the user, made fit for files.
#pragma once

#include <string>
#include <string_view>

namespace orograph {

/// The text as valid UTF-8 that XML 1.0 may hold: bytes that are not UTF-8, and control characters
/// other than tab and line breaks, become U+FFFD.
std::string clean_utf8(std::string_view text);

/// `clean_utf8` with the characters escaped that mean something in XML text or attributes.
std::string xml_escaped(std::string_view text);

} // namespace orograph
