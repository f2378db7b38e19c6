// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/read/read_raster.hpp"

#include "dem/read/asked_window.hpp"
#include "dem/read/crs_frame.hpp"
#include "dem/read/grid_in_frame.hpp"
#include "dem/read/join_tiles.hpp"
#include "dem/read/lonlat.hpp"
#include "dem/read/raster_heights.hpp"
#include "dem/read/raster_shares.hpp"
#include "dem/read/raster_source.hpp"
#include "geometry/error.hpp"
#include "geometry/large_pages.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <new>
#include <stdexcept>

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

// Each note once; with the files that it is about, where it isn't about all.
std::vector<std::string> notes_of(const std::vector<RasterSource>& sources,
                                  std::vector<std::string> RasterSource::*kind) {
  struct Note {
    std::string text;
    std::vector<std::string> paths;
  };
  std::vector<Note> notes;
  for (const RasterSource& source : sources)
    for (const std::string& text : source.*kind) {
      auto note =
          std::find_if(notes.begin(), notes.end(), [&](const Note& n) { return n.text == text; });
      if (note == notes.end()) note = notes.insert(notes.end(), {text, {}});
      if (note->paths.empty() || note->paths.back() != source.path)
        note->paths.push_back(source.path);
    }
  std::vector<std::string> texts;
  for (const Note& note : notes)
    texts.push_back(note.paths.size() == sources.size()
                        ? note.text
                        : fmt::format("{}: {}", in_brief(note.paths), note.text));
  return texts;
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

// Of a rotated or sheared raster the window holds more than the box does.
void cut_to(const Box2& box, const RasterLattice& lattice, const GridOrder& order, Grid& grid) {
  std::visit(
      [&]<class Value>(Heights<Value>& read) {
        const auto heights = read.own();
        for (int row = 0; row < grid.rows; ++row)
          for (int column = 0; column < grid.columns; ++column)
            if (!in_box(lattice, order.first + column * order.column_step + row * order.row_step,
                        box))
              heights[grid.index(column, row)] = std::numeric_limits<Value>::quiet_NaN();
      },
      grid.heights_m);
}

template <class Value>
std::vector<Value> no_heights(std::size_t count) {
  std::vector<Value> heights;
  fill_on_large_pages(heights, count, std::numeric_limits<Value>::quiet_NaN());
  return heights;
}

void set_heights(Grid& grid, ReadHeights heights) {
  std::visit([&](auto& read) { grid.heights_m = Heights(std::move(read)); }, heights);
}

RasterWindow common(const RasterWindow& a, const RasterWindow& b) {
  const int pixel = std::max(a.pixel, b.pixel), line = std::max(a.line, b.line);
  return {pixel, line, std::min(a.pixel + a.pixels, b.pixel + b.pixels) - pixel,
          std::min(a.line + a.lines, b.line + b.lines) - line};
}

// The joined lattice's window, from the parts of the files that lie in it.
HeightDifferences read_joined(std::vector<RasterSource>& sources, const JoinedTiles& joined,
                              const RasterWindow& window, const ReadOptions& options, Grid& grid) {
  const bool in_float = std::all_of(sources.begin(), sources.end(),
                                    [](const RasterSource& source) { return source.in_float; });
  ReadHeights heights = in_float ? ReadHeights(no_heights<float>(grid.size()))
                                 : ReadHeights(no_heights<double>(grid.size()));
  HeightDifferences differences;
  for (const TilePlace& place : joined.places) {
    RasterWindow part = common(place.at, window);
    if (part.empty()) continue;
    RasterSource& source = sources[place.tile];
    const bool was_open = source.full != nullptr;
    if (!was_open) open_again(source, options);
    const int column = part.pixel - window.pixel, row = part.line - window.line;
    part.pixel -= place.at.pixel;
    part.line -= place.at.line;
    read_part(source, options, part, grid.columns, column, row, heights,
              joined.places.size() > 1 ? &differences : nullptr);
    if (!was_open) close(source);
  }
  set_heights(grid, std::move(heights));
  return differences;
}

// Of a single file, whether they are there.
bool take_early(EarlyHeights& early, RasterSource& source, Grid& grid) {
  auto heights = early.take(source.code, grid.columns, grid.rows);
  if (!heights) return false;
  if (heights->has_unwritten) note_unwritten(source);
  set_heights(grid, std::move(heights->values));
  return true;
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

void note_differences(const HeightDifferences& differences, std::vector<std::string>& notes) {
  if (differences.count > 0)
    notes.push_back(fmt::format("Where files overlap {} heights differ, by up to {:.4g} m: those "
                                "of the file given first are taken.",
                                differences.count, differences.greatest_m));
}

void note_filled(const FilledVoids& voids, double cells, std::vector<std::string>& notes) {
  notes.push_back(
      fmt::format("{} missing heights were filled from up to {} cells away; {} are left.",
                  voids.filled, cells, voids.left));
}

TerrainData read_listening(const std::vector<std::string>& paths, const ReadOptions& options) {
  const GdalMessages unheard; // where nobody else listens, until all files are closed
  std::vector<RasterSource> sources;
  EarlyHeights early;
  const auto begin_early = [&](const RasterSource& source) {
    if (paths.size() == 1) early.begin(source, options);
  };
  for (const std::string& path : paths) {
    sources.push_back(open_source(path, options, begin_early));
    if (paths.size() > 1) close(sources.back());
  }
  check_same_terrain(sources);
  JoinedTiles joined = join(sources, options.overview);
  TerrainData terrain;
  terrain.source = in_brief(paths);
  terrain.paths = paths;
  terrain.is_overview = options.overview.has_value();
  terrain.map = sources.front().map;

  std::optional<Box2> box = wanted_window(options, terrain.map, terrain.source);
  const auto turn = whole_turn(terrain.map.crs_wkt);
  if (options.bbox_lonlat && turn) turn_onto(joined, *box, *turn);
  const RasterLattice& lattice = joined.lattice;
  const RasterWindow window =
      box ? vertices_in(*box, lattice, terrain.map, options.bbox_lonlat, terrain.source)
          : RasterWindow{0, 0, lattice.pixels, lattice.lines};
  const GridOrder order = grid_order(part_of(lattice, window));
  terrain.map.origin = order.first;
  set_centre(terrain.map, box_of(part_of(lattice, window)).centre());
  Grid grid = empty_grid(order, terrain.map, paths);
  HeightDifferences differences;
  if (!take_early(early, sources.front(), grid))
    differences = read_joined(sources, joined, window, options, grid);
  terrain.notes = notes_of(sources, &RasterSource::notes);
  terrain.doubts = notes_of(sources, &RasterSource::doubts);
  note_differences(differences, terrain.notes);
  if (options.fill_voids)
    note_filled(fill_voids(grid, *options.fill_voids), *options.fill_voids, terrain.notes);
  if (box) cut_to(*box, lattice, order, grid);
  if (!has_height(grid))
    throw Error(fmt::format("{}{} holds no heights, nodata only", terrain.source,
                            box ? " in the window" : ""),
                "see 'gdalinfo -stats' for its values and nodata value");
  terrain.surface = std::move(grid);
  return terrain;
}

} // namespace

TerrainData read_rasters(const std::vector<std::string>& paths, const ReadOptions& options) {
  const auto too_large = [&] {
    return Error(fmt::format("{} doesn't fit into memory", in_brief(paths)),
                 "use `overview` or `bbox`");
  };
  try {
    return read_listening(paths, options);
  } catch (const std::bad_alloc&) {
    throw too_large();
  } catch (const std::length_error&) {
    throw too_large();
  }
}

TerrainData read_raster(const std::string& path, const ReadOptions& options) {
  return read_rasters({path}, options);
}

} // namespace orograph
