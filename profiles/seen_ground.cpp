// SPDX-License-Identifier: GPL-3.0-or-later
#include "profiles/seen_ground.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <variant>

namespace orograph {
namespace {

constexpr int kSide = SeenGround::kSide;
// In cells; far above rounding.
constexpr double kBeside = 1e-3;

} // namespace

SeenGround::SeenGround(const Grid& grid)
    : columns(blocks_in(grid.columns - 1)), rows(blocks_in(grid.rows - 1)),
      seen(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows), 1) {}

double SeenGround::share() const {
  const auto count = std::accumulate(seen.begin(), seen.end(), std::size_t{0});
  return static_cast<double>(count) / static_cast<double>(seen.size());
}

void SeenGround::add(const SeenGround& other) {
  for (std::size_t i = 0; i < seen.size(); ++i) seen[i] |= other.seen[i];
}

void SeenGround::cells_in_row(int block_row, int cell_columns,
                              std::vector<std::pair<int, int>>& out) const {
  out.clear();
  const std::uint8_t* const row = &seen[index(0, block_row)];
  for (int c = 0; c < columns; ++c) {
    if (row[c] == 0) continue;
    const int first = c * kSide, end = std::min(first + kSide, cell_columns);
    if (!out.empty() && out.back().second == first)
      out.back().second = end;
    else
      out.emplace_back(first, end);
  }
}

double share_behind_ridges(const Grid& grid, const View& view) {
  constexpr int kAway = 2 * kSide; // cells
  const auto place = [&](int column, int row, double height_m) {
    return to_profile_frame(
        view,
        std::visit([&](const auto& lattice) { return lattice.vertex_m(column, row, height_m); },
                   grid.lattice));
  };
  // Of the eight ways on from the middle vertex the one that is most nearly the ray's.
  const int middle_column = grid.columns / 2, middle_row = grid.rows / 2;
  const ProfilePoint middle = place(middle_column, middle_row, 0);
  const double u_per_m = u_along_ray(view, middle);
  int columns_on = 0, rows_on = 0;
  double most = 0;
  for (int down = -1; down <= 1; ++down)
    for (int across = -1; across <= 1; ++across) {
      const ProfilePoint next = place(middle_column + across, middle_row + down, 0);
      const double du = next.u - middle.u, dv = next.v - middle.v;
      const double along = (du * u_per_m + dv) / std::hypot(du, dv);
      if (!(along > most)) continue;
      most = along;
      columns_on = across * kAway;
      rows_on = down * kAway;
    }
  std::size_t asked = 0, lower = 0;
  for (int row = std::max(0, -rows_on); row < grid.rows - std::max(0, rows_on); row += kAway)
    for (int column = std::max(0, -columns_on); column < grid.columns - std::max(0, columns_on);
         column += kAway) {
      const ProfilePoint near = place(column, row, grid.height_m(column, row)),
                         far = place(column + columns_on, row + rows_on,
                                     grid.height_m(column + columns_on, row + rows_on));
      ++asked;
      lower += project(view, far).y < project(view, near).y ? 1 : 0;
    }
  return asked > 0 ? static_cast<double>(lower) / static_cast<double>(asked) : 0;
}

PlaneOverBlocks::PlaneOverBlocks(const Grid& grid, const View& view) {
  const auto& [first_m, column_step_m, row_step_m] = grid.plane();
  const double v_column = dot(column_step_m, view.forward), v_row = dot(row_step_m, view.forward);
  along_columns_ = std::abs(v_row) >= std::abs(v_column);
  const Vec2 along = along_columns_ ? column_step_m : row_step_m,
             across = along_columns_ ? row_step_m : column_step_m;
  cells_along_ = (along_columns_ ? grid.columns : grid.rows) - 1;
  cells_across_ = (along_columns_ ? grid.rows : grid.columns) - 1;
  const Vec2 first = first_m - view.depth_origin_m;
  first_u_ = dot(first, view.right);
  first_v_ = dot(first, view.forward);
  u_along_ = dot(along, view.right);
  v_along_ = dot(along, view.forward);
  u_across_ = dot(across, view.right);
  v_across_ = dot(across, view.forward);
}

