// SPDX-License-Identifier: GPL-3.0-or-later
// Silhouettes of a grid on the ellipsoid: those of the TIN of its triangles, those that facing_of
// tells triangle by triangle, and those of the normals and the eye in long double. The ground
// behind them: that of the TIN.
#include "dem/approximate/tin_of_grid.hpp"
#include "dem/limit_lean.hpp"
#include "profiles/facing.hpp"
#include "profiles/ground_behind.hpp"
#include "profiles/silhouettes.hpp"
#include "profiles/slab_lines.hpp"
#include "tests/catch.hpp"
#include "tests/profiles/triangle_cuts.hpp"
#include "tests/support/made_earth_grid.hpp"
#include "tests/support/random.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

namespace orograph::earth_silhouettes_test {
namespace {

using Edges = std::vector<SurfaceEdge>;

View eye_view(Vec3 eye, double azimuth_deg, double lift_per_m2 = 0) {
  View view = looking(direction_of_azimuth(Angle::degrees(azimuth_deg)), {eye.x, eye.y});
  view.projection = Projection::perspective;
  view.eye_z_m = eye.z;
  if (lift_per_m2 != 0) view.drop = drop_in_frame({-lift_per_m2, -lift_per_m2}, view.forward);
  return view;
}

View parallel_view(Random& random, double azimuth_deg) {
  View view = looking(direction_of_azimuth(Angle::degrees(azimuth_deg)));
  if (random.chance(0.3)) {
    view.projection = Projection::oblique;
    view.x_per_v = random.pick({0.0, 1.0, random.between(-2, 2)});
    view.y_per_v = random.between(0.01, 2);
    return view;
  }
  view.elevation = Angle::degrees(random.pick({0.0, 1e-9, 10.0, 45.0, 90.0}));
  view.y_per_v = sin(view.elevation);
  view.y_per_z = cos(view.elevation);
  return view;
}

// On a vertex or its meridian or parallel, in the middle of things or beside, low or high; or from
// the frame's origin, where scenes have it.
View random_view(Random& random, const Grid& grid) {
  const double azimuth = random.chance(0.5) ? 45.0 * random.whole(0, 7) : random.between(0, 360);
  if (random.chance(0.3)) return parallel_view(random, azimuth);
  const double lift = random.chance(0.5) ? random.pick({0.13, 0.5, -1.0}) / (2 * 6371000.0) : 0;
  const double height = random.pick({-10.0, 0.0, 2.0, 40.0, 3000.0, 1e5});
  if (random.chance(0.4)) return eye_view({0, 0, height}, azimuth, lift);
  const int c = random.whole(0, grid.columns - 1), r = random.whole(0, grid.rows - 1);
  Vec3 eye = grid.vertex_m(c, r);
  if (random.chance(0.5) || std::isnan(eye.z)) eye = grid.earth().vertex_m(c, r, height);
  if (random.chance(0.3)) eye = eye + Vec3{random.between(-1e4, 1e4), random.between(-1e4, 1e4), 0};
  return eye_view(eye, azimuth, lift);
}

// By definition, of all inner edges; in the profile frame, which rounds.
class Definition {
public:
  Definition(const Grid& grid, const View& view)
      : grid_(grid), view_(view), triangles_(triangles_of(grid)) {
    const auto sides = directed_edges(triangles_);
    for (const auto& [edge, left] : sides) {
      const auto other = sides.find({edge.second, edge.first});
      if (edge.first < edge.second && other != sides.end())
        inner_.push_back({{edge.first, edge.second}, left, other->second});
    }
  }

  Edges by_facing_of() const {
    Edges edges;
    for (const Inner& e : inner_) {
      const auto facing = [&](std::size_t t) {
        const auto& v = triangles_[t].vertices; // the first is of lowest index
        return facing_of(view_, at(v[0]), at(v[1]), at(v[2]));
      };
      if (are_seen_and_turned(facing(e.left), facing(e.right)) &&
          may_be_ridge(at(e.edge.from), at(e.edge.to), at(apex(e.left, e.edge)),
                       at(apex(e.right, e.edge))))
        edges.push_back(e.edge);
    }
    return edges;
  }

