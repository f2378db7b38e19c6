// SPDX-License-Identifier: GPL-3.0-or-later
#include "profiles/sheet.hpp"

#include "geometry/error.hpp"
#include "geometry/on_all_cores.hpp"
#include "profiles/earth_row_facing.hpp"
#include "profiles/facing.hpp"
#include "profiles/mesh.hpp"
#include "profiles/row_facing.hpp"
#include "profiles/sheet_vertices.hpp"
#include "profiles/surface_edges.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace orograph {
namespace {

constexpr std::size_t kVerticesOfTask = std::size_t{1} << 15U;

template <class Take>
void in_tasks(std::size_t count, const Take& take) {
  on_all_cores((count + kVerticesOfTask - 1) / kVerticesOfTask, [&](std::size_t task) {
    const std::size_t end = std::min(count, (task + 1) * kVerticesOfTask);
    take(task, task * kVerticesOfTask, end);
  });
}

} // namespace

SheetTriangles::SheetTriangles(const Surface& surface)
    : surface_(&surface), grid_(std::get_if<Grid>(&surface)) {
  if (grid_) {
    is_mirrored_ = !grid_->is_on_earth() && grid_->plane().is_mirrored();
    count_ = grid_triangle_count(*grid_);
    there_.resize(count_);
    std::visit(
        [&](const auto& heights) {
          const auto columns = static_cast<std::size_t>(grid_->columns), cells = columns - 1;
          const auto is_nan = [&](std::size_t vertex) {
            return std::isnan(static_cast<double>(heights[vertex]));
          };
          in_tasks(count_ / 2, [&](std::size_t, std::size_t begin, std::size_t end) {
            for (std::size_t cell = begin; cell < end; ++cell) {
              const std::size_t first = cell + cell / cells, below = first + columns;
              const bool is_diagonal = !is_nan(first) && !is_nan(below + 1);
              there_[2 * cell] = is_diagonal && !is_nan(below);
              there_[2 * cell + 1] = is_diagonal && !is_nan(first + 1);
            }
          });
        },
        grid_->heights_m);
    if (std::ranges::all_of(there_, [](std::uint8_t there) { return there != 0; })) there_.clear();
    return;
  }
  const Tin& tin = std::get<Tin>(surface);
  count_ = tin.triangles.size();
  for_each_edge(tin, [&](const TinEdge& of) { edges_.push_back({of.edge, {of.left, of.right}}); });
  std::ranges::sort(edges_, {}, &TinSides::edge);
}

std::uint32_t SheetTriangles::if_there(int column, int row, Half half) const {
  if (column < 0 || row < 0 || column + 1 >= grid_->columns || row + 1 >= grid_->rows)
    return kNoTriangle;
  const auto t = static_cast<std::uint32_t>(grid_triangle(*grid_, column, row, half));
  return is_there(t) ? t : kNoTriangle;
}

std::uint32_t SheetTriangles::across(std::uint32_t t, std::size_t k) const {
  if (!grid_) return std::get<Tin>(*surface_).neighbours[t][k];
  const auto cells = static_cast<std::uint32_t>(grid_->columns - 1);
  const std::size_t of_lattice = is_mirrored_ && k > 0 ? 3 - k : k;
  const auto& [cell, corner] = grid_mesh::kBeyond[t % 2][of_lattice];
  return if_there(static_cast<int>(t / 2 % cells) + cell.column,
                  static_cast<int>(t / 2 / cells) + cell.row,
                  t % 2 == 0 ? Half::upper : Half::lower);
}

SheetTriangles::Sides SheetTriangles::sides_of(SurfaceEdge edge) const {
  if (!grid_) {
    const auto found = std::ranges::lower_bound(edges_, edge, {}, &TinSides::edge);
    return found->sides;
  }
  const auto side = [&](bool left) {
    const auto& [column, row, half] = side_of(*grid_, edge, left).triangle;
    return if_there(column, row, half);
  };
  return {side(!is_mirrored_), side(is_mirrored_)};
}

namespace {

// Edges at which the side of the sheet that the eye sees changes.
struct TurnsOfSheet {
  std::vector<SurfaceEdge> ridges, valleys;
};

class FindTurns {
public:
  FindTurns(const Sheet& sheet, const Surface& surface, const View& view)
      : sheet_(sheet), view_(view), vertices_(surface, view) {}

