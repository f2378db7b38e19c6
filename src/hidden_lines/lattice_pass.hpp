// SPDX-License-Identifier: GPL-3.0-or-later
// The pass through a grid in the lattice's own order (docs/lattice-order.md): what
// may hide something else comes before it, so that each line, whole, is compared with the horizon
// at its turn and then raises it, and of each profile a piece at a time.
#pragma once

#include "hidden_lines/sector_in_work.hpp"

namespace orograph {

/// What lines a pass takes besides those that hide.
struct LinesTaken {
  bool profiles; ///< drawn, or watched
  bool contours; ///< many, which the order finds itself; slabs have them listed first
};

/// Whether the lattice's order is the quicker way through a sector. Pieces of profiles between two
/// lines of the lattice are taken one by one; where there are about as many as cells (a profile a
/// row, aslant of the rows), slabs between profiles, which are taken whole, cost less, unless the
/// ground is so rough that most of the time goes to silhouettes. `strips`: of a grid on the earth.
bool pays_in_order(const Grid& grid, const Sector& sector, const EarthStrips* strips,
                   LinesTaken lines);
/// On the earth, whether it may be without contours, before strips are looked for. That takes a
/// look at each vertex, which only silhouettes make up for.
bool may_pay_on_earth(const Grid& grid, const Sector& sector, bool profiles);

/// As `strips_pass`, of a surface that hides and is a grid, on a map plane or with strips in order.
SectorParts lattice_pass(const SectorInWork& work, const LayOut& lay_out, const Show& show,
                         Counts& counts, StageSeconds& seconds);

} // namespace orograph
