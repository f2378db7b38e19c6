// SPDX-License-Identifier: GPL-3.0-or-later
#include "draw/drawing.hpp"

#include "draw/round_drawing.hpp"
#include "geometry/on_all_cores.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

namespace orograph {

bool is_all_grey(const Drawing& drawing) {
  return std::ranges::all_of(drawing.layers, [](const Layer& layer) {
    const auto ink = layer.ink();
    return !ink || is_grey(*ink);
  });
}

void append(Layer& layer, const Layer& other) {
  const auto offset = static_cast<std::uint32_t>(layer.page_mm.size());
  const auto features = static_cast<std::int32_t>(layer.features.size());
  layer.features.insert(layer.features.end(), other.features.begin(), other.features.end());
  layer.page_mm.insert(layer.page_mm.end(), other.page_mm.begin(), other.page_mm.end());
  layer.map.insert(layer.map.end(), other.map.begin(), other.map.end());
  layer.depths_m.insert(layer.depths_m.end(), other.depths_m.begin(), other.depths_m.end());
  for (Stroke stroke : other.strokes) {
    stroke.first_point += offset;
    if (stroke.feature >= 0) stroke.feature += features;
    layer.strokes.push_back(stroke);
  }
  for (PageText text : other.texts) {
    if (text.feature >= 0) text.feature += features;
    layer.texts.push_back(std::move(text));
  }
}

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
    throw_if_stopped();
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

double line_length_mm(std::span<const Vec2> points) {
  double sum = 0;
  for (std::size_t i = 1; i < points.size(); ++i) sum += plain_length(points[i] - points[i - 1]);
  return sum;
}

namespace {

void add(PenTravel& sum, const PenTravel& travel) {
  sum.down_mm += travel.down_mm;
  sum.up_mm += travel.up_mm;
  sum.lifts += travel.lifts;
}

// Of strokes `first` to `end` - 1 of a layer, from where the pen is.
PenTravel travel_of(const Layer& layer, std::size_t first, std::size_t end, Vec2 pen) {
  PenTravel out;
  for (std::size_t i = first; i < end; ++i) {
    const std::span<const Vec2> points = layer.points(layer.strokes[i]);
    if (points.front() != pen) {
      out.up_mm += plain_length(points.front() - pen);
      ++out.lifts;
    }
    out.down_mm += line_length_mm(points);
    pen = points.back();
  }
  return out;
}

// On all cores, and added up in order. The pen is left at the layer's last point.
PenTravel travel_of(const Layer& layer, Vec2& pen) {
  constexpr std::size_t kStrokesOfTask = 1024;
  const std::size_t count = layer.strokes.size();
  std::vector<PenTravel> of_tasks((count + kStrokesOfTask - 1) / kStrokesOfTask);
  on_all_cores(of_tasks.size(), [&](std::size_t task) {
    const std::size_t first = task * kStrokesOfTask, end = std::min(count, first + kStrokesOfTask);
    const Vec2 from = first > 0 ? layer.points(layer.strokes[first - 1]).back() : pen;
    of_tasks[task] = travel_of(layer, first, end, from);
  });
  PenTravel out;
  for (const PenTravel& travel : of_tasks) {
    throw_if_stopped();
    add(out, travel);
  }
  if (count > 0) pen = layer.points(layer.strokes.back()).back();
  return out;
}

} // namespace

PenTravels pen_travels(const Drawing& drawing) {
  PenTravels out;
  Vec2 pen{0, 0};
  for (const Layer& layer : drawing.layers) {
    out.by_layer.push_back(layer.is_pen_way ? PenTravel{} : travel_of(layer, pen));
    add(out.all, out.by_layer.back());
  }
  return out;
}

void show_pen_way(Drawing& drawing) {
  if (std::ranges::none_of(drawing.layers, &Layer::is_pen_way)) return;
  std::vector<Vec2> moves; // two points each
  Vec2 pen{0, 0};
  for (const Layer& layer : drawing.layers) {
    if (layer.is_pen_way) continue;
    for (const Stroke& stroke : layer.strokes) {
      const std::span<const Vec2> points = layer.points(stroke);
      throw_if_stopped(moves.size());
      if (points.front() != pen) moves.insert(moves.end(), {pen, points.front()});
      pen = points.back();
    }
  }
  for (Layer& layer : drawing.layers) {
    if (!layer.is_pen_way) continue;
    layer.clear();
    layer.page_mm = moves;
    for (std::uint32_t i = 0; i < moves.size(); i += 2)
      layer.strokes.push_back({.first_point = i, .point_count = 2});
  }
}

double pen_minutes(const PenTravel& travel, const PenSpeed& speed) {
  return (travel.down_mm / speed.down_mm_s + travel.up_mm / speed.up_mm_s +
          static_cast<double>(travel.lifts) * speed.lift_s) /
         60;
}

namespace {

std::optional<std::string> fault_of_point(Vec2 p, const Box2& inner) {
  if (!std::isfinite(p.x) || !std::isfinite(p.y)) return "is not finite";
  if (rounded_to_page_step(p.x) != p.x || rounded_to_page_step(p.y) != p.y ||
      (p.x == 0 && std::signbit(p.x)) || (p.y == 0 && std::signbit(p.y)))
    return fmt::format("({}, {}) is not on the step of {} mm", p.x, p.y, kPageStep_mm);
  // A point on a margin that is itself off the step may be rounded across it.
  if (p.x < inner.low.x - kPageStep_mm || p.x > inner.high.x + kPageStep_mm ||
      p.y < inner.low.y - kPageStep_mm || p.y > inner.high.y + kPageStep_mm)
    return fmt::format("({}, {}) lies outside the margins", p.x, p.y);
  return {};
}

std::optional<std::string> fault_of_stroke(const Layer& layer, const Stroke& stroke,
                                           const Box2& inner) {
  if (stroke.point_count < 2) return "has fewer than two points";
  if (stroke.first_point > layer.page_mm.size() ||
      stroke.point_count > layer.page_mm.size() - stroke.first_point)
    return "runs past the points of its layer";
  const std::span<const Vec2> points = layer.points(stroke);
  bool has_length = false;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (const auto fault = fault_of_point(points[i], inner))
      return fmt::format("point {} {}", i, *fault);
    has_length = has_length || points[i] != points[0];
  }
  if (!has_length) return "has no length";
  return {};
}

std::optional<std::string> fault_of_layer(const Layer& layer, const Box2& inner) {
  if (!layer.map.empty() && layer.map.size() != layer.page_mm.size())
    return "has map points that don't match its page points";
  const auto count = static_cast<std::uint32_t>(layer.strokes.size());
  for (std::uint32_t i = 0; i < count; ++i)
    if (const auto fault = fault_of_stroke(layer, layer.strokes[i], inner))
      return fmt::format("stroke {} {}", i, *fault);
  if (const auto repeated = repeated_strokes(layer); !repeated.empty() && !layer.is_pen_way)
    return fmt::format("stroke {} repeats an earlier one", repeated.front());
  for (std::size_t i = 0; i < layer.map.size(); ++i)
    if (const Vec3 p = layer.map[i];
        !std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z))
      return fmt::format("map point {} is not finite", i);
  return {};
}

