// SPDX-License-Identifier: GPL-3.0-or-later
// Lines of all levels together make the tone that is asked for, at distances near the one asked
// for.
#include "tests/catch.hpp"
#include "tests/support/random.hpp"

#include <cmath>
#include <limits>
#include <vector>

#include "tone/line_widths.hpp"

namespace orograph::line_widths_test {
namespace {

constexpr std::size_t kColumns = 60;
const PageColumns kPage{-1, 0.05, kColumns, 0.5};

ToneRequest made_request(Random& random, bool has_light) {
  ToneRequest request;
  request.spacing_mm = random.between(0.3, 2);
  request.pen_width_mm = 0.25 * request.spacing_mm;
  request.least_width_mm = 0.5 * request.pen_width_mm;
  request.greatest_width_mm = 2 * request.pen_width_mm;
  if (has_light) request.light = GroundLight{{0, 0, 1}, 0.125, 0.5};
  return request;
}

// What is drawn of the lines of all levels on even ground: a share of the finest lines has each
// level.
struct EvenGround {
  double darkness = 0;
  double distance_mm = 0;
};

EvenGround drawn_on(const ToneRequest& request, double planned_mm, int halvings, double darkness) {
  const std::vector<float> planned(kColumns, static_cast<float>(std::log2(planned_mm))),
      dark(kColumns, static_cast<float>(darkness));
  const double finest_mm = std::ldexp(planned_mm, -halvings);
  double ink_mm = 0, share_drawn = 0;
  for (int level = -halvings; level < 40; ++level) {
    const LinePlace line{level, halvings, planned,
                         request.light ? std::span<const float>(dark) : std::span<const float>()};
    const std::vector<ToneRun> runs = runs_of_line(line, kPage, request);
    CHECK(runs.size() <= 1); // all along, or nowhere
    if (runs.empty()) continue;
    CHECK(runs.front().x_begin == kPage.edge(0));
    CHECK(runs.front().x_end == kPage.edge(kColumns));
    const double share = std::ldexp(1.0, -(level + halvings) - 1);
    share_drawn += share;
    ink_mm += share * runs.front().width_mm;
  }
  return {ink_mm / finest_mm, finest_mm / share_drawn};
}

} // namespace

TEST_CASE("without light lines on even ground are within half an octave of the spacing") {
  for (std::uint64_t seed = 1; seed <= last_seed(3000); ++seed) {
    Random random(seed);
    const ToneRequest request = made_request(random, false);
    const int halvings = random.whole(0, 5);
    // As fine as is planned, and much finer.
    const double planned_mm =
        std::ldexp(request.spacing_mm, halvings) * std::exp2(random.between(-6, 0.5));
    INFO("seed " << seed);
    const EvenGround drawn = drawn_on(request, planned_mm, halvings, 0);
    // Levels end at 40, so shares are short of 1 by 2^-35; planned distances are floats.
    CHECK(drawn.distance_mm < std::sqrt(2) * request.spacing_mm * (1 + 1e-6));
    CHECK(drawn.distance_mm > request.spacing_mm / std::sqrt(2) * (1 - 1e-6));
  }
}

TEST_CASE("lines that carry light make the darkness asked for, to a step of width") {
  for (std::uint64_t seed = 1; seed <= last_seed(3000); ++seed) {
    Random random(seed);
    const ToneRequest request = made_request(random, true);
    const int halvings = random.whole(0, 5);
    const double planned_mm =
        std::ldexp(request.spacing_mm, halvings) * std::exp2(random.between(-6, 0.3));
    const double darkness = random.between(0.13, 0.35);
    INFO("seed " << seed << ", darkness " << darkness);
    const EvenGround drawn = drawn_on(request, planned_mm, halvings, darkness);
    // A width is rounded by a twentieth. What the pen's least makes too dark, where a line of half
    // the spacing would be thinner, those beside it don't take back, and neither do they what its
    // greatest leaves out.
    CHECK(drawn.darkness < 1.05 * std::max(darkness, 0.125 * std::sqrt(2)));
    CHECK(drawn.darkness > 0.95 * darkness);
    CHECK(drawn.distance_mm < std::sqrt(2) * request.spacing_mm * (1 + 1e-6));
    CHECK(drawn.distance_mm > 0.5 * request.spacing_mm);
  }
}

TEST_CASE("by density the darkness asked for comes of lines' distances, with one pen") {
  for (std::uint64_t seed = 1; seed <= last_seed(1000); ++seed) {
    Random random(seed);
    ToneRequest request = made_request(random, true);
    request.light->shown_by = LightShownBy::density;
    const double darkness = random.between(0.1, 0.5);
    const double planned_mm = request.pen_width_mm / darkness * std::exp2(random.between(-6, 0.5));
    const EvenGround drawn = drawn_on(request, planned_mm, 0, darkness);
    CHECK(drawn.darkness < std::sqrt(2) * darkness * 1.000001);
    CHECK(drawn.darkness > darkness / std::sqrt(2) / 1.000001);
  }
}

TEST_CASE("whole profiles are drawn from one end to the other, as wide as light wants") {
  ToneRequest request;
  request.is_even = false;
  request.spacing_mm = 0.6;
  request.pen_width_mm = 0.15;
  request.least_width_mm = 0.05;
  request.greatest_width_mm = 1;
  request.light = GroundLight{{0, 0, 1}, 0, 1};
  std::vector<float> planned(kColumns, 1), dark(kColumns, 0.1F);
  for (std::size_t i = 20; i < kColumns; ++i) dark[i] = 0.4F;
  for (std::size_t i = 30; i < 40; ++i) planned[i] = std::numeric_limits<float>::quiet_NaN();
  const std::vector<ToneRun> runs = runs_of_line({0, 0, planned, dark}, kPage, request);
  REQUIRE(runs.size() == 2);
  CHECK(runs[0].x_begin == kPage.edge(0));
  CHECK(runs[0].x_end == kPage.edge(20));
  CHECK(runs[1].x_begin == kPage.edge(20)); // they touch
  CHECK(runs[1].x_end == kPage.edge(kColumns));
  // To half a step of a tenth.
  CHECK(std::abs(runs[0].width_mm / 0.2 - 1) < 0.05);
  CHECK(std::abs(runs[1].width_mm / 0.8 - 1) < 0.05);
}

TEST_CASE("breaks of less than 1.5 mm are bridged, lines of less than 2 mm left out") {
  ToneRequest request;
  request.spacing_mm = request.pen_width_mm = request.least_width_mm = request.greatest_width_mm =
      1;
  for (std::size_t length = 1; length <= 8; ++length)
    for (const bool drawn : {true, false}) {
      // Of level 0, drawn where planned lines are farther apart than the spacing.
      std::vector<float> planned(kColumns, drawn ? -1.7F : 0.3F);
      for (std::size_t i = 30; i < 30 + length; ++i) planned[i] = drawn ? 0.3F : -1.7F;
      const std::vector<ToneRun> runs = runs_of_line({0, 0, planned, {}}, kPage, request);
      const double mm = 0.5 * static_cast<double>(length);
      INFO(mm << " mm");
      if (drawn)
        CHECK(runs.size() == (mm < 2 ? 0 : 1));
      else
        CHECK(runs.size() == (mm < 1.5 ? 1 : 2));
    }
}

TEST_CASE("nothing is drawn where nothing is seen, but a column beside what is") {
  ToneRequest request;
  request.spacing_mm = request.pen_width_mm = request.least_width_mm = request.greatest_width_mm =
      1;
  std::vector<float> planned(kColumns, std::numeric_limits<float>::quiet_NaN());
  CHECK(runs_of_line({0, 0, planned, {}}, kPage, request).empty());
  for (std::size_t i = 10; i < 20; ++i) planned[i] = 1;
  const std::vector<ToneRun> runs = runs_of_line({0, 0, planned, {}}, kPage, request);
  REQUIRE(runs.size() == 1);
  CHECK(runs.front().x_begin == kPage.edge(9));
  CHECK(runs.front().x_end == kPage.edge(21));
}

} // namespace orograph::line_widths_test
