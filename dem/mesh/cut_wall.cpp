// SPDX-License-Identifier: GPL-3.0-or-later
// Over each place the wall reaches from a low point to a high one, and so does what is left of it.
// All corners of what is left stand over such places, since the border has a point wherever the
// plane meets it.
#include "dem/mesh/cut_wall.hpp"

#include <algorithm>
#include <optional>
#include <utility>

namespace orograph {
namespace {

struct Column {
  WallPoint low, high;
};

// What is left over one place, of the points there, the lowest first.
std::optional<Column> left_over(const HalfSpace& space, std::vector<WallPoint> points,
                                const std::function<std::uint32_t(const Vec3&)>& new_vertex) {
  const WallPoint low = points.front(), high = points.back();
  const bool has_cut =
      std::any_of(points.begin(), points.end(), [](const WallPoint& p) { return p.side == 0; });
  if (low.side * high.side < 0 && !has_cut) {
    const double at_low = beyond(space, low.at_m), at_high = beyond(space, high.at_m);
    const double share = std::clamp(at_low / (at_low - at_high), 0.0, 1.0);
    const Vec3 at{low.at_m.x, low.at_m.y, low.at_m.z + share * (high.at_m.z - low.at_m.z)};
    points.push_back({at, 0, 0});
    // Rounded onto an end it is that end.
    if (at == low.at_m)
      points.back().vertex = low.vertex;
    else if (at == high.at_m)
      points.back().vertex = high.vertex;
    else
      points.back().vertex = new_vertex(at);
  }
  std::erase_if(points, [](const WallPoint& p) { return p.side > 0; });
  if (points.empty()) return std::nullopt;
  const auto lower = [](const WallPoint& a, const WallPoint& b) { return a.at_m.z < b.at_m.z; };
  const auto [least, greatest] = std::minmax_element(points.begin(), points.end(), lower);
  return Column{*least, *greatest};
}

bool before(const WallPoint& a, const WallPoint& b) {
  if (a.at_m.x != b.at_m.x) return a.at_m.x < b.at_m.x;
  return a.at_m.y != b.at_m.y ? a.at_m.y < b.at_m.y : a.at_m.z < b.at_m.z;
}

} // namespace

std::vector<std::array<std::uint32_t, 3>>
cut_wall(const HalfSpace& space, std::vector<WallPoint> border, bool turned,
         const std::function<std::uint32_t(const Vec3&)>& new_vertex) {
  const bool in_plane =
      std::all_of(border.begin(), border.end(), [](const WallPoint& p) { return p.side == 0; });
  std::sort(border.begin(), border.end(), before);
  std::vector<std::optional<Column>> columns;
  for (auto begin = border.begin(); begin != border.end();) {
    const auto end = std::find_if(begin, border.end(), [&](const WallPoint& p) {
      return p.at_m.x != begin->at_m.x || p.at_m.y != begin->at_m.y;
    });
    columns.push_back(left_over(space, {begin, end}, new_vertex));
    begin = end;
  }
  std::vector<std::array<std::uint32_t, 3>> triangles;
  const auto add = [&](const WallPoint& a, const WallPoint& b, const WallPoint& c) {
    if (a.vertex == b.vertex || b.vertex == c.vertex || c.vertex == a.vertex) return;
    if (!in_plane && std::min({a.side, b.side, c.side}) == 0) return;
    triangles.push_back(turned ? std::array{a.vertex, c.vertex, b.vertex}
                               : std::array{a.vertex, b.vertex, c.vertex});
  };
  for (std::size_t i = 0; i + 1 < columns.size(); ++i) {
    if (!columns[i] || !columns[i + 1]) continue;
    const Column &here = *columns[i], &next = *columns[i + 1];
    add(here.low, next.low, next.high);
    add(here.low, next.high, here.high);
  }
  return triangles;
}

} // namespace orograph
