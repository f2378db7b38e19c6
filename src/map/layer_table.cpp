// SPDX-License-Identifier: GPL-3.0-or-later
#include "map/layer_table.hpp"

#include <algorithm>
#include <array>

namespace orograph {
namespace {

// Ridges and shores are a little heavier than profiles, border, voids and edges lighter.
constexpr std::array<LayerRow, 17> kSeen{{
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
    {.name = "hidden",
     .source = LineSource::hidden_solids,
     .weight = 0.8,
     .grey = 0.45,
     .hidden_of = "solids"},
    {.name = "solids", .source = LineSource::solids, .weight = 1.4},
    {.name = "pen-up", .source = LineSource::pen_way, .weight = 0.4, .grey = 0.5},
}};

// What may have hidden lines drawn. The skyline, which nothing stands behind, has none.
constexpr std::string_view kHidden = "hidden-";
constexpr std::array<std::string_view, 13> kHiddenNames{
    "hidden-profiles",   "hidden-mesh",   "hidden-contours", "hidden-index-contours",
    "hidden-graticule",  "hidden-grid",   "hidden-edges",    "hidden-waterlines",
    "hidden-shores",     "hidden-border", "hidden-drape",    "hidden-voids",
    "hidden-silhouettes"};

// A hidden line is a little thinner than a visible one of its kind, and much lighter: it is behind
// the ground that one looks at. Thin dashes lighter than this aren't seen on paper.
constexpr LayerRow hidden_row(std::string_view name) {
  constexpr double kWeight = 0.8, kDarkness = 0.55, kLightest = 0.6;
  LayerRow row = *std::ranges::find(kSeen, name.substr(kHidden.size()),
                                    [](const LayerRow& r) { return r.name; });
  row.hidden_of = row.name;
  row.name = name;
  row.weight *= kWeight;
  row.grey = std::min(kLightest, 1 - kDarkness * (1 - row.grey));
  return row;
}

constexpr auto kLayers = [] {
  std::array<LayerRow, kHiddenNames.size() + kSeen.size()> rows{};
  std::ranges::copy(kSeen, std::ranges::transform(kHiddenNames, rows.begin(), hidden_row).out);
  return rows;
}();

// Whether a layer that isn't asked for by its name is drawn all the same: waterlines as a way of
// drawing water, index contours among the others, hidden ones too.
bool goes_with_another(const LayerRow& row, const Style& style) {
  if (row.kind == LineKind::waterline) return !row.is_hidden() && style.draws_waterlines();
  return row.kind == LineKind::index_contour && style.draws_index_contours() &&
         (!row.is_hidden() || style.asks_for("hidden-contours"));
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

std::optional<Layer> layer_of(const LayerRow& row, const Style& style) {
  const LayerSpec* const spec = style.layer(row.name);
  if (!spec && !goes_with_another(row, style)) return std::nullopt;
  Layer layer;
  layer.name = row.name;
  layer.pen_width_mm =
      (spec ? spec->weight : std::nullopt).value_or(row.weight) * style.pen_width_mm;
  layer.grey = (spec ? spec->grey : std::nullopt).value_or(row.grey);
  layer.is_hidden = row.is_hidden();
  layer.is_pen_way = row.source == LineSource::pen_way;
  return layer;
}

} // namespace orograph
