// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/sort_by_number.hpp"
#include "tests/catch.hpp"
#include "tests/support/random.hpp"

#include <algorithm>

using namespace orograph;

namespace {

struct Numbered {
  std::uint64_t number;
  int place;
};

} // namespace

TEST_CASE("things are sorted by their number, and stay in order where it is the same") {
  for (std::uint64_t seed = 1; seed <= last_seed(300); ++seed) {
    Random random(seed);
    const std::uint64_t greatest = std::uint64_t{1} << random.whole(0, 63);
    std::vector<Numbered> things(static_cast<std::size_t>(random.whole(0, 500)));
    for (std::size_t i = 0; i < things.size(); ++i)
      things[i] = {static_cast<std::uint64_t>(random.share() * static_cast<double>(greatest)),
                   static_cast<int>(i)};
    std::vector<Numbered> expected = things;
    std::stable_sort(expected.begin(), expected.end(),
                     [](const Numbered& a, const Numbered& b) { return a.number < b.number; });
    sort_by_number(things, [](const Numbered& thing) { return thing.number; });
    CAPTURE(seed);
    CHECK(std::equal(things.begin(), things.end(), expected.begin(), expected.end(),
                     [](const Numbered& a, const Numbered& b) {
                       return a.number == b.number && a.place == b.place;
                     }));
  }
}
