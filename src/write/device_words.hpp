// SPDX-License-Identifier: GPL-3.0-or-later
// Places in a device's words, such as {x}, and what is put there.
#pragma once

#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace orograph {

/// The first place, with its braces, that isn't one of these; none where all are. A brace alone is
/// no place, and unknown.
std::optional<std::string> unknown_place(std::string_view text,
                                         const std::vector<std::string_view>& places);

/// The text with each place filled.
std::string filled(std::string_view text,
                   std::initializer_list<std::pair<std::string_view, std::string_view>> places);

/// A user's words without what a machine may take for its own: letters, digits, blanks and -_.
/// stay.
std::string plain_words(std::string_view text);

} // namespace orograph