// Its box, but for what rounding its place moves it by.
std::optional<std::string> fault_of_texts(const Layer& layer, const Box2& inner) {
  for (std::size_t i = 0; i < layer.texts.size(); ++i) {
    const PageText& text = layer.texts[i];
    if (text.text.empty()) continue;
    for (const Vec2 corner : text.corners_mm())
      if (!(corner.x >= inner.low.x - kPageStep_mm && corner.x <= inner.high.x + kPageStep_mm &&
            corner.y >= inner.low.y - kPageStep_mm && corner.y <= inner.high.y + kPageStep_mm))
        return fmt::format("text {} '{}' lies outside the margins", i, text.text);
  }
  return {};
}

} // namespace

std::optional<std::string> find_fault(const Drawing& drawing) {
  for (const Layer& layer : drawing.layers)
    if (const auto fault = fault_of_layer(
            layer, layer.is_pen_way ? Box2{{0, 0}, {drawing.page.width_mm, drawing.page.height_mm}}
                                    : drawing.page.inner_mm()))
      return fmt::format("layer {}: {}", layer.name, *fault);
  for (const Layer& layer : drawing.layers)
    if (const auto fault = fault_of_texts(layer, drawing.page.inner_mm()))
      return fmt::format("layer {}: {}", layer.name, *fault);
  return {};
}

} // namespace orograph
