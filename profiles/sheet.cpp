// SPDX-License-Identifier: GPL-3.0-or-later
#include "profiles/sheet.hpp"

#include "geometry/error.hpp"
#include "geometry/large_pages.hpp"
#include "geometry/on_all_cores.hpp"
#include "profiles/facing.hpp"
#include "profiles/mesh.hpp"
#include "profiles/slab_lines.hpp"
#include "profiles/surface_edges.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace orograph {
namespace {

constexpr std::size_t kOfTask = std::size_t{1} << 15U;

template <class Take>
void in_tasks(std::size_t count, const Take& take) {
  on_all_cores((count + kOfTask - 1) / kOfTask, [&](std::size_t task) {
    const std::size_t end = std::min(count, (task + 1) * kOfTask);
    take(task, task * kOfTask, end);
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

std::vector<ProfilePoint> vertices_in(const Surface& surface, const View& view) {
  if (const Tin* tin = std::get_if<Tin>(&surface)) {
    std::vector<ProfilePoint> out(tin->vertices_m.size());
    in_tasks(out.size(), [&](std::size_t, std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) out[i] = to_profile_frame(view, tin->vertices_m[i]);
    });
    return out;
  }
  const Grid& grid = std::get<Grid>(surface);
  std::vector<ProfilePoint> out;
  fill_on_large_pages(out, grid.size(), {});
  std::visit(
      [&](const auto& lattice, const auto& heights) {
        in_tasks(out.size(), [&](std::size_t, std::size_t begin, std::size_t end) {
          const auto columns = static_cast<std::size_t>(grid.columns);
          for (std::size_t i = begin, row = begin / columns, at = begin % columns; i < end; ++i) {
            out[i] = to_profile_frame(
                view, lattice.vertex_m(static_cast<int>(at), static_cast<int>(row), heights[i]));
            if (++at == columns) {
              at = 0;
              ++row;
            }
          }
        });
      },
      grid.lattice, grid.heights_m);
  return out;
}

namespace {

// Edges at which the side of the sheet that the eye sees changes.
struct Turns {
  std::vector<SurfaceEdge> ridges, valleys;
};

void add_turn(const Sheet& sheet, const View& view, SurfaceEdge edge, Turns& out) {
  const int side = eye_side(view, sheet.vertices[edge.from], sheet.vertices[edge.to]);
  if (side == 0) return; // straight away from the eye, or towards it
  const auto [left, right] = sheet.triangles.sides_of(edge);
  const bool front_is_up = sheet.is_up[side > 0 ? left : right] != 0;
  (front_is_up ? out.ridges : out.valleys).push_back(edge);
}

// By vertex: of its edges to the east, the south and the south-east.
void add_turns_of_grid(const Sheet& sheet, const Grid& grid, const View& view, std::size_t begin,
                       std::size_t end, Turns& out) {
  const auto columns = static_cast<std::size_t>(grid.columns), cells = columns - 1,
             rows = static_cast<std::size_t>(grid.rows) - 1;
  const auto differ = [&](std::size_t t, std::size_t other) {
    return sheet.is_up[t] != sheet.is_up[other] &&
           sheet.triangles.is_there(static_cast<std::uint32_t>(t)) &&
           sheet.triangles.is_there(static_cast<std::uint32_t>(other));
  };
  for (std::size_t i = begin; i < end; ++i) {
    const std::size_t column = i % columns, row = i / columns;
    if (column == cells || row == rows) continue;
    const std::size_t lower = 2 * (row * cells + column), upper = lower + 1;
    const auto add = [&](std::size_t to) {
      add_turn(sheet, view, {static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(to)}, out);
    };
    if (row > 0 && differ(upper, lower - 2 * cells)) add(i + 1);
    if (column > 0 && differ(lower, lower - 1)) add(i + columns);
    if (differ(lower, upper)) add(i + columns + 1);
  }
}

void add_turns_of_tin(const Sheet& sheet, const View& view, std::size_t begin, std::size_t end,
                      Turns& out) {
  for (std::size_t t = begin; t < end; ++t) {
    const auto number = static_cast<std::uint32_t>(t);
    const auto corners = sheet.triangles.corners(number);
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t other = sheet.triangles.across(number, k);
      if (other == kNoTriangle || other < number || sheet.is_up[other] == sheet.is_up[t]) continue;
      const auto [from, to] = std::minmax({corners[(k + 1) % 3], corners[(k + 2) % 3]});
      add_turn(sheet, view, {from, to}, out);
    }
  }
}

} // namespace

Sheet sheet_of(const Surface& surface, const View& view) {
  if (const Tin* tin = std::get_if<Tin>(&surface); tin && !walls_of(*tin).empty())
    throw UsageError("the underside of a terrain with vertical walls isn't drawn",
                     "leave out `underside`");
  Sheet sheet{SheetTriangles(surface), vertices_in(surface, view), {}, {}, {}};
  const SheetTriangles& triangles = sheet.triangles;
  const std::vector<ProfilePoint>& vertices = sheet.vertices;
  sheet.is_up.resize(triangles.count());
  in_tasks(triangles.count(), [&](std::size_t, std::size_t begin, std::size_t end) {
    for (std::size_t t = begin; t < end; ++t) {
      const auto number = static_cast<std::uint32_t>(t);
      if (!triangles.is_there(number)) continue;
      auto [a, b, c] = triangles.corners(number);
      while (a > b || a > c) { // from the lowest
        const std::uint32_t first = a;
        a = b;
        b = c;
        c = first;
      }
      sheet.is_up[t] = facing_of(view, vertices[a], vertices[b], vertices[c]) == kMayFace ? 1 : 0;
    }
  });
  const Grid* const grid = std::get_if<Grid>(&surface);
  const std::size_t count = grid ? grid->size() : triangles.count();
  std::vector<Turns> of_tasks((count + kOfTask - 1) / kOfTask);
  in_tasks(count, [&](std::size_t task, std::size_t begin, std::size_t end) {
    if (grid)
      add_turns_of_grid(sheet, *grid, view, begin, end, of_tasks[task]);
    else
      add_turns_of_tin(sheet, view, begin, end, of_tasks[task]);
  });
  for (Turns& found : of_tasks) {
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
