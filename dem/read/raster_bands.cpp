// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/read/raster_bands.hpp"

#include "dem/levels/level_in_bands.hpp"
#include "dem/levels/nested_in_bands.hpp"
#include "dem/levels/stretched_lattice.hpp"
#include "dem/read/asked_window.hpp"
#include "dem/read/network.hpp"
#include "dem/read/read_rows.hpp"
#include "geometry/error.hpp"
#include "geometry/on_all_cores.hpp"

#include <fmt/format.h>
#include <gdal_priv.h>
#include <tbb/task_group.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <utility>
#include <variant>

namespace orograph {
namespace {

constexpr std::int64_t kHeightsOfBand = 1 << 23;
constexpr std::size_t kTopsKept = 10; // as many as drawings tell of
// Blocks are mostly of 256 or 512 rows, or of one.
constexpr int kUsualBlock = 512;
// Twice as large cells would be a quarter of the file.
constexpr int kLeastIndexed = 4;
constexpr int kLeastCells = 128; // along the shorter side: pages show more

int block_lines(const RasterSource& source, const ReadOptions& options) {
  if (!source.full || source.order.transposed) return kUsualBlock;
  const Dataset& dataset = source.overview ? source.overview : source.full;
  int pixels = 0, lines = 0;
  dataset->GetRasterBand(options.band)->GetBlockSize(&pixels, &lines);
  return std::max(lines, 1);
}

// The grid's rows in bands that part none of the file's blocks, where that can be.
std::vector<RowRange> bands_of(const RasterSet& set, const ReadOptions& options) {
  const RasterSource& source = set.sources.front();
  const int rows = set.grid.rows, block = block_lines(source, options);
  const auto most =
      static_cast<int>(std::clamp<std::int64_t>(kHeightsOfBand / set.grid.columns, 16, rows));
  const int height = block <= most ? most / block * block : most;
  // Where the file's last line is the grid's first row, blocks are counted from there.
  const int lines = source.order.rows;
  const int before = source.order.rows_reversed ? (set.window.line + block - lines % block) % block
                                                : set.window.line % block;
  std::vector<RowRange> bands;
  for (int row = 0, end = 0; row < rows; row = end) {
    end = std::min(row + height - (row == 0 ? before % height : 0), rows);
    bands.push_back({row, end - row});
  }
  return bands;
}

// Tasks must have ended before what they work on goes, whatever is thrown meanwhile.
class WaitAtEnd {
public:
  explicit WaitAtEnd(tbb::task_group& tasks) : tasks_(tasks) {}
  ~WaitAtEnd() {
    try {
      tasks_.wait();
    } catch (...) { // another error is on its way
    }
  }
  WaitAtEnd(const WaitAtEnd&) = delete;
  WaitAtEnd& operator=(const WaitAtEnd&) = delete;

private:
  tbb::task_group& tasks_;
};

template <class Height>
std::vector<IndexedLevel> read_levels(RasterSet& set, const std::vector<int>& steps,
                                      bool with_nested, const ReadOptions& options,
                                      HeightDifferences& differences,
                                      const std::function<void(double)>& progress) {
  std::vector<LevelInBands<Height>> levels;
  for (const int step : steps) levels.emplace_back(set.grid.columns, set.grid.rows, step);
  std::optional<NestedInBands<Height>> nested;
  if (with_nested) nested.emplace(set.grid.columns, set.grid.rows);
  // Of one band levels are made while the next is read, by the thread in which GDAL has its
  // settings.
  tbb::task_group making;
  const WaitAtEnd at_end(making);
  for (const RowRange& range : bands_of(set, options)) {
    ReadHeights read = read_rows(set, range, options, differences);
    leave_in_box(set, GridPart{0, range.first, set.grid.columns, range.rows}, read);
    const Band<Height> band{range.first, range.rows,
                            std::make_shared<const std::vector<Height>>(
                                std::get<std::vector<Height>>(std::move(read)))};
    making.wait();
    making.run(stopped_with_caller([&levels, &nested, band] {
      for (LevelInBands<Height>& level : levels) level.take(band);
      if (nested) nested->take(band);
    }));
    if (progress) progress(static_cast<double>(range.first + range.rows) / set.grid.rows);
  }
  making.wait();
  std::vector<IndexedLevel> out;
  for (LevelInBands<Height>& level : levels)
    out.push_back(
        {level.larger_cells(kTopsKept), level.columns(), level.rows(), level.move_heights()});
  if (nested) out.front().cells.nested = std::make_shared<const NestedCells>(nested->move_cells());
  return out;
}

std::vector<IndexedLevel> read_levels(RasterSet& set, const std::vector<int>& steps,
                                      bool with_nested, const ReadOptions& options,
                                      HeightDifferences& differences,
                                      const std::function<void(double)>& progress) {
  return set.are_floats()
             ? read_levels<float>(set, steps, with_nested, options, differences, progress)
             : read_levels<double>(set, steps, with_nested, options, differences, progress);
}

std::optional<IndexedLevel> level_of_index(const RasterSet& set, int step, bool with_nested,
                                           const ReadOptions& options,
                                           std::vector<std::string>& doubts) {
  if (!options.use_index || set.box) return std::nullopt;
  const auto state = state_of(set, options);
  if (!state) return std::nullopt;
  IndexFound found = find_level(index_path(set.terrain.paths), *state, set, step, with_nested);
  if (!found.why_not.empty()) doubts.push_back(found.why_not);
  return std::move(found.level);
}

} // namespace

int step_leaving(int columns, int rows, int least_cells) {
  int step = 1;
  while ((std::min(columns, rows) - 1) / (2 * step) >= least_cells) step *= 2;
  return step;
}

std::uint64_t bytes_in_bands(const RasterSet& set, int step, bool with_nested) {
  const auto width = static_cast<std::uint64_t>(set.grid.columns),
             of_step = static_cast<std::uint64_t>(step);
  const std::uint64_t all = set.grid.size(),
                      bytes = set.are_floats() ? sizeof(float) : sizeof(double);
  // Bands: the one that comes, the last, and what the level's rows still look at.
  const std::uint64_t bands = 2 * kHeightsOfBand + 3 * of_step * width;
  const std::uint64_t nested = with_nested ? nested_size(all) : 0;
  return bytes * (all / (of_step * of_step) + std::min(bands, all) + nested);
}

void read_larger_cells(RasterSet& set, int step, const ReadOptions& options,
                       HeightDifferences& differences, std::vector<std::string>& doubts,
                       const std::function<void(double)>& progress) {
  const bool with_nested = options.large->with_nested;
  std::optional<IndexedLevel> level = level_of_index(set, step, with_nested, options, doubts);
  if (!level)
    level =
        std::move(read_levels(set, {step}, with_nested, options, differences, progress).front());
  Grid& grid = set.grid;
  grid.lattice = stretched_lattice(grid, level->columns, level->rows);
  grid.columns = level->columns;
  grid.rows = level->rows;
  std::visit([&](auto& heights) { grid.heights_m = Heights(std::move(heights)); }, level->heights);
  set.terrain.surface_error_m = level->cells.departure.greatest_m;
  set.terrain.larger_cells = std::move(level->cells);
}

RasterIndex index_of(const std::vector<std::string>& paths, const ReadOptions& options,
                     const std::function<void(double)>& progress) {
  const NetworkGate gate(paths, options.allow_network);
  const GdalMessages unheard;
  RasterSet set = open_rasters(paths, options);
  if (set.box || options.fill_voids)
    throw Error("an index is of all of a raster, as it is", "leave `bbox` and `fill_voids` out");
  std::vector<int> steps;
  const int shorter = std::min(set.grid.columns, set.grid.rows);
  for (int step = kLeastIndexed; shorter / step >= kLeastCells; step *= 2) steps.push_back(step);
  if (steps.empty())
    throw Error(
        fmt::format("{} has {} x {} heights", set.terrain.source, set.grid.columns, set.grid.rows),
        fmt::format("an index is for large rasters, of {0} x {0} at least",
                    kLeastIndexed * kLeastCells));
  const auto state = state_of(set, options);
  if (!state)
    throw Error(set.terrain.source + " isn't a file on a disk",
                "an index is known to be right by the file's size and time: fetch it first");
  HeightDifferences differences;
  return {*state, read_levels(set, steps, true, options, differences, progress), gate.doubts()};
}

IndexState index_state(const std::vector<std::string>& paths, const ReadOptions& options) {
  if (!is_index(index_path(paths))) return {};
  const NetworkGate gate(paths, options.allow_network);
  const GdalMessages unheard;
  const RasterSet set = open_rasters(paths, options);
  const auto state = state_of(set, options);
  return state ? look_at_index(index_path(paths), *state, set) : IndexState{};
}

} // namespace orograph
