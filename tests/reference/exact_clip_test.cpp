// SPDX-License-Identifier: GPL-3.0-or-later
// The exact clip by hand-reckoned cases.
#include "reference/exact_clip.hpp"
#include "tests/catch.hpp"

using namespace orograph;

namespace {

using Segments = std::vector<Segment>;

} // namespace

TEST_CASE("a second list shows where it is above the first") {
  const Segments near{{0, 0, 4, 4, 1}}, far{{0, 3, 4, 0, 2}, {4, 5, 6, 5, 3}};
  const auto clips = exact_clip(std::vector<ExactList>{{near}, {far}});
  REQUIRE(clips.size() == 2);
  CHECK(clips[0].visible == std::vector<Piece>{{0, 0, 4, 0, 1}});
  CHECK(clips[0].least_horizon == 3); // sky, the segment, sky
  // x = 3 - 3 x / 4 at 12 / 7.
  CHECK(clips[1].visible == std::vector<Piece>{{0, 0, 12.0 / 7, 0, 3.0 / 7}, {1, 4, 6, 0, 1}});
  CHECK(clips[1].least_horizon == 5);
}
