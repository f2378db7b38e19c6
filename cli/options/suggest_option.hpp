// SPDX-License-Identifier: GPL-3.0-or-later
// What may have been meant by an option that there isn't.
#pragma once

#include "cli/options/option.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace orograph {

/// A word that other programs have for what an option does, or for what there isn't.
struct OtherWord {
  std::string word;        ///< in lower case; of GMT's and GDAL's short options with its dash
  std::string_view option; ///< ours, or a positional argument; empty where there is none
  std::string_view says;   ///< beside it, or instead
};

/// All of them. A short option that begins another stands behind it.
const std::vector<OtherWord>& other_words();

/// "did you mean --view-from AZ/EL?", or what there is instead; empty where nothing is near. By
/// meaning first, then by edits, of which three at most are bridged. `name` may have dashes.
std::string suggestion(const Command& command, std::string_view name);

} // namespace orograph
