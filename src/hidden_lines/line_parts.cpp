// SPDX-License-Identifier: GPL-3.0-or-later
#include "hidden_lines/line_parts.hpp"

#include "geometry/on_all_cores.hpp"
#include "geometry/sort_by_number.hpp"

#include <algorithm>

namespace orograph {
namespace {

// Parts that are in order, from number `first` on.
template <class Gap>
void join_in_order(std::vector<LinePart>& parts, std::size_t first, const Gap& gap) {
  std::size_t count = first;
  for (std::size_t i = first; i < parts.size(); ++i) {
    throw_if_stopped(i);
    const LinePart part = parts[i];
    if (count > first && parts[count - 1].line == part.line &&
        parts[count - 1].t_end >= part.t_begin - gap(part.line))
      parts[count - 1].t_end = std::max(parts[count - 1].t_end, part.t_end);
    else
      parts[count++] = part;
  }
  parts.resize(count);
  const auto begin = parts.begin() + static_cast<std::ptrdiff_t>(first);
  parts.erase(std::remove_if(begin, parts.end(),
                             [](const LinePart& p) { return p.t_end - p.t_begin <= kSameShare; }),
              parts.end());
}

double no_gap(std::uint32_t) {
  return kSameShare;
}

} // namespace

void join(std::vector<LinePart>& parts, const std::function<double(std::uint32_t)>& gap) {
  sort_by_number_then(
      parts, [](const LinePart& part) { return part.line; },
      [](const LinePart& a, const LinePart& b) { return a.t_begin < b.t_begin; });
  if (gap)
    join_in_order(parts, 0, gap);
  else
    join_in_order(parts, 0, no_gap);
}

void join_of_line(std::vector<LinePart>& parts, std::size_t first) {
  std::sort(parts.begin() + static_cast<std::ptrdiff_t>(first), parts.end(),
            [](const LinePart& a, const LinePart& b) { return a.t_begin < b.t_begin; });
  join_in_order(parts, first, no_gap);
}

std::vector<LinePart> without(const std::vector<LinePart>& parts,
                              const std::vector<LinePart>& taken) {
  std::vector<LinePart> rest;
  rest.reserve(parts.size());
  auto first = taken.begin();
  std::size_t step = 0;
  for (const LinePart& part : parts) {
    throw_if_stopped(step++);
    while (first != taken.end() && first->line < part.line) ++first;
    double begin = part.t_begin;
    const auto keep = [&](double end) {
      if (end > begin + kSameShare) rest.push_back({part.line, begin, end});
    };
    for (auto t = first; t != taken.end() && t->line == part.line; ++t) {
      keep(std::min(t->t_begin, part.t_end));
      begin = std::max(begin, t->t_end);
    }
    keep(part.t_end);
  }
  return rest;
}

std::vector<LinePart> with_whole(const std::vector<LinePart>& parts, std::size_t first,
                                 std::span<const std::uint8_t> marks) {
  std::vector<LinePart> out;
  out.reserve(parts.size() + static_cast<std::size_t>(std::ranges::count(marks, std::uint8_t{1})));
  auto part = parts.begin();
  for (std::size_t i = 0; i < marks.size(); ++i) {
    throw_if_stopped(i);
    if (marks[i] == 0) continue;
    const auto line = static_cast<std::uint32_t>(first + i);
    for (; part != parts.end() && part->line < line; ++part) out.push_back(*part);
    out.push_back({line, 0, 1});
  }
  out.insert(out.end(), part, parts.end());
  return out;
}

std::vector<LinePart> shared(const std::vector<LinePart>& parts,
                             const std::vector<LinePart>& others) {
  return without(parts, without(parts, others));
}

} // namespace orograph
