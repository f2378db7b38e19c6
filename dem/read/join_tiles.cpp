// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/read/join_tiles.hpp"

#include "dem/read/asked_window.hpp"
#include "dem/read/read_options.hpp"
#include "geometry/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <numeric>
#include <stdexcept>

namespace orograph {
namespace {

std::string cells_in_words(const RasterLattice& lattice) {
  return fmt::format("{:.10g} x {:.10g}", length(lattice.pixel_step), length(lattice.line_step));
}

// A file's name with "_joined" before its extension, beside nothing: where the user works.
std::string name_of_copy(const std::string& path) {
  return std::filesystem::path(path).stem().string() + "_joined.tif";
}

// The command that resamples the tile to the base's lattice: to those of its cells whose centres
// are in the tile's cells, so that none at the tile's border are left without a height.
std::string warp_to(const Tile& base, const Tile& tile) {
  const RasterLattice &b = base.lattice, &t = tile.lattice;
  const bool upright = b.pixel_step.y == 0 && b.line_step.x == 0;
  if (!upright)
    return fmt::format("make one raster of them: gdalwarp -r cubic {} {} joined.tif", base.path,
                       tile.path);
  Box2 cells; // of the tile, counted in the base's vertices
  for (const double pixel : {-0.5, t.pixels - 0.5})
    for (const double line : {-0.5, t.lines - 0.5})
      cells.include(b.index_of(t.position(pixel, line)));
  const double slack = 1e-6;
  const Vec2 north_west =
      b.position(std::ceil(cells.low.x - slack) - 0.5, std::ceil(cells.low.y - slack) - 0.5);
  const Vec2 south_east =
      b.position(std::floor(cells.high.x + slack) + 0.5, std::floor(cells.high.y + slack) + 0.5);
  return fmt::format("resample one to the other's: gdalwarp -r cubic -tr {:.15g} {:.15g} -te "
                     "{:.15g} {:.15g} {:.15g} {:.15g} {} {}",
                     b.pixel_step.x, -b.line_step.y, north_west.x, south_east.y, south_east.x,
                     north_west.y, tile.path, name_of_copy(tile.path));
}

// Of a position on a lattice, in cells: how far it is from the nearest vertex.
Vec2 beside(Vec2 index) {
  return {std::abs(index.x - std::round(index.x)), std::abs(index.y - std::round(index.y))};
}

// Throws Error: the tile's vertices aren't those of the base's lattice, with the command that
// brings them there. `same_steps`: only its place doesn't fit.
[[noreturn]] void refuse_lattices(const Tile& base, const Tile& tile, bool same_steps,
                                  std::optional<int> overview) {
  if (overview)
    throw Error(
        fmt::format("overviews {} of {} and {} aren't on one lattice of vertices", *overview,
                    base.path, tile.path),
        "leave `overview` out, or make one file with overviews of its own: gdalbuildvrt all.vrt "
        "FILES && gdaladdo -ro all.vrt 2 4 8");
  if (!same_steps)
    throw Error(fmt::format("{} has cells of {}, and {} of {}", tile.path,
                            cells_in_words(tile.lattice), base.path, cells_in_words(base.lattice)),
                warp_to(base, tile));
  // Where coordinates are too large for their cells, one corner may fit and the other not.
  const RasterLattice& t = tile.lattice;
  const Vec2 first = beside(base.lattice.index_of(t.first)),
             last = beside(base.lattice.index_of(t.position(t.pixels - 1, t.lines - 1)));
  const Vec2 most = first.x + first.y < last.x + last.y ? last : first;
  throw Error(fmt::format("{} is {:.5g} x {:.5g} of a cell beside the lattice of {}", tile.path,
                          most.x, most.y, base.path),
              warp_to(base, tile));
}

// Throws Error: some tiles touch none of those that are `together`.
[[noreturn]] void refuse_apart(const std::vector<Tile>& tiles, const std::vector<bool>& together) {
  std::vector<std::string> apart;
  Box2 there, others;
  for (std::size_t i = 0; i < tiles.size(); ++i) {
    const Box2 box = box_of(tiles[i].lattice);
    Box2& into = together[i] ? others : there;
    if (!together[i]) apart.push_back(tiles[i].path);
    into.include(box.low);
    into.include(box.high);
  }
  throw Error(fmt::format("{} ({}) {} the other files ({})", in_brief(apart), in_words(there),
                          apart.size() == 1 ? "doesn't touch" : "don't touch", in_words(others)),
              "files of one terrain overlap or lie side by side: add what lies between, or draw "
              "them one by one");
}

// Coordinates and steps are written with 15 digits, as those of SRTM and Copernicus tiles are. That
// leaves an error of 5e-13 degrees in a longitude beyond 100, 2e-8 of a cell of 0.1 arc seconds,
// and of 5e-7 of a cell after a thousand million columns. This is far above both, and far below
// what a page shows of a cell.
constexpr double kSameVertex = 1e-5;

// Vertices of a tile on the first tile's lattice.
struct Window {
  std::int64_t column, row, columns, rows;
};

bool is_whole(Vec2 index) {
  const Vec2 off = beside(index);
  return off.x <= kSameVertex && off.y <= kSameVertex;
}

// A step of rows or columns, in the base's: over the whole tile it must lead to the same vertices.
bool same_step(const RasterLattice& base, Vec2 base_step, Vec2 step, int count) {
  const Vec2 apart = base.index_of(base.first + std::max(1, count - 1) * (step - base_step));
  return std::abs(apart.x) <= kSameVertex && std::abs(apart.y) <= kSameVertex;
}

Window window_on(const Tile& base, const Tile& tile, std::optional<int> overview) {
  const RasterLattice &b = base.lattice, &t = tile.lattice;
  const bool same_steps = same_step(b, b.pixel_step, t.pixel_step, t.pixels) &&
                          same_step(b, b.line_step, t.line_step, t.lines);
  const Vec2 first = b.index_of(t.first);
  const Vec2 last = b.index_of(t.position(t.pixels - 1, t.lines - 1));
  if (!same_steps || !is_whole(first) || !is_whole(last))
    refuse_lattices(base, tile, same_steps, overview);
  return {std::llround(first.x), std::llround(first.y), t.pixels, t.lines};
}

bool touch(const Window& a, const Window& b) {
  return a.column <= b.column + b.columns && b.column <= a.column + a.columns &&
         a.row <= b.row + b.rows && b.row <= a.row + a.rows;
}

// Which tiles hang together with the first, over others.
std::vector<bool> connected_with(const std::vector<Window>& windows, std::size_t first) {
  std::vector<bool> reached(windows.size(), false);
  std::vector<std::size_t> open{first};
  reached[first] = true;
  while (!open.empty()) {
    const std::size_t at = open.back();
    open.pop_back();
    for (std::size_t i = 0; i < windows.size(); ++i)
      if (!reached[i] && touch(windows[at], windows[i])) {
        reached[i] = true;
        open.push_back(i);
      }
  }
  return reached;
}

// The largest part that hangs together is the terrain; what isn't in it is apart.
void check_touching(const std::vector<Tile>& tiles, const std::vector<Window>& windows) {
  std::vector<bool> seen(tiles.size(), false), largest;
  std::size_t largest_count = 0;
  for (std::size_t i = 0; i < tiles.size(); ++i) {
    if (seen[i]) continue;
    const std::vector<bool> part = connected_with(windows, i);
    const auto count = static_cast<std::size_t>(std::count(part.begin(), part.end(), true));
    for (std::size_t k = 0; k < tiles.size(); ++k) seen[k] = seen[k] || part[k];
    if (count <= largest_count) continue;
    largest_count = count;
    largest = part;
  }
  if (largest_count < tiles.size()) refuse_apart(tiles, largest);
}

int as_int(std::int64_t count) {
  if (count > std::numeric_limits<int>::max()) throw std::length_error("too many vertices");
  return static_cast<int>(count);
}

// The lattice that holds all windows, its steps and place from the tile nearest to its first
// vertex: where that is the tile's own, it is so to the last bit.
JoinedTiles joined(const std::vector<Tile>& tiles, const std::vector<Window>& windows) {
  Window all = windows.front();
  for (const Window& w : windows) {
    const std::int64_t column = std::min(all.column, w.column), row = std::min(all.row, w.row);
    all.columns = std::max(all.column + all.columns, w.column + w.columns) - column;
    all.rows = std::max(all.row + all.rows, w.row + w.rows) - row;
    all.column = column;
    all.row = row;
  }
  const auto nearness = [&](const Window& w) {
    return std::pair{w.column - all.column + w.row - all.row, w.row};
  };
  const auto nearest =
      std::min_element(windows.begin(), windows.end(),
                       [&](const Window& a, const Window& b) { return nearness(a) < nearness(b); });
  const RasterLattice& anchor = tiles[static_cast<std::size_t>(nearest - windows.begin())].lattice;
  JoinedTiles out;
  out.lattice = anchor;
  out.lattice.first = anchor.position(static_cast<double>(all.column - nearest->column),
                                      static_cast<double>(all.row - nearest->row));
  out.lattice.pixels = as_int(all.columns);
  out.lattice.lines = as_int(all.rows);
  for (std::size_t i = 0; i < tiles.size(); ++i) {
    const Window& w = windows[i];
    out.places.push_back(
        {i,
         {static_cast<int>(w.column - all.column), static_cast<int>(w.row - all.row),
          static_cast<int>(w.columns), static_cast<int>(w.rows)}});
  }
  return out;
}

struct Span {
  double west, width;
};

// How far eastward from one longitude to another, from 0 to a turn.
double eastward(double from, double to, double turn) {
  return (to - from) - turn * std::floor((to - from) / turn);
}

} // namespace

JoinedTiles join_tiles(std::vector<Tile> tiles, std::optional<double> turn,
                       std::optional<int> overview) {
  if (turn) bring_together(tiles, *turn);
  std::vector<Window> windows;
  const Tile& base = tiles.front();
  for (const Tile& tile : tiles)
    windows.push_back(&tile == &base ? Window{0, 0, tile.lattice.pixels, tile.lattice.lines}
                                     : window_on(base, tile, overview));
  check_touching(tiles, windows);
  return joined(tiles, windows);
}

void continue_around(JoinedTiles& joined, double turn, const Box2& window) {
  RasterLattice& lattice = joined.lattice;
  const Vec2 around = lattice.index_of(lattice.first + Vec2{turn, 0});
  if (!is_whole(around) || std::round(around.y) != 0) return;
  const int columns = as_int(std::llround(around.x));
  const std::size_t count = joined.places.size();
  int first = 0, end = lattice.pixels;
  for (std::size_t i = 0; i < count; ++i)
    for (const int side : {-1, 1}) {
      TilePlace place = joined.places[i];
      place.at.pixel += side * columns;
      if (window_of(part_of(lattice, place.at), window).empty()) continue;
      first = std::min(first, place.at.pixel);
      end = std::max(end, place.at.pixel + place.at.pixels);
      joined.places.push_back(place);
    }
  lattice.first = lattice.position(first, 0);
  lattice.pixels = end - first;
  for (TilePlace& place : joined.places) place.at.pixel -= first;
}

void bring_together(std::vector<Tile>& tiles, double turn) {
  std::vector<Span> spans;
  for (const Tile& tile : tiles) {
    const Box2 box = box_of(tile.lattice);
    spans.push_back({box.low.x, box.width()});
  }
  const double rounding = length(tiles.front().lattice.pixel_step) / 4;
  std::optional<std::size_t> start;
  double widest = 0;
  for (std::size_t i = 0; i < spans.size(); ++i) {
    double reach = 0;
    for (const Span& s : spans)
      reach = std::max(reach, eastward(spans[i].west, s.west, turn) + s.width);
    const double gap = turn - reach;
    const bool tied = start && std::abs(gap - widest) <= rounding;
    if (start && !(tied ? spans[i].west < spans[*start].west : gap > widest)) continue;
    start = i;
    widest = gap;
  }
  const double west = spans[*start].west;
  for (std::size_t i = 0; i < tiles.size(); ++i) {
    const double there = west + eastward(west, spans[i].west, turn);
    tiles[i].lattice.first.x += turn * std::round((there - spans[i].west) / turn);
  }
}

double turned_onto(double x, double width, double low, double high, double turn) {
  const auto common = [&](double from) {
    return std::min(from + width, high) - std::max(from, low);
  };
  const double nearest = std::round((low - x) / turn);
  double best = x;
  for (const double turns : {nearest - 1, nearest, nearest + 1}) {
    const double from = x + turns * turn;
    const double more = common(from) - common(best);
    const double rounding = 1e-9 * turn;
    if (more > rounding || (more >= -rounding && std::abs(from - x) < std::abs(best - x)))
      best = from;
  }
  return best;
}

} // namespace orograph
