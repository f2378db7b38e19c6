// SPDX-License-Identifier: GPL-3.0-or-later
#include "hidden_lines/sheet_pass.hpp"

#include "geometry/on_all_cores.hpp"
#include "hidden_lines/instruments.hpp"
#include "hidden_lines/profile_stages.hpp"
#include "hidden_lines/sheet_strip.hpp"

#include <algorithm>
#include <iterator>
#include <memory>

namespace orograph {
namespace {

// Where a profile passes a triangle.
struct Passage {
  std::uint32_t profile;
  std::uint32_t span : 31, on_rim : 1; ///< along its nearer edge
  std::uint32_t triangle;
};

// The middle of what a plane cuts of a triangle whose corners are in front of it or not; none where
// it only touches it.
template <class InFront>
std::optional<double> middle_of_cut(const std::array<ProfilePoint, 3>& corners, double depth_m,
                                    const InFront& in_front) {
  std::array<double, 2> u{};
  std::size_t count = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const ProfilePoint &a = corners[k], &b = corners[(k + 1) % 3];
    if (in_front(a) == in_front(b)) continue;
    u[count++] = a.u + (depth_m - a.v) / (b.v - a.v) * (b.u - a.u);
  }
  if (count < 2 || u[0] == u[1]) return std::nullopt;
  return 0.5 * (u[0] + u[1]);
}

// A list of rising numbers, in which what comes next is mostly near what was asked last.
class Rising {
public:
  explicit Rising(std::span<const double> numbers) : numbers_(numbers) {}
  std::size_t count() const { return numbers_.size(); }
  // The number of the first that is greater.
  std::size_t behind(double number) {
    constexpr int kMostSteps = 8;
    for (int i = 0; i < kMostSteps; ++i) {
      if (at_ < numbers_.size() && numbers_[at_] <= number)
        ++at_;
      else if (at_ > 0 && numbers_[at_ - 1] > number)
        --at_;
      else
        return at_;
    }
    at_ = static_cast<std::size_t>(std::upper_bound(numbers_.begin(), numbers_.end(), number) -
                                   numbers_.begin());
    return at_;
  }

private:
  std::span<const double> numbers_;
  std::size_t at_ = 0;
};

class PassagesOfTriangles {
public:
  PassagesOfTriangles(const SheetInWork& sheet, std::span<const TimedProfile> profiles,
                      std::span<const double> depths_m)
      : sheet_(sheet), depths_m_(depths_m), depths_(depths_m) {
    for (const TimedProfile& of : profiles) spans_.emplace_back(of.profile.profile.u_m);
  }

