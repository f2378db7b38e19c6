// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/triangulate/triangulate.hpp"
#include "geometry/error.hpp"
#include "tests/catch.hpp"
#include "tests/dem/triangulate/whole_plane.hpp"

#include <limits>
#include <string>

using namespace orograph;

namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

std::string complaint(const Survey& survey) {
  try {
    triangulate(survey);
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

Survey square() {
  return {{{0, 0, 1}, {10, 0, 2}, {10, 10, 3}, {0, 10, 4}}, {}, {}, {}};
}

} // namespace

TEST_CASE("too few places, or all on a line") {
  CHECK(complaint({}) ==
        "0 points at 0 different places make no triangle: three places at least, not on one line");
  CHECK(complaint({{{1, 1, 1}, {2, 2, 2}, {1, 1, 3}}, {{{2, 2, 0}}}, {}, {}}) ==
        "4 points at 2 different places make no triangle: three places at least, not on one line");
  Survey line;
  for (int k = 0; k < 1000; ++k) line.points_m.push_back({k * 3., k * 7., k * k * 1.});
  CHECK(complaint(line) == "all 1000 places are on one straight line: points beside it as well; "
                           "check which columns or axes are east and north");
  line.points_m.push_back({0, 1e-9, 0}); // nearly is another thing
  CHECK(complaint(line) == "");
}

TEST_CASE("nothing inside the boundary") {
  const std::string none =
      "no triangle is inside the boundary: a boundary around the points, in the "
      "same coordinates";
  Survey survey = square();
  survey.boundary = {{{{100, 100, kNone}, {120, 100, kNone}, {120, 120, kNone}}}};
  CHECK(complaint(survey) == none);
  survey.boundary = {{}}; // a ring of nothing, of one place, of two
  CHECK(complaint(survey) == none);
  survey.boundary = {{{{5, 5, kNone}}}};
  CHECK(complaint(survey) == none);
  survey.boundary = {{{{5, 5, kNone}, {6, 7, kNone}, {5, 5, kNone}}}};
  CHECK(complaint(survey) == none);
}

TEST_CASE("the least longest edge is told, and keeps something") {
  Survey survey = square();
  survey.max_edge_m = 14.1;
  CHECK(complaint(survey) == "every triangle has an edge longer than 14.1 m: --max-edge "
                             "14.15 is the least that keeps something");
  survey.max_edge_m = 14.15;
  CHECK(complaint(survey) == "");

  Random random(1);
  for (int round = 0; round < 200; ++round) {
    Survey scattered{random_points(random, 30, 1000), {}, {}, {}};
    for (Vec3& p : scattered.points_m) p = std::pow(10, random.whole(-6, 5)) * p;
    scattered.max_edge_m = 1e-12;
    const std::string told = complaint(scattered);
    const std::size_t at = told.find("--max-edge ");
    REQUIRE(at != std::string::npos);
    scattered.max_edge_m = std::stod(told.substr(at + 11));
    CHECK(complaint(scattered) == "");
    *scattered.max_edge_m *= 0.995;
    CHECK(complaint(scattered) != "");
  }
}
