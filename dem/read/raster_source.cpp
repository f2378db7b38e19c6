// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/read/raster_source.hpp"

#include "dem/read/gdal_messages.hpp"
#include "dem/read/open_raster.hpp"
#include "dem/read/raster_frame.hpp"
#include "dem/read/raster_shares.hpp"

#include <gdal_priv.h>

namespace orograph {
namespace {

// The same ground with the overview's fewer, larger cells. Their ratio is seldom a whole number.
RasterLattice coarser(const RasterLattice& full, int pixels, int lines) {
  const double across = static_cast<double>(full.pixels) / pixels;
  const double down = static_cast<double>(full.lines) / lines;
  return {pixels, lines, full.position((across - 1) / 2, (down - 1) / 2), across * full.pixel_step,
          down * full.line_step};
}

GDALRasterBand& band_of(const RasterSource& source, const ReadOptions& options) {
  const Dataset& dataset = source.overview ? source.overview : source.full;
  return *dataset->GetRasterBand(options.band);
}

} // namespace

RasterSource open_source(const std::string& path, const ReadOptions& options,
                         const std::function<void(const RasterSource&)>& on_lattice) {
  GdalMessages messages;
  RasterSource source;
  source.path = path;
  source.full = open_raster(path, options.open_options, messages);
  for (const std::string& warning : messages.warnings())
    source.notes.push_back("GDAL warns: " + warning + ".");
  GDALRasterBand& band = height_band(*source.full, path, options.band);
  source.has_place = has_georeference(*source.full);
  source.lattice = raster_lattice(*source.full, path, source.notes);
  source.order = grid_order(source.lattice);
  source.in_float = fits_float(band);
  if (on_lattice) on_lattice(source);
  source.map = raster_map_frame(*source.full, band, path, box_of(source.lattice).centre(),
                                options.height_unit, source.notes);
  source.code = height_code(band, source.map.height_unit_m);
  if (options.overview) {
    source.overview = open_overview(path, options.open_options, band, *options.overview, messages);
    source.lattice = coarser(source.lattice, source.overview->GetRasterXSize(),
                             source.overview->GetRasterYSize());
    source.order = grid_order(source.lattice);
  }
  return source;
}

void close(RasterSource& source) {
  source.overview.reset();
  source.full.reset();
}

void open_again(RasterSource& source, const ReadOptions& options) {
  GdalMessages messages;
  source.full = open_raster(source.path, options.open_options, messages);
  GDALRasterBand& band = height_band(*source.full, source.path, options.band);
  if (options.overview)
    source.overview =
        open_overview(source.path, options.open_options, band, *options.overview, messages);
}

void read_part(RasterSource& source, const ReadOptions& options, const RasterWindow& part,
               int width, int column, int row, ReadHeights& heights,
               HeightDifferences* differences) {
  const RasterWindow window = raster_window(source.order, part);
  const GridOrder order = order_within(source.order, part, width, column, row);
  const auto file = differences ? std::nullopt : shared_file(source, options);
  const SharesRead shares =
      file ? read_in_shares(*file, window, order, source.code, heights) : SharesRead{};
  if (shares.all_well) {
    if (shares.has_unwritten) note_unwritten(source);
    return;
  }
  GDALRasterBand& band = band_of(source, options);
  read_heights(band, window, order, source.code, source.path, heights, differences);
  if (!source.code.nodata && has_unwritten_blocks(band, window)) note_unwritten(source);
}

// They read as nodata, or as 0 where the file has none: perhaps a sea, perhaps a writer that was
// killed.
void note_unwritten(RasterSource& source) {
  source.notes.push_back("Parts of the file were never written: their heights are taken as 0.");
}

} // namespace orograph
