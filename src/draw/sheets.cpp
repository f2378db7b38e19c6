// SPDX-License-Identifier: GPL-3.0-or-later
#include "draw/sheets.hpp"

#include "draw/cut_drawing.hpp"
#include "draw/round_drawing.hpp"
#include "geometry/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>

namespace orograph {
namespace {

constexpr double kCross_mm = 3, kFromEdge_mm = 15; // of a cross: its arms, and its place on a seam

Vec2 rounded(Vec2 p) {
  return {rounded_to_page_step(p.x), rounded_to_page_step(p.y)};
}

void add_line(Layer& layer, std::initializer_list<Vec2> points) {
  layer.strokes.push_back({.first_point = static_cast<std::uint32_t>(layer.page_mm.size()),
                           .point_count = static_cast<std::uint32_t>(points.size())});
  for (const Vec2 p : points) layer.page_mm.push_back(rounded(p));
}

template <class Move>
void for_each_place(Layer& layer, Move move) {
  for (Vec2& p : layer.page_mm) move(p);
  for (PageText& text : layer.texts) move(text.at_mm);
}

// Where sheets lie on the whole page.
struct Tiling {
  Page sheet;
  SheetsRequest request;

  Vec2 step_mm() const {
    const Box2 inner = sheet.inner_mm();
    return {inner.width() - request.overlap_mm, inner.height() - request.overlap_mm};
  }
  Vec2 corner_mm(int column, int row) const {
    return rounded({column * step_mm().x, row * step_mm().y});
  }
  Box2 box_mm(int column, int row) const {
    const Box2 inner = sheet.inner_mm();
    const Vec2 corner = corner_mm(column, row);
    return {rounded(inner.low + corner), rounded(inner.high + corner)};
  }
};

// Drawn with what the first layer is drawn with.
Layer layer_called(const char* name, const Drawing& whole) {
  Layer layer;
  layer.name = name;
  if (!whole.layers.empty()) {
    layer.pen_width_mm = whole.layers.front().pen_width_mm;
    layer.pen = whole.layers.front().pen;
  }
  return layer;
}

// No pen is put in twice: what one draws stays in one layer. Returns the number of the layer that
// it is in.
std::size_t add_layer(Drawing& drawing, Layer layer) {
  if (layer.pen) {
    append(drawing.layers.front(), layer);
    return 0;
  }
  drawing.layers.push_back(std::move(layer));
  return drawing.layers.size() - 1;
}

void add_cross(Layer& layer, Vec2 at) {
  add_line(layer, {{at.x - kCross_mm, at.y}, {at.x + kCross_mm, at.y}});
  add_line(layer, {{at.x, at.y - kCross_mm}, {at.x, at.y + kCross_mm}});
}

// Two on each seam between two sheets.
Layer register_marks(const Drawing& whole, const Tiling& tiling) {
  Layer layer = layer_called("register", whole);
  const double half_mm = 0.5 * tiling.request.overlap_mm;
  for (int row = 0; row < tiling.request.rows; ++row)
    for (int column = 0; column < tiling.request.columns; ++column) {
      const Box2 box = tiling.box_mm(column, row);
      if (column + 1 < tiling.request.columns)
        for (const double y : {box.low.y + kFromEdge_mm, box.high.y - kFromEdge_mm})
          add_cross(layer, {box.high.x - half_mm, y});
      if (row + 1 < tiling.request.rows)
        for (const double x : {box.low.x + kFromEdge_mm, box.high.x - kFromEdge_mm})
          add_cross(layer, {x, box.high.y - half_mm});
    }
  drop_repeated_strokes(layer);
  return layer;
}

// As on a pocket calculator: of a digit's seven bars, from the top clockwise and then the middle,
// those that are drawn.
constexpr std::string_view kBars[] = {"012345", "12",     "01643", "01623",   "5612",
                                      "05623",  "056432", "012",   "0123456", "012356"};

void add_digit(Layer& layer, char digit, Vec2 low, double height_mm) {
  const double half = 0.5 * height_mm;
  const auto at = [&](double x, double y) { return Vec2{low.x + half * x, low.y + half * y}; };
  const Vec2 ends[7][2] = {{at(0, 0), at(1, 0)}, {at(1, 0), at(1, 1)}, {at(1, 1), at(1, 2)},
                           {at(0, 2), at(1, 2)}, {at(0, 1), at(0, 2)}, {at(0, 0), at(0, 1)},
                           {at(0, 1), at(1, 1)}};
  for (const char bar : kBars[digit - '0'])
    add_line(layer, {ends[bar - '0'][0], ends[bar - '0'][1]});
}

// Of a number whose digits are 1 high.
double width_of(int number) {
  return 0.8 * static_cast<double>(std::to_string(number).size() - 1) + 0.5;
}

void add_number(Layer& layer, int number, Vec2 centre, double height_mm) {
  const std::string digits = std::to_string(number);
  const double step_mm = 0.8 * height_mm; // a digit is half as wide as high
  const double width_mm = height_mm * width_of(number);
  for (std::size_t i = 0; i < digits.size(); ++i)
    add_digit(
        layer, digits[i],
        {centre.x - 0.5 * width_mm + step_mm * static_cast<double>(i), centre.y - 0.5 * height_mm},
        height_mm);
}

// On a seam, beyond its middle, where paper is cut off or lies under the neighbour; of its ends at
// the one towards the whole page's edge, which a map seldom fills.
void number_sheet(Layer& layer, const Tiling& tiling, int column, int row) {
  const SheetsRequest& request = tiling.request;
  const int number = row * request.columns + column + 1;
  const double half_mm = 0.5 * request.overlap_mm;
  const double height_mm = std::min(3.0, 0.8 * half_mm / std::max(width_of(number), 4.0 / 3));
  if (request.columns * request.rows == 1 || height_mm < 1) return; // smaller ones are dots
  const Box2 box = tiling.sheet.inner_mm();
  const Vec2 from_edge_mm{std::min(0.5 * kFromEdge_mm, 0.5 * box.width()),
                          std::min(0.5 * kFromEdge_mm, 0.5 * box.height())};
  Vec2 at{2 * column < request.columns ? box.low.x + from_edge_mm.x : box.high.x - from_edge_mm.x,
          2 * row < request.rows ? box.low.y + from_edge_mm.y : box.high.y - from_edge_mm.y};
  if (request.columns > 1)
    at.x = column + 1 < request.columns ? box.high.x - 0.5 * half_mm : box.low.x + 0.5 * half_mm;
  else
    at.y = row + 1 < request.rows ? box.high.y - 0.5 * half_mm : box.low.y + 0.5 * half_mm;
  add_number(layer, number, at, height_mm);
}

void add_frame(Layer& layer, const Box2& box) {
  add_line(layer, {box.low, {box.high.x, box.low.y}, box.high, {box.low.x, box.high.y}, box.low});
}

// Profiles would be dense on the small; they stay where there is nothing else.
void leave_outlines(Drawing& drawing) {
  const auto is_profile = [](const Stroke& stroke) { return stroke.profile >= 0; };
  const bool are_all = std::ranges::all_of(drawing.layers, [&](const Layer& layer) {
    return layer.is_pen_way || std::ranges::all_of(layer.strokes, is_profile);
  });
  if (are_all) return;
  for (Layer& layer : drawing.layers) std::erase_if(layer.strokes, is_profile);
}

} // namespace

Page page_of_sheets(const Page& sheet, const SheetsRequest& request) {
  const Tiling tiling{sheet, request};
  const Vec2 step_mm = tiling.step_mm();
  if (!(step_mm.x >= 1 && step_mm.y >= 1))
    throw UsageError(
        fmt::format("an overlap of {} mm and margins of {} mm leave nothing of a sheet "
                    "of {} x {} mm",
                    request.overlap_mm, sheet.margin_mm, sheet.width_mm, sheet.height_mm),
        "a smaller `overlap_mm`, or a larger `page`");
  const Vec2 last = tiling.corner_mm(request.columns - 1, request.rows - 1);
  return {sheet.width_mm + last.x, sheet.height_mm + last.y, sheet.margin_mm};
}

std::vector<Drawing> sheets_of(const Drawing& whole, const Page& sheet,
                               const SheetsRequest& request) {
  const Tiling tiling{sheet, request};
  Drawing marked = whole;
  std::erase_if(marked.layers, [](const Layer& layer) { return layer.is_pen_way; });
  const std::size_t marks = add_layer(marked, register_marks(whole, tiling));
  for (const Layer& layer : whole.layers)
    if (layer.is_pen_way) marked.layers.push_back(layer);
  std::vector<Drawing> sheets;
  for (int row = 0; row < request.rows; ++row)
    for (int column = 0; column < request.columns; ++column) {
      Drawing& one = sheets.emplace_back(marked);
      cut_to(one, tiling.box_mm(column, row));
      const Vec2 corner = tiling.corner_mm(column, row);
      for (Layer& layer : one.layers)
        for_each_place(layer, [&](Vec2& p) { p = rounded(p - corner); });
      number_sheet(one.layers[marks], tiling, column, row);
      one.page = sheet;
      one.title = fmt::format("{}, sheet {} of {}", whole.title, sheets.size(),
                              request.columns * request.rows);
    }
  return sheets;
}

Drawing overview_of(const Drawing& whole, const Page& sheet, const SheetsRequest& request) {
  const Tiling tiling{sheet, request};
  const Box2 from = whole.page.inner_mm(), to = sheet.inner_mm();
  const double scale = std::min(to.width() / from.width(), to.height() / from.height());
  const Vec2 low = to.centre() - 0.5 * scale * Vec2{from.width(), from.height()};
  const auto placed = [&](Vec2 p) {
    const Vec2 q = rounded(low + scale * (p - from.low));
    return Vec2{std::clamp(q.x, to.low.x, to.high.x), std::clamp(q.y, to.low.y, to.high.y)};
  };
  Drawing overview = whole;
  overview.page = sheet;
  overview.title = whole.title + ", all sheets";
  leave_outlines(overview);
  for (Layer& layer : overview.layers) {
    for (PageText& text : layer.texts) text.scale(scale);
    for (PageText& text : layer.texts) text.at_mm = placed((1 / scale) * text.at_mm);
    for (Vec2& p : layer.page_mm) p = placed(p);
    if (!layer.is_pen_way) round_to_page_step(layer);
  }
  Layer numbers = layer_called("sheets", whole);
  for (int row = 0; row < request.rows; ++row)
    for (int column = 0; column < request.columns; ++column) {
      const Box2 box = tiling.box_mm(column, row);
      const Box2 frame{placed(box.low), placed(box.high)};
      add_frame(numbers, frame);
      add_number(numbers, row * request.columns + column + 1, frame.centre(),
                 0.3 * std::min(frame.width(), frame.height()));
    }
  numbers.pen_width_mm *= 2;
  add_layer(overview, std::move(numbers));
  return overview;
}

} // namespace orograph
