// SPDX-License-Identifier: GPL-3.0-or-later
// Triangles wholly beyond one of the planes are left out first, so that of a large grid only those
// become a Tin that are needed; then that is cut at plane after plane.
#include "dem/mesh/keep_within.hpp"

#include "dem/approximate/tin_of_grid.hpp"
#include "dem/mesh/cut_at_plane.hpp"
#include "geometry/on_all_cores.hpp"

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

namespace orograph {
namespace {

// Which planes a vertex is beyond, a bit each; of the first 32 planes.
using Beyond = std::uint32_t;

Beyond find_beyond(std::span<const HalfSpace> spaces, const Vec3& vertex) {
  Beyond bits = 0;
  for (std::size_t i = 0; i < std::min<std::size_t>(spaces.size(), 32); ++i)
    bits |= static_cast<Beyond>(side_of(spaces[i], vertex) > 0) << i;
  return bits;
}

class RowsBeyond {
public:
  RowsBeyond(const Grid& grid, std::span<const HalfSpace> spaces) : grid_(grid), spaces_(spaces) {}

  // Takes away triangles that have all vertices beyond one plane.
  void leave_out(int row, CellRow& cells) {
    throw_if_stopped();
    find(row, north_, north_row_);
    find(row + 1, south_, south_row_);
    for (std::size_t c = 0; c + 1 < north_.size(); ++c) {
      const Beyond diagonal = north_[c] & south_[c + 1];
      if ((diagonal & south_[c]) != 0) cells.lower[c] = 0;
      if ((diagonal & north_[c + 1]) != 0) cells.upper[c] = 0;
    }
  }

private:
  void find(int row, std::vector<Beyond>& beyond, int& found_row) {
    if (found_row == row) return;
    if (&beyond == &north_ && south_row_ == row) {
      std::swap(north_, south_);
      std::swap(north_row_, south_row_);
      return;
    }
    found_row = row;
    beyond.resize(static_cast<std::size_t>(grid_.columns));
    std::visit(
        [&](const auto& lattice, const auto& heights) {
          for (int c = 0; c < grid_.columns; ++c) {
            const double height = heights[grid_.index(c, row)];
            beyond[static_cast<std::size_t>(c)] =
                find_beyond(spaces_, lattice.vertex_m(c, row, height));
          }
        },
        grid_.lattice, grid_.heights_m);
  }

  const Grid& grid_;
  std::span<const HalfSpace> spaces_;
  std::vector<Beyond> north_, south_;
  int north_row_ = -1, south_row_ = -1;
};

// The triangles that aren't wholly beyond one plane.
Tin leave_out_beyond(const Tin& tin, std::span<const HalfSpace> spaces) {
  std::vector<Beyond> beyond;
  beyond.reserve(tin.vertices_m.size());
  for (const Vec3& vertex : tin.vertices_m) {
    throw_if_stopped(beyond.size());
    beyond.push_back(find_beyond(spaces, vertex));
  }
  Tin left;
  std::vector<std::uint32_t> number(tin.triangles.size(), kNoTriangle),
      vertex_number(tin.vertices_m.size(), kNoTriangle);
  for (std::uint32_t t = 0; t < tin.triangles.size(); ++t) {
    const auto& [a, b, c] = tin.triangles[t];
    if ((beyond[a] & beyond[b] & beyond[c]) != 0) continue;
    number[t] = static_cast<std::uint32_t>(left.triangles.size());
    left.triangles.push_back(tin.triangles[t]);
    left.neighbours.push_back(tin.neighbours[t]);
    for (const std::uint32_t v : tin.triangles[t]) vertex_number[v] = 0;
  }
  for (std::uint32_t v = 0; v < vertex_number.size(); ++v) {
    if (vertex_number[v] == kNoTriangle) continue;
    vertex_number[v] = static_cast<std::uint32_t>(left.vertices_m.size());
    left.vertices_m.push_back(tin.vertices_m[v]);
  }
  for (auto& triangle : left.triangles)
    for (std::uint32_t& v : triangle) v = vertex_number[v];
  for (auto& neighbours : left.neighbours)
    for (std::uint32_t& n : neighbours) n = n == kNoTriangle ? n : number[n];
  return left;
}

Tin cut_at_planes(Tin tin, std::span<const HalfSpace> spaces) {
  for (const HalfSpace& space : spaces) tin = cut_at_plane(tin, space);
  return tin;
}

} // namespace

Tin keep_within(const Grid& grid, std::span<const HalfSpace> spaces) {
  RowsBeyond rows(grid, spaces);
  return cut_at_planes(tin_of(grid, [&](int row, CellRow& cells) { rows.leave_out(row, cells); }),
                       spaces);
}

Tin keep_within(const Tin& tin, std::span<const HalfSpace> spaces) {
  return cut_at_planes(leave_out_beyond(tin, spaces), spaces);
}

Tin keep_within(const Surface& surface, std::span<const HalfSpace> spaces) {
  return std::visit([&](const auto& s) { return keep_within(s, spaces); }, surface);
}

} // namespace orograph