  // Of which it is certain that they are, and may be, silhouettes: every sign by more than `slack`
  // of its terms.
  struct Found {
    std::set<SurfaceEdge> certain, possible;
  };
  Found by_normals(long double slack) const {
    Found found;
    for (const Inner& e : inner_) {
      const long double left = facing(e.left), right = facing(e.right), bend = bends_down(e);
      const bool one_each = (left > slack && right < -slack) || (right > slack && left < -slack);
      if (one_each && bend > slack) found.certain.insert(e.edge);
      const bool both_seen = left > slack && right > slack;
      const bool both_turned = left < -slack && right < -slack;
      if (!both_seen && !both_turned && !(bend < -slack)) found.possible.insert(e.edge);
    }
    return found;
  }

private:
  struct Inner {
    SurfaceEdge edge;
    std::size_t left, right; ///< triangles
  };
  struct Point {
    long double u, v, z;
  };

  ProfilePoint at(std::uint32_t vertex) const {
    return to_profile_frame(view_, grid_.vertex_m(vertex));
  }
  std::uint32_t apex(std::size_t t, SurfaceEdge edge) const {
    for (const std::uint32_t v : triangles_[t].vertices)
      if (v != edge.from && v != edge.to) return v;
    return edge.from;
  }
  static Point between(ProfilePoint a, ProfilePoint b) {
    return {static_cast<long double>(b.u) - a.u, static_cast<long double>(b.v) - a.v,
            static_cast<long double>(b.z) - a.z};
  }
  // a . (b x c), of the sum of its terms' sizes.
  static long double product(Point a, Point b, Point c) {
    const long double terms[] = {a.u * b.v * c.z,  -a.u * b.z * c.v, a.v * b.z * c.u,
                                 -a.v * b.u * c.z, a.z * b.u * c.v,  -a.z * b.v * c.u};
    long double sum = 0, size = 0;
    for (const long double term : terms) {
      sum += term;
      size += std::abs(term);
    }
    return size > 0 ? sum / size : 0;
  }
  // Positive where the eye is above the triangle's plane.
  long double facing(std::size_t t) const {
    const auto& v = triangles_[t].vertices;
    const ProfilePoint a = at(v[0]);
    // Back along the ray by a metre of depth X and Y stay what they are.
    const Point eye = view_.is_perspective()
                          ? between(a, {0, 0, view_.eye_z_m})
                          : Point{static_cast<long double>(view_.x_per_v) * view_.y_per_z,
                                  -view_.y_per_z, view_.y_per_v};
    return product(eye, between(a, at(v[1])), between(a, at(v[2])));
  }
  // Positive where the right triangle falls away below the plane of the left one.
  long double bends_down(const Inner& e) const {
    const ProfilePoint a = at(e.edge.from);
    return -product(between(a, at(e.edge.to)), between(a, at(apex(e.left, e.edge))),
                    between(a, at(apex(e.right, e.edge))));
  }