  // Of the vertices of some rows: of each its edges to the east, the south and the south-east.
  void in_rows(const Grid& grid, std::size_t begin, std::size_t end, TurnsOfSheet& out) const {
    const auto columns = static_cast<std::size_t>(grid.columns), cells = columns - 1;
    for (std::size_t row = begin; row < end; ++row) {
      const std::uint8_t* const is_up = &sheet_.is_up[2 * row * cells];
      const std::uint8_t* const north = row > 0 ? is_up - 2 * cells : nullptr;
      for (std::size_t c = 0; c < cells; ++c) {
        const std::size_t lower = 2 * c, upper = lower + 1;
        const bool at_north = north && north[lower] != is_up[upper],
                   at_west = c > 0 && is_up[lower - 1] != is_up[lower],
                   at_diagonal = is_up[lower] != is_up[upper];
        if (!at_north && !at_west && !at_diagonal) continue;
        const std::size_t first = 2 * row * cells, vertex = row * columns + c;
        const auto add = [&](std::size_t t, std::size_t other, std::size_t to) {
          if (is_there(t) && is_there(other))
            add_turn({static_cast<std::uint32_t>(vertex), static_cast<std::uint32_t>(to)}, out);
        };
        if (at_north) add(first + upper, first + lower - 2 * cells, vertex + 1);
        if (at_west) add(first + lower, first + lower - 1, vertex + columns);
        if (at_diagonal) add(first + lower, first + upper, vertex + columns + 1);
      }
    }
  }

  void in_triangles(std::size_t begin, std::size_t end, TurnsOfSheet& out) const {
    for (std::size_t t = begin; t < end; ++t) {
      const auto number = static_cast<std::uint32_t>(t);
      const auto corners = sheet_.triangles.corners(number);
      for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t other = sheet_.triangles.across(number, k);
        if (other == kNoTriangle || other < number || sheet_.is_up[other] == sheet_.is_up[t])
          continue;
        const auto [from, to] = std::minmax({corners[(k + 1) % 3], corners[(k + 2) % 3]});
        add_turn({from, to}, out);
      }
    }
  }

private:
  bool is_there(std::size_t t) const {
    return sheet_.triangles.is_there(static_cast<std::uint32_t>(t));
  }
  void add_turn(SurfaceEdge edge, TurnsOfSheet& out) const {
    const int side = eye_side(view_, vertices_[edge.from], vertices_[edge.to]);
    if (side == 0) return; // straight away from the eye, or towards it
    const auto [left, right] = sheet_.triangles.sides_of(edge);
    const bool front_is_up = sheet_.is_up[side > 0 ? left : right] != 0;
    (front_is_up ? out.ridges : out.valleys).push_back(edge);
  }

  const Sheet& sheet_;
  const View& view_;
  SheetVertices vertices_;
};

// Calls take(task, first, end) on all cores with the rows of cells of each task.
constexpr std::size_t kCellRowsOfTask = 64;
std::size_t task_count(const Grid& grid) {
  return (static_cast<std::size_t>(grid.rows) - 1 + kCellRowsOfTask - 1) / kCellRowsOfTask;
}
template <class Take>
void in_rows_of_tasks(const Grid& grid, const Take& take) {
  const auto rows = static_cast<std::size_t>(grid.rows) - 1;
  on_all_cores(task_count(grid), [&](std::size_t task) {
    take(task, task * kCellRowsOfTask, std::min(rows, (task + 1) * kCellRowsOfTask));
  });
}

template <class RowFacing>
void reckon_rows(RowFacing facing, std::size_t first, std::size_t end,
                 std::vector<std::uint8_t>& is_up) {
  const std::size_t cells = facing.lower.size();
  for (std::size_t row = first; row < end; ++row) {
    facing.reckon(static_cast<int>(row), 0, static_cast<int>(cells));
    std::uint8_t* out = &is_up[2 * row * cells];
    for (std::size_t c = 0; c < cells; ++c) {
      out[2 * c] = facing.lower[c] == kMayFace ? 1 : 0;
      out[2 * c + 1] = facing.upper[c] == kMayFace ? 1 : 0;
    }
  }
}

