// SPDX-License-Identifier: GPL-3.0-or-later
// Profiles are added where lines would be too far apart, and nowhere else.
#include "dem/grid.hpp"
#include "tests/catch.hpp"
#include "tests/support/random.hpp"

#include <cmath>
#include <numbers>

#include "tone/plan_on_page.hpp"

namespace orograph::plan_on_page_test {
namespace {

constexpr std::size_t kSide = 40;

// Waves, steeper ones to the right.
Grid waves(Random& random) {
  Grid grid{kSide, kSide, PlaneLattice{{-20, 20}, {1, 0}, {0, -1}}, std::vector<float>()};
  const double across = random.between(0.1, 0.5), along = random.between(0.1, 0.5);
  std::vector<float> heights;
  for (std::size_t row = 0; row < kSide; ++row)
    for (std::size_t column = 0; column < kSide; ++column)
      heights.push_back(static_cast<float>(0.2 * static_cast<double>(column) *
                                           std::sin(across * static_cast<double>(column)) *
                                           std::cos(along * static_cast<double>(row))));
  grid.heights_m = heights;
  return grid;
}

} // namespace

TEST_CASE("no lines that are seen are too far apart") {
  std::size_t added = 0, given_up = 0, intervals = 0;
  for (std::uint64_t seed = 1; seed <= last_seed(200); ++seed) {
    Random random(seed);
    const Surface surface = waves(random);
    View view; // 1 mm a metre, from the side and above
    view.projection = Projection::orthographic;
    view.y_per_z = 0.9;
    view.y_per_v = 0.3;
    const Homography to_page{{1, 0, 0, 0, -1, 0, 0, 0, 1}};
    const Box2 frame{{-1000, -1000}, {1000, 1000}};
    const TriangleSet no_level;
    const SurfaceCutter cutter(surface, view, no_level, {});
    std::vector<double> depths_m;
    const double step_m = random.between(0.5, 4);
    for (double at = cutter.nearest_m() + 0.3; at < cutter.farthest_m(); at += step_m)
      depths_m.push_back(at);
    const PageColumns columns{-60, 0.5, 240, 0.5};
    const ProfileSampler sampler(cutter, view, to_page, columns);
    const double spacing_mm = random.between(0.2, 2);
    ToneRequest request{};
    request.spacing_mm = spacing_mm;
    const PlanOnPage plan =
        plan_on_page(sampler, depths_m, cutter.nearest_m(), columns, view, frame, request);
    INFO("seed " << seed);
    // Planned ones are all there, with their levels; others stand between.
    std::size_t next = 0;
    for (std::size_t j = 0; j < plan.profiles.size(); ++j) {
      const SampledProfile& profile = plan.profiles[j];
      if (j > 0) CHECK(profile.depth_m > plan.profiles[j - 1].depth_m);
      if (next < depths_m.size() && profile.depth_m == depths_m[next]) {
        ++next;
        CHECK((next >> static_cast<unsigned>(profile.level))
                  << static_cast<unsigned>(profile.level) ==
              next);
        CHECK((next >> static_cast<unsigned>(profile.level)) % 2 == 1);
      } else {
        ++added;
        CHECK(profile.level < 0);
        CHECK(-profile.level <= profile.halvings);
      }
      if (j == 0) continue;
      ++intervals;
      double wide_mm = 0;
      for (std::size_t i = 0; i < columns.count; ++i)
        if (plan.seen[j].gap_mm[i] > std::numbers::sqrt2 * spacing_mm) wide_mm += columns.mm;
      if (wide_mm >= 2) {
        CHECK(profile.halvings == 6);
        ++given_up;
      }
      // The interval is as often halved as its length says.
      const double interval_m = profile.depth_m - plan.profiles[j - 1].depth_m;
      CHECK(std::abs(interval_m - std::ldexp(step_m, -profile.halvings)) < 1e-9);
    }
    CHECK(next == depths_m.size());
  }
  CHECK(added > 10 * last_seed(200));
  CHECK(given_up < intervals / 100);
}

} // namespace orograph::plan_on_page_test
