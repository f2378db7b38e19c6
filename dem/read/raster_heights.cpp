// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/read/raster_heights.hpp"

#include "geometry/error.hpp"
#include "geometry/on_all_cores.hpp"

#include <cpl_string.h>
#include <fmt/format.h>
#include <gdal_alg.h>
#include <gdal_priv.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "gdal/gdal.hpp"

namespace orograph {
namespace {

// Pixels read at once: a megabyte or two, so that they are still in the processor's cache when they
// are turned into heights.
constexpr std::int64_t tile_pixels = 1 << 18;

struct TileSize {
  int pixels, lines;
};

// Whole blocks, so that each is decoded once however small GDAL's cache is.
TileSize tile_size(GDALRasterBand& band) {
  int block_pixels = 0, block_lines = 0;
  band.GetBlockSize(&block_pixels, &block_lines);
  const auto blocks = [](std::int64_t one) { return std::max<std::int64_t>(1, tile_pixels / one); };
  const std::int64_t width = band.GetXSize(), height = band.GetYSize();
  const std::int64_t block = std::int64_t{block_pixels} * block_lines;
  const std::int64_t pixels = std::min(width, block_pixels * blocks(block));
  std::int64_t lines = block_lines;
  if (pixels == width) lines *= blocks(width * block_lines);
  // A block larger than a tile (a file in one strip) is read in parts while it stays in the cache.
  lines = std::min({lines, blocks(pixels), height});
  return {static_cast<int>(pixels), static_cast<int>(lines)};
}

// Nodata as the band's values can be; NaN, which equals nothing, if none of them can.
template <class Value>
Value comparable(const std::optional<double>& nodata) {
  if (!nodata || !(std::abs(*nodata) <= std::numeric_limits<double>::max()) ||
      std::abs(*nodata) > 1.0000001 * static_cast<double>(std::numeric_limits<Value>::max()))
    return std::numeric_limits<Value>::quiet_NaN();
  return static_cast<Value>(*nodata);
}

// Plain loops that vectorize; NaN fails the comparison with max.
template <class Value>
void to_metres(Value* value, std::size_t count, const HeightCode& code) {
  constexpr Value max = std::numeric_limits<Value>::max();
  constexpr Value none = std::numeric_limits<Value>::quiet_NaN();
  const Value nodata = comparable<Value>(code.nodata);
  if (!code.changes_values()) {
    for (std::size_t i = 0; i < count; ++i)
      value[i] = ((std::abs(value[i]) <= max) & (value[i] != nodata)) ? value[i] : none;
    return;
  }
  const double scale = code.scale, offset = code.offset, unit_m = code.unit_m;
  for (std::size_t i = 0; i < count; ++i) {
    const Value raw = value[i];
    const Value height = static_cast<Value>((static_cast<double>(raw) * scale + offset) * unit_m);
    value[i] = ((std::abs(height) <= max) & (raw != nodata)) ? height : none;
  }
}

std::ptrdiff_t place_of(const RasterWindow& at, const GridOrder& order) {
  return order.start + at.pixel * order.per_pixel + at.line * order.per_line;
}

template <class Value>
void put(const std::vector<Value>& tile, const RasterWindow& at, const GridOrder& order,
         std::vector<Value>& heights) {
  for (int line = 0; line < at.lines; ++line) {
    const Value* from = tile.data() + std::ptrdiff_t{line} * at.pixels;
    Value* to = heights.data() + place_of(at, order) + line * order.per_line;
    if (order.per_pixel == 1)
      std::copy_n(from, at.pixels, to);
    else
      for (int pixel = 0; pixel < at.pixels; ++pixel) to[pixel * order.per_pixel] = from[pixel];
  }
}

// Where there is a height already it stays.
template <class Value>
void put_beside(const std::vector<Value>& tile, const RasterWindow& at, const GridOrder& order,
                std::vector<Value>& heights, HeightDifferences& differences) {
  for (int line = 0; line < at.lines; ++line) {
    const Value* from = tile.data() + std::ptrdiff_t{line} * at.pixels;
    Value* to = heights.data() + place_of(at, order) + line * order.per_line;
    for (int pixel = 0; pixel < at.pixels; ++pixel) {
      Value& there = to[pixel * order.per_pixel];
      if (std::isnan(there)) {
        there = from[pixel];
      } else if (!std::isnan(from[pixel]) && from[pixel] != there) {
        ++differences.count;
        const double apart_m =
            std::abs(static_cast<double>(from[pixel]) - static_cast<double>(there));
        differences.greatest_m = std::max(differences.greatest_m, apart_m);
      }
    }
  }
}

// A mask of its own beside or instead of a nodata value: an internal mask or an alpha band.
GDALRasterBand* mask_of(GDALRasterBand& band) {
  const int flags = band.GetMaskFlags();
  return flags == GMF_ALL_VALID || flags == GMF_NODATA ? nullptr : band.GetMaskBand();
}

class Reader {
public:
  Reader(GDALRasterBand& band, const RasterWindow& window, const std::string& path)
      : band_(band), mask_(mask_of(band)), window_(window), path_(path) {}

