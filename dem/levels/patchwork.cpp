// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/levels/patchwork.hpp"

#include "dem/levels/patch_heights.hpp"
#include "dem/levels/stretched_lattice.hpp"
#include "dem/mesh/neighbours.hpp"
#include "geometry/on_all_cores.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>
#include <variant>

namespace orograph {
namespace {

constexpr std::uint32_t kNoVertex = 0xffffffff;
constexpr double kNoHeight = std::numeric_limits<double>::quiet_NaN();

using Place = PatchworkPlace;

// Numbers of vertices by their places: a table that is half empty at least, in one piece of memory.
// The standard's has each entry somewhere else.
class NumbersOfPlaces {
public:
  void reserve(std::size_t count) { lay(std::bit_ceil(2 * count + 16)); }

  /// kNoVertex as well where it is known that there is none; none: not known.
  std::optional<std::uint32_t> find(Place place) const {
    const Entry& entry = entries_[slot_of(place)];
    return entry.place == place ? std::optional(entry.number) : std::nullopt;
  }
  /// REQUIRES that the place isn't known.
  void add(Place place, std::uint32_t number) {
    if (2 * (count_ + 1) > entries_.size()) lay(2 * entries_.size());
    entries_[slot_of(place)] = {place, number};
    ++count_;
  }

private:
  struct Entry {
    Place place{-1, -1};
    std::uint32_t number = kNoVertex;
  };

  // Where the place is, or would be.
  std::size_t slot_of(Place place) const {
    const std::size_t mask = entries_.size() - 1;
    const std::size_t hash = HashOfPlace()(place);
    std::size_t slot = (hash ^ hash >> 32U) & mask;
    while (entries_[slot].place != place && entries_[slot].place != Entry().place)
      slot = (slot + 1) & mask;
    return slot;
  }
  void lay(std::size_t slots) {
    const std::vector<Entry> before = std::exchange(entries_, std::vector<Entry>(slots));
    for (const Entry& entry : before)
      if (entry.place != Entry().place) entries_[slot_of(entry.place)] = entry;
  }

  std::vector<Entry> entries_ = std::vector<Entry>(16);
  std::size_t count_ = 0;
};

// Vertices and triangles, patch after patch.
class Sewing {
public:
  Sewing(const Grid& grid, const Patches& patches, const HeightsOfPatches& heights)
      : patches_(patches), heights_(heights),
        lattice_(stretched_lattice(grid, static_cast<int>(patches.columns()) + 1,
                                   static_cast<int>(patches.rows()) + 1)),
        is_turned_(!grid.is_on_earth() && grid.plane().is_mirrored()) {}

  // For so many patches of full size.
  void reserve(std::size_t patches) {
    constexpr std::size_t kCells = std::size_t{kPatchCells} * kPatchCells,
                          kVertices = kCells + kPatchCells, kTriangles = 2 * kCells + kPatchCells;
    out_.tin.vertices_m.reserve(patches * kVertices);
    out_.heights_m.reserve(patches * kVertices);
    out_.places.reserve(patches * kVertices);
    out_.tin.triangles.reserve(patches * kTriangles);
    border_.reserve(patches * 2 * kPatchCells);
  }

  void add(const Patch& patch, const PatchHeights& own) {
    const std::size_t across = own.columns.size(), down = own.rows.size();
    numbers_.assign(across * down, kNoVertex);
    for (std::size_t j = 0; j < down; ++j)
      for (std::size_t i = 0; i < across; ++i) {
        const Place place{own.columns[i], own.rows[j]};
        const bool is_inside = i > 0 && j > 0 && i + 1 < across && j + 1 < down;
        numbers_[j * across + i] = is_inside
                                       ? append(place, in_place(place, own.at(i, j)))
                                       : shared(
                                             place, [&] { return own.at(i, j); }, patch.level);
      }
    for (std::size_t j = 0; j + 1 < down; ++j)
      for (std::size_t i = 0; i + 1 < across; ++i) add_cell(patch, own, i, j);
  }

  /// All but the departures. Vertices without a triangle are left out.
  Patchwork take() {
    std::vector<std::uint32_t> number(out_.places.size(), kNoVertex);
    for (const auto& corners : out_.tin.triangles)
      for (const std::uint32_t corner : corners) number[corner] = 0;
    std::uint32_t count = 0;
    for (std::size_t i = 0; i < number.size(); ++i) {
      if (number[i] == kNoVertex) continue;
      number[i] = count;
      out_.tin.vertices_m[count] = out_.tin.vertices_m[i];
      out_.heights_m[count] = out_.heights_m[i];
      out_.places[count++] = out_.places[i];
    }
    out_.tin.vertices_m.resize(count);
    out_.heights_m.resize(count);
    out_.places.resize(count);
    for (auto& corners : out_.tin.triangles)
      for (std::uint32_t& corner : corners) corner = number[corner];
    out_.tin.neighbours = find_neighbours(out_.tin.triangles, count).of;
    return std::move(out_);
  }

private:
  struct Vertex {
    Vec3 at;
    double height_m;
  };

  Vertex in_place(Place place, double height_m) const {
    return {std::visit(
                [&](const auto& l) {
                  return l.vertex_m(static_cast<int>(place[0]), static_cast<int>(place[1]),
                                    height_m);
                },
                lattice_),
            height_m};
  }

  std::uint32_t append(Place place, const Vertex& vertex) {
    if (std::isnan(vertex.height_m)) return kNoVertex;
    out_.tin.vertices_m.push_back(vertex.at);
    out_.heights_m.push_back(vertex.height_m);
    out_.places.push_back(place);
    return static_cast<std::uint32_t>(out_.places.size() - 1);
  }

