// SPDX-License-Identifier: GPL-3.0-or-later
// Points only, by definition: vertices, hull, Delaunay, merging, order.
#include "dem/triangulate/triangulate.hpp"
#include "geometry/error.hpp"
#include "tests/catch.hpp"
#include "tests/dem/triangulate/whole_plane.hpp"

#include <limits>
#include <map>
#include <set>
#include <string>

namespace orograph::triangulate_test {
namespace {

void check_neighbours(const Tin& tin) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> runs; // edge -> triangle
  for (std::uint32_t t = 0; t < tin.triangles.size(); ++t)
    for (int k = 0; k < 3; ++k)
      REQUIRE(
          runs.emplace(std::pair(tin.triangles[t][k], tin.triangles[t][(k + 1) % 3]), t).second);
  REQUIRE(tin.neighbours.size() == tin.triangles.size());
  for (std::uint32_t t = 0; t < tin.triangles.size(); ++t)
    for (int k = 0; k < 3; ++k) {
      const auto& v = tin.triangles[t];
      const auto back = runs.find({v[(k + 2) % 3], v[(k + 1) % 3]});
      REQUIRE(tin.neighbours[t][k] == (back == runs.end() ? kNoTriangle : back->second));
    }
}

void check_delaunay(const Tin& tin) {
  for (std::uint32_t t = 0; t < tin.triangles.size(); ++t)
    for (int k = 0; k < 3; ++k) {
      const std::uint32_t next = tin.neighbours[t][k];
      if (next == kNoTriangle) continue;
      const auto& v = tin.triangles[t];
      for (const std::uint32_t beyond : tin.triangles[next]) {
        if (std::find(v.begin(), v.end(), beyond) != v.end()) continue;
        REQUIRE_FALSE(in_circle(whole(tin.vertices_m[v[0]]), whole(tin.vertices_m[v[1]]),
                                whole(tin.vertices_m[v[2]]), whole(tin.vertices_m[beyond])));
      }
    }
}

// Counterclockwise triangles that fit together and have the hull's area cover it once.
void check_triangulation(const std::vector<Vec3>& points) {
  const Triangulated result = triangulate({points, {}, {}, {}});
  const Tin& tin = result.tin;
  std::map<Whole, std::vector<double>> heights;
  for (const Vec3& p : points) heights[whole(p)].push_back(p.z);
  CHECK(result.counts.points == points.size());
  CHECK(result.counts.merged == points.size() - heights.size());

  REQUIRE(tin.vertices_m.size() == heights.size());
  double greatest = 0;
  for (const Vec3& v : tin.vertices_m) {
    const auto here = heights.find(whole(v));
    REQUIRE(here != heights.end());
    REQUIRE(v.x == double(here->first.x));
    REQUIRE(v.y == double(here->first.y));
    const auto [low, high] = std::minmax_element(here->second.begin(), here->second.end());
    double sum = 0;
    for (const double z : here->second) sum += z;
    if (*low == *high)
      CHECK(v.z == *low);
    else
      CHECK(std::abs(v.z - sum / double(here->second.size())) < 1e-9);
    greatest = std::max(greatest, *high - *low);
  }
  CHECK(result.counts.greatest_merged_m == greatest);

  std::vector<Whole> places;
  for (const auto& [place, z] : heights) places.push_back(place);
  std::int64_t area = 0;
  for (const auto& [a, b, c] : tin.triangles) {
    const std::int64_t here =
        doubled_area(whole(tin.vertices_m[a]), whole(tin.vertices_m[b]), whole(tin.vertices_m[c]));
    REQUIRE(here > 0);
    area += here;
  }
  CHECK(area == doubled_hull_area(places));
  check_neighbours(tin);
  check_delaunay(tin);
}

bool on_one_line(const std::vector<Vec3>& points) {
  for (const Vec3& a : points)
    for (const Vec3& b : points)
      if (doubled_area(whole(points[0]), whole(a), whole(b)) != 0) return false;
  return true;
}

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

TEST_CASE("the triangulation of points is Delaunay, over their hull, with each place a vertex") {
  Random random(1);
  for (int round = 0; round < rounds(2000); ++round) {
    const auto points = random_points(random, random.whole(3, 40), random.whole(1, 12));
    if (on_one_line(points))
      CHECK_THROWS(triangulate({points, {}, {}, {}}));
    else
      check_triangulation(points);
  }
  for (const int side : {3, 20, 1000, 30000})
    check_triangulation(random_points(random, 4000, side));
}

TEST_CASE("points on circles, lattices, lines and in clusters") {
  Random random(2);
  std::vector<Vec3> circle, lattice, lines, clusters;
  for (int x = -1105; x <= 1105; ++x) // 1105 = 5 * 13 * 17: 108 whole points on its circle
    for (int y = -1105; y <= 1105; ++y)
      if (x * x + y * y == 1105 * 1105) circle.push_back({double(x), double(y), random.share()});
  REQUIRE(circle.size() == 108);
  for (int x = 0; x < 50; ++x)
    for (int y = 0; y < 40; ++y) lattice.push_back({x * 3., y * 5., random.share()});
  for (int k = 0; k < 600; ++k) {
    lines.push_back({double(random.whole(-3000, 3000)), k % 2 * 7., 1});
    const double centre = random.whole(0, 3) * 100000.;
    clusters.push_back({centre + random.whole(0, 9), random.whole(0, 9) - centre / 2, 2});
  }
  for (auto* points : {&circle, &lattice, &lines, &clusters}) {
    shuffle(random, *points);
    check_triangulation(*points);
  }
  circle.push_back({0, 0, 7});
  check_triangulation(circle);
  lines.resize(1);
  for (int k = 0; k < 500; ++k) lines.push_back({k * 2., k * 3., 0});
  check_triangulation(lines);
}

TEST_CASE("far from the origin and very near to each other") {
  Random random(3);
  for (const double scale : {0x1p-40, 0x1p-23, 1., 1000.}) {
    const double shift = scale < 1 ? 0 : 1e9;
    Survey survey;
    std::vector<Whole> places;
    for (int k = 0; k < 300; ++k) {
      places.push_back({random.whole(0, 30), random.whole(0, 30)});
      survey.points_m.push_back(
          {shift + scale * double(places.back().x), scale * double(places.back().y) - shift, 5});
    }
    const Tin tin = triangulate(survey).tin;
    std::int64_t area = 0;
    const auto back = [&](std::uint32_t i) {
      const Vec3 p = tin.vertices_m[i];
      return Whole{std::llround((p.x - shift) / scale), std::llround((p.y + shift) / scale)};
    };
    for (const auto& [a, b, c] : tin.triangles) {
      const std::int64_t here = doubled_area(back(a), back(b), back(c));
      REQUIRE(here > 0);
      area += here;
    }
    CHECK(area == doubled_hull_area(places));
  }
}

TEST_CASE("the order of the points makes no difference, and neither does their sign of zero") {
  Random random(4);
  for (int round = 0; round < rounds(40); ++round) {
    Survey survey;
    survey.points_m = random_points(random, 200, 9);
    for (int k = 0; k < 10; ++k)
      survey.breaklines_m.push_back(random_points(random, random.whole(1, 4), 9));
    const Triangulated first = triangulate(survey);
    shuffle(random, survey.points_m);
    shuffle(random, survey.breaklines_m);
    for (auto& line : survey.breaklines_m)
      if (random.chance(0.5)) std::reverse(line.begin(), line.end());
    for (Vec3& p : survey.points_m)
      if (p.x == 0) p.x = random.pick({0.0, -0.0});
    CHECK(triangulate(survey).tin == first.tin);
  }
}

TEST_CASE("vertices and triangles near each other are near in memory") {
  Random random(5);
  Survey survey;
  for (int k = 0; k < 20000; ++k) survey.points_m.push_back({random.share(), random.share(), 0});
  const Tin tin = triangulate(survey).tin;
  double way = 0;
  for (std::size_t k = 1; k < tin.vertices_m.size(); ++k)
    way += length(tin.vertices_m[k] - tin.vertices_m[k - 1]);
  CHECK(way < 1.2 * std::sqrt(20000.));
  CHECK(std::is_sorted(tin.triangles.begin(), tin.triangles.end()));
  for (const auto& [a, b, c] : tin.triangles) REQUIRE(a < std::min(b, c));
}

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
  CHECK(complaint(survey) == "every triangle has an edge longer than 14.1 m: `max_edge_m` "
                             "14.15 is the least that keeps something");
  survey.max_edge_m = 14.15;
  CHECK(complaint(survey) == "");

  Random random(1);
  for (int round = 0; round < rounds(200); ++round) {
    Survey scattered{random_points(random, 30, 1000), {}, {}, {}};
    for (Vec3& p : scattered.points_m) p = std::pow(10, random.whole(-6, 5)) * p;
    scattered.max_edge_m = 1e-12;
    const std::string told = complaint(scattered);
    const std::size_t at = told.find("`max_edge_m` ");
    REQUIRE(at != std::string::npos);
    scattered.max_edge_m = std::stod(told.substr(at + 13));
    CHECK(complaint(scattered) == "");
    *scattered.max_edge_m *= 0.995;
    CHECK(complaint(scattered) != "");
  }
}

} // namespace orograph::triangulate_test