  const Grid& grid_;
  const View& view_;
  std::vector<GridTriangle> triangles_;
  std::vector<Inner> inner_; ///< in order
};

// The TIN has the vertices that a triangle has, in the grid's order.
std::vector<std::uint32_t> numbers_in_grid(const Grid& grid, const Tin& tin) {
  std::set<std::uint32_t> used;
  for (const GridTriangle& t : triangles_of(grid))
    used.insert(t.vertices.begin(), t.vertices.end());
  std::vector<std::uint32_t> numbers(used.begin(), used.end());
  REQUIRE(numbers.size() == tin.vertices_m.size());
  for (std::size_t i = 0; i < numbers.size(); ++i)
    REQUIRE(grid.vertex_m(numbers[i]) == tin.vertices_m[i]);
  return numbers;
}

struct Compared {
  std::size_t silhouettes = 0, certain = 0, doubtful = 0, rises = 0, falls = 0;
};

void compare(Random& random, const Grid& grid, const View& view, Compared& sum) {
  const Tin tin = tin_of(grid);
  const std::vector<std::uint32_t> number = numbers_in_grid(grid, tin);
  const Edges edges = silhouette_edges(grid, view), of_tin = silhouette_edges(tin, view);
  Edges renumbered = of_tin;
  for (SurfaceEdge& e : renumbered) e = {number[e.from], number[e.to]};
  REQUIRE(edges == renumbered);
  const Definition definition(grid, view);
  REQUIRE(edges == definition.by_facing_of());
  const auto [certain, possible] = definition.by_normals(1e-12L);
  REQUIRE(std::includes(edges.begin(), edges.end(), certain.begin(), certain.end()));
  REQUIRE(std::includes(possible.begin(), possible.end(), edges.begin(), edges.end()));
  sum.silhouettes += edges.size();
  sum.certain += certain.size();
  sum.doubtful += possible.size() - certain.size();

  const Surface as_grid = grid, as_tin = tin;
  const GroundBehind behind(as_grid, view), behind_tin(as_tin, view);
  for (int i = 0; i < 30 && !edges.empty(); ++i) {
    const auto k = static_cast<std::size_t>(random.whole(0, static_cast<int>(edges.size()) - 1));
    const ProfileLine line = line_of(as_grid, view, edges[k]);
    const ProfilePoint from =
        point_between(line.from, line.to, random.pick({0.0, 1.0, 0.5, random.between(0, 1)}));
    if (view.is_perspective() && !(from.v > 0)) continue;
    const double reach = random.pick({1.0, 1000.0, 1e5, 1e7});
    const bool rises = behind.rises_within(edges[k], from, reach);
    CAPTURE(i, edges[k].from, edges[k].to, from.u, from.v, from.z, reach);
    REQUIRE(rises == behind_tin.rises_within(of_tin[k], from, reach));
    ++(rises ? sum.rises : sum.falls);
  }
}

void report(const char* what, const Compared& sum) {
  WARN(what << ": " << sum.silhouettes << " silhouettes, " << sum.certain << " of them certain, "
            << sum.doubtful << " may be; behind them the ground rises " << sum.rises
            << " times and falls " << sum.falls);
}

// Level, but for heights put in.
Grid sea(const MadeEarth& made) {
  Grid grid;
  grid.columns = made.columns;
  grid.rows = made.rows;
  grid.lattice = earth_lattice(made);
  grid.heights_m = std::vector<float>(grid.size(), 0.0F);
  return grid;
}

} // namespace

TEST_CASE("silhouettes on the ellipsoid are the TIN's and those of the definition") {
  Compared sum;
  for (std::uint64_t seed = 1; seed <= last_seed(1000); ++seed) {
    Random random(seed);
    const MadeEarth made = random_earth(random, seed % 8 ? 12 : 40);
    CAPTURE(seed, made.columns, made.rows, made.west_deg, made.north_deg, made.lon_step_deg,
            made.origin_lon_deg, made.origin_lat_deg);
    const Grid grid = made_earth_grid(random, made);
    if (triangles_of(grid).empty()) continue;
    compare(random, grid, random_view(random, grid), sum);
  }
  report("anything", sum);
  CHECK(sum.certain > enough(8000));
  CHECK(sum.rises > enough(500));
  CHECK(sum.falls > enough(500));
}

// A row isn't told by one parabola there.
TEST_CASE("silhouettes of long rows are those of the definition, too") {
  Compared sum;
  std::size_t limited = 0;
  for (std::uint64_t seed = 1; seed <= last_seed(200); ++seed) {
    Random random(seed);
    MadeEarth made = random_earth(random, 4);
    made.columns = random.whole(100, 1800);
    made.lon_step_deg = std::min(made.lon_step_deg, 300.0 / made.columns);
    CAPTURE(seed, made.columns, made.rows, made.lon_step_deg, made.north_deg);
    Grid grid = made_earth_grid(random, made);
    if (random.chance(0.3)) { // so high that they would lean over the cells beside them
      std::visit(
          [&](auto& heights) {
            for (auto& height : heights.own())
              if (random.chance(0.01)) height = random.pick({-32767, 32767});
          },
          grid.heights_m);
      limit_lean(grid);
      limited += grid.earth().lean_limits() ? 1 : 0;
    }
    if (triangles_of(grid).empty()) continue;
    compare(random, grid, random_view(random, grid), sum);
  }
  report("long rows", sum);
  CHECK(limited > enough(20));
  CHECK(sum.certain > enough(20000));
}

TEST_CASE("of a sea seen edge-on, from a vertex of it and from its level beside it") {
  Compared sum;
  for (std::uint64_t seed = 1; seed <= last_seed(200); ++seed) {
    Random random(seed);
    MadeEarth made = random_earth(random, 12);
    made.lon_step_deg = made.lat_step_deg = random.pick({1.0 / 3600, 1.0 / 64});
    made.north_deg = std::clamp(made.north_deg, -80.0, 85.0);
    made.origin_lat_deg = made.north_deg - made.lat_step_deg * random.whole(0, made.rows - 1);
    made.origin_lon_deg = made.west_deg + made.lon_step_deg * random.whole(0, made.columns - 1);
    const Grid grid = sea(made);
    const double azimuth = 45.0 * random.whole(0, 7);
    CAPTURE(seed, azimuth, made.origin_lon_deg, made.origin_lat_deg);
    const double lift = random.pick({0.0, 0.13, 1.0}) / (2 * 6371000.0);
    for (const double height : {0.0, 1e-9, 1e-3, 2.0})
      compare(random, grid, eye_view({0, 0, height}, azimuth, lift), sum);
    View level = looking(direction_of_azimuth(Angle::degrees(azimuth)));
    compare(random, grid, level, sum);
  }
  report("edge-on", sum);
  CHECK(sum.silhouettes > enough(1000));
}

TEST_CASE("of heights of 1e30 and of 1e-30, and of cliffs 100 km away") {
  Compared sum;
  std::size_t limited = 0;
  for (std::uint64_t seed = 1; seed <= last_seed(200); ++seed) {
    Random random(seed);
    MadeEarth made = random_earth(random, 10);
    if (seed % 2) { // the frame's origin 100 km to the south or to the west
      made.lon_step_deg = made.lat_step_deg = 1.0 / 3600;
      made.origin_lat_deg = random.between(-60, 60);
      made.north_deg = made.origin_lat_deg + random.pick({0.0, 0.9});
      made.west_deg = made.origin_lon_deg + random.pick({0.9, 1.3});
    }
    Grid grid = made_earth_grid(random, made);
    const double unit = seed % 2 ? 1 : random.pick({1e30, 1e-30});
    std::visit(
        [&]<class Height>(Heights<Height>& heights) {
          for (Height& h : heights.own())
            h = seed % 2 ? (random.chance(0.5) ? Height{0} : Height{3000})
                         : static_cast<Height>(h * unit);
        },
        grid.heights_m);
    if (random.chance(0.5)) limit_lean(grid);
    limited += grid.earth().lean_limits() ? 1 : 0;
    CAPTURE(seed, unit, made.origin_lon_deg, made.origin_lat_deg);
    if (triangles_of(grid).empty()) continue;
    const double lift = random.chance(0.5) ? 0.13 / (2 * 6371000.0) : 0;
    compare(
        random, grid,
        eye_view({0, 0, unit * random.pick({2.0, 1500.0, 4000.0})}, random.between(0, 360), lift),
        sum);
    compare(random, grid, parallel_view(random, random.between(0, 360)), sum);
  }
  report("extremes", sum);
  CHECK(limited > enough(10));
  CHECK(sum.certain > enough(1500));
}

} // namespace orograph::earth_silhouettes_test
