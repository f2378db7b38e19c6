// SPDX-License-Identifier: GPL-3.0-or-later
#include "naming/ink_map.hpp"

#include "geometry/on_all_cores.hpp"

#include <algorithm>
#include <cmath>

namespace orograph {
namespace {

constexpr double kSquare_mm = 0.5; // about the gap between profiles

std::size_t squares(double mm) {
  return static_cast<std::size_t>(std::max(1.0, std::ceil(mm / kSquare_mm)));
}

} // namespace

InkMap::InkMap(const Page& page, std::span<const Layer> layers)
    : columns_(squares(page.width_mm)), rows_(squares(page.height_mm)), has_ink_(columns_ * rows_) {
  const auto mark = [&](Vec2 at) {
    const double column = std::floor(at.x / kSquare_mm), row = std::floor(at.y / kSquare_mm);
    if (column >= 0 && row >= 0 && column < static_cast<double>(columns_) &&
        row < static_cast<double>(rows_))
      has_ink_[static_cast<std::size_t>(row) * columns_ + static_cast<std::size_t>(column)] = true;
  };
  std::size_t step = 0;
  for (const Layer& layer : layers)
    for (const Stroke& stroke : layer.strokes) {
      throw_if_stopped(step++);
      const auto points = layer.points(stroke);
      for (std::size_t i = 1; i < points.size(); ++i) {
        const Vec2 way = points[i] - points[i - 1];
        const double count = std::ceil(plain_length(way) / (0.5 * kSquare_mm));
        for (double k = 0; k <= count; ++k) mark(points[i - 1] + (count > 0 ? k / count : 0) * way);
      }
    }
}

double InkMap::share(const Box2& box_mm) const {
  const double left = std::floor(box_mm.low.x / kSquare_mm),
               top = std::floor(box_mm.low.y / kSquare_mm),
               right = std::floor(box_mm.high.x / kSquare_mm),
               bottom = std::floor(box_mm.high.y / kSquare_mm);
  if (!(left >= 0 && top >= 0 && right < static_cast<double>(columns_) &&
        bottom < static_cast<double>(rows_)))
    return 1;
  std::size_t with_ink = 0;
  for (auto row = static_cast<std::size_t>(top); row <= static_cast<std::size_t>(bottom); ++row)
    for (auto column = static_cast<std::size_t>(left); column <= static_cast<std::size_t>(right);
         ++column)
      with_ink += has_ink_[row * columns_ + column] ? 1 : 0;
  return static_cast<double>(with_ink) / ((right - left + 1) * (bottom - top + 1));
}

} // namespace orograph
