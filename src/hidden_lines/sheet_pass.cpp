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
  std::uint32_t profile, span, triangle;
  bool on_rim; ///< along its nearer edge
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

// A span along an edge belongs to the triangle in front of it, and is asked before that edge covers
// anything; where there is none, to the one behind, before the edge itself.
void add_passages(const SheetInWork& sheet, std::span<const TimedProfile> profiles,
                  std::span<const double> depths_m, std::uint32_t triangle,
                  std::vector<Passage>& out) {
  const auto [a, b, c] = sheet.sheet.triangles.corners(triangle);
  const std::array corners{sheet.vertices[a], sheet.vertices[b], sheet.vertices[c]};
  const auto [nearest, farthest] = std::minmax({corners[0].v, corners[1].v, corners[2].v});
  const auto first = std::lower_bound(depths_m.begin(), depths_m.end(), nearest);
  for (auto at = first; at != depths_m.end() && *at <= farthest; ++at) {
    const double depth_m = *at;
    const auto profile = static_cast<std::size_t>(at - depths_m.begin());
    const bool on_rim = depth_m == nearest;
    const auto middle =
        on_rim ? middle_of_cut(corners, depth_m, [&](ProfilePoint p) { return p.v <= depth_m; })
               : middle_of_cut(corners, depth_m, [&](ProfilePoint p) { return p.v < depth_m; });
    if (!middle) continue;
    const std::vector<double>& u_m = profiles[profile].profile.profile.u_m;
    const auto right = std::upper_bound(u_m.begin(), u_m.end(), *middle);
    if (right == u_m.begin() || right == u_m.end()) continue;
    out.push_back({static_cast<std::uint32_t>(profile),
                   static_cast<std::uint32_t>(right - u_m.begin()) - 1, triangle, on_rim});
  }
}

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
                                         std::span<const TimedProfile> profiles) {
  constexpr std::size_t kOfTask = std::size_t{1} << 15U;
  const std::size_t count = sheet.sheet.triangles.count();
  std::vector<double> depths_m;
  for (const TimedProfile& of : profiles) depths_m.push_back(of.profile.planned.depth_m);
  std::vector<std::vector<Passage>> of_tasks((count + kOfTask - 1) / kOfTask);
  on_all_cores(of_tasks.size(), [&](std::size_t task) {
    const std::size_t end = std::min(count, (task + 1) * kOfTask);
    for (std::size_t t = task * kOfTask; t < end; ++t)
      if (sheet.sheet.triangles.is_there(static_cast<std::uint32_t>(t)))
        add_passages(sheet, profiles, depths_m, static_cast<std::uint32_t>(t), of_tasks[task]);
  });
  std::vector<SheetProfile> out;
  for (const TimedProfile& of : profiles)
    out.push_back({&of.profile.projected, std::vector<SheetSpan>(of.profile.profile.size())});
  for (const std::vector<Passage>& passages : of_tasks) {
    throw_if_stopped();
    for (const auto& [profile, number, triangle, is_on_rim] : passages) {
      SheetSpan& span = out[profile].spans[number];
      const bool has_front = span.is_there && (span.turn & 3U) != 0;
      if (has_front || (span.is_there && is_on_rim)) continue;
      span = {
          turn_of(sheet.order.place(triangle), is_on_rim ? SheetStep::on_rim : SheetStep::inside),
          true, sheet.sheet.is_up[triangle] != 0};
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
  const auto strips = strips_of<SheetStrip>(work, [&](std::size_t, const auto&... of_strip) {
    return std::make_unique<SheetStrip>(sheet, of_strip...);
  });
  watch.mark(seconds.facing);
  const ProfileStages stages(work, lay_out, strips.size());
  std::vector<TimedProfile> profiles(work.sector.profiles.size());
  on_all_cores(profiles.size(), [&](std::size_t i) { stages.cut(profiles[i], i); });
  {
    const std::vector<SheetProfile> of_sheet = sheet_profiles(sheet, profiles);
    on_all_cores(strips.size(), [&](std::size_t i) { strips[i]->run(of_sheet); });
  }
  SectorParts out;
  for (std::size_t i = 0; i < strips.size(); ++i) {
    throw_if_stopped();
    const SheetStrip& strip = *strips[i];
    for (const auto& [profile, is_up, run] : strip.seen_spans()) {
      ProfileInWork& of = profiles[profile].profile;
      (is_up ? of.by_strip : of.underside_by_strip)[i].push_back(run);
    }
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
