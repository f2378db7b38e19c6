// SPDX-License-Identifier: GPL-3.0-or-later
#include "draw/assign_pens.hpp"

#include "geometry/error.hpp"
#include "geometry/on_all_cores.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <limits>
#include <utility>

namespace orograph {
namespace {

Layer layer_of(const Pen& pen) {
  Layer layer;
  layer.name = pen.name.empty() ? fmt::format("pen {}", pen.number) : pen.name;
  layer.pen_width_mm = pen.width_mm;
  layer.pen = pen;
  return layer;
}

// Where those that draw a layer stand among the pens.
std::vector<std::size_t> numbers_of(std::string_view layer, std::span<const PenOfLayers> pens) {
  std::vector<std::size_t> named, others;
  for (std::size_t i = 0; i < pens.size(); ++i) {
    const std::vector<std::string>& layers = pens[i].layers;
    if (layers.empty()) others.push_back(i);
    if (std::ranges::find(layers, layer) != layers.end()) named.push_back(i);
  }
  return named.empty() ? others : named;
}

std::size_t nearest_in_width(double width_mm, std::span<const std::size_t> candidates,
                             std::span<const PenOfLayers> pens) {
  std::size_t nearest = candidates.front();
  double least = std::numeric_limits<double>::infinity();
  for (const std::size_t i : candidates) {
    const double pen_mm = pens[i].pen.width_mm;
    if (const double off = std::max(pen_mm / width_mm, width_mm / pen_mm); off < least) {
      least = off;
      nearest = i;
    }
  }
  return nearest;
}

// In the pen's own width; what it is a line of is its old layer's to tell.
void append_stroke(Layer& to, const Layer& from, const Stroke& stroke) {
  to.strokes.push_back(stroke);
  to.strokes.back().first_point = static_cast<std::uint32_t>(to.page_mm.size());
  to.strokes.back().width_mm = 0;
  to.strokes.back().feature = -1;
  const std::span<const Vec2> points = from.points(stroke);
  to.page_mm.insert(to.page_mm.end(), points.begin(), points.end());
}

} // namespace

std::vector<Pen> pens_of(std::string_view layer, std::span<const PenOfLayers> pens) {
  std::vector<Pen> out;
  for (const std::size_t i : numbers_of(layer, pens)) out.push_back(pens[i].pen);
  return out;
}

void assign_pens(Drawing& drawing, std::span<const PenOfLayers> pens) {
  std::vector<Layer> by_pen, ways;
  for (const PenOfLayers& one : pens) by_pen.push_back(layer_of(one.pen));
  std::size_t step = 0;
  for (Layer& layer : drawing.layers) {
    if (layer.is_pen_way) {
      ways.push_back(std::move(layer));
      continue;
    }
    const std::vector<std::size_t> candidates = numbers_of(layer.name, pens);
    if (candidates.empty() && !layer.strokes.empty())
      throw UsageError(fmt::format("no pen draws the layer '{}'", layer.name),
                       "name it in a pen's layers, or give a pen without layers for all others");
    for (const Stroke& stroke : layer.strokes) {
      throw_if_stopped(step++);
      const double width_mm = stroke.width_mm > 0 ? stroke.width_mm : layer.pen_width_mm;
      append_stroke(by_pen[nearest_in_width(width_mm, candidates, pens)], layer, stroke);
    }
  }
  std::erase_if(by_pen, [](const Layer& layer) { return layer.strokes.empty(); });
  by_pen.insert(by_pen.end(), std::make_move_iterator(ways.begin()),
                std::make_move_iterator(ways.end()));
  drawing.layers = std::move(by_pen);
}

} // namespace orograph
