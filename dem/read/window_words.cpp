// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/read/window_words.hpp"

#include "geometry/error.hpp"

#include <fmt/format.h>

namespace orograph {

std::string in_words(const Box2& box) {
  return fmt::format("{:.10g},{:.10g} to {:.10g},{:.10g}", box.low.x, box.low.y, box.high.x,
                     box.high.y);
}

void check_window(const Box2& window, const Box2& extent) {
  if (window.empty())
    throw Error(fmt::format("the window {} is empty", in_words(window)),
                fmt::format("its first corner must be south-west of its second; the terrain "
                            "reaches from {}",
                            in_words(extent)));
}

void refuse_window(const Box2& window, const Box2& extent, const std::string& path) {
  throw Error(fmt::format("the window {} holds nothing of {}", in_words(window), path),
              fmt::format("the terrain reaches from {}", in_words(extent)));
}

} // namespace orograph
