// SPDX-License-Identifier: GPL-3.0-or-later
#include "hidden_lines/contour_chains.hpp"

#include "geometry/on_all_cores.hpp"
#include "geometry/sort_by_number.hpp"
#include "hidden_lines/line_parts.hpp"

#include <algorithm>
#include <utility>

namespace orograph {
namespace {

// Brings together what strips have seen of the same pieces.
ContourChains chains_of(std::vector<ContourPart> parts) {
  const auto piece = [](const ContourPart& part) { return std::pair(part.from, part.to); };
  std::size_t steps = 0;
  std::sort(parts.begin(), parts.end(), [&](const ContourPart& a, const ContourPart& b) {
    throw_if_stopped(++steps);
    return piece(a) < piece(b);
  });
  std::vector<LinePart> shares; // lines are numbered with the first part of each
  for (std::uint32_t i = 0; i < parts.size(); ++i) {
    const bool is_same = i > 0 && piece(parts[i]) == piece(parts[i - 1]);
    shares.push_back({is_same ? shares.back().line : i, parts[i].t_begin, parts[i].t_end});
  }
  join(shares);
  ContourChains out;
  for (const auto& [line, t_begin, t_end] : shares) {
    const ContourPart& part = parts[line];
    const auto add = [&](double t, bool is_node, ContourNode node) {
      return out.add(is_node ? node : ContourNode::loose(node.level()),
                     point_between(part.at_from, part.at_to, t));
    };
    const std::uint32_t begin = add(t_begin, t_begin <= 0, part.from);
    out.link(begin, add(t_end, t_end >= 1, part.to));
  }
  return out;
}

} // namespace

std::vector<ContourChains::Run> ContourChains::runs() const {
  std::vector<Run> out;
  std::vector<bool> taken(points_.size());
  const auto walk = [&](std::uint32_t first) {
    std::uint32_t last = kNone, here = first;
    do {
      throw_if_stopped(here);
      taken[here] = true;
      const std::uint32_t beyond = next(here, last);
      last = std::exchange(here, beyond);
    } while (here != kNone && here != first);
    out.push_back({first, here == first ? first : last});
  };
  for (std::uint32_t i = 0; i < points_.size(); ++i)
    if (!taken[i] && points_[i].beside[1] == kNone) walk(i);
  for (std::uint32_t i = 0; i < points_.size(); ++i)
    if (!taken[i]) walk(i); // what is left are rings
  return out;
}

SeenContours seen_contours(std::vector<ContourChains> chains, std::vector<ContourPart> parts) {
  SeenContours out;
  out.chains = std::move(chains);
  out.chains.push_back(chains_of(std::move(parts)));
  std::vector<std::vector<ContourChains::Run>> runs(out.chains.size());
  on_all_cores(runs.size(), [&](std::size_t i) { runs[i] = out.chains[i].runs(); });
  for (std::uint32_t i = 0; i < runs.size(); ++i)
    for (const ContourChains::Run& run : runs[i]) out.runs.push_back({i, run});
  sort_by_number(out.runs, [&](const SeenContours::Run& run) { return out.level(run); });
  return out;
}

} // namespace orograph
