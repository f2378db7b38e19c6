// SPDX-License-Identifier: GPL-3.0-or-later
// The cut of a grid on the ellipsoid: bit for bit that of the TIN of its triangles, and every
// triangle's section by the plane, on its own, in long double.
#include "dem/approximate/tin_of_grid.hpp"
#include "dem/extent.hpp"
#include "profiles/cut_earth_grid.hpp"
#include "profiles/cut_mesh.hpp"
#include "tests/catch.hpp"
#include "tests/profiles/compare_parts.hpp"
#include "tests/profiles/tin_sections.hpp"
#include "tests/profiles/triangle_cuts.hpp"
#include "tests/support/made_earth_grid.hpp"
#include "tests/support/random.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <span>
#include <utility>
#include <vector>

namespace orograph::cut_earth_grid_test {
namespace {

// Along an axis of the frame or anywhere; of a perspective view's frame the drop alone matters.
View random_view(Random& random, const Grid& grid) {
  const Vec2 forward = random.chance(0.4)
                           ? random.pick({Vec2{0, 1}, Vec2{1, 0}, Vec2{0, -1}, Vec2{-1, 0}})
                           : direction_of_azimuth(Angle::degrees(random.between(0, 360)));
  Vec2 origin;
  if (random.chance(0.2)) {
    const Vec3 vertex =
        grid.earth().vertex_m(random.whole(0, grid.columns - 1), random.whole(0, grid.rows - 1), 0);
    origin = {vertex.x, vertex.y};
  }
  View view = looking(forward, origin);
  if (random.chance(0.3)) {
    view.projection = Projection::perspective;
    view.drop = drop_in_frame({-1e-8, -1.2e-8}, forward);
  }
  return view;
}

// The same triangles, some of them level, by the grid's numbers and by the TIN's.
struct LevelTriangles {
  TriangleSet of_grid, of_tin;
};
LevelTriangles some_level(Random& random, const Grid& grid) {
  LevelTriangles level;
  if (random.chance(0.4)) return level;
  const std::vector<GridTriangle> triangles = triangles_of(grid);
  level = {TriangleSet(grid_triangle_count(grid)), TriangleSet(triangles.size())};
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    if (random.chance(0.5)) continue;
    level.of_grid.add(
        grid_triangle(grid, triangles[i].column, triangles[i].row, triangles[i].half));
    level.of_tin.add(i);
  }
  return level;
}

struct DepthRange {
  double nearest = kInfinity, farthest = -kInfinity;
};
DepthRange depths_of(const Grid& grid, const View& view) {
  DepthRange range;
  for (const GridTriangle& t : triangles_of(grid))
    for (const std::uint32_t v : t.vertices) {
      const double depth = to_profile_frame(view, grid.vertex_m(v)).v;
      range.nearest = std::min(range.nearest, depth);
      range.farthest = std::max(range.farthest, depth);
    }
  return range;
}

// Anywhere, through vertices and a rounding beside them, at both ends and beyond, and at the
// frame's own axes, where a whole row or column may lie.
std::vector<double> depths_to_cut(Random& random, const Grid& grid, const View& view,
                                  const DepthRange& range) {
  const auto [near, far] = range;
  std::vector<double> depths{near,
                             far,
                             std::nextafter(near, kInfinity),
                             std::nextafter(near, -kInfinity),
                             std::nextafter(far, kInfinity),
                             std::nextafter(far, -kInfinity),
                             near - 1,
                             far + 1,
                             0,
                             std::nan("")};
  const std::vector<GridTriangle> triangles = triangles_of(grid);
  for (int i = 0; i < 6; ++i) {
    const auto& t = triangles[static_cast<std::size_t>(
        random.whole(0, static_cast<int>(triangles.size()) - 1))];
    const double vertex =
        to_profile_frame(view, grid.vertex_m(t.vertices[static_cast<std::size_t>(i % 3)])).v;
    depths.insert(depths.end(), {vertex, std::nextafter(vertex, near), std::nextafter(vertex, far),
                                 random.between(near, far)});
  }
  return depths;
}

bool are_same(const std::vector<double>& a, const std::vector<double>& b) {
  const auto bits = [](double x) { return std::bit_cast<std::uint64_t>(x); };
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [&](double x, double y) { return bits(x) == bits(y); });
}

std::shared_ptr<const BorderPlaces> places_of(const Grid& grid) {
  return std::make_shared<const BorderPlaces>(border_places(grid, border_edges(grid, false)));
}

struct Compared {
  std::size_t grids = 0, leaning = 0, profiles = 0, vertices = 0, level = 0, gaps = 0, empty = 0;
};

