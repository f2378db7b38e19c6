// SPDX-License-Identifier: GPL-3.0-or-later
#include "draw/shade_strokes.hpp"

#include "geometry/on_all_cores.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

namespace orograph {
namespace {

constexpr double kNormalOver_mm = 1.5, kLeastRun_mm = 1, kWidthRatio = 1.1;
// A class holds until the width is so many steps off it.
constexpr double kHysteresis = 0.8;
// Of lines steeper than this share (sine) upper and lower side are a matter of a cell or two, so
// that they are as heavy as level ones, by and by.
constexpr double kSteep = 0.3;

// A stroke's points by their way along it.
struct Way {
  std::span<const Vec2> points;
  std::vector<double> mm;

  explicit Way(std::span<const Vec2> p) : points(p), mm(p.size(), 0) {
    for (std::size_t i = 1; i < p.size(); ++i) mm[i] = mm[i - 1] + plain_length(p[i] - p[i - 1]);
  }
  Vec2 at(double way_mm) const {
    if (way_mm <= 0) return points.front();
    const auto next = std::upper_bound(mm.begin(), mm.end(), way_mm);
    if (next == mm.end()) return points.back();
    const auto i = static_cast<std::size_t>(next - mm.begin());
    return points[i - 1] +
           ((way_mm - mm[i - 1]) / (mm[i] - mm[i - 1])) * (points[i] - points[i - 1]);
  }
};

// Of a level line's width, the share of one that goes along a chord.
double lit_share(Vec2 chord, double x_mm, const LineShade& shade) {
  const double size = plain_length(chord);
  if (!(size > 0)) return 1;
  Vec2 normal{chord.y / size, -chord.x / size};
  if (dot(normal, shade.up) < 0) normal = -1.0 * normal;
  const Vec2 towards_light = shade.standing ? shade.standing->on_page(x_mm) : shade.towards_light;
  const double level = dot(shade.up, towards_light);
  const double sure = std::min(1.0, dot(normal, shade.up) / kSteep);
  const double darker = sure * (level - dot(normal, towards_light));
  return std::clamp(1 + 0.5 * shade.contrast * darker, 0.5, 2.0);
}

double haze_share(double depth_m, const LineShade& shade) {
  const double range_m = shade.farthest_m - shade.nearest_m;
  if (!(range_m > 0)) return 1;
  return 1 - shade.haze * std::clamp((depth_m - shade.nearest_m) / range_m, 0.0, 1.0);
}

class Shader {
public:
  Shader(const Layer& layer, const LineShade& shade, Layer& out)
      : layer_(layer), shade_(shade), out_(out) {}

  void add(const Stroke& stroke) {
    const Way way(layer_.points(stroke));
    const std::size_t last = way.points.size() - 1;
    std::size_t from = 0;
    double step = std::round(step_of(stroke, way, 0));
    for (std::size_t i = 1; i < last; ++i) {
      const double here = step_of(stroke, way, i);
      if (std::abs(here - step) < kHysteresis || way.mm[i] - way.mm[from] < kLeastRun_mm ||
          way.mm[last] - way.mm[i] < kLeastRun_mm)
        continue;
      append(stroke, from, i, step);
      from = i;
      step = std::round(here);
    }
    append(stroke, from, last, step);
  }

private:
  // Of the segment behind a point, in steps of width.
  double step_of(const Stroke& stroke, const Way& way, std::size_t i) const {
    const double middle_mm = 0.5 * (way.mm[i] + way.mm[i + 1]);
    const Vec2 chord =
        way.at(middle_mm + 0.5 * kNormalOver_mm) - way.at(middle_mm - 0.5 * kNormalOver_mm);
    const double share = lit_share(chord, way.points[i].x, shade_) *
                         haze_share(layer_.depths_m[stroke.first_point + i], shade_);
    return std::log(share) / std::log(kWidthRatio);
  }

  void append(const Stroke& like, std::size_t first, std::size_t last, double step) {
    Stroke stroke = like;
    stroke.first_point = static_cast<std::uint32_t>(out_.page_mm.size());
    stroke.point_count = static_cast<std::uint32_t>(last - first + 1);
    const double own_mm = like.width_mm > 0 ? like.width_mm : layer_.pen_width_mm;
    stroke.width_mm = own_mm * std::pow(kWidthRatio, step);
    const auto points = layer_.points(like).subspan(first, last - first + 1);
    out_.page_mm.insert(out_.page_mm.end(), points.begin(), points.end());
    out_.strokes.push_back(stroke);
  }

  const Layer& layer_;
  const LineShade& shade_;
  Layer& out_;
};

} // namespace

Layer shaded(const Layer& layer, const LineShade& shade) {
  Layer out = layer;
  out.clear();
  Shader shader(layer, shade, out);
  for (std::size_t i = 0; i < layer.strokes.size(); ++i) {
    throw_if_stopped(i);
    shader.add(layer.strokes[i]);
  }
  return out;
}

} // namespace orograph
