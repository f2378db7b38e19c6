// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/for_each_marked.hpp"
#include "tests/catch.hpp"
#include "tests/support/random.hpp"

#include <utility>
#include <vector>

using namespace orograph;

TEST_CASE("of a row's bytes those with any of the bits are taken, and each of these bits") {
  for (std::uint64_t seed = 1; seed <= last_seed(1000); ++seed) {
    Random random(seed);
    std::vector<std::uint8_t> bytes(static_cast<std::size_t>(random.whole(1, 60)));
    const double share = random.pick({0.02, 0.3, 1.0});
    for (std::uint8_t& byte : bytes)
      byte = random.chance(share) ? static_cast<std::uint8_t>(random.whole(0, 255)) : 0;
    const int count = static_cast<int>(bytes.size()), first = random.whole(0, count - 1),
              end = random.whole(first, count);
    const auto which = static_cast<std::uint8_t>(random.whole(1, 255));

    std::vector<int> expected, taken;
    std::vector<std::pair<int, int>> expected_marks, marks;
    for (int i = first; i < end; ++i) {
      const int byte = bytes[static_cast<std::size_t>(i)] & which;
      if (byte != 0) expected.push_back(i);
      for (int bit = 1; bit < 256; bit *= 2)
        if (byte & bit) expected_marks.emplace_back(i, bit);
    }
    for_each_marked(bytes, first, end, which, [&](int i) { taken.push_back(i); });
    for_each_mark(bytes, first, end, which,
                  [&](int i, std::uint8_t mark) { marks.emplace_back(i, mark); });
    CAPTURE(seed);
    CHECK(taken == expected);
    CHECK(marks == expected_marks);
  }
}
