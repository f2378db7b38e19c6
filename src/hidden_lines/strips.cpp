// SPDX-License-Identifier: GPL-3.0-or-later
#include "hidden_lines/strips.hpp"

#include "view/sectors.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace orograph {
namespace {

constexpr std::size_t kMostStrips = 64;
// Tried from 2 to 16: with fewer vertices in a block the blocks themselves cost, with more the
// bounds decide less.
constexpr double kVerticesABlock = 6;
constexpr std::size_t kMostBlocks = 1U << 16U;
// Beyond this, where the page doesn't end, one block holds all.
constexpr double kFarAside = 8;

// The terrain's extent seen from above, as a rectangle's corners in the profile frame.
std::array<ProfilePoint, 4> corners_of(const Box3& box, const View& view) {
  return {to_profile_frame(view, {box.low.x, box.low.y, 0}),
          to_profile_frame(view, {box.high.x, box.low.y, 0}),
          to_profile_frame(view, {box.high.x, box.high.y, 0}),
          to_profile_frame(view, {box.low.x, box.high.y, 0})};
}

// Where the plane at a depth cuts the rectangle; empty (begin > end) where it doesn't.
XRange u_range(const std::array<ProfilePoint, 4>& corners, double depth_m) {
  XRange range{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
  for (std::size_t i = 0; i < 4; ++i) {
    const ProfilePoint &a = corners[i], &b = corners[(i + 1) % 4];
    if ((a.v < depth_m) == (b.v < depth_m)) continue;
    const double u = a.u + (depth_m - a.v) / (b.v - a.v) * (b.u - a.u);
    range = {std::min(range.begin, u), std::max(range.end, u)};
  }
  return range;
}

// Cut vertices over X, in bins of equal width.
struct Work {
  XRange core{};
  std::array<double, 512> bins{};
  double most = 0; ///< of one profile

  double width() const { return (core.end - core.begin) / static_cast<double>(bins.size()); }
  double sum() const {
    double total = 0;
    for (const double bin : bins) total += bin;
    return total;
  }
};

// Of some profiles; where there are none, over the sector.
std::vector<double> sampled_depths_m(const Sector& sector) {
  constexpr std::size_t kSamples = 64;
  const auto& profiles = sector.profiles;
  std::vector<double> depths_m;
  const std::size_t step = std::max<std::size_t>(1, profiles.size() / kSamples);
  for (std::size_t i = step / 2; i < profiles.size(); i += step)
    depths_m.push_back(profiles[i].depth_m);
  if (profiles.empty())
    for (std::size_t i = 0; i < kSamples; ++i)
      depths_m.push_back(sector.nearest_m + (static_cast<double>(i) + 0.5) / kSamples *
                                                (sector.farthest_m - sector.nearest_m));
  return depths_m;
}

Work work_of(const PlacedView& placed, const Sector& sector, XRange range) {
  const View& view = sector.view;
  const auto corners = corners_of(placed.extent.box, view);
  struct Cut {
    XRange x;
    double per_x; ///< vertices
  };
  std::vector<Cut> cuts;
  Work work;
  work.core = {std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
  for (const double v : sampled_depths_m(sector)) {
    const XRange u = u_range(corners, v);
    if (!(u.begin < u.end) || (view.is_perspective() && !(v > 0))) continue;
    const double scale = view.is_perspective() ? v : 1;
    const double aside = view.is_perspective() ? 0 : v * view.x_per_v;
    XRange x{std::max(u.begin / scale + aside, range.begin),
             std::min(u.end / scale + aside, range.end)};
    if (view.is_perspective())
      x = {std::clamp(x.begin, -kFarAside, kFarAside), std::clamp(x.end, -kFarAside, kFarAside)};
    if (!(x.begin < x.end)) continue;
    cuts.push_back({x, 2 * scale / placed.cell_m});
    work.core = {std::min(work.core.begin, x.begin), std::max(work.core.end, x.end)};
    work.most = std::max(work.most, cuts.back().per_x * (x.end - x.begin));
  }
  if (cuts.empty()) {
    const double begin = std::clamp(-1.0, range.begin, range.end);
    const double end = std::clamp(begin + 1, range.begin, range.end);
    work.core = {begin < end ? begin : end - 1, end};
    return work;
  }
  const double last = static_cast<double>(work.bins.size() - 1);
  for (const auto& [x, per_x] : cuts) {
    const auto bin = [&](double at) {
      return static_cast<std::size_t>(std::clamp((at - work.core.begin) / work.width(), 0.0, last));
    };
    for (std::size_t i = bin(x.begin); i <= bin(x.end); ++i)
      work.bins[i] += per_x * work.width() / static_cast<double>(cuts.size());
  }
  return work;
}

} // namespace

std::vector<Strip> plan_strips(const PlacedView& placed, const Sector& sector, XRange range,
                               double vertices_a_strip) {
  const Work work = work_of(placed, sector, range);
  const double sum = work.sum();
  const auto count = static_cast<std::size_t>(
      std::clamp(std::round(sum / vertices_a_strip), 1.0, static_cast<double>(kMostStrips)));
  const double blocks = std::clamp(work.most / kVerticesABlock, static_cast<double>(count),
                                   static_cast<double>(kMostBlocks));
  const double width = work.core.end - work.core.begin;
  std::vector<Strip> strips;
  double taken = 0, begin = work.core.begin;
  for (std::size_t i = 0; i < work.bins.size() && strips.size() + 1 < count; ++i) {
    taken += work.bins[i];
    if (taken * static_cast<double>(count) < sum * static_cast<double>(strips.size() + 1)) continue;
    const double end = work.core.begin + static_cast<double>(i + 1) * work.width();
    strips.push_back({{begin, end}, {begin, end}, 1});
    begin = end;
  }
  if (begin < work.core.end) strips.push_back({{begin, work.core.end}, {begin, work.core.end}, 1});
  for (Strip& strip : strips)
    strip.blocks = static_cast<std::size_t>(
        std::max(1.0, std::ceil(blocks * (strip.core.end - strip.core.begin) / width)));
  strips.front().range.begin = range.begin;
  strips.back().range.end = range.end;
  return strips;
}

} // namespace orograph
