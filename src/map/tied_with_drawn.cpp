// SPDX-License-Identifier: GPL-3.0-or-later
#include "map/tied_with_drawn.hpp"

#include <algorithm>
#include <cmath>

namespace orograph {
namespace {

bool ties_others(LineKind kind) {
  return !is_on_ground(kind) || kind == LineKind::block;
}

} // namespace

std::uint64_t TiedWithDrawn::count(const SeenLines& seen) {
  const View& view = seen.sector.view;
  const auto tied = std::ranges::count_if(places_, [&](const Place& place) {
    const auto& [x, y] = place.at;
    return std::ranges::any_of(seen.visible, [&](const LinePart& part) {
      if (!ties_others(seen.lines.line(part.line).kind)) return false;
      const auto [from, to] = seen.lines.whole(part.line);
      const Vec2 a = project(view, point_between(from, to, part.t_begin)),
                 b = project(view, point_between(from, to, part.t_end));
      if (x < std::min(a.x, b.x) || x > std::max(a.x, b.x)) return false;
      const double at_y = a.x == b.x ? std::clamp(y, std::min(a.y, b.y), std::max(a.y, b.y))
                                     : a.y + (x - a.x) / (b.x - a.x) * (b.y - a.y);
      constexpr double kRounding = 1e-3; // of the tolerance
      return std::abs(at_y - y) <= (1 + kRounding) * place.within_y;
    });
  });
  places_.clear();
  return static_cast<std::uint64_t>(tied);
}

} // namespace orograph