  // A span along an edge belongs to the triangle in front of it, and is asked before that edge
  // covers anything; where there is none, to the one behind, before the edge itself.
  void add(std::uint32_t triangle, std::vector<Passage>& out) {
    const auto [a, b, c] = sheet_.sheet.triangles.corners(triangle);
    const ProfilePoint p = sheet_.vertices[a], q = sheet_.vertices[b], r = sheet_.vertices[c];
    const double nearest = std::min({p.v, q.v, r.v}), farthest = std::max({p.v, q.v, r.v});
    std::size_t at = depths_.behind(nearest);
    while (at > 0 && depths_m_[at - 1] == nearest) --at;
    for (; at < depths_m_.size() && depths_m_[at] <= farthest; ++at) {
      const double depth_m = depths_m_[at];
      const bool on_rim = depth_m == nearest;
      const std::array corners{p, q, r};
      const auto middle =
          on_rim ? middle_of_cut(corners, depth_m, [&](ProfilePoint of) { return of.v <= depth_m; })
                 : middle_of_cut(corners, depth_m, [&](ProfilePoint of) { return of.v < depth_m; });
      if (!middle) continue;
      const std::size_t right = spans_[at].behind(*middle);
      if (right == 0 || right == spans_[at].count()) continue;
      out.push_back({static_cast<std::uint32_t>(at), static_cast<std::uint32_t>(right) - 1, on_rim,
                     triangle});
    }
  }

private:
  const SheetInWork& sheet_;
  std::span<const double> depths_m_;
  Rising depths_;
  std::vector<Rising> spans_; ///< by profile: its vertices' u
};

// Slivers that no triangle has been found for go with the span beside them.
void fill_slivers(const Profile& profile, std::vector<SheetSpan>& spans) {
  for (std::size_t i = 1; i < spans.size(); ++i)
    if (!spans[i].is_there && profile.after[i] != Span::gap && profile.after[i - 1] != Span::gap)
      spans[i] = spans[i - 1];
  for (std::size_t i = spans.size(); i-- > 1;)
    if (!spans[i - 1].is_there && profile.after[i - 1] != Span::gap &&
        profile.after[i] != Span::gap)
      spans[i - 1] = spans[i];
}

std::vector<SheetProfile> sheet_profiles(const SheetInWork& sheet,
                                         std::span<TimedProfile> profiles) {
  constexpr std::uint32_t kTrianglesOfTask = 1U << 15U;
  const std::uint32_t count = sheet.part.count();
  std::vector<double> depths_m;
  for (const TimedProfile& of : profiles) depths_m.push_back(of.profile.planned.depth_m);
  std::vector<SheetProfile> out;
  for (TimedProfile& of : profiles)
    out.push_back({&of.profile, std::vector<SheetSpan>(of.profile.profile.size())});
  // So many at a time, so that they need little memory.
  constexpr std::uint32_t kTasks = 32;
  std::vector<std::vector<Passage>> of_tasks(kTasks);
  for (std::uint32_t first = 0; first < count; first += kTasks * kTrianglesOfTask) {
    throw_if_stopped();
    on_all_cores(kTasks, [&](std::size_t task) {
      std::vector<Passage>& found = of_tasks[task];
      found.clear();
      const std::uint32_t begin =
          std::min(count, first + static_cast<std::uint32_t>(task) * kTrianglesOfTask);
      PassagesOfTriangles passages(sheet, profiles, depths_m);
      sheet.part.for_each(begin, std::min(count, begin + kTrianglesOfTask),
                          [&](std::uint32_t t, std::uint32_t) {
                            if (sheet.sheet.triangles.is_there(t)) passages.add(t, found);
                          });
    });
    for (const std::vector<Passage>& passages : of_tasks) {
      for (const auto& [profile, number, is_on_rim, triangle] : passages) {
        SheetSpan& span = out[profile].spans[number];
        if (span.is_there && (is_on_rim || has_front(span.turn))) continue;
        const SheetStep step = is_on_rim ? SheetStep::on_rim : SheetStep::inside;
        span = SheetSpan(turn_of(sheet.order.place(triangle), step), true,
                         sheet.sheet.is_up[triangle] != 0);
      }
    }
  }
  on_all_cores(out.size(),
               [&](std::size_t i) { fill_slivers(profiles[i].profile.profile, out[i].spans); });
  return out;
}

} // namespace

SectorParts sheet_pass(const SectorInWork& work, const LayOut& lay_out, const Show& show,
                       Counts& counts, StageSeconds& seconds) {
  Stopwatch watch;
  const SheetInWork sheet(work);
  const std::size_t strip_count =
      plan_strips(work.placed, work.sector, work.range, work.vertices_a_strip).size();
  watch.mark(seconds.facing);
  const ProfileStages stages(work, lay_out, strip_count);
  std::vector<TimedProfile> profiles(work.sector.profiles.size());
  on_all_cores(profiles.size(), [&](std::size_t i) {
    thread_local TimedProfile cut; // so that all of them take no more memory than they need
    stages.cut(cut, i);
    profiles[i] = cut;
    cut.cut_s = cut.project_s = 0;
  });
  std::vector<std::unique_ptr<SheetStrip>> strips;
  {
    const std::vector<SheetProfile> of_sheet = sheet_profiles(sheet, profiles);
    strips = strips_of<SheetStrip>(work, [&](std::size_t i, const Strip& strip,
                                             std::span<const LineAtDepth> which,
                                             std::span<const Segment> near_cut) {
      auto made = std::make_unique<SheetStrip>(sheet, i, strip);
      made->run(which, near_cut, of_sheet);
      return made;
    });
  }
  SectorParts out;
  std::size_t part_count = 0;
  for (const auto& strip : strips) part_count += strip->visible_parts().size();
  out.visible.reserve(part_count);
  for (const auto& made : strips) {
    throw_if_stopped();
    const SheetStrip& strip = *made;
    const std::vector<LinePart>& parts = strip.visible_parts();
    out.visible.insert(out.visible.end(), parts.begin(), parts.end());
    const Horizon top = strip.top();
    counts.largest_horizon = std::max<std::uint64_t>(counts.largest_horizon, top.size());
    const std::vector<LinePart> skyline = strip.pictures().skyline(top);
    out.skyline.insert(out.skyline.end(), skyline.begin(), skyline.end());
  }
  join(out.visible);
  join(out.skyline);
  out.skyline = shared(out.skyline, out.visible);
  watch.mark(seconds.clip);
  on_all_cores(profiles.size(), [&](std::size_t i) { stages.lay_out(profiles[i]); });
  for (TimedProfile& timed : profiles) {
    count(timed.profile, counts);
    show(timed.profile);
    timed.add_to(seconds);
  }
  return out;
}

} // namespace orograph
