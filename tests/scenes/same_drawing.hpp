// SPDX-License-Identifier: GPL-3.0-or-later
// Whether two drawings are the same to the bit.
#pragma once

#include "draw/drawing.hpp"

#include <algorithm>
#include <string>

namespace orograph {

inline bool same_strokes(const Layer& a, const Layer& b) {
  return a.name == b.name && a.page_mm == b.page_mm && a.map == b.map &&
         std::equal(a.strokes.begin(), a.strokes.end(), b.strokes.begin(), b.strokes.end(),
                    [](const Stroke& s, const Stroke& t) {
                      return s.first_point == t.first_point && s.point_count == t.point_count &&
                             s.profile == t.profile;
                    });
}

/// The first layer that differs, or nothing.
inline std::string difference(const Drawing& a, const Drawing& b) {
  if (a.layers.size() != b.layers.size()) return "the number of layers";
  for (std::size_t i = 0; i < a.layers.size(); ++i)
    if (!same_strokes(a.layers[i], b.layers[i])) return a.layers[i].name;
  return "";
}

} // namespace orograph
