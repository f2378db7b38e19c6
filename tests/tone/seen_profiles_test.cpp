// SPDX-License-Identifier: GPL-3.0-or-later
// What is seen of samples, by the definition: all in front of it in its column are lower.
#include "tests/catch.hpp"
#include "tests/support/random.hpp"
#include "tests/tone/made_profiles.hpp"

#include <cmath>

#include "tone/seen_profiles.hpp"

namespace orograph::seen_profiles_test {

TEST_CASE("a sample is seen that is higher than all in front of it, on the page") {
  const Box2 frame{{1, -40}, {5, 40}};
  const View view = upright_view();
  std::size_t seen_count = 0, hidden_count = 0, gaps = 0;
  for (std::uint64_t seed = 1; seed <= last_seed(2000); ++seed) {
    Random random(seed);
    const bool is_wide = random.chance(0.1); // several tasks
    const PageColumns columns{0, 1, is_wide ? 150U : 12U, is_wide ? 0.04 : 0.5};
    const std::vector<SampledProfile> profiles = made_profiles(random, columns);
    const std::vector<SeenProfile> seen = seen_profiles(profiles, columns, view, frame);
    REQUIRE(seen.size() == profiles.size());
    bool all_right = true;
    for (std::size_t i = 0; i < columns.count; ++i)
      for (std::size_t j = 0; j < profiles.size(); ++j) {
        const double z = profiles[j].z_m[i];
        const float x_mm = profiles[j].x_mm[i];
        bool is_seen = !std::isnan(z) && x_mm >= 1 && x_mm <= 5 && -z >= -40 && -z <= 40;
        double highest = -1e9;
        for (std::size_t k = 0; k < j; ++k)
          if (!std::isnan(profiles[k].z_m[i])) highest = std::max(highest, profiles[k].z_m[i]);
        is_seen = is_seen && z > highest;
        all_right &= is_seen == (seen[j].sight[i] != Sight::none);
        ++(is_seen ? seen_count : hidden_count);
        // Across the line it is at most the way up the column.
        const float gap_mm = seen[j].gap_mm[i];
        const bool behind_void = j > 0 && std::isnan(profiles[j - 1].z_m[i]);
        if (is_seen && behind_void) all_right &= seen[j].sight[i] == Sight::first;
        if (!is_seen || highest == -1e9 || behind_void) {
          all_right &= gap_mm == 0;
        } else {
          all_right &= gap_mm >= 0 && gap_mm <= static_cast<float>(z - highest) * 1.00001F;
          ++gaps;
        }
      }
    INFO("seed " << seed);
    CHECK(all_right);
  }
  CHECK(seen_count > 10 * last_seed(2000));
  CHECK(hidden_count > 10 * last_seed(2000));
  CHECK(gaps > 10 * last_seed(2000));
}

TEST_CASE("gaps are measured across the line, whichever way it goes") {
  // Two parallel straight lines, 3 mm apart up the page.
  const PageColumns columns{0, 1, 9, 0.5};
  const Box2 frame{{-100, -100}, {100, 100}};
  for (const double rise : {0.0, 0.5, -2.0}) {
    std::vector<double> near, far;
    for (std::size_t i = 0; i < columns.count; ++i) {
      near.push_back(rise * columns.mm * static_cast<double>(i));
      far.push_back(near.back() + 3);
    }
    const std::vector<SampledProfile> profiles{sampled(0, near, columns), sampled(1, far, columns)};
    const auto seen = seen_profiles(profiles, columns, upright_view(), frame);
    for (std::size_t i = 0; i < columns.count; ++i)
      CHECK(std::abs(seen[1].gap_mm[i] - 3 / std::hypot(1, rise)) < 1e-5); // of floats
  }
}

TEST_CASE("ground goes on behind hidden profiles near by, and doesn't far behind") {
  const PageColumns columns{0, 1, 1, 0.5};
  const Box2 frame{{-100, -1e4}, {100, 1e4}};
  View view;
  view.projection = Projection::perspective;
  view.eye_z_m = 100;
  const auto sight_behind = [&](double depth_m) {
    std::vector<SampledProfile> profiles;
    for (const auto& [depth, z] : {std::pair{1000., 50.}, {depth_m - 1, -1000.}, {depth_m, 90.}})
      profiles.push_back(sampled(depth, {z}, columns));
    return seen_profiles(profiles, columns, view, frame).back().sight.front();
  };
  CHECK(sight_behind(1020) == Sight::next);
  CHECK(sight_behind(1100) == Sight::first);
}

} // namespace orograph::seen_profiles_test
