// SPDX-License-Identifier: GPL-3.0-or-later
// The table of layers: what may be drawn, in which order and how heavy. A new kind of lines enters
// here.
#pragma once

#include "draw/drawing.hpp"
#include "hidden_lines/hidden_parts.hpp"
#include "hidden_lines/line_pass.hpp"
#include "placing/map_spec.hpp"

#include <optional>
#include <span>
#include <string_view>

namespace orograph {

/// Where a layer's lines come from.
enum class LineSource {
  profiles,
  underside, ///< of profiles what shows it
  edges,
  ground,
  skyline,
  solids,
  hidden_solids,
  lettering, ///< texts, and lines that belong to them: drawn when all other lines are on the page
  pen_way
};

struct LayerRow {
  std::string_view name;
  LineSource source;
  double weight = 1; ///< of its pen, beside the profiles'
  double grey = 0;   ///< in Palette::mono: 0 black to 1 white
  LineKind kind{};   ///< which of the edges, or of the lines on the ground
  Colour map = {};   ///< in Palette::map
  /// The layer whose lines these are, where the eye doesn't see them; empty: those it sees.
  std::string_view hidden_of = {};

  bool is_hidden() const { return !hidden_of.empty(); }
};

/// All layers, in drawing order: what is drawn last lies on top. Hidden lines come first, but those
/// of solids.
std::span<const LayerRow> layer_table();

/// REQUIRES that there is one of that name.
const LayerRow& layer_row(std::string_view name);

/// Whether a layer shows the underside of a surface that has one.
bool is_of_underside(const LayerRow& row);

/// The kinds of edges and of lines on the ground of which a style asks for hidden parts, too.
HiddenKinds hidden_kinds(const Style& style);

/// The layer that a style asks for by a row's name, without strokes; none where it doesn't ask. A
/// grey or a colour that is asked for goes before the palette's. Index contours that come with
/// contours have the colour that those are asked for in, and waterlines that of shores. Hidden
/// lines are lighter than those that are seen.
std::optional<Layer> layer_of(const LayerRow& row, const Style& style);

/// The same whether or not it is asked for: of what else than names of layers asks for. REQUIRES a
/// name of the table.
Layer layer_of_lettering(std::string_view name, const Style& style);

} // namespace orograph