void PlaneOverBlocks::seen_parts(double depth_m, const URange& within, const SeenGround& ground,
                                 std::vector<URange>& out) const {
  out.clear();
  // The plane in cell coordinates: b = b0 + slope * a, where a runs along and b across.
  const double b0 = (depth_m - first_v_) / v_across_, slope = -v_along_ / v_across_;
  const double u0 = first_u_ + b0 * u_across_, u_per_a = u_along_ + slope * u_across_;
  const auto a_at = [&](double u_m) {
    return std::clamp((u_m - u0) / u_per_a, -1.0, cells_along_ + 1.0);
  };
  // In the order of rising u.
  const double low = a_at(within.low_m), high = a_at(within.high_m);
  const int first = static_cast<int>(std::floor(low)), last = static_cast<int>(std::floor(high));
  const int step = u_per_a > 0 ? 1 : -1;
  const int most = SeenGround::blocks_in(cells_along_) - 1,
            most_across = SeenGround::blocks_in(cells_across_) - 1;
  const int begin = std::clamp(first / kSide, 0, most), end = std::clamp(last / kSide, 0, most);
  const auto take = [&](double a, double b) {
    const double from = u0 + u_per_a * a, to = u0 + u_per_a * b;
    const URange part{std::max(std::min(from, to), within.low_m),
                      std::min(std::max(from, to), within.high_m)};
    if (!(part.low_m <= part.high_m)) return;
    if (!out.empty() && part.low_m - out.back().high_m < 2 * kSide * std::abs(u_per_a))
      out.back().high_m = std::max(out.back().high_m, part.high_m);
    else
      out.push_back(part);
  };
  const auto is_seen = [&](int block, int across) {
    const std::size_t i =
        along_columns_ ? ground.index(block, across) : ground.index(across, block);
    return ground.seen[i] != 0;
  };
  // Where the plane passes seen ground alone, as nearly everywhere, blocks are taken together.
  std::optional<std::pair<double, double>> together;
  const auto take_together = [&] {
    if (together) take(together->first - kBeside, together->second + kBeside);
    together.reset();
  };
  for (int block = begin; block != end + step; block += step) {
    const double a_low = block * kSide, a_high = std::min(a_low + kSide, 1.0 * cells_along_);
    const double b_first = b0 + slope * (step > 0 ? a_low : a_high),
                 b_last = b0 + slope * (step > 0 ? a_high : a_low);
    const double b_low = std::min(b_first, b_last), b_high = std::max(b_first, b_last);
    if (b_high < -kBeside || b_low > cells_across_ + kBeside) continue;
    const auto block_at = [&](double b) { // rounded down, but for what is before the first
      return std::clamp(static_cast<int>(b / kSide), 0, most_across);
    };
    const int lowest = block_at(b_low - kBeside), highest = block_at(b_high + kBeside);
    int seen = 0;
    for (int across = lowest; across <= highest; ++across) seen += is_seen(block, across) ? 1 : 0;
    if (seen == highest - lowest + 1) {
      if (!together) together.emplace(a_low, a_high);
      together->first = std::min(together->first, a_low);
      together->second = std::max(together->second, a_high);
      continue;
    }
    take_together();
    for (int i = 0; i <= highest - lowest && seen > 0; ++i) {
      const int across = b_last >= b_first ? lowest + i : highest - i;
      if (!is_seen(block, across)) continue;
      double part_low = a_low, part_high = a_high;
      if (slope != 0 && lowest != highest) { // where b is in the block
        const auto [from, to] =
            std::minmax({(across * kSide - b0) / slope, ((across + 1) * kSide - b0) / slope});
        part_low = std::max(part_low, from);
        part_high = std::min(part_high, to);
      }
      take(part_low - kBeside, part_high + kBeside);
    }
  }
  take_together();
}

} // namespace orograph
