// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/levels/departure.hpp"

#include "geometry/on_all_cores.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace orograph {

std::vector<PlaceInLevel> places_in_level(int vertices, int of_level) {
  std::vector<PlaceInLevel> out;
  const double step = (of_level - 1.0) / (vertices - 1);
  for (int i = 0; i < vertices; ++i) {
    const int cell = std::min(static_cast<int>(i * step), of_level - 2);
    out.push_back({cell, i * step - cell});
  }
  return out;
}

template <class Height>
RowDeparture departure_of_row(std::span<const Height> row, std::span<const Height> upper,
                              std::span<const Height> lower, double share,
                              const std::vector<PlaceInLevel>& across) {
  // Cells are looked at one by one, so that the loops over their columns have no branches.
  constexpr std::size_t kMost = 256;
  std::array<double, kMost> apart;
  RowDeparture sum;
  const double y = share;
  // What has no share in it may be missing.
  const auto part = [](double of, double height) { return of == 0 ? 0 : of * height; };
  for (std::size_t first = 0, end = 0; first < across.size(); first = end) {
    const auto cell = static_cast<std::size_t>(across[first].cell);
    const auto in_cell = [&](std::size_t i) {
      return i < across.size() && i - first < kMost && across[i].cell == across[first].cell;
    };
    end = first + 1;
    std::size_t middle = first; // columns before it are in the lower triangle, x <= y
    while (middle < across.size() && in_cell(middle) && across[middle].share <= y) ++middle;
    end = std::max(end, middle);
    while (in_cell(end)) ++end;
    const double nw = upper[cell], ne = upper[cell + 1], sw = lower[cell], se = lower[cell + 1];
    const bool are_there = nw == nw && ne == ne && sw == sw && se == se;
    for (std::size_t i = first; i < middle; ++i) {
      const double x = across[i].share;
      const double drawn = are_there ? (1 - y) * nw + (y - x) * sw + x * se
                                     : part(1 - y, nw) + part(y - x, sw) + part(x, se);
      apart[i - first] = std::abs(drawn - row[i]);
    }
    for (std::size_t i = middle; i < end; ++i) {
      const double x = across[i].share;
      const double drawn = are_there ? (1 - x) * nw + (x - y) * ne + y * se
                                     : part(1 - x, nw) + part(x - y, ne) + part(y, se);
      apart[i - first] = std::abs(drawn - row[i]);
    }
    for (std::size_t i = 0; i < end - first; ++i) {
      const bool is_there = apart[i] == apart[i];
      const double distance = is_there ? apart[i] : 0;
      sum.greatest_m = distance > sum.greatest_m ? distance : sum.greatest_m;
      sum.squares += distance * distance;
      sum.count += is_there ? 1 : 0;
    }
  }
  return sum;
}

Departure departure_of(const std::vector<RowDeparture>& rows) {
  RowDeparture all;
  for (const RowDeparture& row : rows) {
    all.greatest_m = std::max(all.greatest_m, row.greatest_m);
    all.squares += row.squares;
    all.count += row.count;
  }
  Departure departure{.greatest_m = all.greatest_m};
  if (all.count > 0) departure.rms_m = std::sqrt(all.squares / static_cast<double>(all.count));
  return departure;
}

Departure departure_of(const Grid& level, const Grid& grid) {
  const std::vector<PlaceInLevel> across = places_in_level(grid.columns, level.columns),
                                  down = places_in_level(grid.rows, level.rows);
  std::vector<RowDeparture> rows(down.size());
  std::visit(
      [&](const auto& heights) {
        using Heights = std::remove_cvref_t<decltype(heights)>;
        const auto line = [](const Grid& of, const Heights& in, int row) {
          return std::span(in.data() + of.index(0, row), static_cast<std::size_t>(of.columns));
        };
        const auto& of_level = std::get<Heights>(level.heights_m);
        on_all_cores(rows.size(), [&](std::size_t j) {
          const auto [cell, share] = down[j];
          rows[j] = departure_of_row(line(grid, heights, static_cast<int>(j)),
                                     line(level, of_level, cell), line(level, of_level, cell + 1),
                                     share, across);
        });
      },
      grid.heights_m);
  return departure_of(rows);
}

template RowDeparture departure_of_row(std::span<const float>, std::span<const float>,
                                       std::span<const float>, double,
                                       const std::vector<PlaceInLevel>&);
template RowDeparture departure_of_row(std::span<const double>, std::span<const double>,
                                       std::span<const double>, double,
                                       const std::vector<PlaceInLevel>&);

} // namespace orograph
