// SPDX-License-Identifier: GPL-3.0-or-later
#include "naming/choose_names.hpp"

#include <algorithm>
#include <numeric>
#include <tuple>

namespace orograph {
namespace {

// The names by x, and how many of them are far enough to the left of each.
struct Line {
  std::vector<std::size_t> order;
  std::vector<std::size_t> before;
};

Line line_of(std::span<const NameOnLine> names, double pitch_mm) {
  Line out;
  out.order.resize(names.size());
  std::iota(out.order.begin(), out.order.end(), std::size_t{0});
  std::ranges::sort(out.order, [&](std::size_t a, std::size_t b) {
    return std::tie(names[a].x_mm, names[a].weight) < std::tie(names[b].x_mm, names[b].weight);
  });
  for (const std::size_t own : out.order) {
    const auto free = std::ranges::partition_point(out.order, [&](std::size_t other) {
      return names[own].x_mm - names[other].x_mm >= pitch_mm;
    });
    out.before.push_back(static_cast<std::size_t>(free - out.order.begin()));
  }
  return out;
}

// Goes back over what was taken: for each number of names that may still follow, or in all.
std::vector<std::size_t> traced(const Line& line, const std::vector<std::vector<bool>>& taken,
                                bool is_by_number) {
  std::vector<std::size_t> out;
  std::size_t round = taken.size();
  for (std::size_t i = line.order.size(); i > 0 && round > 0;) {
    if (!taken[round - 1][i - 1]) {
      --i;
      continue;
    }
    out.push_back(line.order[i - 1]);
    i = line.before[i - 1];
    if (is_by_number) --round;
  }
  std::ranges::reverse(out);
  return out;
}

} // namespace

std::vector<std::size_t> choose_on_line(std::span<const NameOnLine> names, double pitch_mm,
                                        std::optional<std::size_t> most) {
  const std::size_t count = names.size();
  if (most == std::size_t{0}) return {};
  const Line line = line_of(names, pitch_mm);
  // best[i]: the greatest sum of the first i names; before: the same with a name less.
  const auto round = [&](const std::vector<NameWeight>& before, std::vector<NameWeight>& best) {
    std::vector<bool> taken(count);
    for (std::size_t i = 0; i < count; ++i) {
      const NameWeight with = names[line.order[i]].weight + before[line.before[i]];
      taken[i] = with > best[i];
      best[i + 1] = std::max(best[i], with);
    }
    return taken;
  };
  std::vector<NameWeight> best(count + 1);
  std::vector<std::size_t> all = traced(line, {round(best, best)}, false);
  if (!most || all.size() <= *most) return all;
  std::vector<std::vector<bool>> taken;
  best.assign(count + 1, {});
  std::vector<NameWeight> before = best;
  for (std::size_t k = 0; k < *most; ++k) {
    taken.push_back(round(before, best));
    before = best;
  }
  return traced(line, taken, true);
}

} // namespace orograph
