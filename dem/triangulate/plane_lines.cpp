// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/triangulate/plane_lines.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace orograph {
namespace {

// Vertices and what lines say of their heights.
using Told = std::vector<std::pair<std::uint32_t, double>>;

// The vertices of a line between its `begin`th and `end`th get heights evenly between those two's.
void tell_between(const std::vector<std::uint32_t>& line, std::size_t begin, std::size_t end,
                  const std::vector<Vec2>& places, const std::vector<double>& heights_m,
                  Told& told) {
  const Vec2 from = places[line[begin]], along = places[line[end]] - from;
  const double low = heights_m[line[begin]], high = heights_m[line[end]];
  for (std::size_t k = begin + 1; k < end; ++k) {
    if (!std::isnan(heights_m[line[k]])) continue;
    const double share = dot(places[line[k]] - from, along) / dot(along, along);
    told.emplace_back(line[k], low + std::clamp(share, 0.0, 1.0) * (high - low));
  }
}

// Each vertex gets the mean of what was told; from the lowest on, so that equal heights stay equal.
SplitHeights take_means(Told& told, std::vector<double>& heights_m) {
  SplitHeights all;
  std::sort(told.begin(), told.end());
  for (std::size_t begin = 0, end = 0; begin < told.size(); begin = end) {
    const auto [vertex, lowest] = told[begin];
    double above = 0;
    for (end = begin; end < told.size() && told[end].first == vertex; ++end)
      above += told[end].second - lowest;
    heights_m[vertex] = lowest + above / static_cast<double>(end - begin);
    all.greatest_m = std::max(all.greatest_m, told[end - 1].second - lowest);
    ++all.vertices;
  }
  return all;
}

void make_room(const PlaneTriangulation& plane, std::vector<double>& heights_m) {
  heights_m.resize(plane.places().size(), std::numeric_limits<double>::quiet_NaN());
}

} // namespace

void append_edges(std::span<const std::uint32_t> polyline, bool closed, std::vector<Edge>& edges) {
  for (std::size_t k = 0; k < polyline.size(); ++k) {
    if (k + 1 == polyline.size() && !closed) break;
    const Edge edge{polyline[k], polyline[(k + 1) % polyline.size()]};
    if (edge[0] != edge[1]) edges.push_back(edge);
  }
}

std::vector<std::uint32_t> add_lines(PlaneTriangulation& plane, std::span<const Edge> edges) {
  std::vector<std::uint64_t> keys;
  keys.reserve(edges.size());
  for (const Edge& edge : edges) keys.push_back(edge_key(edge[0], edge[1]));
  std::sort(keys.begin(), keys.end());
  keys.erase(std::unique(keys.begin(), keys.end()), keys.end());
  std::vector<std::uint32_t> added, of_edges;
  added.reserve(keys.size());
  of_edges.reserve(edges.size());
  for (const std::uint64_t key : keys)
    added.push_back(plane.add_line(static_cast<std::uint32_t>(key >> 32U),
                                   static_cast<std::uint32_t>(key & 0xffffffffU)));
  for (const Edge& edge : edges)
    of_edges.push_back(
        added[std::lower_bound(keys.begin(), keys.end(), edge_key(edge[0], edge[1])) -
              keys.begin()]);
  return of_edges;
}

SplitHeights add_heights_of_lines(const PlaneTriangulation& plane,
                                  std::span<const std::uint32_t> lines,
                                  std::vector<double>& heights_m) {
  make_room(plane, heights_m);
  std::vector<std::uint32_t> each(lines.begin(), lines.end());
  std::sort(each.begin(), each.end());
  each.erase(std::unique(each.begin(), each.end()), each.end());
  Told told;
  for (const std::uint32_t number : each) {
    const auto line = plane.line(number);
    tell_between(line, 0, line.size() - 1, plane.places(), heights_m, told);
  }
  return take_means(told, heights_m);
}

SplitHeights add_heights_between(const PlaneTriangulation& plane,
                                 std::span<const std::uint32_t> lines,
                                 std::vector<double>& heights_m) {
  make_room(plane, heights_m);
  Told told;
  for (const std::uint32_t number : lines) {
    const auto line = plane.line(number);
    std::size_t known = line.size(); // none yet
    for (std::size_t k = 0; k < line.size(); ++k) {
      if (std::isnan(heights_m[line[k]])) continue;
      if (known < k) tell_between(line, known, k, plane.places(), heights_m, told);
      known = k;
    }
  }
  return take_means(told, heights_m);
}

} // namespace orograph
