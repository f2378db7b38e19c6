// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/read/open_rasters.hpp"

#include "dem/read/asked_window.hpp"
#include "dem/read/crs_frame.hpp"
#include "dem/read/grid_in_frame.hpp"
#include "dem/read/lonlat.hpp"
#include "geometry/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace orograph {
namespace {

[[noreturn]] void refuse_crs(const RasterSource& one, const RasterSource& other) {
  const auto is_in = [](const RasterSource& source) {
    return source.map.crs_wkt.empty()
               ? fmt::format("{} has no CRS", source.path)
               : fmt::format("{} is in {}", source.path, source.map.crs_name);
  };
  const RasterSource& known = one.map.crs_wkt.empty() ? other : one;
  const bool both = !one.map.crs_wkt.empty() && !other.map.crs_wkt.empty();
  const std::string crs = crs_for_command(known.map.crs_wkt);
  throw Error(fmt::format("{}, but {}", is_in(one), is_in(other)),
              both ? fmt::format("make one raster of them: gdalwarp -t_srs {} -r cubic {} {} "
                                 "joined.tif",
                                 crs, one.path, other.path)
                   : fmt::format("if it is the same, say so: gdal_edit.py -a_srs {} {}", crs,
                                 &known == &one ? other.path : one.path));
}

void check_datum(std::vector<RasterSource>& sources) {
  const RasterSource* told = nullptr;
  for (const RasterSource& source : sources) {
    const std::string& above = source.map.vertical_crs_name;
    if (above.empty()) continue;
    if (told && told->map.vertical_crs_name != above)
      throw Error(fmt::format("heights of {} are above {}, and those of {} above {}", told->path,
                              told->map.vertical_crs_name, source.path, above),
                  "bring them to one with gdalwarp -s_srs and -t_srs, which take vertical CRSs "
                  "too (EPSG:4326+5773)");
    told = told ? told : &source;
  }
  if (!told) return;
  for (RasterSource& source : sources)
    if (source.map.vertical_crs_name.empty())
      source.notes.push_back(
          fmt::format("The file doesn't say what its heights are above: {} is taken, as {} has it.",
                      told->map.vertical_crs_name, told->path));
}

// Throws Error, naming two of them, where several rasters aren't in one CRS, their heights are
// above different things, or one doesn't tell its place. Adds a note where some tell what their
// heights are above and others don't. Units of height may differ: heights are in metres.
void check_same_terrain(std::vector<RasterSource>& sources) {
  if (sources.size() < 2) return;
  const RasterSource& first = sources.front();
  for (const RasterSource& source : sources) {
    if (!source.has_place)
      throw Error(fmt::format("{} has no georeference, so its place among the other files isn't "
                              "known",
                              source.path),
                  fmt::format("set one: gdal_edit.py -a_ullr XMIN YMAX XMAX YMIN {}", source.path));
    if (!same_place(first.map.crs_wkt, source.map.crs_wkt)) refuse_crs(first, source);
  }
  check_datum(sources);
}

// The window's vertices in the lattice; `lonlat` is as it was asked for, if it was so.
RasterWindow vertices_in(const Box2& window, const RasterLattice& lattice, const MapFrame& map,
                         const std::optional<Box2>& lonlat, const std::string& name) {
  const Box2 extent = box_of(lattice);
  check_window(window, extent);
  const RasterWindow vertices = window_of(lattice, window);
  if (vertices.empty()) {
    const auto bounds = lonlat ? lonlat_bounds(map.crs_wkt, extent) : std::nullopt;
    refuse_window(bounds ? *lonlat : window, bounds.value_or(extent), name);
  }
  if (vertices.pixels < 2 || vertices.lines < 2)
    throw Error(
        fmt::format("the window {} holds {} x {} vertices of {}", in_words(window), vertices.pixels,
                    vertices.lines, name),
        fmt::format("it needs at least 2 x 2; the terrain reaches from {}", in_words(extent)));
  return vertices;
}

JoinedTiles join(const std::vector<RasterSource>& sources, std::optional<int> overview) {
  std::vector<Tile> tiles;
  for (const RasterSource& source : sources)
    tiles.push_back({source.path, in_grid_order(source.order)});
  JoinedTiles joined = join_tiles(tiles, whole_turn(sources.front().map.crs_wkt), overview);
  const RasterLattice& lattice = joined.lattice;
  if (lattice.pixels < 2 || lattice.lines < 2)
    throw Error(
        fmt::format("{} has {} x {} cells", sources.front().path, lattice.pixels, lattice.lines),
        "a terrain needs at least 2 x 2");
  return joined;
}

// A window in longitude and latitude is the same whole turns on: it goes where the files are, and
// over their end to their beginning.
void turn_onto(JoinedTiles& joined, Box2& window, double turn) {
  const Box2 extent = box_of(joined.lattice);
  const double width = window.width();
  window.low.x = turned_onto(window.low.x, width, extent.low.x, extent.high.x, turn);
  window.high.x = window.low.x + width;
  continue_around(joined, turn, window);
}

} // namespace

bool RasterSet::are_floats() const {
  return std::ranges::all_of(sources, [](const RasterSource& source) { return source.in_float; });
}

RasterSet open_rasters(const std::vector<std::string>& paths, const ReadOptions& options,
                       const std::function<void(const RasterSource&)>& on_lattice) {
  RasterSet set;
  for (const std::string& path : paths) {
    set.sources.push_back(open_source(path, options, on_lattice));
    if (paths.size() > 1) close(set.sources.back());
  }
  check_same_terrain(set.sources);
  set.joined = join(set.sources, options.overview);
  TerrainData& terrain = set.terrain;
  terrain.source = in_brief(paths);
  terrain.paths = paths;
  terrain.is_overview = options.overview.has_value();
  terrain.map = set.sources.front().map;

  set.box = wanted_window(options, terrain.map, terrain.source);
  const auto turn = whole_turn(terrain.map.crs_wkt);
  if (options.bbox_lonlat && turn) turn_onto(set.joined, *set.box, *turn);
  const RasterLattice& lattice = set.joined.lattice;
  set.window =
      set.box ? vertices_in(*set.box, lattice, terrain.map, options.bbox_lonlat, terrain.source)
              : RasterWindow{0, 0, lattice.pixels, lattice.lines};
  set.order = grid_order(part_of(lattice, set.window));
  terrain.map.origin = set.order.first;
  set_centre(terrain.map, box_of(part_of(lattice, set.window)).centre());
  set.grid = empty_grid(set.order, terrain.map, paths);
  return set;
}

} // namespace orograph