void compare(Random& random, const Grid& grid, Compared& sum) {
  const Tin tin = tin_of(grid);
  const View view = random_view(random, grid);
  const LevelTriangles level = some_level(random, grid);
  const EarthGridCutter of_grid(grid, view, level.of_grid, places_of(grid));
  const TinCutter of_tin(tin, view, level.of_tin);
  const DepthRange range = depths_of(grid, view);
  const bool leans = leaning_triangles(grid) > 0;
  CAPTURE(range.nearest, range.farthest, leans);
  // A cliff that leans over has ground beyond all border.
  if (!leans) {
    REQUIRE(of_grid.nearest_m() == range.nearest);
    REQUIRE(of_grid.farthest_m() == range.farthest);
  }
  ++sum.grids;
  sum.leaning += leans;
  Profile profile, expected;
  if (tin.triangles.empty()) {
    of_grid.cut(0, profile);
    REQUIRE(profile.size() == 0);
    return;
  }
  for (const double depth : depths_to_cut(random, grid, view, range)) {
    CAPTURE(depth, depth - range.nearest, range.farthest - depth);
    // Whether vertices in the plane are near or far hangs on which is the nearest.
    if (leans && (depth <= of_grid.nearest_m() || depth >= of_grid.farthest_m())) continue;
    of_grid.cut(depth, profile);
    of_tin.cut(depth, expected);
    REQUIRE((profile.depth_m == depth || std::isnan(depth)));
    REQUIRE(are_same(profile.u_m, expected.u_m));
    REQUIRE(are_same(profile.z_m, expected.z_m));
    REQUIRE(profile.after == expected.after);
    ++sum.profiles;
    sum.vertices += profile.size();
    sum.empty += profile.size() == 0;
    for (std::size_t k = 0; k + 1 < profile.size(); ++k) {
      sum.level += profile.after[k] == Span::level;
      sum.gaps += profile.after[k] == Span::gap;
    }
  }
}

// Parts of profiles are those of the whole ones, bit for bit.
void compare_parts(Random& random, const Grid& grid, Parts& sum) {
  const View view = random_view(random, grid);
  const LevelTriangles level = some_level(random, grid);
  const auto border = places_of(grid);
  const Box3 box = extent_of(grid).box;
  const EarthGridCutter whole(grid, view, level.of_grid, border),
      cutter(grid, view, level.of_grid, border, &box);
  for (const double depth : depths_to_cut(random, grid, view, depths_of(grid, view)))
    compare_parts(random, whole, cutter, depth, sum);
}

// The triangles alone, without their neighbours.
Tin sections_of(const Grid& grid) {
  Tin tin;
  for (std::uint32_t i = 0; i < grid.size(); ++i) tin.vertices_m.push_back(grid.vertex_m(i));
  for (const GridTriangle& t : triangles_of(grid)) tin.triangles.push_back(t.vertices);
  return tin;
}

struct Asked {
  std::size_t places = 0, gaps = 0, level = 0, in_plane = 0, ends = 0;
};

// What one plane's profile says at a place.
struct Said {
  Span span = Span::gap;
  long double z = 0;
};
Said said_at(const Profile& profile, long double u) {
  for (std::size_t k = 0; k + 1 < profile.size(); ++k) {
    const long double left = profile.u_m[k], right = profile.u_m[k + 1];
    if (!(left < u && u < right)) continue;
    return {profile.after[k],
            profile.z_m[k] + (u - left) / (right - left) *
                                 (static_cast<long double>(profile.z_m[k + 1]) - profile.z_m[k])};
  }
  return {};
}

void check_place(const TinSections& sections, const TriangleSet& level, const Profile& profile,
                 long double u, long double slack, Asked& asked) {
  std::size_t holding = 0;
  bool right_height = false, is_level = false;
  const Said said = said_at(profile, u);
  for (const TinSection& s : sections.ground) {
    if (std::abs(u - s.left.u) <= slack || std::abs(u - s.right.u) <= slack) return;
    if (!(s.left.u < u && u < s.right.u)) continue;
    ++holding;
    const long double slope = (s.right.z - s.left.z) / (s.right.u - s.left.u);
    const long double z = s.left.z + (u - s.left.u) * slope;
    if (!(std::abs(z - said.z) <= slack * (1 + std::abs(slope)))) continue;
    right_height = true;
    is_level = is_level || (!level.empty() && level.has(s.triangle));
    asked.in_plane += s.in_plane;
  }
  CAPTURE(static_cast<double>(u), static_cast<double>(said.z), holding);
  ++asked.places;
  asked.gaps += holding == 0;
  asked.level += is_level;
  REQUIRE((said.span == Span::gap) == (holding == 0));
  if (holding == 0) return;
  REQUIRE(right_height);
  REQUIRE((said.span == Span::level) == is_level);
}

