// SPDX-License-Identifier: GPL-3.0-or-later
// What Cairo's PostScript needs on its way out.
#pragma once

#include "draw/byte_sink.hpp"

#include <string>
#include <string_view>

namespace orograph {

/// Passes lines on, without `%%CreationDate`, and sees whether the page is whole: Cairo keeps it in
/// a temporary file of its own and doesn't notice when that one's disk is full.
class PostscriptFilter {
public:
  explicit PostscriptFilter(ByteSink& out) : out_(out) {}
  bool append(std::string_view bytes) noexcept;
  /// Passes on what is left. Throws Error where the page isn't whole.
  void finish();

private:
  bool pass_on_line() noexcept;

  ByteSink& out_;
  std::string line_;
  bool page_is_whole_ = false, good_ = true;
};

/// The `%%Title` comment: ASCII, one line, under the 255 characters that the format allows.
std::string postscript_title(std::string_view title);

} // namespace orograph
