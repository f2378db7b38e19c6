// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/read/read_raster.hpp"

#include "dem/read/asked_window.hpp"
#include "dem/read/grid_in_frame.hpp"
#include "dem/read/open_rasters.hpp"
#include "dem/read/raster_bands.hpp"
#include "dem/read/raster_heights.hpp"
#include "dem/read/raster_shares.hpp"
#include "dem/read/raster_source.hpp"
#include "dem/read/read_rows.hpp"
#include "geometry/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <new>
#include <stdexcept>
#include <utility>

namespace orograph {
namespace {

// Each note once; with the files that it is about, where it isn't about all.
std::vector<std::string> notes_of(const std::vector<RasterSource>& sources,
                                  std::vector<std::string> RasterSource::*kind) {
  struct Note {
    std::string text;
    std::vector<std::string> paths;
  };
  std::vector<Note> notes;
  for (const RasterSource& source : sources)
    for (const std::string& text : source.*kind) {
      auto note =
          std::find_if(notes.begin(), notes.end(), [&](const Note& n) { return n.text == text; });
      if (note == notes.end()) note = notes.insert(notes.end(), {text, {}});
      if (note->paths.empty() || note->paths.back() != source.path)
        note->paths.push_back(source.path);
    }
  std::vector<std::string> texts;
  for (const Note& note : notes)
    texts.push_back(note.paths.size() == sources.size()
                        ? note.text
                        : fmt::format("{}: {}", in_brief(note.paths), note.text));
  return texts;
}

void set_heights(Grid& grid, ReadHeights heights) {
  std::visit([&](auto& read) { grid.heights_m = Heights(std::move(read)); }, heights);
}

// Of a single file, whether they are there.
bool take_early(EarlyHeights& early, RasterSource& source, Grid& grid) {
  auto heights = early.take(source.code, grid.columns, grid.rows);
  if (!heights) return false;
  if (heights->has_unwritten) note_unwritten(source);
  set_heights(grid, std::move(heights->values));
  return true;
}

void note_differences(const HeightDifferences& differences, std::vector<std::string>& notes) {
  if (differences.count > 0)
    notes.push_back(fmt::format("Where files overlap {} heights differ, by up to {:.4g} m: those "
                                "of the file given first are taken.",
                                differences.count, differences.greatest_m));
}

void note_filled(const FilledVoids& voids, double cells, std::vector<std::string>& notes) {
  notes.push_back(
      fmt::format("{} missing heights were filled from up to {} cells away; {} are left.",
                  voids.filled, cells, voids.left));
}

// All heights of the grid.
void read_heights_of(RasterSet& set, EarlyHeights& early, const ReadOptions& options,
                     HeightDifferences& differences) {
  Grid& grid = set.grid;
  if (!take_early(early, set.sources.front(), grid))
    set_heights(grid, read_rows(set, {0, grid.rows}, options, differences));
  if (options.fill_voids)
    note_filled(fill_voids(grid, *options.fill_voids), *options.fill_voids, set.terrain.notes);
  leave_in_box(set, grid);
}

int step_of(const Grid& grid, const ReadOptions& options) {
  const auto& large = options.large;
  if (!large || options.fill_voids || grid.size() <= large->most_heights) return 1;
  return step_leaving(grid.columns, grid.rows, large->least_cells);
}

// A drawing takes about as much again as the heights do.
std::uint64_t bytes_to_draw(std::size_t heights, bool in_float) {
  return 2 * heights * (in_float ? sizeof(float) : sizeof(double));
}

bool has_block_above(const RasterSource& source, const ReadOptions& options) {
  return options.max_memory && source.block_bytes > static_cast<double>(*options.max_memory);
}

void check_memory_of(const RasterSet& set, int step, const ReadOptions& options) {
  for (const RasterSource& source : set.sources)
    check_memory(
        source.block_bytes, options.max_memory,
        fmt::format("{} is in blocks of which one, with all bands side by side,", source.path),
        "take out the band of heights, in tiles: gdal_translate -b 1 -co TILED=YES");
  const Grid& grid = set.grid;
  check_memory(
      static_cast<double>(step > 1 ? bytes_in_bands(set, step, options.large->with_nested)
                                   : bytes_to_draw(grid.size(), set.are_floats())),
      options.max_memory,
      fmt::format("to draw the {} x {} heights of {}", grid.columns, grid.rows, set.terrain.source),
      "keep a part with `bbox`, take an `overview`");
}

TerrainData read_listening(const std::vector<std::string>& paths, const ReadOptions& options,
                           const std::function<void(double)>& progress) {
  const GdalMessages unheard; // where nobody else listens, until all files are closed
  EarlyHeights early;
  RasterSet set = open_rasters(paths, options, [&](const RasterSource& source) {
    const auto heights = static_cast<std::size_t>(source.order.columns) *
                         static_cast<std::size_t>(source.order.rows);
    const bool may_be_refused =
        has_block_above(source, options) ||
        (options.max_memory && bytes_to_draw(heights, false) > *options.max_memory);
    const bool may_be_large = options.large && heights > options.large->most_heights;
    if (paths.size() == 1 && !may_be_large && !may_be_refused) early.begin(source, options);
  });
  const int step = step_of(set.grid, options);
  check_memory_of(set, step, options);
  HeightDifferences differences;
  std::vector<std::string> doubts; // about an index
  if (step > 1)
    read_larger_cells(set, step, options, differences, doubts, progress);
  else
    read_heights_of(set, early, options, differences);
  TerrainData& terrain = set.terrain;
  std::vector<std::string> notes = notes_of(set.sources, &RasterSource::notes);
  note_differences(differences, notes);
  notes.insert(notes.end(), doubts.begin(), doubts.end());
  notes.insert(notes.end(), terrain.notes.begin(), terrain.notes.end());
  terrain.notes = std::move(notes);
  terrain.doubts = notes_of(set.sources, &RasterSource::doubts);
  terrain.doubts.insert(terrain.doubts.end(), doubts.begin(), doubts.end());
  if (!has_height(set.grid))
    throw Error(fmt::format("{}{} holds no heights, nodata only", terrain.source,
                            set.box ? " in the window" : ""),
                "see 'gdalinfo -stats' for its values and nodata value");
  terrain.surface = std::move(set.grid);
  return std::move(terrain);
}

} // namespace

TerrainData read_rasters(const std::vector<std::string>& paths, const ReadOptions& options,
                         const std::function<void(double)>& progress) {
  const auto too_large = [&] {
    return Error(fmt::format("{} doesn't fit into memory", in_brief(paths)),
                 "use `overview` or `bbox`");
  };
  try {
    return read_listening(paths, options, progress);
  } catch (const std::bad_alloc&) {
    throw too_large();
  } catch (const std::length_error&) {
    throw too_large();
  }
}

TerrainData read_raster(const std::string& path, const ReadOptions& options) {
  return read_rasters({path}, options);
}

} // namespace orograph
