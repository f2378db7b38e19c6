// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/read/nested_index.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace orograph {
namespace {

// Each block in the order of the file.
template <class Cells, class Act>
void for_blocks(Cells& cells, const Act& act) {
  act(cells.ranges);
  for (auto& departures : cells.departures) act(departures);
  for (auto& heights : cells.heights) std::visit(act, heights);
}

int coarsest_of(int columns, int rows) {
  return coarsest_level(Grid{columns, rows, {}, {}});
}

std::size_t patches_of(int columns, int rows, int level) {
  return static_cast<std::size_t>(patches_along(columns, level)) *
         static_cast<std::size_t>(patches_along(rows, level));
}

std::size_t heights_of(int columns, int rows, int level) {
  return static_cast<std::size_t>(nested_places(columns, level)) *
         static_cast<std::size_t>(nested_places(rows, level));
}

NestedCells empty_cells(int columns, int rows, bool in_float) {
  NestedCells cells{columns, rows, coarsest_of(columns, rows), {}, {}, {}};
  cells.ranges.resize(patches_of(columns, rows, 0));
  for (int level = 1; level <= cells.coarsest; ++level)
    cells.departures.emplace_back(patches_of(columns, rows, level));
  for (int level = kFinestKept; level <= cells.coarsest; ++level) {
    const std::size_t heights = heights_of(columns, rows, level);
    if (in_float)
      cells.heights.emplace_back(std::vector<float>(heights));
    else
      cells.heights.emplace_back(std::vector<double>(heights));
  }
  return cells;
}

bool are_in_order(const std::vector<PartHeights>& ranges) {
  return std::ranges::all_of(ranges, [](const PartHeights& range) {
    return range.empty() || (std::isfinite(range.low_m) && std::isfinite(range.high_m));
  });
}

bool are_in_order(const std::vector<Departure>& departures) {
  return std::ranges::all_of(departures, [](const Departure& departure) {
    return departure.greatest_m >= 0 && departure.rms_m >= 0;
  });
}

template <class Height>
bool are_in_order(const std::vector<Height>& heights) {
  return are_heights(heights);
}

} // namespace

void tell_nested(Teller& told, const NestedCells& cells) {
  for_blocks(cells, [&](const auto& block) { told.put(sum_of(block)); });
}

void write_nested(std::ostream& file, const NestedCells& cells) {
  for_blocks(cells, [&](const auto& block) {
    file.write(reinterpret_cast<const char*>(block.data()),
               static_cast<std::streamsize>(block.size() * sizeof(block[0])));
  });
}

std::vector<std::uint64_t> take_nested(Listener& told, int columns, int rows) {
  const int coarsest = coarsest_of(columns, rows);
  std::vector<std::uint64_t> sums;
  const int blocks = 1 + coarsest + std::max(0, coarsest - kFinestKept + 1);
  for (int i = 0; i < blocks; ++i) sums.push_back(told.take<std::uint64_t>());
  return sums;
}

std::uint64_t bytes_of_nested(int columns, int rows, std::uint32_t bytes_of_height) {
  std::uint64_t bytes = patches_of(columns, rows, 0) * sizeof(PartHeights);
  const int coarsest = coarsest_of(columns, rows);
  for (int level = 1; level <= coarsest; ++level)
    bytes += patches_of(columns, rows, level) * sizeof(Departure);
  for (int level = kFinestKept; level <= coarsest; ++level)
    bytes += heights_of(columns, rows, level) * bytes_of_height;
  return bytes;
}

NestedCells read_nested(std::istream& file, const std::vector<std::uint64_t>& sums, int columns,
                        int rows, std::uint32_t bytes_of_height) {
  NestedCells cells = empty_cells(columns, rows, bytes_of_height == sizeof(float));
  auto sum = sums.begin();
  for_blocks(cells, [&](auto& block) {
    read_block(file, block, *sum++);
    if (!are_in_order(block)) throw Refused{"it is damaged"};
  });
  return cells;
}

} // namespace orograph
