// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/levels/nested_cells.hpp"

namespace orograph {

std::vector<double> NestedCells::heights_m(int level, const PatchHeights& lattice) const {
  std::vector<double> out;
  out.reserve(lattice.columns.size() * lattice.rows.size());
  const auto width = static_cast<std::size_t>(nested_places(columns, level));
  std::visit(
      [&](const auto& values) {
        for (const std::int64_t row : lattice.rows)
          for (const std::int64_t column : lattice.columns)
            out.push_back(values[static_cast<std::size_t>(row >> level) * width +
                                 static_cast<std::size_t>(column >> level)]);
      },
      heights[static_cast<std::size_t>(level - kFinestKept)]);
  return out;
}

} // namespace orograph
