// SPDX-License-Identifier: GPL-3.0-or-later
#include "hidden_lines/hidden_parts.hpp"

#include "geometry/on_all_cores.hpp"

#include <algorithm>

namespace orograph {
namespace {

// Where two occluders meet, rounding may leave a slit between what they hide, or show: a share of a
// line, far below the page's step.
constexpr double kSlit = 1e-9;

// What of a line may have a picture.
void add_in_front(const LinePictures& lines, std::uint32_t line, std::vector<LinePart>& out) {
  const ProfileLine whole = lines.whole(line);
  if (!(std::max(whole.from.v, whole.to.v) > lines.from_m())) return;
  lines.add_part(line, lines.picture(line, whole), 0, 1, out);
}

} // namespace

std::vector<LinePart> hidden_parts(const LinePictures& lines, std::size_t count,
                                   const HiddenKinds& kinds, const std::vector<LinePart>& visible) {
  constexpr std::size_t kLinesOfTask = std::size_t{1} << 14U;
  std::vector<std::vector<LinePart>> of_tasks((count + kLinesOfTask - 1) / kLinesOfTask);
  on_all_cores(of_tasks.size(), [&](std::size_t task) {
    const std::size_t end = std::min(count, (task + 1) * kLinesOfTask);
    for (std::size_t i = task * kLinesOfTask; i < end; ++i) {
      const auto number = static_cast<std::uint32_t>(i);
      const EdgeLine& line = lines.line(number);
      if (line.drawn && kinds.has(line.kind)) add_in_front(lines, number, of_tasks[task]);
    }
  });
  std::vector<LinePart> in_front;
  for (const std::vector<LinePart>& parts : of_tasks)
    in_front.insert(in_front.end(), parts.begin(), parts.end());
  std::vector<LinePart> hidden = without(in_front, visible);
  std::erase_if(hidden, [](const LinePart& part) { return part.t_end - part.t_begin <= kSlit; });
  return hidden;
}

std::vector<VisibleRun> hidden_runs(const Profile& profile, std::span<const VisibleRun> visible) {
  std::vector<VisibleRun> out;
  const auto size = static_cast<std::uint32_t>(profile.size());
  auto next = visible.begin();
  for (std::uint32_t span = 0; span < size; ++span) {
    if (profile.after[span] == Span::gap) continue;
    std::uint32_t last = span;
    while (profile.after[last + 1] != Span::gap) ++last; // as the last one is
    VisibleRun hidden{span, span, 0, 0};
    const auto end_at = [&](std::uint32_t end, double t_end) {
      if (hidden.t_begin >= 1 - kSlit && hidden.first < end) hidden = {hidden.first + 1, 0, 0, 0};
      if (t_end <= kSlit && hidden.first < end) {
        --end;
        t_end = 1;
      }
      if (hidden.first < end || (hidden.first == end && t_end - hidden.t_begin > kSlit))
        out.push_back({hidden.first, end, hidden.t_begin, t_end});
    };
    for (; next != visible.end() && next->first <= last; ++next) {
      end_at(next->first, next->t_begin);
      hidden = {next->last, next->last, next->t_end, 0};
    }
    end_at(last, 1);
    span = last;
  }
  return out;
}

} // namespace orograph
