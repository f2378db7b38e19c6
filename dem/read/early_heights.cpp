// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/read/early_heights.hpp"

#include "dem/read/large_pages.hpp"
#include "dem/read/length_units.hpp"

#include <gdal_priv.h>
#include <tbb/task_arena.h>
#include <tbb/task_group.h>

#include <exception>
#include <utility>

namespace orograph {

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
    } catch (const std::exception&) { // not enough memory
      done = {};
    }
  }
};

namespace {

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

EarlyHeights::EarlyHeights() = default;

EarlyHeights::~EarlyHeights() {
  if (reading_) reading_->task.wait();
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
  reading_->task.run([reading = reading_.get()] { reading->read(); });
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
