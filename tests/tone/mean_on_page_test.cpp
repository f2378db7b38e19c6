// SPDX-License-Identifier: GPL-3.0-or-later
// Sums around a place of the page, against each weight reckoned on its own.
#include "tests/catch.hpp"
#include "tests/support/random.hpp"
#include "tests/tone/made_profiles.hpp"

#include <algorithm>
#include <cmath>

#include "tone/mean_on_page.hpp"

namespace orograph::mean_on_page_test {

TEST_CASE("sums on the page are those of all samples by their weights") {
  const Box2 frame{{-100, -1000}, {100, 1000}};
  for (std::uint64_t seed = 1; seed <= last_seed(500); ++seed) {
    Random random(seed);
    const PageColumns columns{0, 1, random.chance(0.1) ? 70U : 10U, 0.5}; // one strip, or three
    const std::vector<SampledProfile> profiles = made_profiles(random, columns);
    const auto seen = seen_profiles(profiles, columns, upright_view(), frame);
    std::vector<float> values;
    for (std::size_t k = 0; k < profiles.size() * columns.count; ++k)
      values.push_back(static_cast<float>(random.between(0, 1)));
    const double reach_mm = random.pick({0.1, 0.5, 1.0, 2.0});
    const auto own = [&](std::size_t j, std::size_t first, std::size_t count, StripValues<1>& out) {
      std::copy_n(values.data() + j * columns.count + first, count, out[0].data());
    };
    const auto sums = sums_on_page<1>(seen, columns, reach_mm, own);
    // Of what lies between two profiles of a column.
    const auto weight = [&](std::size_t a, std::size_t b, std::size_t i) {
      double product = 1;
      for (std::size_t j = std::min(a, b) + 1; j <= std::max(a, b); ++j) {
        if (seen[j].sight[i] == Sight::none) continue;
        const double way = seen[j].gap_mm[i] / reach_mm;
        product *= seen[j].sight[i] == Sight::first ? 0 : 1 / (1 + way + 0.5 * way * way);
      }
      return product;
    };
    const auto radius = std::lround(reach_mm / columns.mm);
    bool all_right = true;
    for (std::size_t j = 0; j < profiles.size(); ++j)
      for (std::size_t i = 0; i < columns.count; ++i) {
        double expected = 0;
        if (seen[j].sight[i] != Sight::none)
          for (std::size_t at = 0; at < columns.count; ++at) {
            if (std::abs(static_cast<long>(at) - static_cast<long>(i)) > radius) continue;
            if (seen[j].sight[at] == Sight::none) continue;
            for (std::size_t k = 0; k < profiles.size(); ++k)
              if (seen[k].sight[at] != Sight::none)
                expected += weight(j, k, at) * values[k * columns.count + at];
          }
        // Sums of up to 300 floats of up to 1.
        all_right &= std::abs(sums[j][i] - expected) < 1e-3;
      }
    INFO("seed " << seed << ", reach " << reach_mm);
    CHECK(all_right);
  }
}

} // namespace orograph::mean_on_page_test
