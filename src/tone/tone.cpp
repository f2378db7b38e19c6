// SPDX-License-Identifier: GPL-3.0-or-later
#include "tone/tone.hpp"

#include "geometry/on_all_cores.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include "tone/darkness.hpp"
#include "tone/line_widths.hpp"
#include "tone/mean_on_page.hpp"
#include "tone/plan_on_page.hpp"

namespace orograph {
namespace {

constexpr double kColumn_mm = 0.5;
// Lines that are nearer than this agree on how far apart they are. Over twelve views 94 % of the
// gaps are between 0.5 and 1.6 times what is asked for; at 1 mm 91 %, below it ends of lines get
// ragged.
constexpr double kGapReach_mm = 0.5;

// On the page, the octave of the planned profiles' distance around each sample, that of 1 mm being
// 0; NaN where nothing is seen. It is a mean over the page, on which wide gaps take more room than
// narrow ones. It is the octaves' mean: that of distances is what the widest are for a millimetre
// into a slope seen edge-on, which then goes black.
std::vector<float> planned_octaves(const PlanOnPage& plan, const PageColumns& columns) {
  const auto own = [&](std::size_t j, std::size_t first, std::size_t count, StripValues<2>& out) {
    const float* const gap_mm = plan.seen[j].gap_mm.data() + first;
    const Sight* const sight = plan.seen[j].sight.data() + first;
    const auto halvings = static_cast<float>(plan.profiles[j].halvings);
    for (std::size_t k = 0; k < count; ++k) {
      const bool counts = sight[k] == Sight::next && gap_mm[k] > 0;
      out[0][k] = counts ? gap_mm[k] * (std::log2(gap_mm[k]) + halvings) : 0;
      out[1][k] = counts ? gap_mm[k] : 0;
    }
  };
  const auto sums = sums_on_page<2>(plan.seen, columns, kGapReach_mm, own);
  std::vector<float> octaves(sums.size() * columns.count);
  on_all_cores(sums.size(), [&](std::size_t j) {
    const float *const weighted = sums[j].data(), *const weights = weighted + columns.count;
    for (std::size_t i = 0; i < columns.count; ++i)
      octaves[j * columns.count + i] =
          weights[i] > 0 ? weighted[i] / weights[i] : std::numeric_limits<float>::quiet_NaN();
  });
  return octaves;
}

// How often the step is halved around a profile.
int halvings_around(const PlanOnPage& plan, std::size_t j) {
  const int behind = j + 1 < plan.profiles.size() ? plan.profiles[j + 1].halvings : 0;
  return std::max(plan.profiles[j].halvings, behind);
}

} // namespace

PageColumns columns_of(const TonePage& page) {
  return page_columns(page.range, page.of_u, page.frame_mm, kColumn_mm);
}

std::vector<TonedProfile> toned_profiles(const SurfaceCutter& cutter, const TonePage& page,
                                         std::span<const double> depths_m, double nearest_m,
                                         const ToneRequest& request) {
  const PageColumns columns = columns_of(page);
  const ProfileSampler sampler(cutter, page.view, page.to_page, columns);
  return toned_profiles(sampler, columns, page.view, page.frame_mm, depths_m, nearest_m, request);
}

std::vector<TonedProfile> toned_profiles(const ProfileSampler& sampler, const PageColumns& columns,
                                         const View& view, const Box2& frame_mm,
                                         std::span<const double> depths_m, double nearest_m,
                                         const ToneRequest& request) {
  const PlanOnPage plan =
      request.is_even ? plan_on_page(sampler, depths_m, nearest_m, columns, view, frame_mm, request)
                      : as_planned(sampler, depths_m, columns, view, frame_mm, request.both_sides);
  const std::vector<float> octaves = planned_octaves(plan, columns);
  const std::vector<float> darkness = darkness_of(plan, columns, view, request);
  std::vector<TonedProfile> toned(plan.profiles.size());
  on_all_cores(plan.profiles.size(), [&](std::size_t j) {
    const std::size_t first = j * columns.count;
    const LinePlace place{plan.profiles[j].level, halvings_around(plan, j),
                          std::span(octaves).subspan(first, columns.count),
                          darkness.empty() ? std::span<const float>()
                                           : std::span(darkness).subspan(first, columns.count)};
    toned[j] = {plan.profiles[j].depth_m,
                plan.profiles[j].level,
                runs_of_line(place, columns, request),
                {}};
    if (columns.of_u)
      for (ToneRun& run : toned[j].runs) {
        run.x_begin /= toned[j].depth_m;
        run.x_end /= toned[j].depth_m;
      }
    if (request.is_shown_by(LightShownBy::nothing))
      toned[j].darkness.assign(place.darkness.begin(), place.darkness.end());
  });
  if (request.is_even)
    std::erase_if(toned, [&](const TonedProfile& profile) {
      return profile.runs.empty() && !(request.keeps_unseen && profile.level >= 0);
    });
  return toned;
}

} // namespace orograph