  // On a patch's border: as the coarsest patch there has it. `own` is that of a patch that touches
  // it, of a level.
  template <class Own>
  std::uint32_t shared(Place place, const Own& own, int level) {
    if (const auto known = border_.find(place)) return *known;
    const std::uint32_t number = append(place, on_border(place, own, level));
    border_.add(place, number);
    return number;
  }

  template <class Own>
  Vertex on_border(Place place, const Own& own, int level) {
    const int coarsest = patches_.coarsest_at(place[0], place[1]);
    const std::int64_t cell = patches_.cell(coarsest);
    // Of a cell of that level, the last one perhaps narrower.
    const auto ends = [&](std::int64_t at, std::int64_t end) {
      const std::int64_t from = at / cell * cell;
      return at == end || at == from ? std::pair(at, at)
                                     : std::pair(from, std::min(from + cell, end));
    };
    const auto [west, east] = ends(place[0], patches_.columns());
    const auto [north, south] = ends(place[1], patches_.rows());
    if (west == east && north == south)
      return in_place(place, coarsest == level ? own() : heights_.at(coarsest, place));
    const Vertex from = end_of_edge({west, north}), to = end_of_edge({east, south});
    const double share =
        west < east ? static_cast<double>(place[0] - west) / static_cast<double>(east - west)
                    : static_cast<double>(place[1] - north) / static_cast<double>(south - north);
    return {from.at + share * (to.at - from.at),
            from.height_m + share * (to.height_m - from.height_m)};
  }

  // Of a patch that is coarser than the one that asks.
  Vertex end_of_edge(Place place) {
    const int coarsest = patches_.coarsest_at(place[0], place[1]);
    const std::uint32_t number = shared(
        place, [&] { return heights_.at(coarsest, place); }, coarsest);
    return number == kNoVertex ? Vertex{{}, kNoHeight}
                               : Vertex{out_.tin.vertices_m[number], out_.heights_m[number]};
  }
  void add_cell(const Patch& patch, const PatchHeights& own, std::size_t i, std::size_t j) {
    const std::size_t across = own.columns.size();
    const std::uint32_t nw = numbers_[j * across + i], ne = numbers_[j * across + i + 1],
                        sw = numbers_[(j + 1) * across + i],
                        se = numbers_[(j + 1) * across + i + 1];
    const std::int64_t west = own.columns[i], east = own.columns[i + 1], north = own.rows[j],
                       south = own.rows[j + 1];
    const std::int64_t half = patches_.cell(patch.level) / 2;
    // In the middle of an edge that finer patches lie beyond.
    const auto middle = [&](bool is_border, std::int64_t column_beyond, std::int64_t row_beyond,
                            Place from, Place to) {
      if (!is_border || half == 0 || !patches_.is_parted(patch.level, column_beyond, row_beyond))
        return kNoVertex;
      const Place at{from[0] < to[0] ? from[0] + half : from[0],
                     from[1] < to[1] ? from[1] + half : from[1]};
      if (at[0] >= to[0] && at[1] >= to[1]) return kNoVertex; // a narrow cell, which isn't parted
      return shared(
          at, [] { return kNoHeight; }, patch.level - 1);
    };
    const bool is_last_row = j + 2 == own.rows.size(), is_last_column = i + 2 == across;
    const std::uint32_t at_north = middle(j == 0, west, north - 1, {west, north}, {east, north}),
                        at_south = middle(is_last_row, west, south, {west, south}, {east, south}),
                        at_west = middle(i == 0, west - 1, north, {west, north}, {west, south}),
                        at_east = middle(is_last_column, east, north, {east, north}, {east, south});
    add_triangle(nw, sw, se, at_west, at_south);
    add_triangle(se, ne, nw, at_east, at_north);
  }

  // Of a, b, c, where others may be in the middle of ab and bc.
  void add_triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t in_ab,
                    std::uint32_t in_bc) {
    if (a == kNoVertex || b == kNoVertex || c == kNoVertex) return;
    if (in_ab == kNoVertex && in_bc == kNoVertex) {
      put(a, b, c);
    } else if (in_bc == kNoVertex) {
      put(a, in_ab, c);
      put(in_ab, b, c);
    } else if (in_ab == kNoVertex) {
      put(a, b, in_bc);
      put(a, in_bc, c);
    } else {
      put(in_ab, b, in_bc);
      put(a, in_ab, in_bc);
      put(a, in_bc, c);
    }
  }
  void put(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    if (is_turned_) std::swap(b, c);
    out_.tin.triangles.push_back({a, b, c});
  }

  const Patches& patches_;
  const HeightsOfPatches& heights_;
  std::variant<PlaneLattice, EarthLattice> lattice_;
  bool is_turned_;
  Patchwork out_;
  NumbersOfPlaces border_;
  std::vector<std::uint32_t> numbers_; // of a patch's vertices
};

} // namespace

Patchwork patchwork(const Grid& grid, const Patches& patches, const PatchSource& source) {
  const HeightsOfPatches own(patches, source);
  const std::vector<Patch>& all = patches.patches();
  std::vector<Departure> departures(all.size());
  on_all_cores(all.size(),
               [&](std::size_t i) { departures[i] = source.departure(all[i], own[i]); });
  Sewing sewing(grid, patches, own);
  sewing.reserve(all.size());
  for (std::size_t i = 0; i < all.size(); ++i) {
    throw_if_stopped();
    sewing.add(all[i], own[i]);
  }
  Patchwork out = sewing.take();
  out.departures = std::move(departures);
  return out;
}

} // namespace orograph
