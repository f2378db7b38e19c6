// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/page/page_lines.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace orograph {

PageLines::PageLines(const Page& page)
    : columns_(static_cast<int>(std::ceil(page.width_mm)) + 1),
      rows_(static_cast<int>(std::ceil(page.height_mm)) + 1),
      squares_(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_)) {}

PageLines::PageLines(const Drawing& drawing, std::initializer_list<std::string_view> names)
    : PageLines(drawing.page) {
  for (const Layer& layer : drawing.layers) {
    if (std::ranges::find(names, layer.name) == names.end()) continue;
    for (const Stroke& stroke : layer.strokes) {
      const auto points = layer.points(stroke);
      for (std::size_t i = 1; i < points.size(); ++i) add(points[i - 1], points[i]);
    }
  }
}

template <class Take>
void PageLines::each_square(Vec2 a_mm, Vec2 b_mm, const Take& take) const {
  const auto square = [](double mm, int count) {
    return std::clamp(static_cast<int>(std::floor(mm)), 0, count - 1);
  };
  const auto [left, right] = std::minmax(a_mm.x, b_mm.x);
  const auto [top, bottom] = std::minmax(a_mm.y, b_mm.y);
  for (int row = square(top, rows_); row <= square(bottom, rows_); ++row)
    for (int column = square(left, columns_); column <= square(right, columns_); ++column)
      take(static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
           static_cast<std::size_t>(column));
}

void PageLines::add(Vec2 from_mm, Vec2 to_mm) {
  // Piece by piece, so that a long oblique line doesn't fill all squares beside it.
  const int pieces = std::max(1, static_cast<int>(length(to_mm - from_mm)));
  const auto at = [&](int i) {
    return from_mm + (static_cast<double>(i) / pieces) * (to_mm - from_mm);
  };
  for (int i = 0; i < pieces; ++i)
    each_square(at(i), at(i + 1), [&](std::size_t square) {
      squares_[square].push_back({from_mm, to_mm});
    });
}

std::optional<double> PageLines::first_met(Vec2 from_mm, Vec2 direction, double reach_mm) const {
  double nearest_mm = std::numeric_limits<double>::infinity();
  for (double walked_mm = 0; walked_mm < std::min(reach_mm, nearest_mm);) {
    const double next_mm = std::min(walked_mm + 1, reach_mm);
    each_square(from_mm + walked_mm * direction, from_mm + next_mm * direction,
                [&](std::size_t square) {
                  for (const auto& [a, b] : squares_[square]) {
                    const double turn = cross(direction, b - a);
                    if (turn == 0) continue;
                    const double along_mm = cross(a - from_mm, b - a) / turn,
                                 share = cross(a - from_mm, direction) / turn;
                    if (share >= 0 && share <= 1 && along_mm >= 0)
                      nearest_mm = std::min(nearest_mm, along_mm);
                  }
                });
    walked_mm = next_mm;
  }
  return nearest_mm <= reach_mm ? std::optional(nearest_mm) : std::nullopt;
}

} // namespace orograph
