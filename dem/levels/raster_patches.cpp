// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/levels/raster_patches.hpp"

#include "dem/levels/generalise.hpp"
#include "dem/levels/nested_cells.hpp"
#include "dem/levels/stretched_lattice.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <set>
#include <utility>
#include <variant>
#include <vector>

namespace orograph {
namespace {

// Of the larger cells; 4 where they are 16 times as large.
int level_of(const LargerCells& read) {
  return std::countr_zero(static_cast<unsigned>(read.step));
}

using PlaceOfPart = std::pair<int, int>; // row and column of its first vertex

// That a patch of smaller cells lies in.
GridPart part_under(const LargerCells& read, const Patch& patch) {
  const int side = kPatchCells * read.step;
  const auto range = [&](std::int64_t number, int vertices) {
    const auto from = static_cast<int>(number >> (level_of(read) - patch.level)) * side;
    const int first = std::max(0, from - read.step),
              end = std::min(vertices, from + side + read.step + 1);
    return std::pair(first, end - first);
  };
  const auto [first_column, columns] = range(patch.column, read.columns);
  const auto [first_row, rows] = range(patch.row, read.rows);
  return {first_column, first_row, columns, rows};
}

PlaceOfPart place_of(const GridPart& part) {
  return {part.first_row, part.first_column};
}

const RasterPart& found_part(const LargerCells& read, const Patch& patch) {
  return *std::ranges::lower_bound(read.parts, place_of(part_under(read, patch)), {},
                                   [](const RasterPart& part) { return place_of(part.at); });
}

// As the raster's other parts aren't looked at, this is all that tells a lake.
bool is_level_around(const Grid& cells, int column, int row) {
  const double height = cells.height_m(column, row);
  for (int r = std::max(0, row - 1); r <= std::min(cells.rows - 1, row + 1); ++r)
    for (int c = std::max(0, column - 1); c <= std::min(cells.columns - 1, column + 1); ++c)
      if (cells.height_m(c, r) != height) return false;
  return true;
}

std::vector<double> own_heights(const RasterPart& part, const PatchHeights& lattice) {
  std::vector<double> out;
  out.reserve(lattice.columns.size() * lattice.rows.size());
  for (const std::int64_t row : lattice.rows)
    for (const std::int64_t column : lattice.columns)
      out.push_back(part.cells.height_m(static_cast<int>(column) - part.at.first_column,
                                        static_cast<int>(row) - part.at.first_row));
  return out;
}

std::vector<double> heights_in_part(const RasterPart& part, const Patch& patch,
                                    const PatchHeights& lattice) {
  const Grid& cells = part.cells;
  if (patch.level == 0) return own_heights(part, lattice);
  const int step = 1 << patch.level;
  const auto first = [&](std::int64_t place, int of_part) {
    return static_cast<std::size_t>((static_cast<int>(place) - of_part) / step);
  };
  return nested_heights(cells, step,
                        {first(lattice.columns.front(), part.at.first_column),
                         first(lattice.rows.front(), part.at.first_row), lattice.columns.size(),
                         lattice.rows.size()},
                        [&](int column, int row) { return is_level_around(cells, column, row); });
}

// Of so many vertices of the larger cells, which are between the same borders as the raster's.
struct Axis {
  int larger, raster;