// Of triangles that aren't there no.
void find_facing(const Grid& grid, const View& view, std::vector<std::uint8_t>& is_up) {
  in_rows_of_tasks(grid, [&](std::size_t, std::size_t first, std::size_t end) {
    std::visit(
        [&](const auto& heights) {
          if (grid.is_on_earth())
            reckon_rows(EarthRowFacing(grid, heights, view), first, end, is_up);
          else
            reckon_rows(PlaneRowFacing(grid, heights, view), first, end, is_up);
        },
        grid.heights_m);
  });
}

void find_facing(const Surface& surface, const SheetTriangles& triangles, const View& view,
                 std::vector<std::uint8_t>& is_up) {
  const SheetVertices vertices(surface, view);
  in_tasks(is_up.size(), [&](std::size_t, std::size_t begin, std::size_t end) {
    for (std::size_t t = begin; t < end; ++t) {
      auto [a, b, c] = triangles.corners(static_cast<std::uint32_t>(t));
      while (a > b || a > c) { // from the lowest
        const std::uint32_t first = a;
        a = b;
        b = c;
        c = first;
      }
      is_up[t] = facing_of(view, vertices[a], vertices[b], vertices[c]) == kMayFace ? 1 : 0;
    }
  });
}

} // namespace

namespace {

// Whether a wall lacks a neighbour but beside an upright side of it, or ground ends at one place at
// two heights without a wall between them: then one sees through between pieces that have no order.
bool has_cracks(const Tin& tin, const TriangleSet& walls) {
  using At = std::array<double, 2>;
  std::vector<std::array<At, 2>> ends; // of ground, seen from above
  bool is_free = false;
  for_each_edge(tin, [&](const TinEdge& of) {
    if (of.left != kNoTriangle && of.right != kNoTriangle) return;
    const Vec3 &a = tin.vertices_m[of.edge.from], &b = tin.vertices_m[of.edge.to];
    const auto [from, to] = std::minmax({At{a.x, a.y}, At{b.x, b.y}});
    if (from == to) return;
    is_free = is_free || walls.has(of.left != kNoTriangle ? of.left : of.right);
    ends.push_back({from, to});
  });
  std::ranges::sort(ends);
  return is_free || std::ranges::adjacent_find(ends) != ends.end();
}

} // namespace

Sheet sheet_of(const Surface& surface, const View& view) {
  Sheet sheet{SheetTriangles(surface), {}, {}, {}, {}};
  if (const Tin* tin = std::get_if<Tin>(&surface)) {
    sheet.walls = walls_of(*tin);
    if (!sheet.walls.empty() && has_cracks(*tin, sheet.walls))
      throw UsageError("the underside of a terrain whose vertical walls have gaps isn't drawn",
                       "close the walls, or leave out `underside`");
  }
  sheet.is_up.resize(sheet.triangles.count());
  const FindTurns turns(sheet, surface, view);
  std::vector<TurnsOfSheet> of_tasks;
  const Grid* const grid = std::get_if<Grid>(&surface);
  if (grid) {
    find_facing(*grid, view, sheet.is_up);
    of_tasks.resize(task_count(*grid));
    in_rows_of_tasks(*grid, [&](std::size_t task, std::size_t first, std::size_t end) {
      turns.in_rows(*grid, first, end, of_tasks[task]);
    });
  } else {
    find_facing(surface, sheet.triangles, view, sheet.is_up);
    of_tasks.resize((sheet.is_up.size() + kVerticesOfTask - 1) / kVerticesOfTask);
    in_tasks(sheet.is_up.size(), [&](std::size_t task, std::size_t begin, std::size_t end) {
      turns.in_triangles(begin, end, of_tasks[task]);
    });
  }
  for (TurnsOfSheet& found : of_tasks) {
    throw_if_stopped();
    sheet.ridges.insert(sheet.ridges.end(), found.ridges.begin(), found.ridges.end());
    sheet.valleys.insert(sheet.valleys.end(), found.valleys.begin(), found.valleys.end());
  }
  if (grid) return sheet; // in order already
  std::sort(sheet.ridges.begin(), sheet.ridges.end());
  std::sort(sheet.valleys.begin(), sheet.valleys.end());
  return sheet;
}

} // namespace orograph
