// SPDX-License-Identifier: GPL-3.0-or-later
// One raster among those of a terrain: what it tells before its heights are read.
#pragma once

#include "dem/read/raster_heights.hpp"
#include "dem/read/raster_order.hpp"
#include "dem/read/read_options.hpp"
#include "dem/terrain.hpp"

#include <functional>
#include <string>
#include <vector>

#include "gdal/gdal.hpp"

namespace orograph {

struct RasterSource {
  std::string path;
  Dataset full, overview; ///< `overview` is null where full heights are read; both while closed
  std::vector<std::string> files; ///< that it is made of, as GDAL lists them
  RasterLattice lattice;          ///< of what is read, as the file counts
  GridOrder order;                ///< of the whole of it
  MapFrame map;                   ///< without its origin
  HeightCode code;
  bool in_float = true; ///< float holds all its heights
  /// What GDAL has in memory at once to read one height: a block, of all bands where the file has
  /// them side by side.
  double block_bytes = 0;
  bool has_place = false; ///< its georeference is told
  std::vector<std::string> notes;
  std::vector<std::string> doubts; ///< as a terrain's: they are among the notes too
};

/// Opens a raster. Throws Error as `read_raster` does, before any height is read, and where GDAL
/// ignores what tells the place, the CRS or the heights because it is damaged. What else GDAL warns
/// of is a doubt. `on_lattice` is called once the file's lattice is known, before its CRS is looked
/// at: understanding one takes GDAL 20 ms, in which other cores can do something.
RasterSource open_source(const std::string& path, const ReadOptions& options,
                         const std::function<void(const RasterSource&)>& on_lattice = {});

/// Files are closed while others are read: there may be more of them than may be open at once.
void close(RasterSource& source);
void open_again(RasterSource& source, const ReadOptions& options);

/// Reads `part`, a window of `in_grid_order(source.order)`, into rows of `width` heights, its first
/// vertex at (column, row). `differences` as in `read_heights`. REQUIRES that it is open.
void read_part(RasterSource& source, const ReadOptions& options, const RasterWindow& part,
               int width, int column, int row, ReadHeights& heights,
               HeightDifferences* differences);

/// Adds the note that a part of the file was never written.
void note_unwritten(RasterSource& source);

/// Throws Error with a hint: not there, not a raster, an archive, a container of several rasters.
Dataset open_raster(const std::string& path, const std::vector<std::string>& open_options,
                    GdalMessages& messages);

} // namespace orograph
