// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/error.hpp"

#include <algorithm>

namespace orograph {
namespace {

// `what()` ends at the first null character.
std::string whole(std::string_view wrong, std::string_view right) {
  std::string text(wrong);
  text.append(": ").append(right);
  std::replace(text.begin(), text.end(), '\0', '?');
  return text;
}

} // namespace

// Out of line: in some 550 places an error is thrown, and this would be compiled in each.
Error::Error(std::string_view wrong, std::string_view right, ErrorCode code)
    : runtime_error(whole(wrong, right)), wrong_length_(wrong.size()), code_(code) {}

UsageError::UsageError(std::string_view wrong, std::string_view right)
    : Error(wrong, right, ErrorCode::request) {}

} // namespace orograph
