// SPDX-License-Identifier: GPL-3.0-or-later
// The pixels' size in a PNG, which Cairo doesn't write: without it the page has no size in mm.
#pragma once

#include "draw/byte_sink.hpp"

#include <cstddef>
#include <string_view>

namespace orograph {

/// Passes a PNG on, with a `pHYs` chunk put behind its header.
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
