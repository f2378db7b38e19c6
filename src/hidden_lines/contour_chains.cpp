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
ContourRuns runs_of(std::vector<ContourPart> parts) {
  const auto piece = [](const ContourPart& part) {
    return std::pair(part.from.node, part.to.node);
  };
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
  ContourRuns out;
  for (const auto& [line, t_begin, t_end] : shares) {
    const auto& [from, to, begin, end] = parts[line];
    const ContourNode loose = ContourNode::loose(from.node.level());
    out.points.push_back(
        {t_begin <= 0 ? from.node : loose, point_between(from.at, to.at, t_begin)});
    out.points.push_back({t_end >= 1 ? to.node : loose, point_between(from.at, to.at, t_end)});
    out.end_run();
  }
  return out;
}

} // namespace

// Of a ring the first point is the last as well.
void ContourChains::walk(std::uint32_t first, std::vector<bool>& taken, ContourRuns& out) const {
  std::uint32_t last = kNone, here = first;
  do {
    taken[here] = true;
    out.points.push_back(points_[here]);
    const Beside& beside = beside_[here];
    last = std::exchange(here, beside[beside[0] == last ? 1 : 0]);
  } while (here != kNone && here != first);
  if (here == first) out.points.push_back(points_[first]);
  out.end_run();
}

void ContourChains::end_runs() {
  throw_if_stopped();
  if (points_.empty()) return;
  ContourRuns& out = runs_.emplace_back();
  out.points.reserve(points_.size());
  std::vector<bool> taken(points_.size());
  for (std::uint32_t i = 0; i < points_.size(); ++i)
    if (!taken[i] && beside_[i][1] == kNone) walk(i, taken, out);
  for (std::uint32_t i = 0; i < points_.size(); ++i)
    if (!taken[i]) walk(i, taken, out); // what is left are rings
  first_ += static_cast<std::uint32_t>(points_.size());
  points_.clear();
  beside_.clear();
}

SeenContours seen_contours(std::vector<ContourRuns> runs, std::vector<ContourPart> parts) {
  SeenContours out;
  out.runs = std::move(runs);
  out.runs.push_back(runs_of(std::move(parts)));
  for (std::uint32_t i = 0; i < out.runs.size(); ++i) {
    throw_if_stopped();
    std::uint32_t begin = 0;
    for (const auto& [end, level] : out.runs[i].runs)
      out.by_level.push_back({i, std::exchange(begin, end), end, level});
  }
  sort_by_number(out.by_level, [](const SeenContours::Run& run) { return run.level; });
  return out;
}

} // namespace orograph
