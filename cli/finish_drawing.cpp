// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/finish_drawing.hpp"

#include "draw/cut_drawing.hpp"
#include "draw/pen_order.hpp"
#include "draw/sheets.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <utility>

namespace orograph {
namespace {

void order_pens(Drawing& drawing, const RenderSettings& settings) {
  if (!settings.finishing_order) return;
  order_for_pen(drawing, *settings.finishing_order);
  bool is_first = true;
  for (Layer& layer : drawing.layers) {
    if (!layer.pen || layer.strokes.empty()) continue;
    if (settings.pause_between_pens && !is_first) layer.pen->waits = true;
    is_first = false;
  }
  show_pen_way(drawing);
}

} // namespace

void finish_drawing(Map& map, const RenderSettings& settings) {
  if (!settings.finishing_order) return; // it is finished
  Drawing& drawing = map.drawing;
  if (!settings.pens.empty())
    assign_pens(drawing, settings.pens,
                settings.has_colours() ? WithoutPen::kept : WithoutPen::refused);
  if (settings.clip_to_mm) cut_to(drawing, middle_of(drawing.page, *settings.clip_to_mm));
  order_pens(drawing, settings);
  Counts& counts = map.facts.counts;
  counts.strokes = counts.points = 0;
  for (const Layer& layer : drawing.layers) {
    if (layer.is_pen_way) continue;
    counts.strokes += layer.strokes.size();
    counts.points += layer.page_mm.size();
  }
}

std::vector<std::string> output_names(const RenderSettings& settings) {
  if (!settings.sheets) return {settings.output};
  const std::filesystem::path path(settings.output);
  const auto named = [&](const std::string& end) {
    return (path.parent_path() / (path.stem().string() + "-" + end + path.extension().string()))
        .string();
  };
  std::vector<std::string> names;
  for (int i = 1; i <= settings.sheets->columns * settings.sheets->rows; ++i)
    names.push_back(named(std::to_string(i)));
  names.push_back(named("overview"));
  return names;
}

std::vector<Drawing> sheets_and_overview(const Drawing& drawing, const RenderSettings& settings) {
  if (!settings.sheets) return {};
  std::vector<Drawing> all = sheets_of(drawing, settings.sheet, *settings.sheets);
  all.push_back(overview_of(drawing, settings.sheet, *settings.sheets));
  for (Drawing& one : all) order_pens(one, settings);
  return all;
}

void write_outputs(const Drawing& drawing, const std::vector<Drawing>& sheets,
                   const RenderSettings& settings) {
  if (sheets.empty()) return write_drawing(drawing, settings.output, settings.write);
  write_drawings(sheets, output_names(settings), settings.write);
}

} // namespace orograph
