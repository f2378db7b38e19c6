// SPDX-License-Identifier: GPL-3.0-or-later
// One sector with the surface as occluder: all its profiles and lines, in strips of X on all cores.
#pragma once

#include "cli/line_sweep.hpp"
#include "cli/profile_batch.hpp"
#include "cli/report.hpp"
#include "dem/terrain.hpp"
#include "profiles/cut_surface.hpp"

#include <functional>
#include <vector>

namespace orograph {

/// What a sweep needs of its sector. REQUIRES that all outlive it.
struct SectorInWork {
  const Terrain& terrain;
  const Scene& scene;
  const Sector& sector;
  const std::vector<SweptLine>& lines;
  const SurfaceCutter& cutter;
  const TieTolerance& tolerance;
  double from_m;       ///< depth from which on terrain is looked at
  XRange range;        ///< of X that is asked for
  bool whole_profiles; ///< whether profiles are cut beyond it as well, for those who watch
  double vertices_a_strip;
  std::uint32_t near_cut; ///< number of the near plane's cut, which no profile has
};

/// Slabs are about a cell thick, so that few lines meet in one; but slivers that a cut has left
/// don't make millions of them. `nearest_m` is where the first one begins.
double slab_thickness_m(const SectorInWork& work, double nearest_m);

struct SweptSector {
  std::vector<LinePart> visible; ///< joined, by line
  std::vector<LinePart> skyline; ///< of the horizon behind everything, visible or not
};

/// Lays one profile's visible runs out in its own layer; called from several threads.
using LayOut = std::function<void(ProfileInWork&)>;
/// Is shown profiles in order, front to back.
using Show = std::function<void(ProfileInWork&)>;

/// Profiles are cut, clipped strip by strip, and laid out, a batch of them after another, on all
/// threads that the caller's arena has. The result is the same with any number of threads. Seconds
/// of the stages are those of all threads together.
SweptSector sweep_strips(const SectorInWork& work, const LayOut& lay_out, const Show& show,
                         CountsReport& counts, SecondsReport& seconds);

} // namespace orograph