void check_sections(Random& random, const Grid& grid, Asked& asked) {
  const Tin tin = sections_of(grid);
  const View view = random_view(random, grid);
  const LevelTriangles level = some_level(random, grid);
  const EarthGridCutter cutter(grid, view, level.of_grid, places_of(grid));
  double reach = 1;
  for (const Vec3& v : tin.vertices_m) {
    const ProfilePoint p = to_profile_frame(view, v);
    reach = std::fmax(reach, std::fmax(std::abs(p.u), std::abs(p.z)));
  }
  const long double slack = 16 * std::numeric_limits<double>::epsilon() * reach;
  Profile profile;
  for (const double depth : depths_to_cut(random, grid, view, depths_of(grid, view))) {
    CAPTURE(depth, view.forward.x, view.forward.y, reach);
    cutter.cut(depth, profile);
    const TinSections sections(tin, view, depth);
    REQUIRE(sections.walls.empty());
    long double low = HUGE_VALL, high = -HUGE_VALL;
    for (const TinSection& s : sections.ground) {
      low = std::min(low, s.left.u);
      high = std::max(high, s.right.u);
    }
    if (sections.ground.empty()) {
      REQUIRE(profile.size() == 0);
      continue;
    }
    for (int i = 0; i < 20; ++i) {
      const auto& s = sections.ground[static_cast<std::size_t>(
          random.whole(0, static_cast<int>(sections.ground.size()) - 1))];
      const auto share = static_cast<long double>(random.between(0.05, 0.95));
      check_place(sections, level.of_tin, profile,
                  i % 2 ? low - 1 + (high - low + 2) * share
                        : s.left.u + (s.right.u - s.left.u) * share,
                  slack, asked);
      if (s.right.u - s.left.u <= 4 * slack) continue; // a crumb
      // Where a plane crosses an edge it has a vertex.
      bool found = false;
      for (const double u : profile.u_m) found = found || std::abs(u - s.left.u) <= slack;
      REQUIRE(found);
      ++asked.ends;
    }
  }
}

} // namespace

TEST_CASE("a grid on the ellipsoid is cut as the TIN of its triangles, bit for bit") {
  Compared sum;
  for (std::uint64_t seed = 1; seed <= last_seed(1500); ++seed) {
    Random random(seed);
    const MadeEarth made = random_earth(random, seed % 4 ? 15 : 40);
    CAPTURE(seed, made.columns, made.rows, made.west_deg, made.north_deg, made.lon_step_deg,
            made.origin_lon_deg, made.origin_lat_deg);
    compare(random, made_earth_grid(random, made), sum);
  }
  CHECK(sum.grids - sum.leaning > enough(800));
  CHECK(sum.leaning > enough(50));
  CHECK(sum.vertices > enough(200000));
  CHECK(sum.level > enough(20000));
  CHECK(sum.gaps > enough(5000));
}

TEST_CASE("parts of profiles are those of whole ones, bit for bit") {
  Parts sum;
  for (std::uint64_t seed = 1; seed <= last_seed(600); ++seed) {
    Random random(seed + 20000);
    const MadeEarth made = random_earth(random, seed % 4 ? 15 : 40);
    CAPTURE(seed, made.columns, made.rows, made.west_deg, made.north_deg, made.lon_step_deg,
            made.lat_step_deg, made.origin_lon_deg, made.origin_lat_deg);
    const Grid grid = made_earth_grid(random, made);
    if (triangles_of(grid).empty() || leaning_triangles(grid) > 0) continue;
    compare_parts(random, grid, sum);
  }
  CHECK(sum.asked > enough(20000));
  CHECK(sum.vertices > enough(50000));
  CHECK(sum.gaps > enough(1000));
  CHECK(sum.shorter > enough(3000));
}

TEST_CASE("and as its triangles are, one by one") {
  Asked asked;
  for (std::uint64_t seed = 1; seed <= last_seed(600); ++seed) {
    Random random(seed + 10000);
    const MadeEarth made = random_earth(random, seed % 8 ? 12 : 30);
    CAPTURE(seed, made.columns, made.rows, made.west_deg, made.north_deg, made.lon_step_deg,
            made.origin_lon_deg, made.origin_lat_deg);
    const Grid grid = made_earth_grid(random, made);
    if (triangles_of(grid).empty() || leaning_triangles(grid) > 0) continue;
    check_sections(random, grid, asked);
  }
  CHECK(asked.places > enough(50000));
  CHECK(asked.gaps > enough(5000));
  CHECK(asked.level > enough(5000));
  CHECK(asked.in_plane > enough(500));
}

} // namespace orograph::cut_earth_grid_test
