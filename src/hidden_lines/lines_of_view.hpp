// SPDX-License-Identifier: GPL-3.0-or-later
// The lines of a view that its sectors' passes take, and how each of them takes them.
#pragma once

#include "dem/terrain.hpp"
#include "hidden_lines/ground_lines.hpp"
#include "hidden_lines/hidden_parts.hpp"
#include "hidden_lines/instruments.hpp"
#include "hidden_lines/line_pictures.hpp"
#include "placing/placed_view.hpp"
#include "profiles/earth_strips.hpp"
#include "profiles/seen_ground.hpp"
#include "profiles/sheet.hpp"
#include "profiles/sheet_part.hpp"
#include "profiles/silhouettes.hpp"

#include <cstdint>
#include <optional>
#include <vector>

namespace orograph {

/// The lines of a view, for all of its sectors.
struct LinesOfView {
  std::vector<EdgeLine> listed; ///< last those on the ground
  GroundLines on_ground;
  /// The silhouettes, where they aren't listed; each sector finds those that it looks at.
  std::optional<SilhouetteMarks> silhouettes;
  HiddenKinds hidden = {}; ///< of which what isn't visible is asked for, too
  /// By the lattice's other direction, where some of a panorama's sectors want that.
  std::optional<SilhouetteMarks> turned_silhouettes = {};
  std::optional<Sheet> sheet = {};         ///< the surface, where it has two sides
  std::vector<SheetPart> sheet_parts = {}; ///< by sector, where those don't look at all of it
  /// Of a block's lines those that are seen where an edge of the border is, which is listed as
  /// well: they aren't asked for themselves. By that edge's number, up to the last that has one.
  std::vector<SeenWith> seen_with = {};
  /// For each of a panorama's sectors those listed that may reach into it, by number.
  std::vector<std::vector<std::uint32_t>> by_sector = {};

  /// Of overlays those that an earlier pass hasn't taken, alone: all else was drawn by that.
  bool are_more_overlays = false;

  /// On the earth: the strips of the view's sector, where they have an order and that pays.
  std::optional<EarthStrips> earth_strips = {};

  /// By sector, whether it is taken in the lattice's order; empty if none may be.
  std::vector<bool> in_order = {};

  const SilhouetteMarks* silhouettes_by(bool rows_are_strips) const;
};
/// `ground`: what any sector looks at, where that isn't all. Hidden silhouettes need a list.
LinesOfView lines_of_view(const TerrainData& terrain, const PlacedView& placed, const Style& style,
                          const Instruments& instruments, const SeenGround* ground,
                          const HiddenKinds& hidden = {});

/// In the place of the overlays' features that were taken the next ones; tells whether there are
/// any. REQUIRES that the view hides and asks the same. The lines listed are those that hide and
/// the overlays'.
bool take_more_overlays(const TerrainData& terrain, const PlacedView& placed, const Style& style,
                        const Instruments& instruments, LinesOfView& lines);

/// The grid, if its sectors may be taken in the lattice's order.
const Grid* grid_in_order(const TerrainData& terrain, const Style& style,
                          const Instruments& instruments);

/// What of X a sector is asked for; `in_list`: with the horizon in one list.
XRange asked_range(const Sector& sector, bool in_list, const Instruments& instruments);

} // namespace orograph