  double to_larger() const { return (larger - 1.0) / (raster - 1); }
  // Of places in the raster, and the level's beside them.
  std::vector<double> with_those_beside(const std::vector<std::int64_t>& places,
                                        std::int64_t cell) const {
    std::vector<double> out;
    const auto add = [&](std::int64_t place) {
      out.push_back(std::min(static_cast<double>(place) * to_larger(), larger - 1.0));
    };
    if (places.front() > 0) add(places.front() - cell);
    for (const std::int64_t place : places) add(place);
    if (places.back() < raster - 1) add(std::min<std::int64_t>(places.back() + cell, raster - 1));
    return out;
  }
};

std::vector<double> heights_in_larger(const Grid& larger, const LargerCells& read,
                                      const Patches& patches, const Patch& patch,
                                      const PatchHeights& lattice,
                                      const std::function<bool(int, int)>& is_kept) {
  const std::int64_t cell = patches.cell(patch.level);
  const LevelPlaces places{
      Axis{larger.columns, read.columns}.with_those_beside(lattice.columns, cell),
      Axis{larger.rows, read.rows}.with_those_beside(lattice.rows, cell),
      static_cast<double>(cell) / read.step};
  return heights_about(larger, places,
                       {lattice.columns.front() > 0 ? 1U : 0U, lattice.rows.front() > 0 ? 1U : 0U,
                        lattice.columns.size(), lattice.rows.size()},
                       is_kept);
}

// Where nobody looks, the nearest vertices' do: to generalise a raster of 20,000 x 20,000 beside
// the page took 15 ms.
std::vector<double> nearest_heights(const Grid& larger, const LargerCells& read,
                                    const PatchHeights& lattice) {
  const auto nearest = [](const Axis& axis, std::int64_t place) {
    return static_cast<int>(std::lround(static_cast<double>(place) * axis.to_larger()));
  };
  std::vector<double> out;
  out.reserve(lattice.columns.size() * lattice.rows.size());
  for (const std::int64_t row : lattice.rows)
    for (const std::int64_t column : lattice.columns)
      out.push_back(larger.height_m(nearest({larger.columns, read.columns}, column),
                                    nearest({larger.rows, read.rows}, row)));
  return out;
}

// Each once, under patches of levels below one.
std::vector<GridPart> parts_under(const LargerCells& read, const Patches& patches, int level) {
  std::vector<GridPart> parts;
  std::set<PlaceOfPart> known;
  for (const Patch& patch : patches.patches())
    if (patch.level < level)
      if (const GridPart part = part_under(read, patch); known.insert(place_of(part)).second)
        parts.push_back(part);
  std::ranges::sort(parts, {}, place_of);
  return parts;
}

// In a patch, of a vertex of the larger cells: between which two of its rows, or columns.
struct PlaceInPatch {
  std::size_t cell;
  double share;
};
PlaceInPatch place_in_patch(const std::vector<std::int64_t>& places, double at) {
  const auto next = std::upper_bound(
      places.begin() + 1, places.end() - 1, at,
      [](double value, std::int64_t place) { return value < static_cast<double>(place); });
  const auto from = static_cast<double>(next[-1]), to = static_cast<double>(*next);
  return {static_cast<std::size_t>(next - places.begin()) - 1, (at - from) / (to - from)};
}

Departure departure_from_larger(const Grid& larger, const LargerCells& read,
                                const PatchHeights& own) {
  const Axis across{larger.columns, read.columns}, down{larger.rows, read.rows};
  const auto range = [](const Axis& axis, const std::vector<std::int64_t>& places) {
    return std::pair(
        static_cast<int>(std::ceil(static_cast<double>(places.front()) * axis.to_larger())),
        static_cast<int>(std::floor(static_cast<double>(places.back()) * axis.to_larger())));
  };
  const auto [first_column, last_column] = range(across, own.columns);
  const auto [first_row, last_row] = range(down, own.rows);
  SumOfDepartures sum;
  for (int row = first_row; row <= last_row; ++row) {
    const auto [j, y] = place_in_patch(own.rows, row / down.to_larger());
    for (int column = first_column; column <= last_column; ++column) {
      const auto [i, x] = place_in_patch(own.columns, column / across.to_larger());
      sum.add(height_in_cell(own, i, j, x, y) - larger.height_m(column, row));
    }
  }
  Departure out = sum.take();
  out.greatest_m += read.departure.greatest_m;
  out.rms_m += read.departure.rms_m;
  return out;
}

} // namespace

Grid lattice_of_raster(const Grid& larger, const LargerCells& read) {
  return {read.columns, read.rows, stretched_lattice(larger, read.columns, read.rows), {}};
}

std::vector<GridPart> parts_under(const LargerCells& read, const Patches& patches) {
  return parts_under(read, patches, level_of(read));
}

std::vector<GridPart> parts_under_finest(const LargerCells& read, const Patches& patches) {
  return parts_under(read, patches, kFinestKept);
}

Grid own_cells_in(const GridPart& window, const Grid& raster, const LargerCells& read) {
  Grid out{window.columns, window.rows, lattice_of_part(raster, window), {}};
  std::vector<float> heights_m(out.size(), std::numeric_limits<float>::quiet_NaN());
  for (const RasterPart& part : read.parts) {
    const int first_column = std::max(window.first_column, part.at.first_column),
              end_column = std::min(window.first_column + window.columns,
                                    part.at.first_column + part.at.columns),
              first_row = std::max(window.first_row, part.at.first_row),
              end_row = std::min(window.first_row + window.rows, part.at.first_row + part.at.rows);
    std::visit(
        [&](const auto& of_part) {
          for (int row = first_row; row < end_row; ++row)
            for (int column = first_column; column < end_column; ++column)
              heights_m[out.index(column - window.first_column, row - window.first_row)] =
                  static_cast<float>(of_part[part.cells.index(column - part.at.first_column,
                                                              row - part.at.first_row)]);
        },
        part.cells.heights_m);
  }
  out.heights_m = Heights<float>(std::move(heights_m));
  return out;
}

PatchSource nested_patches(const LargerCells& read) {
  return {[&](const Patch& patch, const PatchHeights& lattice) {
            return patch.level < kFinestKept ? own_heights(found_part(read, patch), lattice)
                                             : read.nested->heights_m(patch.level, lattice);
          },
          [&](const Patch& patch, const PatchHeights&) {
            return patch.level == 0 ? Departure{}
                                    : read.nested->departure(patch.level, patch.column, patch.row);
          }};
}

PatchSource patches_of_raster(const Grid& larger, const LargerCells& read, const Patches& patches,
                              std::function<bool(int, int)> is_kept) {
  return {[&, is_kept = std::move(is_kept)](const Patch& patch, const PatchHeights& lattice) {
            if (patch.level < level_of(read))
              return heights_in_part(found_part(read, patch), patch, lattice);
            if (patch.level > kCoarsestShown) return nearest_heights(larger, read, lattice);
            return heights_in_larger(larger, read, patches, patch, lattice, is_kept);
          },
          [&](const Patch& patch, const PatchHeights& own) {
            if (patch.level >= level_of(read)) return departure_from_larger(larger, read, own);
            const RasterPart& part = found_part(read, patch);
            return patch.level == 0 ? Departure{}
                                    : departure_of_patch(part.cells, part.at.first_column,
                                                         part.at.first_row, patches, own);
          }};
}

} // namespace orograph
