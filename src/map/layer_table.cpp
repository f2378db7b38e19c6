// SPDX-License-Identifier: GPL-3.0-or-later
#include "map/layer_table.hpp"

#include <algorithm>
#include <array>

namespace orograph {
namespace {

// Ridges and shores are a little heavier than profiles, border, voids and edges lighter.
constexpr std::array<LayerRow, 17> kLayers{{
    {.name = "profiles", .source = LineSource::profiles},
    {"mesh", LineSource::ground, 0.8, 0, LineKind::mesh},
    {"contours", LineSource::ground, 0.6, 0.2, LineKind::contour},
    {"index-contours", LineSource::ground, 1.1, 0.2, LineKind::index_contour},
    {"graticule", LineSource::ground, 0.6, 0.45, LineKind::graticule},
    {"grid", LineSource::ground, 0.6, 0.45, LineKind::grid},
    {"edges", LineSource::edges, 0.6, 0.45, LineKind::edge},
    {"waterlines", LineSource::edges, 0.6, 0.45, LineKind::waterline},
    {"shores", LineSource::edges, 1.2, 0, LineKind::shore},
    {"border", LineSource::edges, 0.8, 0.45, LineKind::border},
    {"drape", LineSource::ground, 2.2, 0, LineKind::drape},
    {"voids", LineSource::edges, 0.8, 0.45, LineKind::void_edge},
    {"silhouettes", LineSource::edges, 1.6, 0, LineKind::silhouette},
    {.name = "skyline", .source = LineSource::skyline, .weight = 2},
    {.name = "hidden", .source = LineSource::hidden_solids, .weight = 0.8, .grey = 0.45},
    {.name = "solids", .source = LineSource::solids, .weight = 1.4},
    {.name = "pen-up", .source = LineSource::pen_way, .weight = 0.4, .grey = 0.5},
}};

} // namespace

std::span<const LayerRow> layer_table() {
  return kLayers;
}

std::optional<Layer> layer_of(const LayerRow& row, const Style& style) {
  const LayerSpec* const spec = style.layer(row.name);
  const bool with_another = (row.kind == LineKind::waterline && style.draws_waterlines()) ||
                            (row.kind == LineKind::index_contour && style.draws_index_contours());
  if (!spec && !with_another) return std::nullopt;
  Layer layer;
  layer.name = row.name;
  layer.pen_width_mm =
      (spec ? spec->weight : std::nullopt).value_or(row.weight) * style.pen_width_mm;
  layer.grey = (spec ? spec->grey : std::nullopt).value_or(row.grey);
  layer.is_hidden = row.source == LineSource::hidden_solids;
  layer.is_pen_way = row.source == LineSource::pen_way;
  return layer;
}

} // namespace orograph
