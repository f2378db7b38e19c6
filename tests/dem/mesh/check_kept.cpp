// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/dem/mesh/check_kept.hpp"

#include "dem/mesh/verify_tin.hpp"
#include "tests/catch.hpp"
#include "tests/support/half_spaces.hpp"

#include <algorithm>
#include <set>
#include <vector>

namespace orograph {
namespace {

double scale_m(const Tin& tin) {
  double greatest = 1;
  for (const Vec3& v : tin.vertices_m)
    greatest = std::max({greatest, std::abs(v.x), std::abs(v.y), std::abs(v.z)});
  return greatest;
}

std::vector<LongPoint> corners(const Tin& tin, std::size_t t) {
  std::vector<LongPoint> points;
  for (const std::uint32_t v : tin.triangles[t]) points.push_back(long_point(tin.vertices_m[v]));
  return points;
}

void check_areas(const Tin& tin, std::span<const HalfSpace> spaces, const Tin& kept, double band) {
  Areas expected, got;
  long double doubtful = 0, length = 0;
  for (std::size_t t = 0; t < tin.triangles.size(); ++t) {
    const std::vector<LongPoint> whole = corners(tin, t);
    const Areas part = areas_of(part_within(whole, spaces));
    expected.in_plan += part.in_plan;
    expected.in_space += part.in_space;
    for (const HalfSpace& space : spaces)
      if (std::all_of(whole.begin(), whole.end(),
                      [&](LongPoint p) { return std::abs(metres_beyond(space, p)) < band; }))
        doubtful += areas_of(whole).in_space;
    for (std::size_t k = 0; k < 3; ++k) {
      const LongPoint p = whole[k], q = whole[(k + 1) % 3];
      length += std::hypot(p.x - q.x, p.y - q.y, p.z - q.z);
    }
  }
  for (std::size_t t = 0; t < kept.triangles.size(); ++t) {
    const Areas part = areas_of(corners(kept, t));
    got.in_plan += part.in_plan;
    got.in_space += part.in_space;
  }
  CAPTURE(static_cast<double>(expected.in_space), static_cast<double>(got.in_space));
  REQUIRE(std::abs(expected.in_plan - got.in_plan) <= band * length + doubtful);
  REQUIRE(std::abs(expected.in_space - got.in_space) <= band * length + doubtful);
}

// By more than `band` outside of an edge: below 0; inside of all: above 0.
int place_in(const Tin& tin, std::size_t t, LongPoint p, long double band) {
  const std::vector<LongPoint> c = corners(tin, t);
  if (areas_of(c).in_plan <= 0) return -1;
  bool inside = true;
  for (std::size_t k = 0; k < 3; ++k) {
    const LongPoint a = c[k], b = c[(k + 1) % 3];
    const long double left =
        ((b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x)) / std::hypot(b.x - a.x, b.y - a.y);
    if (left < -band) return -1;
    inside = inside && left > band;
  }
  return inside ? 1 : 0;
}

long double height_at(const Tin& tin, std::size_t t, LongPoint p) {
  const std::vector<LongPoint> c = corners(tin, t);
  const auto twice = [&](LongPoint a, LongPoint b) {
    return (a.x - p.x) * (b.y - p.y) - (a.y - p.y) * (b.x - p.x);
  };
  const long double u = twice(c[1], c[2]), v = twice(c[2], c[0]), w = twice(c[0], c[1]);
  return (u * c[0].z + v * c[1].z + w * c[2].z) / (u + v + w);
}

// Points of the old surface are there or not; and points of the kept one were.
void check_points(const Tin& tin, std::span<const HalfSpace> spaces, const Tin& kept, double band,
                  Random& random, KeptSums& sums) {
  const auto any_point = [&](const Tin& of, std::size_t t) {
    const auto& [i, j, k] = of.triangles[t];
    const double a = random.between(0.05, 0.55), b = random.between(0.05, 0.4);
    const Vec3 o = of.vertices_m[i];
    return o + a * (of.vertices_m[j] - o) + b * (of.vertices_m[k] - o);
  };
  const auto covering = [&](const Tin& of, LongPoint p) {
    int most = -1;
    for (std::size_t t = 0; t < of.triangles.size(); ++t) {
      const int place = place_in(of, t, p, band);
      if (place > 0) REQUIRE(std::abs(height_at(of, t, p) - p.z) <= 50 * band);
      most = std::max(most, place);
    }
    return most;
  };
  for (std::size_t t = 0; t < tin.triangles.size(); ++t) {
    const LongPoint p = long_point(any_point(tin, t));
    if (place_in(tin, t, p, 4 * band) <= 0) continue;
    const long double by = metres_beyond(spaces, p);
    if (std::abs(by) <= 4 * band) continue;
    ++sums.asked;
    sums.within += by < 0;
    const int place = covering(kept, p);
    REQUIRE((by < 0 ? place >= 0 : place <= 0));
  }
  for (std::size_t t = 0; t < kept.triangles.size(); ++t) {
    for (const LongPoint p : corners(kept, t)) REQUIRE(metres_beyond(spaces, p) <= band);
    const LongPoint p = long_point(any_point(kept, t));
    if (place_in(kept, t, p, 4 * band) <= 0) continue;
    REQUIRE(covering(tin, p) >= 0);
  }
}

long double distance(LongPoint p, LongPoint a, LongPoint b) {
  const long double x = b.x - a.x, y = b.y - a.y, z = b.z - a.z;
  const long double along =
      ((p.x - a.x) * x + (p.y - a.y) * y + (p.z - a.z) * z) / (x * x + y * y + z * z);
  const long double s = std::clamp(along, 0.0L, 1.0L);
  return std::hypot(a.x + s * x - p.x, a.y + s * y - p.y, a.z + s * z - p.z);
}

// New border lies on planes: pieces share their vertices.
void check_border(const Tin& tin, std::span<const HalfSpace> spaces, const Tin& kept, double band) {
  std::vector<std::array<LongPoint, 2>> border;
  for (std::size_t t = 0; t < tin.triangles.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k)
      if (tin.neighbours[t][k] == kNoTriangle)
        border.push_back({corners(tin, t)[(k + 1) % 3], corners(tin, t)[(k + 2) % 3]});
  for (std::size_t t = 0; t < kept.triangles.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k) {
      if (kept.neighbours[t][k] != kNoTriangle) continue;
      const LongPoint p = corners(kept, t)[(k + 1) % 3], q = corners(kept, t)[(k + 2) % 3];
      const bool cut = std::any_of(spaces.begin(), spaces.end(), [&](const HalfSpace& space) {
        return std::abs(metres_beyond(space, p)) <= band &&
               std::abs(metres_beyond(space, q)) <= band;
      });
      const bool old = std::any_of(border.begin(), border.end(), [&](const auto& edge) {
        return distance(p, edge[0], edge[1]) <= band && distance(q, edge[0], edge[1]) <= band;
      });
      CAPTURE(t, k);
      REQUIRE((cut || old));
    }
}

// Triangles well within are there as they were, in their order, and their vertices in theirs.
void check_whole_triangles(const Tin& tin, std::span<const HalfSpace> spaces, const Tin& kept,
                           double band) {
  const auto key = [](const Tin& of, std::size_t t) {
    const auto& [i, j, k] = of.triangles[t];
    return std::array{of.vertices_m[i], of.vertices_m[j], of.vertices_m[k]};
  };
  bool walls = false;
  for (std::size_t t = 0; t < tin.triangles.size(); ++t)
    walls = walls || areas_of(corners(tin, t)).in_plan == 0;
  std::size_t next = 0;
  std::vector<std::array<std::uint32_t, 2>> numbers; // of vertices: old and new
  for (std::size_t t = 0; t < tin.triangles.size(); ++t) {
    const auto c = corners(tin, t);
    if (std::any_of(c.begin(), c.end(),
                    [&](LongPoint p) { return metres_beyond(spaces, p) > -band; }))
      continue;
    std::size_t found = next;
    while (found < kept.triangles.size() && key(kept, found) != key(tin, t)) ++found;
    if (walls && found == kept.triangles.size()) continue; // beside a wall that is cut
    REQUIRE(found < kept.triangles.size());
    next = found + 1;
    for (std::size_t k = 0; k < 3; ++k)
      numbers.push_back({tin.triangles[t][k], kept.triangles[found][k]});
  }
  std::sort(numbers.begin(), numbers.end());
  for (std::size_t i = 1; i < numbers.size(); ++i) {
    if (numbers[i][0] == numbers[i - 1][0])
      REQUIRE(numbers[i][1] == numbers[i - 1][1]);
    else
      REQUIRE(numbers[i][1] > numbers[i - 1][1]);
  }
}

} // namespace

void check_kept(const Tin& tin, const Tin& kept, std::span<const HalfSpace> spaces, Random& random,
                KeptSums& sums) {
  const double band = 1e-12 * scale_m(tin);
  ++sums.scenes;
  sums.kept += !kept.triangles.empty();
  sums.cut += !kept.triangles.empty() && kept.triangles.size() != tin.triangles.size();
  for (std::size_t t = 0; t < kept.triangles.size(); ++t)
    sums.walls += areas_of(corners(kept, t)).in_plan == 0;
  if (!kept.triangles.empty()) {
    const auto fault = verify(kept);
    INFO((fault ? fault->what : ""));
    REQUIRE_FALSE(fault);
  }
  std::set<std::uint32_t> used;
  for (const auto& triangle : kept.triangles) used.insert(triangle.begin(), triangle.end());
  REQUIRE(used.size() == kept.vertices_m.size());
  check_areas(tin, spaces, kept, 20 * band);
  check_points(tin, spaces, kept, 20 * band, random, sums);
  check_border(tin, spaces, kept, 20 * band);
  check_whole_triangles(tin, spaces, kept, 20 * band);
}

} // namespace orograph
