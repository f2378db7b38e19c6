// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/read/raster_shares.hpp"

#include "dem/read/open_raster.hpp"
#include "geometry/error.hpp"
#include "geometry/on_all_cores.hpp"

#include <cpl_conv.h>
#include <gdal_priv.h>

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <filesystem>
#include <string_view>

namespace orograph {
namespace {

// Fewer aren't worth another handle, which takes GDAL a tenth of a millisecond.
constexpr std::int64_t kPixelsOfShare = 1 << 20;

// While one lives, GeoTIFFs that this thread opens are read straight from the file to their place:
// a third of the time that the way through GDAL's cache of blocks takes.
class DirectReading {
public:
  DirectReading() { CPLSetThreadLocalConfigOption("GTIFF_DIRECT_IO", "YES"); }
  ~DirectReading() { CPLSetThreadLocalConfigOption("GTIFF_DIRECT_IO", nullptr); }
  DirectReading(const DirectReading&) = delete;
  DirectReading& operator=(const DirectReading&) = delete;
};

Dataset open_directly(const SharedFile& file) {
  GdalMessages messages;
  const DirectReading direct;
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
  const Dataset dataset = open_directly(file);
  GDALRasterBand& band = *dataset->GetRasterBand(file.band);
  read_heights(band, share, order, code, file.path, heights, nullptr);
  return !code.nodata && has_unwritten_blocks(band, share);
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

} // namespace orograph
