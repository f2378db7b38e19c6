// SPDX-License-Identifier: GPL-3.0-or-later
// One row of `orograph fragmentation`: a terrain and a view, and how the horizon fragments.
#pragma once

#include "cli/render_settings.hpp"
#include "reference/compare_horizons.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace orograph {

/// A run over all profiles. Where the page shows what is behind the eye as well, there are two
/// horizons: their pieces are added up, and the profiles of one follow those of the other.
struct FragmentationRun {
  std::vector<std::uint32_t> after; ///< pieces of the horizon behind each profile
  std::uint64_t at_end = 0, at_most = 0;
  std::uint64_t work = 0; ///< horizon pieces written, over all profiles
  double seconds = 0;     ///< of clipping, the least of the repeats
};

/// The same in exact arithmetic, which keeps as few pieces as there can be.
struct LeastRun {
  FragmentationRun run;
  HorizonDifferences differences; ///< from the collapsed horizon, added up over all profiles
  HorizonDifferences at_end;      ///< the same behind the last profile
};

struct FragmentationRow {
  std::string scene; ///< "terrain", or the name of a worst case
  Occluder occluder = Occluder::surface;
  double azimuth_deg = 0, elevation_deg = 0;
  int profiles = 0;

  std::uint64_t segments = 0; ///< of profiles
  std::uint64_t occluders =
      0;                     ///< that were put into the horizon: segments, or pieces of other lines
  std::uint64_t visible = 0; ///< visible pieces of profiles
  FragmentationRun collapsed;
  std::optional<FragmentationRun> fragmented; ///< none: more occluders than asked for
  std::optional<LeastRun> least;              ///< likewise

  // The runs, or none.
  const FragmentationRun* without_collapse() const { return fragmented ? &*fragmented : nullptr; }
  const FragmentationRun* least_run() const { return least ? &least->run : nullptr; }
};

/// "profiles hide, from 180/2, 60 profiles".
std::string name_of(const FragmentationRow& row);

/// What breaks the promise that collapse keeps the horizon at its least size, ties apart: a
/// sentence; empty where it is kept, or where the least size isn't known.
std::string broken_promise(const FragmentationRow& row);

/// Throws Error, which names the first row that broke its promise.
void check_promises(const std::vector<FragmentationRow>& rows);

} // namespace orograph
