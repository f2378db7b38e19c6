// SPDX-License-Identifier: GPL-3.0-or-later
// Breaklines by definition, against every pair of segments. Coordinates are whole and small, so
// that places that differ at all are much farther apart than the tolerance.
#include "dem/mesh/verify_tin.hpp"
#include "dem/triangulate/triangulate.hpp"
#include "tests/catch.hpp"
#include "tests/dem/triangulate/whole_plane.hpp"

#include <map>
#include <set>
#include <string>

namespace orograph::triangulate_lines_test {
namespace {

constexpr double kTolerance = 1e-9;

struct Straight {
  Vec3 from, to;
  Vec2 at(double share) const {
    return {from.x + share * (to.x - from.x), from.y + share * (to.y - from.y)};
  }
  double share_of(Vec2 p) const {
    const Vec2 along{to.x - from.x, to.y - from.y};
    return dot(p - Vec2{from.x, from.y}, along) / dot(along, along);
  }
  bool holds(Vec2 p) const {
    return length(p - at(std::clamp(share_of(p), 0.0, 1.0))) < kTolerance;
  }
  double height_m(Vec2 p) const { return from.z + share_of(p) * (to.z - from.z); }
};

// Rule (1), in its own words.
std::map<Whole, double> heights_of(const Survey& survey) {
  std::map<Whole, std::pair<double, int>> of_points, of_lines;
  const auto add = [](auto& sums, const Vec3& p) {
    sums[whole(p)].first += p.z;
    ++sums[whole(p)].second;
  };
  for (const Vec3& p : survey.points_m) add(of_points, p);
  for (const auto& line : survey.breaklines_m)
    for (const Vec3& p : line) add(of_lines, p);
  std::map<Whole, double> heights;
  for (const auto* sums : {&of_points, &of_lines})
    for (const auto& [place, sum] : *sums) heights[place] = sum.first / sum.second;
  return heights;
}

// Each once, whatever its direction.
std::vector<Straight> segments_of(const Survey& survey, const std::map<Whole, double>& heights) {
  std::set<std::pair<Whole, Whole>> pairs;
  for (const auto& line : survey.breaklines_m)
    for (std::size_t k = 1; k < line.size(); ++k) {
      const Whole a = whole(line[k - 1]), b = whole(line[k]);
      if (a != b) pairs.insert({std::min(a, b), std::max(a, b)});
    }
  std::vector<Straight> all;
  for (const auto& [a, b] : pairs)
    all.push_back(
        {{double(a.x), double(a.y), heights.at(a)}, {double(b.x), double(b.y), heights.at(b)}});
  return all;
}

// Where segments cross, away from given places.
std::vector<Vec2> crossings_of(const std::vector<Straight>& all,
                               const std::map<Whole, double>& heights) {
  std::vector<Vec2> places;
  for (const Straight& a : all)
    for (const Straight& b : all) {
      const Vec2 u{a.to.x - a.from.x, a.to.y - a.from.y}, v{b.to.x - b.from.x, b.to.y - b.from.y};
      if (cross(u, v) == 0) continue;
      const Vec2 p = a.at(cross(Vec2{b.from.x - a.from.x, b.from.y - a.from.y}, v) / cross(u, v));
      const auto is_here = [&](Vec2 q) { return length(p - q) < kTolerance; };
      if (!a.holds(p) || !b.holds(p) || std::any_of(places.begin(), places.end(), is_here) ||
          std::any_of(heights.begin(), heights.end(), [&](const auto& given) {
            return is_here({double(given.first.x), double(given.first.y)});
          }))
        continue;
      places.push_back(p);
    }
  return places;
}

void check_covered(const Straight& segment, const Tin& tin) {
  std::vector<std::pair<double, double>> parts;
  for (const auto& t : tin.triangles)
    for (int k = 0; k < 3; ++k) {
      const Vec3 a = tin.vertices_m[t[k]], b = tin.vertices_m[t[(k + 1) % 3]];
      if (!segment.holds({a.x, a.y}) || !segment.holds({b.x, b.y})) continue;
      const double from = segment.share_of({a.x, a.y}), to = segment.share_of({b.x, b.y});
      parts.emplace_back(std::min(from, to), std::max(from, to));
    }
  std::sort(parts.begin(), parts.end());
  double covered = 0;
  for (const auto& [from, to] : parts) {
    REQUIRE(from <= covered + kTolerance);
    covered = std::max(covered, to);
  }
  REQUIRE(covered >= 1 - kTolerance);
}

void check_delaunay_off_lines(const Tin& tin, const std::vector<Straight>& all) {
  const auto at = [&](std::uint32_t v) { return Vec2{tin.vertices_m[v].x, tin.vertices_m[v].y}; };
  for (std::uint32_t t = 0; t < tin.triangles.size(); ++t)
    for (int k = 0; k < 3; ++k) {
      if (tin.neighbours[t][k] == kNoTriangle) continue;
      const auto& v = tin.triangles[t];
      const Vec2 a = at(v[(k + 1) % 3]), b = at(v[(k + 2) % 3]);
      if (std::any_of(all.begin(), all.end(),
                      [&](const Straight& s) { return s.holds(a) && s.holds(b); }))
        continue;
      for (const std::uint32_t w : tin.triangles[tin.neighbours[t][k]])
        if (std::find(v.begin(), v.end(), w) == v.end())
          REQUIRE_FALSE(in_circle(whole(tin.vertices_m[v[0]]), whole(tin.vertices_m[v[1]]),
                                  whole(tin.vertices_m[v[2]]), whole(tin.vertices_m[w])));
    }
}

void check_triangulation(const Survey& survey) {
  const Triangulated result = triangulate(survey);
  const Tin& tin = result.tin;
  const auto fault = verify(tin);
  INFO((fault ? fault->what : ""));
  REQUIRE_FALSE(fault);
  const auto heights = heights_of(survey);
  const auto all = segments_of(survey, heights);
  const auto crossings = crossings_of(all, heights);

  CHECK(result.counts.crossings == crossings.size());
  REQUIRE(tin.vertices_m.size() == heights.size() + crossings.size());
  std::size_t given = 0;
  double greatest = 0;
  for (const Vec3& v : tin.vertices_m) {
    const auto here = heights.find(whole(v));
    if (here != heights.end() && v.x == double(here->first.x) && v.y == double(here->first.y)) {
      CHECK(std::abs(v.z - here->second) < kTolerance);
      ++given;
      continue;
    }
    REQUIRE(std::any_of(crossings.begin(), crossings.end(), [&](Vec2 p) {
      return length(p - Vec2{v.x, v.y}) < kTolerance;
    }));
    std::vector<double> own;
    for (const Straight& segment : all)
      if (segment.holds({v.x, v.y})) own.push_back(segment.height_m({v.x, v.y}));
    double sum = 0;
    for (const double z : own) sum += z;
    CHECK(std::abs(v.z - sum / double(own.size())) < kTolerance);
    const auto [low, high] = std::minmax_element(own.begin(), own.end());
    greatest = std::max(greatest, *high - *low);
  }
  CHECK(given == heights.size());
  CHECK(std::abs(result.counts.greatest_crossing_m - greatest) < kTolerance);

  std::vector<Whole> places;
  for (const auto& [place, z] : heights) places.push_back(place);
  double area = 0;
  for (const auto& [a, b, c] : tin.triangles) {
    const Vec3 p = tin.vertices_m[a], u = tin.vertices_m[b] - p, v = tin.vertices_m[c] - p;
    area += u.x * v.y - u.y * v.x;
  }
  CHECK(std::abs(area - double(doubled_hull_area(places))) < kTolerance);
  for (const Straight& segment : all) check_covered(segment, tin);
  if (crossings.empty()) check_delaunay_off_lines(tin, all);
}

bool on_one_line(const std::vector<Vec3>& points) {
  return std::all_of(points.begin(), points.end(), [&](const Vec3& a) {
    return std::all_of(points.begin(), points.end(), [&](const Vec3& b) {
      return doubled_area(whole(points[0]), whole(a), whole(b)) == 0;
    });
  });
}

} // namespace

TEST_CASE(
    "every stretch of a breakline is an edge, crossings are vertices with the lines' height") {
  Random random(1);
  for (int round = 0; round < rounds(700); ++round) {
    const int side = random.whole(2, 15);
    Survey survey{random_points(random, random.whole(3, 25), side), {}, {}, {}};
    if (on_one_line(survey.points_m)) continue;
    const int lines = random.whole(1, 6);
    for (int k = 0; k < lines; ++k)
      survey.breaklines_m.push_back(random_points(random, random.whole(0, 5), side));
    if (random.chance(0.3)) survey.breaklines_m.push_back(survey.breaklines_m.front()); // again
    if (random.chance(0.3)) { // there and back, from one of the points
      const Vec3 a = survey.points_m[0], b = survey.points_m[1];
      survey.breaklines_m.push_back({a, a, b, b, a});
    }
    check_triangulation(survey);
  }
}

TEST_CASE("where many lines meet at one place that no double is, there is one vertex") {
  Random random(5);
  for (int round = 0; round < rounds(40); ++round) {
    const int side = random.whole(3, 6);
    Survey survey{{{-9, -9, 0}, {9, -8, 0}, {8, 9, 0}}, {}, {}, {}};
    for (int k = 0; k < 25; ++k) survey.breaklines_m.push_back(random_points(random, 2, side));
    check_triangulation(survey);
  }
}

TEST_CASE("breaklines that don't cross leave the rest Delaunay") {
  Random random(2);
  for (int round = 0; round < rounds(500); ++round) {
    Survey survey{random_points(random, random.whole(3, 60), 12), {}, {}, {}};
    if (on_one_line(survey.points_m)) continue;
    survey.breaklines_m = {random_points(random, 2, 12)};
    check_triangulation(survey);
  }
}

TEST_CASE("breaklines that overlap along a stretch, touch, and pass through points") {
  const std::vector<Vec3> corners{{0, 0, 0}, {12, 0, 0}, {12, 12, 0}, {0, 12, 0}};
  check_triangulation({corners, {{{1, 3, 1}, {9, 3, 2}}, {{4, 3, 5}, {11, 3, 6}}}, {}, {}});
  check_triangulation({corners, {{{1, 3, 1}, {9, 3, 2}}, {{5, 3, 5}, {5, 9, 6}}}, {}, {}});
  check_triangulation({corners, {{{0, 0, 1}, {12, 12, 2}}, {{12, 0, 3}, {0, 12, 4}}}, {}, {}});
  check_triangulation(
      {corners, {{{0, 0, 1}, {12, 12, 2}, {12, 0, 3}, {0, 12, 4}, {0, 0, 9}}}, {}, {}});
  check_triangulation({corners, {{{-5, 6, 1}, {20, 6, 2}}, {{12, -3, 0}, {12, 20, 4}}}, {}, {}});
  check_triangulation({corners, {{}, {{3, 3, 8}}, {{4, 4, 1}, {4, 4, 3}}}, {}, {}});
  // Lines alone; three through one place.
  check_triangulation({{}, {{{0, 0, 1}, {7, 1, 2}}, {{0, 1, 3}, {7, 0, 4}}}, {}, {}});
  check_triangulation(
      {{}, {{{0, 0, 1}, {10, 10, 2}}, {{0, 10, 3}, {10, 0, 4}}, {{5, 0, 5}, {5, 11, 9}}}, {}, {}});
}

TEST_CASE("where two lines cross the height is their mean, to the last bit where they agree") {
  const Triangulated result =
      triangulate({{}, {{{0, 0, 10}, {3, 1, 10}}, {{0, 1, 10}, {3, 0, 10}}}, {}, {}});
  CHECK(result.counts.crossings == 1);
  CHECK(result.counts.greatest_crossing_m == 0);
  CHECK(result.counts.breaklines == 2);
  CHECK(result.counts.points == 4);
  for (const Vec3& v : result.tin.vertices_m) CHECK(v.z == 10);
}

TEST_CASE("lines that differ by a few units in the last place make a valid TIN") {
  Random random(3);
  for (int round = 0; round < rounds(300); ++round) {
    const int side = random.whole(2, 40), lines = random.whole(3, 40);
    const double step =
        0x1p-23 * (round % 2 ? 1 : 1e6); // one unit at 1e9, or much longer than wide
    Survey survey{{}, {}, {}, {}};
    for (int k = 0; k < lines; ++k) {
      auto& line = survey.breaklines_m.emplace_back();
      for (int end = 0; end < 2; ++end)
        line.push_back({1e9 + step * random.whole(0, side), 1e9 + 0x1p-23 * random.whole(0, side),
                        random.share()});
    }
    try {
      CHECK_FALSE(verify(triangulate(survey).tin));
    } catch (const std::runtime_error& error) {
      CHECK(std::string(error.what()).find("on one straight line") != std::string::npos);
    }
  }
}

TEST_CASE("many lines through one place, or nearly the same line, split at few vertices") {
  Random random(4);
  Survey star, bundle;
  for (int k = 0; k < 120; ++k) {
    const double angle = random.between(0, 7), far_m = 100;
    star.breaklines_m.push_back({{7 + far_m * std::cos(angle), 3 + far_m * std::sin(angle), 1},
                                 {7 - far_m * std::cos(angle), 3 - far_m * std::sin(angle), 1}});
    const auto off = [&] { return random.between(0, 1e-12); };
    bundle.breaklines_m.push_back({{0, off(), 1}, {1000, 1000 + off(), 1}});
  }
  const Triangulated met = triangulate(star);
  CHECK_FALSE(verify(met.tin));
  CHECK(met.counts.crossings == 1);
  CHECK_FALSE(verify(triangulate(bundle).tin));
}

} // namespace orograph::triangulate_lines_test
