// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/accuracy/visible_record.hpp"

#include "profiles/profile.hpp"

#include <algorithm>

#include "map/line_on_page.hpp"

namespace orograph {

void VisibleRecord::see(const SeenProfile& seen) {
  const auto& [sector, clipped, profile, segments, visible] = seen;
  Stretches& stretches = profiles_.emplace_back();
  const auto at = [&](std::uint32_t vertex) {
    return ProfilePoint{profile.u_m[vertex], profile.depth_m, profile.z_m[vertex]};
  };
  double start_mm = 0; // the same in every run, whatever segments arithmetic has lost
  auto piece = visible.begin();
  for (std::uint32_t vertex = 0; vertex + 1 < profile.size(); ++vertex) {
    if (profile.after[vertex] == Span::gap) continue;
    const auto line = LineOnPage::of({at(vertex), at(vertex + 1)}, sector.view, sector.to_page,
                                     scene_.page.inner_mm());
    for (; piece != visible.end() && left_vertex(segments[piece->segment]) <= vertex; ++piece) {
      if (!line || left_vertex(segments[piece->segment]) < vertex) continue;
      const auto mm = [&](double t) {
        return start_mm + std::clamp(line->mm_at(t), 0.0, line->length_mm());
      };
      const double begin = mm(piece->t_begin), end = mm(piece->t_end);
      if (!stretches.empty() && stretches.back().second >= begin)
        stretches.back().second = std::max(stretches.back().second, end);
      else
        stretches.emplace_back(begin, end);
    }
    if (line) start_mm += line->length_mm();
  }
}

double longest_difference_mm(const VisibleRecord& a, const VisibleRecord& b) {
  double longest = 0;
  for (std::size_t i = 0; i < std::min(a.profiles_.size(), b.profiles_.size()); ++i) {
    // Ends in order: between two of them either run is visible or hidden throughout.
    std::vector<std::pair<double, bool>> ends; // place, of `a`
    for (const auto& [begin, end] : a.profiles_[i]) {
      ends.emplace_back(begin, true);
      ends.emplace_back(end, true);
    }
    for (const auto& [begin, end] : b.profiles_[i]) {
      ends.emplace_back(begin, false);
      ends.emplace_back(end, false);
    }
    std::sort(ends.begin(), ends.end());
    bool in_a = false, in_b = false;
    for (std::size_t k = 0; k < ends.size(); ++k) {
      if (in_a != in_b) longest = std::max(longest, ends[k].first - ends[k - 1].first);
      bool& in = ends[k].second ? in_a : in_b;
      in = !in;
    }
  }
  return longest;
}

} // namespace orograph
