// SPDX-License-Identifier: GPL-3.0-or-later
// One pass over the rows of cells: neighbours are known from the row before and the cell before.
#include "dem/approximate/tin_of_grid.hpp"

#include <algorithm>
#include <utility>

namespace orograph {
namespace {

std::size_t count_of(const CellRow& cells) {
  std::size_t count = 0;
  for (const auto* half : {&cells.lower, &cells.upper})
    for (const unsigned char there : *half) count += there;
  return count;
}

using LeaveOut = std::function<void(int, CellRow&)>;

template <class Value>
void find_left(const Grid& grid, const Heights<Value>& heights, int row, const LeaveOut& leave_out,
               CellRow& cells) {
  find_triangles(grid, heights, row, cells);
  if (leave_out && row + 1 < grid.rows) leave_out(row, cells);
}

template <class Value>
std::size_t triangle_count(const Grid& grid, const Heights<Value>& heights,
                           const LeaveOut& leave_out) {
  CellRow cells(grid.columns);
  std::size_t count = 0;
  for (int row = 0; row + 1 < grid.rows; ++row) {
    find_left(grid, heights, row, leave_out, cells);
    count += count_of(cells);
  }
  return count;
}

using Numbers = std::vector<std::uint32_t>;

// The vertices of a row that a triangle north or south of it uses, and their numbers in the Tin.
template <class Value>
void add_vertices(const Grid& grid, const Heights<Value>& heights, int row, const CellRow& north,
                  const CellRow& south, Tin& tin, Numbers& numbers) {
  for (int c = 0; c < grid.columns; ++c) {
    const auto i = static_cast<std::size_t>(c);
    if (triangles_around(i, north, south) == 0) continue;
    numbers[i] = static_cast<std::uint32_t>(tin.vertices_m.size());
    const double height = heights[grid.index(c, row)];
    tin.vertices_m.push_back(
        std::visit([&](const auto& l) { return l.vertex_m(c, row, height); }, grid.lattice));
  }
}

// Adds the triangles row by row. `turned`: the grid's rows go to the left of its columns, seen from
// above, so that triangles have to run the other way.
class TriangleRows {
public:
  TriangleRows(Tin& tin, int columns, bool turned)
      : tin_(tin), lower_before_(static_cast<std::size_t>(columns), kNoTriangle), turned_(turned) {}

  // The triangles of one row of cells, between the vertices of two rows.
  void add(const CellRow& cells, const Numbers& north, const Numbers& south) {
    std::uint32_t upper_before = kNoTriangle; // of the cell to the west
    for (std::size_t c = 0; c + 1 < north.size(); ++c) {
      std::uint32_t lower = kNoTriangle, upper = kNoTriangle;
      const std::uint32_t northern = lower_before_[c];
      if (cells.lower[c]) {
        lower = add_triangle(north[c], south[c], south[c + 1]);
        join(lower, kWest, upper_before, kEast);
      }
      if (cells.upper[c]) {
        upper = add_triangle(north[c], south[c + 1], north[c + 1]);
        join(upper, kDiagonalOfUpper, lower, kDiagonalOfLower);
        join(upper, kNorth, northern, kSouth);
      }
      lower_before_[c] = lower;
      upper_before = upper;
    }
  }

private:
  // Edges by the corner opposite to them, in the order of add_triangle's arguments.
  static constexpr int kSouth = 0, kDiagonalOfLower = 1, kWest = 2; // of a lower triangle
  static constexpr int kEast = 0, kNorth = 1, kDiagonalOfUpper = 2; // of an upper one

  std::uint32_t add_triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    const auto number = static_cast<std::uint32_t>(tin_.triangles.size());
    if (turned_) std::swap(b, c);
    tin_.triangles.push_back({a, b, c});
    tin_.neighbours.push_back({kNoTriangle, kNoTriangle, kNoTriangle});
    return number;
  }
  void join(std::uint32_t one, int one_corner, std::uint32_t other, int other_corner) {
    if (other == kNoTriangle) return;
    tin_.neighbours[one][stored(one_corner)] = other;
    tin_.neighbours[other][stored(other_corner)] = one;
  }
  std::size_t stored(int corner) const {
    return static_cast<std::size_t>(turned_ && corner > 0 ? 3 - corner : corner);
  }

  Tin& tin_;
  Numbers lower_before_; // by column, of the row of cells to the north
  bool turned_;
};

} // namespace

Tin tin_of(const Grid& grid) {
  return tin_of(grid, {});
}

Tin tin_of(const Grid& grid, const LeaveOut& leave_out) {
  Tin tin;
  if (grid.columns < 2 || grid.rows < 2) return tin;
  std::visit(
      [&](const auto& heights) {
        const std::size_t count = triangle_count(grid, heights, leave_out);
        tin.triangles.reserve(count);
        tin.neighbours.reserve(count);
        tin.vertices_m.reserve(std::min(grid.size(), 3 * count));
        CellRow before(grid.columns), cells(grid.columns);
        Numbers north(static_cast<std::size_t>(grid.columns)), south = north;
        const bool turned = !grid.is_on_earth() && grid.plane().is_mirrored();
        TriangleRows triangles(tin, grid.columns, turned);
        for (int row = 0; row < grid.rows; ++row) {
          find_left(grid, heights, row, leave_out, cells);
          add_vertices(grid, heights, row, before, cells, tin, south);
          if (row > 0) triangles.add(before, north, south);
          std::swap(north, south);
          std::swap(before, cells);
        }
      },
      grid.heights_m);
  return tin;
}

} // namespace orograph
