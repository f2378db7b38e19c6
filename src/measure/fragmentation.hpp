// SPDX-License-Identifier: GPL-3.0-or-later
// How the horizon fragments as profiles are added, and what collapse keeps of it.
#pragma once

#include "dem/terrain.hpp"
#include "placing/map_spec.hpp"
#include "reference/compare_horizons.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace orograph {

/// What is varied, and how much of it is run.
struct FragmentationSpec {
  std::vector<int> profiles{15, 30, 60, 125, 250, 500, 1000, 2000};
  std::vector<double> elevations_deg{2, 5, 10, 25, 45, 70};
  /// Along the rows of a grid, along its columns, and oddly between.
  std::vector<double> azimuths_deg{90, 180, 217};
  int exact_segments = 100000;       ///< rows with more occluders aren't run in exact arithmetic
  int fragmented_segments = 1000000; ///< and not without collapse
  int worst_case = 1000;             ///< the largest size of the worst cases; 0: none
  int repeats = 1;                   ///< runs that are timed, each row; the fastest counts
};

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
  /// Put into the horizon: segments, or pieces of other lines.
  std::uint64_t occluders = 0;
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

/// The rows to measure on a terrain: each number of profiles in each view, with either occluder.
std::vector<FragmentationRow> fragmentation_rows(const FragmentationSpec& spec);

/// The row's measures into it; of `map` it has what rows don't differ in. Throws Error as
/// `placed_view` does.
void measure_row(FragmentationRow& row, const FragmentationSpec& spec, const TerrainData& terrain,
                 const MapSpec& map);

/// What breaks the promise that collapse keeps the horizon at its least size, ties apart: a
/// sentence; empty where it is kept, or where the least size isn't known.
std::string broken_promise(const FragmentationRow& row);

} // namespace orograph
