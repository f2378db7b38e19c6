// SPDX-License-Identifier: GPL-3.0-or-later
// A drawing that is too large for the paper, over several sheets.
#pragma once

#include "draw/drawing.hpp"
#include "geometry/api.hpp"

#include <vector>

namespace orograph {

struct SheetsRequest {
  int columns = 1, rows = 1;
  double overlap_mm = 10; ///< that neighbours both show
};

/// A page on which all sheets lie side by side, but for their overlaps: the margins around it are a
/// sheet's. Throws UsageError where the overlap leaves nothing of a sheet.
OROGRAPH_API Page page_of_sheets(const Page& sheet, const SheetsRequest& request);

/// What each sheet shows of a drawing on `page_of_sheets(sheet, request)`, row by row, from the
/// upper left: strokes are parted at the edges of sheets, a margin from the paper's, and nowhere
/// else. Two sheets show the same in the overlap, with crosses in its middle that lie upon each
/// other where the sheets lie right, and each its number in a half of the overlap that is cut off
/// or covered, where that has room for it: in a layer of their own, "register", or, where layers
/// have pens, in the first. REQUIRES strokes without map points.
OROGRAPH_API std::vector<Drawing> sheets_of(const Drawing& whole, const Page& sheet,
                                            const SheetsRequest& request);

/// All sheets on one of them, with their numbers, which count from 1; without the profiles, where
/// there are other lines.
OROGRAPH_API Drawing overview_of(const Drawing& whole, const Page& sheet,
                                 const SheetsRequest& request);

} // namespace orograph
