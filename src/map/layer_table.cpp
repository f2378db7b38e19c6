// SPDX-License-Identifier: GPL-3.0-or-later
#include "map/layer_table.hpp"

#include <algorithm>
#include <array>

namespace orograph {
namespace {

// Of maps: what is rock is nearly black, so that colours beside it look clean on white paper.
constexpr Colour kRock{0x2b, 0x26, 0x22}, kContour{0x9c, 0x62, 0x33}, kWater{0x2a, 0x6f, 0xa8},
    kEdge{0x8a, 0x8a, 0x8a}, kNet{0x7f, 0x93, 0xa6}, kDrape{0x9b, 0x22, 0x26};

// Ridges and shores are a little heavier than profiles, border, voids and edges lighter.
constexpr std::array<LayerRow, 17> kLayers{{
    {.name = "profiles", .source = LineSource::profiles, .map = kRock},
    {"mesh", LineSource::ground, 0.8, 0, LineKind::mesh, kRock},
    {"contours", LineSource::ground, 0.6, 0.2, LineKind::contour, kContour},
    {"index-contours", LineSource::ground, 1.1, 0.2, LineKind::index_contour, kContour},
    {"graticule", LineSource::ground, 0.6, 0.45, LineKind::graticule, kNet},
    {"grid", LineSource::ground, 0.6, 0.45, LineKind::grid, kNet},
    {"edges", LineSource::edges, 0.6, 0.45, LineKind::edge, kEdge},
    {"waterlines", LineSource::edges, 0.6, 0.45, LineKind::waterline, kWater},
    {"shores", LineSource::edges, 1.2, 0, LineKind::shore, kWater},
    {"border", LineSource::edges, 0.8, 0.45, LineKind::border, kEdge},
    {"drape", LineSource::ground, 2.2, 0, LineKind::drape, kDrape},
    {"voids", LineSource::edges, 0.8, 0.45, LineKind::void_edge, kEdge},
    {"silhouettes", LineSource::edges, 1.6, 0, LineKind::silhouette, kRock},
    {.name = "skyline", .source = LineSource::skyline, .weight = 2, .map = kRock},
    {.name = "hidden",
     .source = LineSource::hidden_solids,
     .weight = 0.8,
     .grey = 0.45,
     .map = kEdge},
    {.name = "solids", .source = LineSource::solids, .weight = 1.4, .map = kRock},
    {.name = "pen-up", .source = LineSource::pen_way, .weight = 0.4, .grey = 0.5, .map = kEdge},
}};

// What lines look like that come with a layer and aren't asked for themselves.
const LayerSpec* companion_of(const LayerRow& row, const Style& style) {
  if (row.kind == LineKind::index_contour) return style.layer("contours");
  return row.kind == LineKind::waterline ? style.layer("shores") : nullptr;
}

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
  const bool is_told = spec && (spec->colour || spec->grey);
  if (const LayerSpec* const like = is_told ? spec : companion_of(row, style))
    layer.colour = like->colour;
  if (!layer.colour && !is_told && style.palette == Palette::map) layer.colour = row.map;
  layer.is_hidden = row.source == LineSource::hidden_solids;
  layer.is_pen_way = row.source == LineSource::pen_way;
  return layer;
}

} // namespace orograph
