// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/levels/departure.hpp"

#include "geometry/on_all_cores.hpp"

#include <algorithm>
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
  RowDeparture sum;
  for (std::size_t i = 0; i < across.size(); ++i) {
    const auto cell = static_cast<std::size_t>(across[i].cell);
    const double drawn = height_in_cell(upper[cell], upper[cell + 1], lower[cell], lower[cell + 1],
                                        across[i].share, share);
    const double apart = std::abs(drawn - row[i]);
    if (std::isnan(apart)) continue;
    sum.greatest_m = std::max(sum.greatest_m, apart);
    sum.squares += apart * apart;
    ++sum.count;
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
