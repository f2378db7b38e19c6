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

// Told out of line: errors are thrown in some 550 places, and made there they take a sixth of what
// those files' compiling takes.
Error::Error(std::string_view wrong, std::string_view right, ErrorCode code)
    : runtime_error(whole(wrong, right)), wrong_length_(wrong.size()), code_(code) {}

UsageError::UsageError(std::string_view wrong, std::string_view right)
    : Error(wrong, right, ErrorCode::request) {}

} // namespace orograph
