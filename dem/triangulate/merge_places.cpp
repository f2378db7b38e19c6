// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/triangulate/merge_places.hpp"

#include "dem/triangulate/hilbert_order.hpp"
#include "geometry/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

namespace orograph {
namespace {

// One list of all points: the scattered ones, then those of breaklines, then those of rings.
struct Listed {
  std::vector<Vec3> points_m;
  std::size_t scattered = 0;
};

Listed list_of(const Survey& survey) {
  Listed all{survey.points_m, survey.points_m.size()};
  for (const auto& line : survey.breaklines_m)
    all.points_m.insert(all.points_m.end(), line.begin(), line.end());
  for (const BoundaryRing& ring : survey.boundary)
    if (has_heights(ring))
      all.points_m.insert(all.points_m.end(), ring.points_m.begin(), ring.points_m.end());
  for (Vec3& p : all.points_m) { // -0.0 and 0.0 are one place
    p.x += 0.0;
    p.y += 0.0;
  }
  return all;
}

// Of sorted heights. From the lowest on, so that equal heights keep theirs to the last bit.
double mean(std::span<const double> heights) {
  double above = 0;
  for (const double height : heights) above += height - heights.front();
  return heights.front() + above / static_cast<double>(heights.size());
}

// The height at one place: of lines if there are any, else of points. Both lists get sorted.
double height_of(std::vector<double>& of_points, std::vector<double>& of_lines) {
  std::sort(of_points.begin(), of_points.end());
  std::sort(of_lines.begin(), of_lines.end());
  return mean(of_lines.empty() ? of_points : of_lines);
}

double range_of(const std::vector<double>& a, const std::vector<double>& b) {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const auto* heights : {&a, &b})
    if (!heights->empty()) {
      low = std::min(low, heights->front());
      high = std::max(high, heights->back());
    }
  return high - low;
}

// The next `count` numbers of the list.
std::vector<std::uint32_t> take(const std::vector<std::uint32_t>& numbers, std::size_t& at,
                                std::size_t count) {
  const auto first = numbers.begin() + static_cast<std::ptrdiff_t>(at);
  at += count;
  return {first, first + static_cast<std::ptrdiff_t>(count)};
}

} // namespace

bool has_heights(const BoundaryRing& ring) {
  return std::none_of(ring.points_m.begin(), ring.points_m.end(),
                      [](const Vec3& p) { return std::isnan(p.z); });
}

MergedPlaces merge_places(const Survey& survey) {
  const Listed all = list_of(survey);
  // Triangles are numbered with 32 bits as well, and there are up to two a vertex.
  constexpr std::size_t most = 2'000'000'000;
  if (all.points_m.size() > most)
    throw Error(fmt::format("{} points are too many", all.points_m.size()),
                fmt::format("at most {} can be triangulated; thin them out first", most));

  std::vector<Vec2> places;
  places.reserve(all.points_m.size());
  for (const Vec3& p : all.points_m) places.push_back({p.x, p.y});
  const std::vector<std::uint32_t> order = hilbert_order(places);

  MergedPlaces merged;
  merged.points = all.points_m.size();
  merged.vertices_m.reserve(order.size());
  std::vector<std::uint32_t> vertex_of(order.size());
  std::vector<double> of_points, of_lines;
  for (std::size_t begin = 0, end = 0; begin < order.size(); begin = end) {
    const Vec2 place = places[order[begin]];
    of_points.clear();
    of_lines.clear();
    for (end = begin; end < order.size() && places[order[end]] == place; ++end) {
      (order[end] < all.scattered ? of_points : of_lines).push_back(all.points_m[order[end]].z);
      vertex_of[order[end]] = static_cast<std::uint32_t>(merged.vertices_m.size());
    }
    merged.vertices_m.push_back({place.x, place.y, height_of(of_points, of_lines)});
    merged.greatest_merged_m = std::max(merged.greatest_merged_m, range_of(of_points, of_lines));
  }
  merged.merged = order.size() - merged.vertices_m.size();

  std::size_t at = all.scattered;
  for (const auto& line : survey.breaklines_m)
    merged.breaklines.push_back(take(vertex_of, at, line.size()));
  for (const BoundaryRing& ring : survey.boundary)
    merged.rings.push_back(take(vertex_of, at, has_heights(ring) ? ring.points_m.size() : 0));
  return merged;
}

} // namespace orograph
