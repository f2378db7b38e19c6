// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/levels/generalise.hpp"

#include "dem/levels/stretched_lattice.hpp"
#include "geometry/on_all_cores.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace orograph {
namespace {

// A straight ridge bends by as much as the ground around rises and falls; noise by far less. From
// the first share on it counts as one, at the second fully.
constexpr double kSomeRidge = 0.15, kFullRidge = 0.5;
// How far a ridge goes back to the highest ground: all the way would bring its noise back.
constexpr double kAddedBack = 0.8;

// Rows, or columns, of the given grid that a vertex of the new one looks at.
struct Window {
  double middle;             ///< in the given grid's rows or columns
  double reach;              ///< to either side; not beyond the border, lest the ground there tilts
  int first, last;           ///< of the mean
  int first_near, last_near; ///< of the highest and the lowest
};

// As many vertices as cells of about `step` need.
int vertices_for(int vertices, int step) {
  return std::max(2, static_cast<int>(std::lround((vertices - 1.0) / step)) + 1);
}

// About each of some places among so many vertices, rising from the first to the last.
std::vector<Window> windows_about(const std::vector<double>& places, double step, int vertices) {
  std::vector<Window> windows;
  const auto within = [&](double at) {
    return static_cast<int>(std::clamp(at, 0.0, vertices - 1.0));
  };
  for (const double middle : places) {
    const double reach = std::min({step, middle + 1, vertices - middle});
    windows.push_back({middle, reach, within(std::floor(middle - reach) + 1),
                       within(std::ceil(middle + reach) - 1), within(std::ceil(middle - reach / 2)),
                       within(std::floor(middle + reach / 2))});
  }
  return windows;
}

// At even steps from border to border.
std::vector<Window> windows_of(int vertices, int made) {
  const double step = (vertices - 1.0) / (made - 1);
  std::vector<double> places;
  for (int i = 0; i < made; ++i) places.push_back(i == made - 1 ? vertices - 1 : i * step);
  return windows_about(places, step, vertices);
}

// At every `step`th vertex, and at the last one.
std::vector<Window> nested_windows(int vertices, int step) {
  std::vector<double> places;
  for (int at = 0; at < vertices - 1; at += step) places.push_back(at);
  places.push_back(vertices - 1);
  return windows_about(places, step, vertices);
}

double weight(const Window& window, int at) {
  return 1 - std::abs(at - window.middle) / window.reach;
}

struct Made {
  std::vector<double> mean, lowest, highest; ///< NaN where nothing is
};

template <class Height>
Made looked_at(const Grid& grid, const Heights<Height>& heights, const std::vector<Window>& columns,
               const std::vector<Window>& rows) {
  const std::size_t across = columns.size(), count = across * rows.size();
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN(),
                   kInfinity = std::numeric_limits<double>::infinity();
  Made made{std::vector<double>(count, kNone), std::vector<double>(count, kNone),
            std::vector<double>(count, kNone)};
  const auto width = static_cast<std::size_t>(grid.columns);
  on_all_cores(rows.size(), [&](std::size_t j) {
    thread_local std::vector<double> sum, weights, low, high;
    sum.assign(width, 0);
    weights.assign(width, 0);
    low.assign(width, kInfinity);
    high.assign(width, -kInfinity);
    for (int row = rows[j].first; row <= rows[j].last; ++row) {
      const Height* const line = heights.data() + grid.index(0, row);
      const double share = weight(rows[j], row);
      for (std::size_t c = 0; c < width; ++c) {
        const double height = line[c];
        const bool is_there = height == height;
        sum[c] += is_there ? share * height : 0;
        weights[c] += is_there ? share : 0;
      }
      if (row < rows[j].first_near || row > rows[j].last_near) continue;
      for (std::size_t c = 0; c < width; ++c) { // comparisons with NaN are false
        low[c] = line[c] < low[c] ? line[c] : low[c];
        high[c] = line[c] > high[c] ? line[c] : high[c];
      }
    }
    const auto nearest_row = static_cast<int>(std::lround(rows[j].middle));
    for (std::size_t i = 0; i < across; ++i) {
      const auto nearest = static_cast<int>(std::lround(columns[i].middle));
      if (std::isnan(heights[grid.index(nearest, nearest_row)])) continue;
      double total = 0, of_weights = 0;
      for (int c = columns[i].first; c <= columns[i].last; ++c) {
        const double share = weight(columns[i], c);
        total += share * sum[static_cast<std::size_t>(c)];
        of_weights += share * weights[static_cast<std::size_t>(c)];
      }
      const std::size_t at = j * across + i;
      made.mean[at] = total / of_weights;
      const auto near = [&](const std::vector<double>& values) {
        return std::pair(values.begin() + columns[i].first_near,
                         values.begin() + columns[i].last_near + 1);
      };
      const auto lows = near(low), highs = near(high);
      made.lowest[at] = *std::min_element(lows.first, lows.second);
      made.highest[at] = *std::max_element(highs.first, highs.second);
    }
  });
  return made;
}

// Ridges, valley floors and summits where they were.
double with_character(const Made& made, int columns, int rows, int column, int row) {
  const auto index = [&](int c, int r) {
    return static_cast<std::size_t>(r) * static_cast<std::size_t>(columns) +
           static_cast<std::size_t>(c);
  };
  const std::size_t at = index(column, row);
  const double mean = made.mean[at], lowest = made.lowest[at], highest = made.highest[at];
  if (!(highest > lowest)) return mean;
  const auto is_there = [&](int c, int r) {
    return c >= 0 && r >= 0 && c < columns && r < rows && !std::isnan(made.mean[index(c, r)]);
  };
  // By how much it is above what lies on both sides; a slope isn't.
  double bend = 0;
  int ways = 0;
  bool is_summit = true;
  for (const auto& [across, down] : {std::pair{1, 0}, {0, 1}, {1, 1}, {1, -1}}) {
    bool is_between = true;
    double beside = 0;
    for (const int side : {-1, 1}) {
      const int c = column + side * across, r = row + side * down;
      if (!is_there(c, r)) {
        is_between = false;
        continue;
      }
      const std::size_t other = index(c, r);
      beside += made.mean[other];
      is_summit = is_summit && made.highest[other] <= highest &&
                  (made.mean[other] < mean || (made.mean[other] == mean && at < other));
    }
    if (!is_between) continue;
    bend += mean - 0.5 * beside;
    ++ways;
  }
  if (ways == 0) return mean;
  if (is_summit) return highest;
  bend /= ways * (highest - lowest);
  const double share =
      kAddedBack * std::clamp((std::abs(bend) - kSomeRidge) / (kFullRidge - kSomeRidge), 0.0, 1.0);
  return mean + share * ((bend > 0 ? highest : lowest) - mean);
}

template <class Height, class Is>
void generalise(const Grid& grid, const Heights<Height>& heights, const std::vector<Window>& across,
                const std::vector<Window>& down, const Is& is_kept, std::vector<Height>& out) {
  const Made made = looked_at(grid, heights, across, down);
  const auto columns = static_cast<int>(across.size()), rows = static_cast<int>(down.size());
  out.resize(across.size() * down.size());
  on_all_cores(down.size(), [&](std::size_t j) {
    const auto nearest_row = static_cast<int>(std::lround(down[j].middle));
    for (int column = 0; column < columns; ++column) {
      const auto i = static_cast<std::size_t>(column);
      const auto nearest = static_cast<int>(std::lround(across[i].middle));
      out[j * across.size() + i] = is_kept(nearest, nearest_row)
                                       ? heights[grid.index(nearest, nearest_row)]
                                       : static_cast<Height>(with_character(
                                             made, columns, rows, column, static_cast<int>(j)));
    }
  });
}

} // namespace

Grid generalised(const Grid& grid, int step, const std::function<bool(int, int)>& is_kept) {
  const int columns = vertices_for(grid.columns, step), rows = vertices_for(grid.rows, step);
  Grid out{columns, rows, stretched_lattice(grid, columns, rows), {}};
  std::visit(
      [&]<class Height>(const Heights<Height>& heights) {
        std::vector<Height> lower;
        generalise(grid, heights, windows_of(grid.columns, columns), windows_of(grid.rows, rows),
                   is_kept, lower);
        out.heights_m = Heights<Height>(std::move(lower));
      },
      grid.heights_m);
  return out;
}

NestedHeights nested_heights(const Grid& grid, int step,
                             const std::function<bool(int, int)>& is_kept) {
  NestedHeights out;
  const std::vector<Window> across = nested_windows(grid.columns, step);
  out.columns = across.size();
  std::visit(
      [&]<class Height>(const Heights<Height>& heights) {
        std::vector<Height> lower;
        generalise(grid, heights, across, nested_windows(grid.rows, step), is_kept, lower);
        out.heights_m.assign(lower.begin(), lower.end());
      },
      grid.heights_m);
  return out;
}

} // namespace orograph
