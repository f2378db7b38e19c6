// SPDX-License-Identifier: GPL-3.0-or-later
#include "tone/plan_on_page.hpp"

#include "geometry/on_all_cores.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <utility>

namespace orograph {
namespace {

// Beside an eye that stands 5 m above cells of 75 m, ground seen edge-on runs through depths so
// fast that 6 leave gaps of four spacings; of ordinary views 10 change nothing.
constexpr int kMostHalvings = 10;
// Less of a line isn't worth one.
constexpr double kLeastLine_mm = 2;
// Rounds of halving make no more profiles than this for each that was planned.
constexpr std::size_t kMostPerPlanned = 12, kLeastMost = 2000;
// From the eye to the first planned profile depths rise by this ratio.
constexpr double kRatioNear = 1.25;

void sample_all(const ProfileSampler& sampler, std::span<SampledProfile*> profiles) {
  constexpr std::size_t kOfTask = ProfileSampler::kAtOnce;
  // Here, where pages are large and used before (docs/decisions/0066): 18 bytes a column.
  for (SampledProfile* const profile : profiles) sampler.make_room(*profile);
  on_all_cores((profiles.size() + kOfTask - 1) / kOfTask, [&](std::size_t task) {
    const std::span from = profiles.subspan(task * kOfTask);
    sampler.sample(from.first(std::min(kOfTask, from.size())));
  });
}

void sample_all(const ProfileSampler& sampler, std::vector<SampledProfile>& profiles) {
  std::vector<SampledProfile*> all;
  for (SampledProfile& profile : profiles) all.push_back(&profile);
  sample_all(sampler, all);
}

std::vector<SampledProfile> at_depths(std::span<const double> depths_m) {
  std::vector<SampledProfile> out(depths_m.size());
  for (std::size_t i = 0; i < depths_m.size(); ++i) {
    out[i].depth_m = depths_m[i];
    out[i].level = std::countr_zero(static_cast<std::uint64_t>(i) + 1);
  }
  return out;
}

bool is_too_far_apart(const SampledProfile& profile, const SeenProfile& seen,
                      const PageColumns& columns, double widest_mm, bool draws_level) {
  double wide_mm = 0;
  for (std::size_t i = 0; i < columns.count; ++i)
    if (seen.gap_mm[i] > widest_mm && (draws_level || profile.is_level[i] == 0))
      wide_mm += columns.mm;
  return wide_mm >= kLeastLine_mm;
}

// Halfway on the page, on level ground.
double between(double a_m, double b_m, const View& view, const PageColumns& columns) {
  return view.is_perspective() && !columns.of_u ? 2 * a_m * b_m / (a_m + b_m) : 0.5 * (a_m + b_m);
}

} // namespace

PlanOnPage as_planned(const ProfileSampler& sampler, std::span<const double> depths_m,
                      const PageColumns& columns, const View& view, const Box2& frame_mm,
                      bool both_sides) {
  PlanOnPage plan;
  plan.profiles = at_depths(depths_m);
  sample_all(sampler, plan.profiles);
  plan.seen = seen_profiles(plan.profiles, columns, view, frame_mm, both_sides);
  return plan;
}

PlanOnPage plan_on_page(const ProfileSampler& sampler, std::span<const double> depths_m,
                        double nearest_m, const PageColumns& columns, const View& view,
                        const Box2& frame_mm, const ToneRequest& request) {
  PlanOnPage plan;
  plan.profiles = at_depths(depths_m);
  if (view.is_perspective() && !columns.of_u && nearest_m > 0 && !depths_m.empty()) {
    std::vector<SampledProfile> near;
    for (double depth_m = depths_m.front() / kRatioNear; depth_m > nearest_m; depth_m /= kRatioNear)
      near.emplace_back().depth_m = depth_m;
    plan.profiles.insert(plan.profiles.begin(), std::make_move_iterator(near.rbegin()),
                         std::make_move_iterator(near.rend()));
  }
  sample_all(sampler, plan.profiles);
  const std::size_t most = std::max(kLeastMost, kMostPerPlanned * depths_m.size());
  for (;;) {
    plan.seen = seen_profiles(plan.profiles, columns, view, frame_mm, request.both_sides);
    std::vector<SampledProfile> halved;
    std::vector<std::size_t> added;
    for (std::size_t j = 0; j < plan.profiles.size(); ++j) {
      SampledProfile& profile = plan.profiles[j];
      if (j > 0 && profile.halvings < kMostHalvings && plan.profiles.size() + added.size() < most &&
          is_too_far_apart(profile, plan.seen[j], columns, std::numbers::sqrt2 * request.spacing_mm,
                           request.draws_level)) {
        SampledProfile middle;
        middle.depth_m = between(plan.profiles[j - 1].depth_m, profile.depth_m, view, columns);
        middle.halvings = ++profile.halvings;
        middle.level = -profile.halvings;
        added.push_back(halved.size());
        halved.push_back(std::move(middle));
      }
      halved.push_back(std::move(profile));
    }
    plan.profiles = std::move(halved);
    if (added.empty()) return plan;
    std::vector<SampledProfile*> to_sample;
    for (const std::size_t j : added) to_sample.push_back(&plan.profiles[j]);
    sample_all(sampler, to_sample);
  }
}

} // namespace orograph
