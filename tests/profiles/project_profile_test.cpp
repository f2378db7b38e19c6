// SPDX-License-Identifier: GPL-3.0-or-later
#include "profiles/profile.hpp"
#include "tests/catch.hpp"
#include "tests/support/made_grid.hpp"
#include "tests/support/random.hpp"

namespace orograph::project_profile_test {
namespace {

const Profile profile{100,
                      {-10, 0, 0, 20, 30, 40},
                      {1, 2, 5, 8, 9, 0},
                      {Span::slope, Span::slope, Span::level, Span::gap, Span::slope, Span::gap},
                      {}};

} // namespace

TEST_CASE("spans become segments with the profile's number and their left vertex") {
  View view;
  view.eye_z_m = 4;
  std::vector<Segment> uprights, segments{{0, 0, 1, 1, 99}};
  project_profile(profile, 7, view, segments, uprights);
  REQUIRE(segments.size() == 3); // not the upright one, not the gap
  const std::uint64_t id = std::uint64_t{7} << 32U;
  const double expected[3][4] = {{-10, 1, 0, 2}, {0, 5, 20, 8}, {30, 9, 40, 0}};
  const std::uint32_t vertex[3] = {0, 2, 4};
  for (std::size_t i = 0; i < 3; ++i) {
    const Segment& s = segments[i];
    CHECK(s.id == (id | vertex[i]));
    CHECK(left_vertex(s) == vertex[i]);
    CHECK(std::abs(s.x0 - expected[i][0] / 100) <= 1e-16);
    CHECK(std::abs(s.y0 - (expected[i][1] - 4) / 100) <= 1e-16);
    CHECK(std::abs(s.x1 - expected[i][2] / 100) <= 1e-16);
    CHECK(std::abs(s.y1 - (expected[i][3] - 4) / 100) <= 1e-16);
  }
}

TEST_CASE("a parallel view keeps u, and mixes height and depth by its elevation") {
  View view;
  view.projection = Projection::orthographic;
  view.y_per_v = 0.6;
  view.y_per_z = 0.8;
  std::vector<Segment> uprights, segments;
  project_profile(profile, 0, view, segments, uprights);
  REQUIRE(segments.size() == 3);
  CHECK(segments[1].x0 == 0);
  CHECK(segments[1].x1 == 20);
  CHECK(std::abs(segments[1].y0 - (5 * 0.8 + 100 * 0.6)) <= 1e-13);
  CHECK(std::abs(segments[1].y1 - (8 * 0.8 + 100 * 0.6)) <= 1e-13);
}

TEST_CASE("runs and uprights are what lies after the vertices, one by one") {
  for (std::uint64_t seed = 1; seed <= last_seed(3000); ++seed) {
    Random random(seed);
    INFO("seed " << seed);
    Profile made{50, {}, {}, {}, {}};
    const int count = random.whole(0, 12);
    for (int i = 0; i < count; ++i) {
      made.u_m.push_back(i);
      made.z_m.push_back(random.between(0, 9));
      made.after.push_back(i + 1 < count ? random.pick({Span::gap, Span::slope, Span::slope,
                                                        Span::level, Span::wall})
                                         : Span::gap);
    }
    View view;
    ProjectedProfile out;
    std::vector<Segment> uprights;
    project_profile(made, 3, view, out, uprights);
    // For each span, how often it lies in a run, and how often it is upright.
    std::vector<int> in_runs(made.size()), upright(made.size());
    std::uint32_t last = 0;
    for (const VertexRun& run : out.runs) {
      REQUIRE(run.first < run.last);
      REQUIRE(run.first >= last);
      REQUIRE(run.last < made.size());
      // As long as it can be.
      CHECK((run.first == 0 || made.after[run.first - 1] == Span::gap ||
             made.after[run.first - 1] == Span::wall));
      last = run.last;
      for (std::uint32_t i = run.first; i < run.last; ++i) ++in_runs[i];
    }
    for (const Segment& s : uprights) {
      const std::uint32_t i = left_vertex(s);
      ++upright[i];
      CHECK(s.y0 == out.y[i]);
      CHECK(s.y1 == out.y[i + 1]);
    }
    for (std::size_t i = 0; i < made.size(); ++i) {
      const bool ground = made.after[i] == Span::slope || made.after[i] == Span::level;
      CHECK(in_runs[i] == (ground ? 1 : 0));
      CHECK(upright[i] == (made.after[i] == Span::wall ? 1 : 0));
    }
  }
}

} // namespace orograph::project_profile_test
