// SPDX-License-Identifier: GPL-3.0-or-later
// The one exception type. Readers, writers and option parsing throw it; algorithms get checked
// input and don't throw.
#pragma once

#include <stdexcept>
#include <string>
#include <utility>

namespace orograph {

/// What is wrong, and what would be right: each a phrase without a full stop or line break.
/// `what()` is "wrong: right", the text that follows "orograph: error: " on stderr.
class Error : public std::runtime_error {
public:
  Error(const std::string& wrong, const std::string& right) : runtime_error(wrong + ": " + right) {}
};

/// An error of the command line itself (exit code 2); any other Error is exit code 1.
class UsageError : public Error {
public:
  using Error::Error;
};

} // namespace orograph
