// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/mesh/seen_lines.hpp"

#include "dem/mesh/neighbours.hpp"
#include "dem/tin.hpp"

#include <algorithm>

namespace orograph {
namespace {

using Link = std::array<std::uint32_t, 2>; // two points, the lower number first

Link link(std::uint32_t a, std::uint32_t b) {
  return {std::min(a, b), std::max(a, b)};
}

// Edges of faces with different triangles on their sides, each once, in order.
std::vector<Link> seen_links(const PlanArrangement& arrangement,
                             std::span<const std::uint32_t> highest) {
  const auto beside = find_neighbours(arrangement.faces, arrangement.points.size()).of;
  std::vector<Link> links;
  for (std::size_t f = 0; f < arrangement.faces.size(); ++f)
    for (std::uint32_t k = 0; k < 3; ++k) {
      const std::uint32_t other = beside[f][k];
      if (highest[f] == (other == kNoTriangle ? kNoTriangle : highest[other])) continue;
      const auto [a, b] = ends_of(arrangement.faces[f], k);
      links.push_back(link(a, b));
    }
  std::sort(links.begin(), links.end());
  links.erase(std::unique(links.begin(), links.end()), links.end());
  return links;
}

} // namespace

std::vector<SeenLine> seen_lines(const PlanArrangement& arrangement,
                                 std::span<const std::uint32_t> highest) {
  const std::vector<Link> links = seen_links(arrangement, highest);
  std::vector<std::uint32_t> links_at(arrangement.points.size());
  for (const Link& l : links)
    for (const std::uint32_t point : l) ++links_at[point];

  std::vector<SeenLine> seen;
  std::vector<bool> on_a_line(links.size(), false);
  for (std::uint32_t i = 0; i < arrangement.lines.size(); ++i) {
    const auto& line = arrangement.lines[i];
    bool runs_on = false;
    for (std::size_t j = 1; j < line.size(); ++j) {
      const Vec2 from = arrangement.points[line[j - 1]], to = arrangement.points[line[j]];
      const Link step = link(line[j - 1], line[j]);
      const auto place = std::lower_bound(links.begin(), links.end(), step);
      const bool is_seen = place != links.end() && *place == step;
      if (is_seen) on_a_line[static_cast<std::size_t>(place - links.begin())] = true;
      if (is_seen && !runs_on) seen.push_back({i, {from}});
      if (is_seen && runs_on && links_at[line[j - 1]] == 2) seen.back().points.pop_back();
      if (is_seen) seen.back().points.push_back(to);
      runs_on = is_seen;
    }
  }
  for (std::size_t i = 0; i < links.size(); ++i)
    if (!on_a_line[i])
      seen.push_back({no_line, {arrangement.points[links[i][0]], arrangement.points[links[i][1]]}});
  return seen;
}

} // namespace orograph
