// SPDX-License-Identifier: GPL-3.0-or-later
#include "draw/assign_pens.hpp"

#include "draw/pen_order.hpp"
#include "draw/round_drawing.hpp"
#include "geometry/error.hpp"
#include "geometry/on_all_cores.hpp"
#include "text/printable.hpp"
#include "text/words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <functional>
#include <iterator>
#include <limits>
#include <set>
#include <utility>
#include <variant>

namespace orograph {
namespace {

Layer layer_of(const Pen& pen) {
  Layer layer;
  layer.name = pen.name.empty() ? fmt::format("pen {}", pen.number) : pen.name;
  layer.pen_width_mm = pen.width_mm;
  layer.pen = pen;
  return layer;
}

bool names(const PenOfLayers& one, std::string_view layer) {
  return std::ranges::find(one.layers, layer) != one.layers.end();
}

// Where those that draw a layer, whatever its features, stand among the pens.
std::vector<std::size_t> numbers_of(std::string_view layer, std::span<const PenOfLayers> pens) {
  std::vector<std::size_t> named, others;
  for (std::size_t i = 0; i < pens.size(); ++i) {
    if (!pens[i].field.empty()) continue;
    if (pens[i].layers.empty()) others.push_back(i);
    if (names(pens[i], layer)) named.push_back(i);
  }
  return named.empty() ? others : named;
}

bool may_have_field(const PenOfLayers& one, std::string_view layer) {
  return !one.field.empty() && (one.layers.empty() || names(one, layer));
}

std::string text_of(const Attribute& attribute) {
  return std::visit([](const auto& value) { return fmt::format("{}", value); }, attribute.value);
}

bool meets(const Attributes& feature, const PenOfLayers& one) {
  const std::string field = in_lower_case(one.field);
  return std::ranges::any_of(feature, [&](const Attribute& attribute) {
    return in_lower_case(attribute.name) == field &&
           std::ranges::find(one.values, text_of(attribute)) != one.values.end();
  });
}

// For each feature of a layer where its own pens stand among the pens; none: it is drawn as the
// layer is.
std::vector<std::vector<std::size_t>> numbers_by_feature(const Layer& layer,
                                                         std::span<const PenOfLayers> pens) {
  std::vector<std::vector<std::size_t>> out(layer.features.size());
  for (std::size_t i = 0; i < pens.size(); ++i) {
    if (!may_have_field(pens[i], layer.name)) continue;
    for (std::size_t f = 0; f < out.size(); ++f) {
      throw_if_stopped(f);
      if (meets(layer.features[f], pens[i])) out[f].push_back(i);
    }
  }
  return out;
}

// A field that no feature can have is a slip of the pens.
void check_field(const PenOfLayers& one, const Drawing& drawing) {
  std::set<std::string, std::less<>> fields;
  for (const Layer& layer : drawing.layers) {
    if (!may_have_field(one, layer.name)) continue;
    fields.insert(layer.fields.begin(), layer.fields.end());
    for (const Attributes& feature : layer.features)
      for (const Attribute& attribute : feature) fields.insert(attribute.name);
  }
  const auto is_meant = [&](const std::string& name) {
    return in_lower_case(name) == in_lower_case(one.field);
  };
  if (fields.empty() || std::ranges::any_of(fields, is_meant)) return;
  throw UsageError(fmt::format("{}{}no line has a field '{}'", one.place,
                               one.place.empty() ? "" : ": ", printable(one.field)),
                   fmt::format("there {} {}", fields.size() == 1 ? "is" : "are",
                               printable(joined(std::vector(fields.begin(), fields.end()), ", "))));
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

[[noreturn]] void refuse(const Layer& layer, std::span<const PenOfLayers> pens) {
  const bool has_fields = std::ranges::any_of(
      pens, [&](const PenOfLayers& one) { return may_have_field(one, layer.name); });
  throw UsageError(
      fmt::format("no pen draws {}the layer '{}'", has_fields ? "all of " : "", layer.name),
      fmt::format("name it in a pen's layers{}, or give a pen without layers for all "
                  "others",
                  has_fields ? ", without a field" : ""));
}

void append_stroke(Layer& to, const Layer& from, const Stroke& stroke) {
  to.strokes.push_back(stroke);
  to.strokes.back().first_point = static_cast<std::uint32_t>(to.page_mm.size());
  const std::span<const Vec2> points = from.points(stroke);
  to.page_mm.insert(to.page_mm.end(), points.begin(), points.end());
}

} // namespace

std::vector<Pen> pens_of(std::string_view layer, std::span<const PenOfLayers> pens) {
  std::vector<Pen> out;
  for (const std::size_t i : numbers_of(layer, pens)) out.push_back(pens[i].pen);
  return out;
}

void assign_pens(Drawing& drawing, std::span<const PenOfLayers> pens, WithoutPen rest) {
  std::vector<Layer> kept, by_pen, ways;
  for (const PenOfLayers& one : pens) {
    by_pen.push_back(layer_of(one.pen));
    if (!one.field.empty()) check_field(one, drawing);
  }
  std::size_t step = 0;
  for (Layer& layer : drawing.layers) {
    if (layer.is_pen_way) {
      ways.push_back(std::move(layer));
      continue;
    }
    const std::vector<std::size_t> of_layer = numbers_of(layer.name, pens);
    const std::vector<std::vector<std::size_t>> by_feature = numbers_by_feature(layer, pens);
    Layer of_no_pen;
    if (rest == WithoutPen::kept) {
      of_no_pen = layer;
      of_no_pen.clear();
      of_no_pen.texts.clear();
    }
    for (const Stroke& stroke : layer.strokes) {
      throw_if_stopped(step++);
      const bool has_own =
          stroke.feature >= 0 && !by_feature[static_cast<std::size_t>(stroke.feature)].empty();
      const std::vector<std::size_t>& candidates =
          has_own ? by_feature[static_cast<std::size_t>(stroke.feature)] : of_layer;
      if (candidates.empty()) {
        if (rest == WithoutPen::refused) refuse(layer, pens);
        append_stroke(of_no_pen, layer, stroke);
        continue;
      }
      const double width_mm = stroke.width_mm > 0 ? stroke.width_mm : layer.pen_width_mm;
      Layer& to = by_pen[nearest_in_width(width_mm, candidates, pens)];
      append_stroke(to, layer, stroke);
      to.strokes.back().width_mm = 0; // the pen's own
      to.strokes.back().feature = -1; // which is its old layer's to tell
    }
    for (PageText& text : layer.texts) {
      text.feature = -1;
      Layer* to = &of_no_pen;
      if (of_layer.empty() && rest == WithoutPen::refused) refuse(layer, pens);
      if (!of_layer.empty()) to = &by_pen[nearest_in_width(layer.pen_width_mm, of_layer, pens)];
      to->texts.push_back(std::move(text));
    }
    if (!of_no_pen.strokes.empty() || !of_no_pen.texts.empty())
      kept.push_back(std::move(of_no_pen));
  }
  for (std::size_t i = 0; i < pens.size(); ++i) {
    if (!pens[i].dash) continue;
    by_pen[i] = dashed(merged(by_pen[i]), pens[i].dash->dash_mm, pens[i].dash->gap_mm);
    round_to_page_step(by_pen[i]);
  }
  std::erase_if(by_pen,
                [](const Layer& layer) { return layer.strokes.empty() && layer.texts.empty(); });
  drawing.layers = std::move(kept);
  for (std::vector<Layer>* layers : {&by_pen, &ways})
    std::ranges::move(*layers, std::back_inserter(drawing.layers));
}

} // namespace orograph
