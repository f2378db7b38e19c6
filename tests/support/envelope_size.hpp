// SPDX-License-Identifier: GPL-3.0-or-later
// How many pieces the upper envelope of segments has, by brute force; shares no code with the clip.
#pragma once

#include "geometry/segment.hpp"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

namespace orograph {

/// Parts of segments that have a number as their source: pieces of one source side by side are one.
struct EnvelopePart {
  Segment source;
  double begin, end;
};

/// Of -infinity to +infinity, with the pieces of sky. Between neighbouring ends and crossings of
/// all parts the middle tells which of them is on top; of two that lie on each other there the
/// first. REQUIRES that what doesn't meet is apart by more than 1e-13.
inline std::size_t envelope_size(const std::vector<EnvelopePart>& parts) {
  const auto height = [](const Segment& s, long double x) {
    return s.y0 + (x - s.x0) * (static_cast<long double>(s.y1) - s.y0) /
                      (static_cast<long double>(s.x1) - s.x0);
  };
  std::vector<long double> places;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    places.push_back(parts[i].begin);
    places.push_back(parts[i].end);
    for (std::size_t k = 0; k < i; ++k) {
      const long double low = std::max(parts[i].begin, parts[k].begin);
      const long double high = std::min(parts[i].end, parts[k].end);
      if (!(low < high)) continue;
      const long double at_low = height(parts[i].source, low) - height(parts[k].source, low);
      const long double at_high = height(parts[i].source, high) - height(parts[k].source, high);
      if ((at_low < 0) != (at_high < 0))
        places.push_back(low + (high - low) * at_low / (at_low - at_high));
    }
  }
  std::sort(places.begin(), places.end());
  constexpr std::uint64_t kNothing = std::numeric_limits<std::uint64_t>::max();
  std::uint64_t last = kNothing;
  std::size_t size = 1;
  for (std::size_t i = 1; i < places.size(); ++i) {
    if (places[i] - places[i - 1] <= 1e-13L) continue;
    const long double middle = (places[i] + places[i - 1]) / 2;
    std::uint64_t top = kNothing;
    long double greatest = 0;
    for (const EnvelopePart& part : parts) {
      if (middle <= part.begin || part.end <= middle) continue;
      const long double y = height(part.source, middle);
      if (top == kNothing || y > greatest + 1e-15L) {
        top = part.source.id;
        greatest = y;
      }
    }
    if (top != last) ++size;
    last = top;
  }
  return last == kNothing ? size : size + 1;
}

inline std::size_t envelope_size(const std::vector<Segment>& segments) {
  std::vector<EnvelopePart> parts;
  for (const Segment& s : segments) parts.push_back({s, s.x0, s.x1});
  return envelope_size(parts);
}

} // namespace orograph
