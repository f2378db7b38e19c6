// SPDX-License-Identifier: GPL-3.0-or-later
// What PostScript and PNG need on their way out of Cairo.
#pragma once

#include "write/byte_sink.hpp"

#include <cstddef>
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

/// Passes a PNG on, with the pixels' size (a `pHYs` chunk) put behind its header, which Cairo
/// doesn't write: without it the page has no size in mm.
class PngResolution {
public:
  PngResolution(ByteSink& out, double dpi) : out_(out), dpi_(dpi) {}
  bool append(std::string_view bytes) noexcept;

private:
  ByteSink& out_;
  double dpi_;
  std::size_t passed_ = 0;
};

} // namespace orograph