  template <class Value>
  void read(const GridOrder& order, const HeightCode& code, std::vector<Value>& heights,
            HeightDifferences* differences) {
    const TileSize size = tile_size(band_);
    // As the file has them: then they are read to their place without a way round.
    const bool is_in_rows = order.per_pixel == 1 && order.per_line > 0;
    std::vector<Value> tile;
    // Tiles are counted from the raster's corner, not the window's, to hold whole blocks.
    const int first_pixel = window_.pixel - window_.pixel % size.pixels;
    const int first_line = window_.line - window_.line % size.lines;
    const int end_pixel = window_.pixel + window_.pixels, end_line = window_.line + window_.lines;
    // Down before across: the parts of a large block follow each other.
    for (int pixel = first_pixel; pixel < end_pixel;
         pixel += std::min(size.pixels, end_pixel - pixel))
      for (int line = first_line; line < end_line; line += std::min(size.lines, end_line - line)) {
        throw_if_stopped();
        RasterWindow at{std::max(pixel, window_.pixel), std::max(line, window_.line), 0, 0};
        at.pixels = std::min(size.pixels, end_pixel - pixel) - (at.pixel - pixel);
        at.lines = std::min(size.lines, end_line - line) - (at.line - line);
        const RasterWindow in_window{at.pixel - window_.pixel, at.line - window_.line, at.pixels,
                                     at.lines};
        if (is_in_rows && !differences) {
          read_tile(at, heights.data() + place_of(in_window, order), order.per_line, code);
          continue;
        }
        tile.resize(std::max(tile.size(), static_cast<std::size_t>(at.pixels) * at.lines));
        read_tile(at, tile.data(), at.pixels, code);
        at = in_window;
        if (differences)
          put_beside(tile, at, order, heights, *differences);
        else
          put(tile, at, order, heights);
      }
  }

  const std::vector<std::string>& warnings() const { return warnings_; }

private:
  // To rows that begin `stride` values apart.
  template <class Value>
  void read_tile(const RasterWindow& at, Value* to, std::ptrdiff_t stride, const HeightCode& code) {
    fetch(band_, at, to, sizeof(Value) == sizeof(float) ? GDT_Float32 : GDT_Float64,
          stride * static_cast<std::ptrdiff_t>(sizeof(Value)));
    const auto pixels = static_cast<std::size_t>(at.pixels);
    for (int line = 0; line < at.lines; ++line) to_metres(to + line * stride, pixels, code);
    if (!mask_) return;
    mask_tile_.resize(std::max(mask_tile_.size(), pixels * static_cast<std::size_t>(at.lines)));
    fetch(*mask_, at, mask_tile_.data(), GDT_Byte, at.pixels);
    const unsigned char* mask = mask_tile_.data();
    for (int line = 0; line < at.lines; ++line)
      for (int pixel = 0; pixel < at.pixels; ++pixel)
        if (*mask++ == 0) to[line * stride + pixel] = std::numeric_limits<Value>::quiet_NaN();
  }

  void fetch(GDALRasterBand& band, const RasterWindow& at, void* to, GDALDataType type,
             std::ptrdiff_t bytes_a_line) {
    GdalMessages messages;
    if (band.RasterIO(GF_Read, at.pixel, at.line, at.pixels, at.lines, to, at.pixels, at.lines,
                      type, 0, bytes_a_line, nullptr) == CE_None &&
        !messages.has_failure()) {
      for (const std::string& warning : messages.warnings())
        if (std::find(warnings_.begin(), warnings_.end(), warning) == warnings_.end())
          warnings_.push_back(warning);
      return;
    }
    throw Error(fmt::format("{} can't be read ({})", path_, messages.last_failure()),
                "the file seems to be truncated or damaged, fetch it again");
  }

