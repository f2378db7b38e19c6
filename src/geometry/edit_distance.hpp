// SPDX-License-Identifier: GPL-3.0-or-later
// How far words are apart; for "did you mean".
#pragma once

#include <span>
#include <string_view>

namespace orograph {

/// Edits (insert, remove, replace) that turn one word into the other.
int edit_distance(std::string_view a, std::string_view b);

/// The word that may have been meant: the first of those fewest edits away, if these are at most
/// three and fewer than the word has letters. Empty where there is none.
std::string_view nearest_word(std::string_view given, std::span<const std::string_view> words);

} // namespace orograph
