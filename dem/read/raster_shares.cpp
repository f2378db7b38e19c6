// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/read/raster_shares.hpp"

#include "dem/read/length_units.hpp"
#include "geometry/error.hpp"
#include "geometry/large_pages.hpp"
#include "geometry/on_all_cores.hpp"

#include <gdal_priv.h>
#include <tbb/task_arena.h>
#include <tbb/task_group.h>

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <exception>
#include <filesystem>
#include <string_view>
#include <utility>

namespace orograph {
namespace {

// Fewer aren't worth another handle, which takes GDAL a tenth of a millisecond.
constexpr std::int64_t kPixelsOfShare = 1 << 20;

// GeoTIFFs are read straight from the file to their place: a third of the time that the way through
// GDAL's cache of blocks takes.
Dataset open_directly(const SharedFile& file) {
  GdalMessages messages;
  const GdalThreadOption direct("GTIFF_DIRECT_IO", "YES");
  return open_raster(file.path, file.open_options, messages);
}

// Whole blocks, so that none is decoded twice.
int lines_of_share(const SharedFile& file, const RasterWindow& window) {
  const std::int64_t blocks =
      (kPixelsOfShare / window.pixels + file.block_lines) / file.block_lines;
  return static_cast<int>(std::min<std::int64_t>(blocks * file.block_lines, window.lines));
}

// Whether it has blocks that were never written.
bool read_share(const SharedFile& file, const RasterWindow& share, const GridOrder& order,
                const HeightCode& code, ReadHeights& heights) {
  const GdalMessages unheard;
  const Dataset dataset = open_directly(file);
  GDALRasterBand& band = *dataset->GetRasterBand(file.band);
  const auto warnings = read_heights(band, share, order, code, file.path, heights, nullptr);
  if (!warnings.empty()) // it is read again where they can be told
    throw Error(file.path + ": " + warnings.front(), "fetch it again");
  return !code.nodata && has_unwritten_blocks(band, share);
}

// Metres where only the file can tell, since GDAL looks at the CRS for it; few have anything else.
std::optional<double> assumed_unit_m(const ReadOptions& options) {
  if (options.height_unit.empty()) return 1;
  const auto unit = length_unit(options.height_unit);
  return unit ? std::optional(unit->metres) : std::nullopt;
}

bool are_same(const HeightCode& a, const HeightCode& b) {
  return a.nodata == b.nodata && a.scale == b.scale && a.offset == b.offset && a.unit_m == b.unit_m;
}

} // namespace

std::optional<SharedFile> shared_file(const RasterSource& source, const ReadOptions& options) {
  std::error_code ignored;
  if (options.overview || std::string_view(source.full->GetDriverName()) != "GTiff" ||
      !std::filesystem::is_regular_file(source.path, ignored))
    return std::nullopt;
  int pixels = 0, lines = 0;
  source.full->GetRasterBand(options.band)->GetBlockSize(&pixels, &lines);
  return SharedFile{source.path, options.open_options, options.band, lines};
}

SharesRead read_in_shares(const SharedFile& file, const RasterWindow& window,
                          const GridOrder& order, const HeightCode& code, ReadHeights& heights) {
  const int lines = lines_of_share(file, window);
  const int first = window.line - window.line % lines, end = window.line + window.lines;
  std::atomic<bool> all_well = true, has_unwritten = false;
  const auto read = [&](std::size_t share_number) {
    const int number = static_cast<int>(share_number);
    RasterWindow share = window;
    share.line = std::max(first + number * lines, window.line);
    share.lines = std::min(first + (number + 1) * lines, end) - share.line;
    GridOrder share_order = order;
    share_order.start += (share.line - window.line) * order.per_line;
    try {
      if (all_well && read_share(file, share, share_order, code, heights)) has_unwritten = true;
    } catch (const Error&) {
      all_well = false;
    }
  };
  on_all_cores(static_cast<std::size_t>((end - first + lines - 1) / lines), read);
  return {all_well, has_unwritten};
}

struct EarlyHeights::Reading {
  SharedFile file;
  GridOrder order;
  HeightCode code;
  ReadHeights heights;
  SharesRead done;
  tbb::task_group task;

  void read() {
    const RasterWindow whole{0, 0, order.columns, order.rows};
    const auto count = static_cast<std::size_t>(order.columns) * order.rows;
    try {
      std::visit([&](auto& values) { fill_on_large_pages(values, count, {}); }, heights);
      done = read_in_shares(file, raster_window(order, whole),
                            order_within(order, whole, order.columns, 0, 0), code, heights);
    } catch (const std::exception&) { // not enough memory, or stopped
      done = {};
    }
  }
};

EarlyHeights::EarlyHeights() = default;

EarlyHeights::~EarlyHeights() {
  if (!reading_) return;
  try {
    reading_->task.wait();
  } catch (const std::exception&) {
    // No thread could be started. The task may still wait for one, and is left all that it needs.
    static_cast<void>(reading_.release());
  }
}

void EarlyHeights::begin(const RasterSource& source, const ReadOptions& options) {
  if (options.bbox || options.bbox_lonlat || tbb::this_task_arena::max_concurrency() == 1) return;
  const auto file = shared_file(source, options);
  GDALRasterBand& band = *source.full->GetRasterBand(options.band);
  const auto unit_m = assumed_unit_m(options);
  if (!file || !unit_m || source.order.columns < 2 || source.order.rows < 2) return;
  reading_ = std::make_unique<Reading>();
  reading_->file = *file;
  reading_->order = source.order;
  reading_->code = height_code(band, *unit_m);
  if (!source.in_float) reading_->heights = std::vector<double>();
  reading_->task.run(stopped_with_caller([reading = reading_.get()] { reading->read(); }));
}

std::optional<EarlyHeights::Heights> EarlyHeights::take(const HeightCode& code, int columns,
                                                        int rows) {
  if (!reading_) return std::nullopt;
  reading_->task.wait();
  const std::unique_ptr<Reading> read = std::move(reading_);
  if (!read->done.all_well || !are_same(read->code, code) || read->order.columns != columns ||
      read->order.rows != rows)
    return std::nullopt;
  return Heights{std::move(read->heights), read->done.has_unwritten};
}

} // namespace orograph
