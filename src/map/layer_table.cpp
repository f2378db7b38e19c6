// SPDX-License-Identifier: GPL-3.0-or-later
#include "map/layer_table.hpp"

#include "hidden_lines/surface_lines.hpp"

#include <algorithm>
#include <array>

namespace orograph {
namespace {

// Of maps: what is rock is nearly black, so that colours beside it look clean on white paper.
constexpr Colour kRock{0x2b, 0x26, 0x22}, kContour{0x9c, 0x62, 0x33}, kWater{0x2a, 0x6f, 0xa8},
    kEdge{0x8a, 0x8a, 0x8a}, kNet{0x7f, 0x93, 0xa6}, kDrape{0x9b, 0x22, 0x26};

// Ridges and shores are a little heavier than profiles, border, voids and edges lighter.
constexpr auto kSeen = std::to_array<LayerRow>({
    {.name = "profiles", .source = LineSource::profiles, .map = kRock},
    {"underside", LineSource::underside, 0.8, 0.4, {}, kNet},
    {"mesh", LineSource::ground, 0.8, 0, LineKind::mesh, kRock},
    {"hachures", LineSource::ground, 1, 0, LineKind::hachure, kRock},
    {"walls", LineSource::ground, 0.6, 0.45, LineKind::wall, kEdge},
    {"wall-contours", LineSource::ground, 0.6, 0.2, LineKind::wall_contour, kContour},
    {"wall-index-contours", LineSource::ground, 1.1, 0.2, LineKind::wall_index_contour, kContour},
    {"block", LineSource::ground, 1, 0, LineKind::block, kRock},
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
    {"underside-edges", LineSource::edges, 1.2, 0.2, LineKind::underside, kNet},
    {"silhouettes", LineSource::edges, 1.6, 0, LineKind::silhouette, kRock},
    {.name = "skyline", .source = LineSource::skyline, .weight = 2, .map = kRock},
    {.name = "hidden",
     .source = LineSource::hidden_solids,
     .weight = 0.8,
     .grey = 0.45,
     .map = kEdge,
     .hidden_of = "solids"},
    {.name = "solids", .source = LineSource::solids, .weight = 1.4, .map = kRock},
    {.name = "leaders", .source = LineSource::lettering, .weight = 0.6, .grey = 0.3, .map = kEdge},
    {.name = "labels", .source = LineSource::lettering, .map = kRock},
    {.name = "furniture", .source = LineSource::lettering, .map = kRock},
    {.name = "pen-up", .source = LineSource::pen_way, .weight = 0.4, .grey = 0.5, .map = kEdge},
});

// What may have hidden lines drawn. The skyline, which nothing stands behind, has none.
constexpr std::string_view kHidden = "hidden-";
constexpr std::array<std::string_view, 13> kHiddenNames{
    "hidden-profiles",   "hidden-mesh",   "hidden-contours", "hidden-index-contours",
    "hidden-graticule",  "hidden-grid",   "hidden-edges",    "hidden-waterlines",
    "hidden-shores",     "hidden-border", "hidden-drape",    "hidden-voids",
    "hidden-silhouettes"};

// How dark hidden lines are beside those that are seen.
constexpr double kDarknessOfHidden = 0.55;

constexpr Colour lighter(Colour colour) {
  for (std::uint8_t& part : colour)
    part = static_cast<std::uint8_t>(255 - kDarknessOfHidden * (255 - part) + 0.5);
  return colour;
}

// A hidden line is a little thinner than a visible one of its kind, and much lighter: it is behind
// the ground that one looks at. Thin dashes lighter than this aren't seen on paper.
constexpr LayerRow hidden_row(std::string_view name) {
  constexpr double kWeight = 0.8, kLightest = 0.6;
  LayerRow row = *std::ranges::find(kSeen, name.substr(kHidden.size()),
                                    [](const LayerRow& r) { return r.name; });
  row.hidden_of = row.name;
  row.name = name;
  row.weight *= kWeight;
  row.grey = std::min(kLightest, 1 - kDarknessOfHidden * (1 - row.grey));
  row.map = lighter(row.map);
  return row;
}

constexpr auto kLayers = [] {
  std::array<LayerRow, kHiddenNames.size() + kSeen.size()> rows{};
  std::ranges::copy(kSeen, std::ranges::transform(kHiddenNames, rows.begin(), hidden_row).out);
  return rows;
}();

// Whether a layer that isn't asked for by its name is drawn all the same: waterlines as a way of
// drawing water, index contours among the others, hidden ones too; what is on a block's walls; and
// the underside of what is drawn of the upper side.
bool goes_with_another(const LayerRow& row, const Style& style) {
  const bool shows_underside = style.underside == Underside::draw && !style.asks_for("block");
  if (row.source == LineSource::underside) return shows_underside && style.asks_for("profiles");
  if (row.kind == LineKind::underside) return shows_underside && draws_silhouettes(style);
  if (row.kind == LineKind::wall) return style.hatches_block();
  if (row.kind == LineKind::wall_contour)
    return style.asks_for("block") && style.asks_for("contours");
  if (row.kind == LineKind::wall_index_contour)
    return style.asks_for("block") && style.draws_index_contours();
  if (row.kind == LineKind::waterline) return !row.is_hidden() && style.draws_waterlines();
  return row.kind == LineKind::index_contour && style.draws_index_contours() &&
         (!row.is_hidden() || style.asks_for("hidden-contours"));
}

// Which layer's colour one has that isn't told its own: hidden lines that of those that are seen,
// and lines that come with others that of those.
const LayerSpec* companion_of(const LayerRow& row, const Style& style) {
  const LayerSpec* const seen = row.is_hidden() ? style.layer(row.hidden_of) : nullptr;
  if (seen) return seen;
  if (row.kind == LineKind::index_contour || row.kind == LineKind::wall_contour)
    return style.layer("contours");
  if (row.kind == LineKind::wall_index_contour) {
    const LayerSpec* const index = style.layer("index-contours");
    return index ? index : style.layer("contours");
  }
  if (row.kind == LineKind::wall) return style.layer("block");
  if (row.kind == LineKind::underside) return style.layer("underside");
  return row.kind == LineKind::waterline ? style.layer("shores") : nullptr;
}

Layer as_told(const LayerRow& row, const Style& style) {
  const LayerSpec* const spec = style.layer(row.name);
  Layer layer;
  layer.name = row.name;
  layer.pen_width_mm =
      (spec ? spec->weight : std::nullopt).value_or(row.weight) * style.pen_width_mm;
  layer.grey = (spec ? spec->grey : std::nullopt).value_or(row.grey);
  const bool is_told = spec && (spec->colour || spec->grey);
  if (is_told)
    layer.colour = spec->colour;
  else if (const LayerSpec* const like = companion_of(row, style); like && like->colour)
    layer.colour = row.is_hidden() ? lighter(*like->colour) : *like->colour;
  else if (style.palette == Palette::map)
    layer.colour = row.map;
  layer.is_hidden = row.is_hidden();
  layer.is_pen_way = row.source == LineSource::pen_way;
  return layer;
}

} // namespace

std::span<const LayerRow> layer_table() {
  return kLayers;
}

const LayerRow& layer_row(std::string_view name) {
  return *std::ranges::find(kLayers, name, &LayerRow::name);
}

HiddenKinds hidden_kinds(const Style& style) {
  HiddenKinds kinds;
  for (const LayerRow& row : kLayers)
    if (row.is_hidden() && (row.source == LineSource::edges || row.source == LineSource::ground) &&
        layer_of(row, style))
      kinds.add(row.kind);
  return kinds;
}

bool is_of_underside(const LayerRow& row) {
  return row.source == LineSource::underside || row.kind == LineKind::underside;
}

std::optional<Layer> layer_of(const LayerRow& row, const Style& style) {
  if (!style.layer(row.name) && !goes_with_another(row, style)) return std::nullopt;
  return as_told(row, style);
}

Layer layer_of_lettering(std::string_view name, const Style& style) {
  return as_told(layer_row(name), style);
}

} // namespace orograph
