// SPDX-License-Identifier: GPL-3.0-or-later
#include "profiles/border_places.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>
#include <variant>

namespace orograph {
namespace {

constexpr int kTile = 32;           // cells
constexpr double kRounding = 1e-12; // far above what places along a direction are rounded by

// Bounds of how far along a direction a tile's sides reach.
std::pair<double, double> along(const BorderPlaces::Tile& tile, const View& view, Vec2 way) {
  const Vec2 half{0.5 * tile.box_m.width(), 0.5 * tile.box_m.height()};
  const Vec2 centre = tile.box_m.centre(), &origin = view.depth_origin_m;
  const double at = dot(centre - origin, way),
               beside = std::abs(half.x * way.x) + std::abs(half.y * way.y) +
                        kRounding * (std::abs(centre.x) + std::abs(centre.y) + half.x + half.y +
                                     std::abs(origin.x) + std::abs(origin.y));
  return {at - beside, at + beside};
}

BorderSides<std::uint32_t> by_depth(const std::vector<BorderPlaces::Tile>& tiles,
                                    const View& view) {
  std::vector<std::uint32_t> numbers(tiles.size());
  std::iota(numbers.begin(), numbers.end(), 0U);
  return {numbers, [&](std::uint32_t number) {
            const auto [nearest, farthest] = along(tiles[number], view, view.forward);
            return BorderSides<std::uint32_t>::Depths{nearest, farthest};
          }};
}

} // namespace

BorderPlaces border_places(const Grid& grid, std::span<const BorderEdge> border) {
  const std::size_t across = static_cast<std::size_t>((grid.columns + kTile - 1) / kTile),
                    count = across * static_cast<std::size_t>((grid.rows + kTile - 1) / kTile);
  const auto tile_of = [&](const GridSide& side) {
    return static_cast<std::size_t>(side.triangle.row / kTile) * across +
           static_cast<std::size_t>(side.triangle.column / kTile);
  };
  std::vector<std::uint32_t> next(count + 1, 0);
  for (const auto& [edge, left] : border) ++next[tile_of(side_of(grid, edge, left)) + 1];
  for (std::size_t i = 0; i < count; ++i) next[i + 1] += next[i];
  BorderPlaces out;
  for (std::size_t i = 0; i < count; ++i) {
    if (next[i] == next[i + 1]) continue;
    const int column = static_cast<int>(i % across) * kTile,
              row = static_cast<int>(i / across) * kTile;
    out.tiles.push_back(
        {column, column + kTile - 1, row, row + kTile - 1, {}, next[i], next[i + 1]});
  }
  out.sides.resize(border.size());
  std::visit(
      [&](const auto& heights) {
        const auto place = [&](CellVertex at) {
          return grid.earth().vertex_m(at.column, at.row,
                                       static_cast<double>(heights[grid.index(at.column, at.row)]));
        };
        for (std::size_t i = 0; i < border.size(); ++i) {
          const GridSide side = side_of(grid, border[i].edge, border[i].left);
          const auto corner = [&](std::size_t k) {
            const auto& [column, row] =
                grid_mesh::kCorners[static_cast<int>(side.triangle.half)][(side.k + k) % 3];
            return place({side.triangle.column + column, side.triangle.row + row});
          };
          out.sides[next[tile_of(side)]++] = {side, static_cast<std::uint32_t>(i), corner(1),
                                              corner(2)};
        }
      },
      grid.heights_m);
  for (BorderPlaces::Tile& tile : out.tiles)
    for (std::uint32_t i = tile.begin; i < tile.end; ++i)
      for (const Vec3& end : {out.sides[i].from_m, out.sides[i].to_m})
        tile.box_m.include({end.x, end.y});
  return out;
}

BorderInView::BorderInView(std::shared_ptr<const BorderPlaces> places, const View& view)
    : places_(std::move(places)), view_(view), nearest_m_(std::numeric_limits<double>::infinity()),
      farthest_m_(-nearest_m_), tiles_(by_depth(places_->tiles, view)) {
  // Those of the tiles' boxes are bounds.
  for (const BorderPlaces::Tile& tile : places_->tiles) {
    const auto [nearest, farthest] = along(tile, view, view.forward);
    if (nearest >= nearest_m_ && farthest <= farthest_m_) continue;
    for (std::uint32_t i = tile.begin; i < tile.end; ++i)
      for (const Vec3& end : {places_->sides[i].from_m, places_->sides[i].to_m}) {
        const double v = to_profile_frame(view, end).v;
        nearest_m_ = std::min(nearest_m_, v);
        farthest_m_ = std::max(farthest_m_, v);
      }
  }
}

void BorderInView::at(double depth_m, const URange& part, const Cells& cells,
                      std::vector<GridSide>& out) const {
  thread_local std::vector<std::pair<std::uint32_t, GridSide>> found; // kept for its memory
  found.clear();
  for (const std::uint32_t number : tiles_.at(depth_m)) {
    const BorderPlaces::Tile& tile = places_->tiles[number];
    const auto [nearest, farthest] = along(tile, view_, view_.forward);
    if (depth_m < nearest || depth_m > farthest) continue;
    const auto [left, right] = along(tile, view_, view_.right);
    const bool has_cells = !cells.empty() && tile.first_column <= cells.last_column &&
                           tile.last_column >= cells.first_column &&
                           tile.first_row <= cells.last_row && tile.last_row >= cells.first_row;
    if (!has_cells && !(right >= part.low_m && left <= part.high_m)) continue;
    for (std::uint32_t i = tile.begin; i < tile.end; ++i) {
      const auto& [side, of_border, from_m, to_m] = places_->sides[i];
      const ProfilePoint from = to_profile_frame(view_, from_m), to = to_profile_frame(view_, to_m);
      if (std::min(from.v, to.v) > depth_m || std::max(from.v, to.v) < depth_m) continue;
      const bool reaches =
          std::max(from.u, to.u) >= part.low_m && std::min(from.u, to.u) <= part.high_m;
      if (reaches || cells.has(side.triangle)) found.emplace_back(of_border, side);
    }
  }
  std::sort(found.begin(), found.end(),
            [](const auto& a, const auto& b) { return a.first < b.first; });
  out.clear();
  for (const auto& [of_border, side] : found) out.push_back(side);
}

} // namespace orograph
