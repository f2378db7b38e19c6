// SPDX-License-Identifier: GPL-3.0-or-later
// Between a view by PHIGS's parameters and the view that the cut and the clip work with.
#pragma once

#include "view/phigs_view.hpp"
#include "view/view.hpp"

namespace orograph {

/// The view with its profiles parallel to the view plane (`frame_of`), its picture plane the view
/// plane in metres, its window the same. `exaggeration` is what heights in `phigs` are multiplied
/// by already; `cell_m` is the terrain's finest ground detail. Front and back plane are not looked
/// at: they cut the terrain (dem/mesh).
/// Throws the Errors of the pipeline, and one for a parallel view that looks up.
View place_phigs_view(const PhigsView& phigs, double exaggeration, double cell_m,
                      const EarthDrop& drop = {});

/// The same the other way round, for every kind of view: a PHIGS view with the same picture, its
/// view plane at distance 1 from the eye, or through the depth origin at height 0 in a parallel
/// view. Of front and back plane it keeps the defaults. REQUIRES that it wasn't placed from a PHIGS
/// view.
PhigsView phigs_of(const View& view);

} // namespace orograph