  GDALRasterBand& band_;
  GDALRasterBand* mask_;
  RasterWindow window_;
  const std::string& path_;
  std::vector<unsigned char> mask_tile_;
  std::vector<std::string> warnings_;
};

// A raster in memory over the values, which it neither copies nor owns.
template <class Value>
Dataset raster_over(std::vector<Value>& values, int columns, int rows, GDALDataType type) {
  GDALDriver* driver = GetGDALDriverManager()->GetDriverByName("MEM");
  Dataset dataset(driver ? driver->Create("", columns, rows, 0, type, nullptr) : nullptr);
  char pointer[64];
  pointer[CPLPrintPointer(pointer, values.data(), sizeof pointer - 1)] = '\0';
  CPLStringList band;
  band.SetNameValue("DATAPOINTER", pointer);
  if (!dataset || dataset->AddBand(type, band.List()) != CE_None)
    throw Error("voids can't be filled: GDAL has no rasters in memory here",
                "install GDAL's MEM driver, or leave `fill_voids` out");
  return dataset;
}

// GDAL's fill works in single precision, on a copy: heights that are there keep all their digits.
template <class Height>
FilledVoids fill(std::span<Height> heights, int columns, int rows, double cells) {
  FilledVoids voids;
  std::vector<std::uint8_t> is_there(heights.size());
  for (std::size_t i = 0; i < heights.size(); ++i) {
    throw_if_stopped(i);
    is_there[i] = std::isnan(heights[i]) ? 0 : 255;
    voids.left += is_there[i] == 0;
  }
  if (voids.left == 0 || voids.left == heights.size()) return voids;
  std::vector<float> filled;
  filled.reserve(heights.size());
  for (const Height height : heights) {
    throw_if_stopped(filled.size());
    filled.push_back(static_cast<float>(height));
  }
  const Dataset surface = raster_over(filled, columns, rows, GDT_Float32);
  const Dataset mask = raster_over(is_there, columns, rows, GDT_Byte);
  CPLStringList options;
  options.SetNameValue("TEMP_FILE_DRIVER", "MEM");
  const auto go_on = [](double, const char*, void*) { return is_stopped() ? FALSE : TRUE; };
  const CPLErr done = GDALFillNodata(surface->GetRasterBand(1), mask->GetRasterBand(1), cells, 0, 0,
                                     options.List(), go_on, nullptr);
  throw_if_stopped();
  if (done != CE_None) throw Error("GDAL can't fill the voids", "leave `fill_voids` out");
  surface->FlushCache();
  for (std::size_t i = 0; i < heights.size(); ++i) {
    throw_if_stopped(i);
    if (std::isnan(heights[i]) && !std::isnan(filled[i])) {
      heights[i] = static_cast<Height>(filled[i]);
      ++voids.filled;
      --voids.left;
    }
  }
  return voids;
}

} // namespace

HeightCode height_code(GDALRasterBand& band, double unit_m) {
  HeightCode code;
  int known = 0;
  // The C function, because only it converts the nodata value of 64-bit integers.
  const double nodata = GDALGetRasterNoDataValue(GDALRasterBand::ToHandle(&band), &known);
  if (known) code.nodata = nodata;
  code.scale = band.GetScale(&known);
  if (!known) code.scale = 1;
  code.offset = band.GetOffset(&known);
  if (!known) code.offset = 0;
  code.unit_m = unit_m;
  return code;
}

// Float holds integers of 16 bits and its own values exactly.
bool fits_float(GDALRasterBand& band) {
  const GDALDataType type = band.GetRasterDataType();
  return type == GDT_Float32 || GDALGetDataTypeSizeBits(type) <= 16;
}

bool has_unwritten_blocks(GDALRasterBand& band, const RasterWindow& window) {
  return (band.GetDataCoverageStatus(window.pixel, window.line, window.pixels, window.lines, 0,
                                     nullptr) &
          GDAL_DATA_COVERAGE_STATUS_EMPTY) != 0;
}

std::vector<std::string> read_heights(GDALRasterBand& band, const RasterWindow& window,
                                      const GridOrder& order, const HeightCode& code,
                                      const std::string& path, ReadHeights& heights,
                                      HeightDifferences* differences) {
  return std::visit(
      [&](auto& values) {
        Reader reader(band, window, path);
        reader.read(order, code, values, differences);
        return reader.warnings();
      },
      heights);
}

FilledVoids fill_voids(Grid& grid, double cells) {
  const GdalMessages unheard;
  return std::visit(
      [&](auto& heights) { return fill(heights.own(), grid.columns, grid.rows, cells); },
      grid.heights_m);
}

} // namespace orograph
