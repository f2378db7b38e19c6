// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/levels/departure.hpp"

#include "geometry/on_all_cores.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace orograph {
namespace {

// Where a vertex of the file is in the level: in which cell, and how far into it.
struct InCell {
  int cell;
  double share;
};

std::vector<InCell> in_cells(int vertices, int of_level) {
  std::vector<InCell> out;
  const double step = (of_level - 1.0) / (vertices - 1);
  for (int i = 0; i < vertices; ++i) {
    const int cell = std::min(static_cast<int>(i * step), of_level - 2);
    out.push_back({cell, i * step - cell});
  }
  return out;
}

struct OfRow {
  double greatest_m = 0, squares = 0;
  std::uint64_t count = 0;
};

} // namespace

Departure departure_of(const Grid& level, const Grid& grid) {
  const std::vector<InCell> across = in_cells(grid.columns, level.columns),
                            down = in_cells(grid.rows, level.rows);
  std::vector<OfRow> rows(down.size());
  std::visit(
      [&](const auto& heights) {
        using Heights = std::remove_cvref_t<decltype(heights)>;
        const auto& of_level = std::get<Heights>(level.heights_m);
        on_all_cores(rows.size(), [&](std::size_t j) {
          OfRow& sum = rows[j];
          const auto upper = of_level.data() + level.index(0, down[j].cell);
          const auto lower = upper + level.columns;
          const double y = down[j].share;
          const auto row = heights.data() + grid.index(0, static_cast<int>(j));
          for (std::size_t i = 0; i < across.size(); ++i) {
            const auto [cell, x] = across[i];
            // What has no share in it may be missing.
            const auto part = [](double share, double height) {
              return share == 0 ? 0 : share * height;
            };
            const double drawn = x > y ? part(1 - x, upper[cell]) + part(x - y, upper[cell + 1]) +
                                             part(y, lower[cell + 1])
                                       : part(1 - y, upper[cell]) + part(y - x, lower[cell]) +
                                             part(x, lower[cell + 1]);
            const double apart = std::abs(drawn - row[i]);
            if (std::isnan(apart)) continue;
            sum.greatest_m = std::max(sum.greatest_m, apart);
            sum.squares += apart * apart;
            ++sum.count;
          }
        });
      },
      grid.heights_m);
  Departure departure;
  OfRow all;
  for (const OfRow& row : rows) {
    all.greatest_m = std::max(all.greatest_m, row.greatest_m);
    all.squares += row.squares;
    all.count += row.count;
  }
  departure.greatest_m = all.greatest_m;
  if (all.count > 0) departure.rms_m = std::sqrt(all.squares / static_cast<double>(all.count));
  return departure;
}

} // namespace orograph
