// SPDX-License-Identifier: GPL-3.0-or-later
// The one exception type. Readers, writers and checks of what is asked throw it; algorithms get
// checked input and don't throw.
#pragma once

#include "geometry/api.hpp"

#include <stdexcept>
#include <string>
#include <string_view>

namespace orograph {

enum class ErrorCode {
  input,     ///< a terrain, a scene or a view in a file can't be used
  request,   ///< what is asked for can't be done, or makes no sense
  output,    ///< a file can't be written
  cancelled, ///< the caller stopped the work
};

/// What is wrong, and what would be right: each a phrase without a full stop or line break. What
/// the caller may set is named by its field in backquotes: "use `overview` or `bbox`". `what()` is
/// "wrong: right".
class OROGRAPH_API Error : public std::runtime_error {
public:
  Error(std::string_view wrong, std::string_view right, ErrorCode code = ErrorCode::input);

  ErrorCode code() const { return code_; }
  std::string wrong() const { return std::string(what()).substr(0, wrong_length_); }
  std::string right() const { return std::string(what()).substr(wrong_length_ + 2); }

private:
  std::size_t wrong_length_;
  ErrorCode code_;
};

/// An error of what is asked for, told without looking at any file.
class OROGRAPH_API UsageError : public Error {
public:
  UsageError(std::string_view wrong, std::string_view right);
};

} // namespace orograph
