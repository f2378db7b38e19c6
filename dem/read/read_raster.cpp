// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/read/read_raster.hpp"

#include "dem/read/fill_voids.hpp"
#include "dem/read/gdal_messages.hpp"
#include "dem/read/open_raster.hpp"
#include "dem/read/raster_frame.hpp"
#include "dem/read/raster_heights.hpp"
#include "dem/read/raster_order.hpp"
#include "dem/read/window_words.hpp"
#include "geometry/error.hpp"

#include <fmt/format.h>
#include <gdal_priv.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <new>
#include <stdexcept>

namespace orograph {
namespace {

// The same ground with the overview's fewer, larger cells. Their ratio is seldom a whole number.
RasterLattice coarser(const RasterLattice& full, int pixels, int lines) {
  const double across = static_cast<double>(full.pixels) / pixels;
  const double down = static_cast<double>(full.lines) / lines;
  RasterLattice lattice{pixels, lines, full.position((across - 1) / 2, (down - 1) / 2),
                        across * full.pixel_step, down * full.line_step};
  return lattice;
}

RasterWindow wanted_window(const RasterLattice& lattice, const std::optional<Box2>& bbox,
                           const std::string& path) {
  if (lattice.pixels < 2 || lattice.lines < 2)
    throw Error(fmt::format("{} has {} x {} cells", path, lattice.pixels, lattice.lines),
                "a terrain needs at least 2 x 2");
  if (!bbox) return {0, 0, lattice.pixels, lattice.lines};
  const Box2 extent = box_of(lattice);
  check_window(*bbox, extent);
  const RasterWindow window = window_of(lattice, *bbox);
  if (window.pixels == 0 || window.lines == 0) refuse_window(*bbox, extent, path);
  if (window.pixels < 2 || window.lines < 2)
    throw Error(
        fmt::format("the window {} holds {} x {} vertices of {}", in_words(*bbox), window.pixels,
                    window.lines, path),
        fmt::format("it needs at least 2 x 2; the terrain reaches from {}", in_words(extent)));
  return window;
}

// Of a rotated or sheared raster the window holds more than the box does.
void cut_to(const Box2& box, const RasterLattice& lattice, const GridOrder& order, Grid& grid) {
  std::visit(
      [&](auto& heights) {
        using Value = typename std::decay_t<decltype(heights)>::value_type;
        for (int row = 0; row < grid.rows; ++row)
          for (int column = 0; column < grid.columns; ++column)
            if (!in_box(lattice, order.first + column * order.column_step + row * order.row_step,
                        box))
              heights[grid.index(column, row)] = std::numeric_limits<Value>::quiet_NaN();
      },
      grid.heights_m);
}

bool has_height(const Grid& grid) {
  return std::visit(
      [](const auto& heights) {
        return std::any_of(heights.begin(), heights.end(), [](auto h) { return !std::isnan(h); });
      },
      grid.heights_m);
}

DegreeLattice degree_lattice(const GridOrder& order, double unit_deg, const std::string& path) {
  if (order.column_step.y != 0 || order.row_step.x != 0)
    throw Error(fmt::format("{} is turned against meridians and parallels", path),
                fmt::format("bring it to their order first: gdalwarp {} degrees.tif", path));
  const DegreeLattice lattice{
      order.first.x * unit_deg, order.column_step.x * unit_deg, order.columns,
      order.first.y * unit_deg, order.row_step.y * unit_deg,    order.rows};
  const double south_deg = lattice.lat_deg(order.rows - 1);
  // A row at a pole itself may be off it by rounding, and is no surface.
  if (!(lattice.first_lat_deg < 90 && south_deg > -90))
    throw Error(
        fmt::format("{} reaches from latitude {:.10g} to {:.10g} degrees", path, south_deg,
                    lattice.first_lat_deg),
        "latitudes are within -90 to 90, the poles themselves left out; --bbox keeps a part");
  if (std::abs(lattice.lon_step_deg) * (order.columns - 1) > 360)
    throw Error(fmt::format("{} goes round the earth more than once", path),
                "--bbox keeps a part of it");
  return lattice;
}

// On a map plane the origin is at vertex (0, 0): then positions are whole multiples of the steps,
// the same numbers however the file stores them.
Grid empty_grid(const GridOrder& order, const MapFrame& map, const std::string& path) {
  Grid grid;
  grid.columns = order.columns;
  grid.rows = order.rows;
  if (map.earth)
    grid.lattice = EarthLattice(degree_lattice(order, map.earth->unit_deg, path), map.earth->local);
  else
    grid.lattice = PlaneLattice{{}, map.unit_m * order.column_step, map.unit_m * order.row_step};
  return grid;
}

// Blocks that were never written read as nodata, or as 0 where the file has none: perhaps a sea,
// perhaps a writer that was killed.
void note_unwritten(GDALRasterBand& band, const RasterWindow& window, const HeightCode& code,
                    std::vector<std::string>& notes) {
  const int status = band.GetDataCoverageStatus(window.pixel, window.line, window.pixels,
                                                window.lines, 0, nullptr);
  if (!code.nodata && (status & GDAL_DATA_COVERAGE_STATUS_EMPTY))
    notes.push_back("Parts of the file were never written: their heights are taken as 0.");
}

void note_filled(const FilledVoids& voids, double cells, std::vector<std::string>& notes) {
  notes.push_back(
      fmt::format("{} missing heights were filled from up to {} cells away; {} are left.",
                  voids.filled, cells, voids.left));
}

Terrain read(const std::string& path, const ReadOptions& options) {
  GdalMessages messages;
  Terrain terrain;
  terrain.source = path;

  const Dataset full = open_raster(path, options.open_options, messages);
  for (const std::string& warning : messages.warnings())
    terrain.notes.push_back("GDAL warns: " + warning + ".");
  GDALRasterBand& full_band = height_band(*full, path, options.band);
  RasterLattice lattice = raster_lattice(*full, path, terrain.notes);
  const Vec2 centre = (options.bbox ? *options.bbox : box_of(lattice)).centre();
  terrain.map = raster_map_frame(*full, full_band, path, centre, terrain.notes);
  const HeightCode code = height_code(full_band, terrain.map.height_unit_m);

  Dataset overview;
  if (options.overview) {
    overview = open_overview(path, options.open_options, full_band, *options.overview, messages);
    lattice = coarser(lattice, overview->GetRasterXSize(), overview->GetRasterYSize());
  }
  GDALRasterBand& band = overview ? *overview->GetRasterBand(options.band) : full_band;

  const RasterWindow window = wanted_window(lattice, options.bbox, path);
  const GridOrder order = grid_order(part_of(lattice, window));
  terrain.map.origin = order.first;
  Grid grid = empty_grid(order, terrain.map, path);
  if (grid.is_on_earth())
    terrain.map.earth->middle_lon_deg = grid.earth().degrees().middle_lon_deg();
  read_heights(band, window, order, code, path, grid);
  note_unwritten(band, window, code, terrain.notes);
  if (options.fill_voids)
    note_filled(fill_voids(grid, *options.fill_voids), *options.fill_voids, terrain.notes);
  if (options.bbox) cut_to(*options.bbox, lattice, order, grid);
  if (!has_height(grid))
    throw Error(fmt::format("{}{} holds no heights, nodata only", path,
                            options.bbox ? " in the window" : ""),
                "see 'gdalinfo -stats' for its values and nodata value");
  terrain.surface = std::move(grid);
  return terrain;
}

} // namespace

Terrain read_raster(const std::string& path, const ReadOptions& options) {
  try {
    return read(path, options);
  } catch (const std::bad_alloc&) {
    throw Error(fmt::format("{} doesn't fit into memory", path), "use --overview or --bbox");
  } catch (const std::length_error&) {
    throw Error(fmt::format("{} doesn't fit into memory", path), "use --overview or --bbox");
  }
}

} // namespace orograph
