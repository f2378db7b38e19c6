// SPDX-License-Identifier: GPL-3.0-or-later
#include "profiles/hollows.hpp"

#include "geometry/on_all_cores.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <unordered_set>
#include <utility>

namespace orograph {
namespace {

class Walk {
public:
  Walk(const PlanTriangles& triangles, std::span<const double> levels)
      : triangles_(triangles), levels_(levels) {}

  // The line through a triangle, if it is closed, around lower ground, and wasn't walked before.
  std::optional<Hollow> hollow(std::uint32_t level, std::uint32_t first) {
    if (!passed_.insert(key(level, first)).second) return std::nullopt;
    Hollow out{level, {}, 0};
    double low_on_left = 0; // above 0, or below it
    std::uint32_t triangle = first, came_from = kNoTriangle;
    for (bool is_first = true;; is_first = false) {
      throw_if_stopped(out.line.size());
      const auto sides = crossed_sides(triangle, level);
      if (!sides) return std::nullopt; // a void
      auto [in, on] = *sides;
      if (!is_first && triangles_.across(triangle, in) != came_from) std::swap(in, on);
      out.line.push_back({point_on(triangle, in, level), triangle});
      const Vec2 from_m = middle_m(triangle, in);
      low_on_left += cross(middle_m(triangle, on) - from_m, low_corner_m(triangle, level) - from_m);
      came_from = triangle;
      triangle = triangles_.across(triangle, on);
      if (triangle == kNoTriangle) return std::nullopt;
      if (triangle == first) break;
      if (!passed_.insert(key(level, triangle)).second) return std::nullopt; // an open one
    }
    out.area_m2 = std::abs(area_of(out, [&](const EdgePoint& at) { return place_m(at); }));
    // Around a ridge whose top is the level a line may go there and back. Through the middles of
    // the edges that it crosses it goes round the same vertices, and well apart from itself.
    const double through_middles = area_of(out, [&](const EdgePoint& at) {
      return place_m({at.edge, 0.5});
    });
    return through_middles * low_on_left > 0 ? std::optional(std::move(out)) : std::nullopt;
  }

private:
  std::uint64_t key(std::uint32_t level, std::uint32_t triangle) const {
    return std::uint64_t{triangle} * levels_.size() + level;
  }
  bool is_above(double value, std::uint32_t level) const { return value >= levels_[level]; }

  // Opposite to which corners the level crosses; none where a vertex is missing. REQUIRES that it
  // crosses the triangle.
  std::optional<std::pair<std::size_t, std::size_t>> crossed_sides(std::uint32_t triangle,
                                                                   std::uint32_t level) const {
    const auto corners = triangles_.corners(triangle);
    std::array<bool, 3> above;
    for (std::size_t k = 0; k < 3; ++k) {
      const double value = triangles_.value(corners[k]);
      if (std::isnan(value)) return std::nullopt;
      above[k] = is_above(value, level);
    }
    // All but the side between the two that are alike.
    const std::size_t alone = above[0] == above[1] ? 2 : above[0] == above[2] ? 1 : 0;
    return std::pair{(alone + 1) % 3, (alone + 2) % 3};
  }
  EdgePoint point_on(std::uint32_t triangle, std::size_t side, std::uint32_t level) const {
    const auto corners = triangles_.corners(triangle);
    const auto [from, to] = std::minmax({corners[(side + 1) % 3], corners[(side + 2) % 3]});
    const double low = triangles_.value(from), high = triangles_.value(to);
    return {{from, to}, (levels_[level] - low) / (high - low)};
  }
  Vec2 place_m(const EdgePoint& at) const {
    const Vec2 from = triangles_.place_m(at.edge.from), to = triangles_.place_m(at.edge.to);
    return from + at.t * (to - from);
  }
  Vec2 low_corner_m(std::uint32_t triangle, std::uint32_t level) const {
    const auto corners = triangles_.corners(triangle);
    return triangles_.place_m(*std::ranges::find_if(
        corners, [&](std::uint32_t vertex) { return !is_above(triangles_.value(vertex), level); }));
  }
  Vec2 middle_m(std::uint32_t triangle, std::size_t side) const {
    const auto corners = triangles_.corners(triangle);
    return 0.5 * (triangles_.place_m(corners[(side + 1) % 3]) +
                  triangles_.place_m(corners[(side + 2) % 3]));
  }
  // Above 0 with the inside on its left.
  template <class PlaceOf>
  static double area_of(const Hollow& hollow, const PlaceOf& place_of) {
    const Vec2 first = place_of(hollow.line.front().at);
    Vec2 last{0, 0};
    double twice = 0;
    for (const Hollow::Crossing& crossing : hollow.line) {
      const Vec2 next = place_of(crossing.at) - first;
      twice += cross(last, next);
      last = next;
    }
    return twice / 2;
  }

  const PlanTriangles& triangles_;
  std::span<const double> levels_;
  std::unordered_set<std::uint64_t> passed_;
};

} // namespace

std::vector<Hollow> hollows(const PlanTriangles& triangles, std::span<const double> levels,
                            std::span<const Isoline> lines) {
  std::vector<Hollow> out;
  Walk walk(triangles, levels);
  for (const Isoline& line : lines)
    if (std::optional<Hollow> hollow = walk.hollow(line.level, line.triangle))
      out.push_back(std::move(*hollow));
  return out;
}

} // namespace orograph
