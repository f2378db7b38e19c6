// SPDX-License-Identifier: GPL-3.0-or-later
#include "draw/dash.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

namespace orograph {
namespace {

// What of a polyline lies between two lengths along it, as a stroke of `out`.
void add_part(std::span<const Vec2> points, const Stroke& of, double begin_mm, double end_mm,
              Layer& out) {
  Stroke stroke = of;
  stroke.first_point = static_cast<std::uint32_t>(out.page_mm.size());
  double at_mm = 0;
  for (std::size_t i = 1; i < points.size(); ++i) {
    const double step_mm = length(points[i] - points[i - 1]);
    const double from = std::max(begin_mm, at_mm), to = std::min(end_mm, at_mm + step_mm);
    if (step_mm > 0 && from < to) {
      const auto point = [&](double mm) {
        return points[i - 1] + ((mm - at_mm) / step_mm) * (points[i] - points[i - 1]);
      };
      if (out.page_mm.size() == stroke.first_point) out.page_mm.push_back(point(from));
      out.page_mm.push_back(point(to));
    }
    at_mm += step_mm;
  }
  stroke.point_count = static_cast<std::uint32_t>(out.page_mm.size()) - stroke.first_point;
  if (stroke.point_count > 1) out.strokes.push_back(stroke);
}

} // namespace

Layer dashed(const Layer& layer, double dash_mm, double gap_mm) {
  Layer out = layer;
  out.clear();
  for (const Stroke& stroke : layer.strokes) {
    const std::span<const Vec2> points = layer.points(stroke);
    double length_mm = 0;
    for (std::size_t i = 1; i < points.size(); ++i) length_mm += length(points[i] - points[i - 1]);
    // n dashes and n - 1 gaps.
    const double count = std::max(1.0, std::round((length_mm + gap_mm) / (dash_mm + gap_mm)));
    const double stretch = length_mm / (count * dash_mm + (count - 1) * gap_mm);
    for (double i = 0; i < count; ++i) {
      const double begin_mm = i * (dash_mm + gap_mm) * stretch;
      add_part(points, stroke, begin_mm, i + 1 == count ? length_mm : begin_mm + dash_mm * stretch,
               out);
    }
  }
  return out;
}

} // namespace orograph
