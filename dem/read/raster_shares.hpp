// SPDX-License-Identifier: GPL-3.0-or-later
// Reading one file on all cores: GDAL lets each thread have a handle of its own on it.
#pragma once

#include "dem/read/raster_heights.hpp"
#include "dem/read/raster_source.hpp"
#include "dem/read/read_options.hpp"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace orograph {

/// What another handle on a raster's file is opened by.
struct SharedFile {
  std::string path;
  std::vector<std::string> open_options;
  int band = 1;
  int block_lines = 1;
};

/// Nothing where shares aren't worth it or not possible: for anything but full heights of a GeoTIFF
/// on disk. REQUIRES that the source is open.
std::optional<SharedFile> shared_file(const RasterSource& source, const ReadOptions& options);

struct SharesRead {
  bool all_well = false; ///< otherwise some heights are read and others not
  bool has_unwritten = false;
};

/// Reads as `read_heights` does without differences, but on all cores, and past GDAL's cache where
/// the file isn't compressed. Where anything goes wrong `read_heights` can tell what it is.
/// `has_unwritten` as `has_unwritten_blocks` tells it, which isn't asked where there is nodata.
SharesRead read_in_shares(const SharedFile& file, const RasterWindow& window,
                          const GridOrder& order, const HeightCode& code, ReadHeights& heights);

/// Reads heights on other cores while GDAL and PROJ understand the CRS, which only one can do.
/// What has to be known of the CRS before heights can be read, their unit, is assumed; where that
/// was wrong they are thrown away.
class EarlyHeights {
public:
  EarlyHeights();
  /// Waits for what has begun.
  ~EarlyHeights();

  /// Begins to read all of a source whose lattice is known. Does nothing where only a part of it
  /// may be wanted, where shares can't be read, and where there is one core only.
  void begin(const RasterSource& source, const ReadOptions& options);

  struct Heights {
    ReadHeights values;
    bool has_unwritten;
  };
  /// All heights in the order of a Grid. Nothing where none were begun, for another code or another
  /// size, and where anything went wrong: then the usual way tells what it is.
  std::optional<Heights> take(const HeightCode& code, int columns, int rows);

private:
  struct Reading;
  std::unique_ptr<Reading> reading_;
};

} // namespace orograph
