// SPDX-License-Identifier: GPL-3.0-or-later
// Silhouette edges against their definition: each triangle's facing from its normal and the eye, in
// long double; the nearer of an edge's two triangles from where the eye is of the edge's line.
#include "profiles/silhouettes.hpp"
#include "tests/catch.hpp"
#include "tests/support/made_grid.hpp"
#include "tests/support/random.hpp"

#include <algorithm>
#include <cmath>
#include <set>

namespace orograph::silhouettes_test {
namespace {

struct Point {
  long double x, y, z;
};
Point operator-(Point a, Point b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
Point cross_of(Point a, Point b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
long double dot_of(Point a, Point b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

// By definition, for one grid and view.
class Definition {
public:
  Definition(const Grid& grid, const View& view)
      : grid_(grid), view_(view), triangles_(triangles_of(grid)),
        edges_(directed_edges(triangles_)) {}

  // Towards the eye, from a point.
  Point to_eye(Point p) const {
    if (view_.is_perspective())
      return Point{view_.depth_origin_m.x, view_.depth_origin_m.y, view_.eye_z_m} - p;
    // Back along the ray by a metre of depth, X and Y stay what they are.
    const long double y = view_.y_per_z, x = view_.x_per_v;
    return {y * (x * view_.right.x - view_.forward.x), y * (x * view_.right.y - view_.forward.y),
            view_.y_per_v};
  }
  Point vertex(std::uint32_t i) const {
    const Vec3 p = vertex_m(grid_, i);
    const long double x = static_cast<long double>(p.x) - view_.depth_origin_m.x,
                      y = static_cast<long double>(p.y) - view_.depth_origin_m.y;
    const long double u = x * view_.right.x + y * view_.right.y,
                      v = x * view_.forward.x + y * view_.forward.y;
    const auto& [uu, uv, vv] = view_.drop;
    return {p.x, p.y,
            static_cast<long double>(p.z) * view_.exaggeration -
                (uu * u * u + uv * u * v + vv * v * v)};
  }
  // Normal times direction to the eye, of the sum of its terms' sizes: positive where it is seen.
  long double facing(std::size_t triangle) const {
    const auto& [a, b, c] = triangles_[triangle].vertices;
    const Point normal = cross_of(vertex(b) - vertex(a), vertex(c) - vertex(a));
    const Point eye = to_eye(vertex(a));
    const long double size =
        std::abs(normal.x * eye.x) + std::abs(normal.y * eye.y) + std::abs(normal.z * eye.z);
    return size > 0 ? dot_of(normal, eye) / size : 0;
  }
  // How far the eye is to the left of the edge's line on the ground, of the way to it.
  long double eye_on_left(DirectedEdge edge) const {
    const Point a = vertex(edge.first), along = vertex(edge.second) - a;
    const Point eye = to_eye(a);
    return (along.x * eye.y - along.y * eye.x) /
           (std::hypot(along.x, along.y) * std::hypot(eye.x, eye.y));
  }

  // Inner edges of which it is certain that they are, and may be, silhouettes: every sign by more
  // than `slack`.
  struct Found {
    std::set<DirectedEdge> certain, possible;
  };
  Found silhouettes(long double slack) const {
    Found found;
    for (const auto& [edge, left] : edges_) {
      if (edge.first > edge.second) continue;
      const auto other = edges_.find({edge.second, edge.first});
      if (other == edges_.end()) continue;
      const long double on_left = eye_on_left(edge), f_left = facing(left),
                        f_right = facing(other->second);
      const auto seen_then_turned = [&](long double nearer, long double near_face,
                                        long double far_face, long double by) {
        return nearer > by && near_face > by && far_face <= -by;
      };
      // `!(… > …)` holds for the NaN of an eye straight above an edge's end as well.
      const auto may_be = [&](long double nearer, long double near_face, long double far_face) {
        return !(nearer < -slack) && !(near_face < -slack) && !(far_face > slack);
      };
      if (seen_then_turned(on_left, f_left, f_right, slack) ||
          seen_then_turned(-on_left, f_right, f_left, slack))
        found.certain.insert(edge);
      if (may_be(on_left, f_left, f_right) || may_be(-on_left, f_right, f_left))
        found.possible.insert(edge);
    }
    return found;
  }

private:
  const Grid& grid_;
  const View& view_;
  std::vector<GridTriangle> triangles_;
  std::map<DirectedEdge, std::size_t> edges_;
};

std::set<DirectedEdge> found_in(const Grid& grid, const View& view) {
  std::set<DirectedEdge> edges;
  const std::vector<SurfaceEdge> list = silhouette_edges(grid, view);
  for (const SurfaceEdge& edge : list) edges.insert({edge.from, edge.to});
  CHECK(edges.size() == list.size()); // none twice
  return edges;
}

View eye_view(Vec3 eye, double azimuth_deg, double exaggeration = 1) {
  View view;
  view.forward = direction_of_azimuth(Angle::degrees(azimuth_deg));
  view.right = {view.forward.y, -view.forward.x};
  view.depth_origin_m = {eye.x, eye.y};
  view.eye_z_m = eye.z * exaggeration;
  view.exaggeration = exaggeration;
  return view;
}

View parallel_view(double azimuth_deg, double elevation_deg, double exaggeration = 1) {
  View view = eye_view({}, azimuth_deg, exaggeration);
  view.projection = Projection::orthographic;
  view.elevation = Angle::degrees(elevation_deg);
  view.y_per_v = sin(view.elevation);
  view.y_per_z = cos(view.elevation);
  return view;
}

struct Tally {
  std::size_t certain = 0, listed = 0, doubtful = 0;
};

// Every true silhouette is listed, and nothing that certainly isn't one.
void check(const Grid& grid, const View& view, Tally& tally, long double slack = 1e-12L) {
  const auto [certain, possible] = Definition(grid, view).silhouettes(slack);
  const std::set<DirectedEdge> listed = found_in(grid, view);
  CHECK(std::includes(listed.begin(), listed.end(), certain.begin(), certain.end()));
  CHECK(std::includes(possible.begin(), possible.end(), listed.begin(), listed.end()));
  tally.certain += certain.size();
  tally.listed += listed.size();
  tally.doubtful += possible.size() - certain.size();
}

Grid random_grid(Random& random, double height_scale = 1) {
  const int columns = random.whole(2, 20), rows = random.whole(2, 20);
  GridLattice lattice{columns, rows, {}, {30, 0}, {0, -20}};
  if (random.chance(0.5))
    lattice = turned_lattice(columns, rows, {30, 25}, random.between(-0.7, 0.7),
                             random.between(-0.3, 0.3));
  lattice.first_vertex_m = {random.between(-500, 500), random.between(-500, 500)};
  return made_grid(random, lattice,
                   {height_scale * random.between(-50, 0), height_scale * random.between(0, 100),
                    random.pick({0.0, 0.1, 0.4}), random.chance(0.4), random.chance(0.5)});
}

// On a vertex, above a grid line, above the ground, or far away; at any height from low to high.
Vec3 random_eye(const Grid& grid, Random& random) {
  double c = random.between(-1, grid.columns), r = random.between(-1, grid.rows);
  if (random.chance(0.5)) c = std::floor(c);
  if (random.chance(0.5)) r = std::floor(r);
  const Vec2 at =
      grid.plane().first_vertex_m + c * grid.plane().column_step_m + r * grid.plane().row_step_m;
  const double height = random.pick({-10.0, 0.0, 40.0, 100.0, 1000.0});
  if (random.chance(0.3)) return {at.x + 3000, at.y - 7000, height};
  return {at.x, at.y, height};
}

} // namespace

TEST_CASE("silhouettes are those of the definition, in perspective") {
  Tally tally;
  for (std::uint64_t seed = 1; seed <= last_seed(1500); ++seed) {
    Random random(seed);
    const Grid grid = random_grid(random);
    const Vec3 eye = random_eye(grid, random);
    CAPTURE(seed, eye.x, eye.y, eye.z);
    check(grid, eye_view(eye, random.between(0, 360), random.pick({1.0, 1.0, 2.5})), tally);
  }
  WARN(tally.certain << " silhouettes, " << tally.listed << " listed, " << tally.doubtful
                     << " may be");
  CHECK(tally.certain > enough(20000));
  // Only eyes in line with edges or faces leave a doubt.
  CHECK(tally.listed < tally.certain + tally.certain / 4);
}

TEST_CASE("and in parallel views") {
  Tally tally;
  for (std::uint64_t seed = 1; seed <= last_seed(1500); ++seed) {
    Random random(seed);
    const Grid grid = random_grid(random);
    const double azimuth = random.chance(0.5) ? 45.0 * random.whole(0, 7) : random.between(0, 360);
    const double elevation = random.pick({0.0, 1e-9, 10.0, 45.0, 89.999, 90.0});
    CAPTURE(seed, azimuth, elevation);
    check(grid, parallel_view(azimuth, elevation, random.pick({1.0, 3.0})), tally);
  }
  WARN(tally.certain << " silhouettes, " << tally.listed << " listed, " << tally.doubtful
                     << " may be");
  CHECK(tally.certain > enough(20000));
  CHECK(tally.listed < tally.certain + tally.certain / 4);
}

TEST_CASE("and in oblique views") {
  Tally tally;
  for (std::uint64_t seed = 1; seed <= last_seed(500); ++seed) {
    Random random(seed);
    const Grid grid = random_grid(random);
    View view =
        parallel_view(random.chance(0.5) ? 45.0 * random.whole(0, 7) : random.between(0, 360), 0,
                      random.pick({1.0, 3.0}));
    view.projection = Projection::oblique;
    view.x_per_v = random.pick({0.0, 1.0, random.between(-2, 2)});
    // Level rays along the map's axes would leave the definition's own signs to rounding.
    view.y_per_v = random.pick({1.0, random.between(0.01, 2)});
    CAPTURE(seed, view.x_per_v, view.y_per_v);
    check(grid, view, tally);
  }
  CHECK(tally.certain > enough(6000));
  CHECK(tally.listed < tally.certain + tally.certain / 4);
}

// Of heights that have nothing to do with each other rows differ by chance alone.
TEST_CASE("how many there are for a cell is told from some of the rows") {
  Random random(1);
  for (const double roughness_m : {4.0, 40.0, 400.0}) {
    const Grid grid = made_grid(random, {200, 400, {}, {30, 0}, {0, -20}}, {0, roughness_m});
    const View view = parallel_view(random.between(0, 360), 25);
    const auto count = static_cast<double>(silhouette_edges(grid, view).size());
    CAPTURE(roughness_m, count);
    CHECK(silhouettes_a_cell(grid, view) == Approx(count / (199.0 * 399)).epsilon(0.15));
  }
}

TEST_CASE(
    "and where the ground sinks with the earth's curvature, which may bend it more than heights") {
  Tally tally;
  for (std::uint64_t seed = 1; seed <= last_seed(1500); ++seed) {
    Random random(seed);
    const Grid grid = random_grid(random, random.pick({1.0, 1e-3, 1e-4}));
    const Vec3 eye = random_eye(grid, random);
    const double azimuth = random.between(0, 360), exaggeration = random.pick({1.0, 2.5});
    View view = random.chance(0.7) ? eye_view(eye, azimuth, exaggeration)
                                   : parallel_view(azimuth, random.between(0, 60), exaggeration);
    // By radii of 5000, 50 and 5 km.
    const double per_m2 = random.pick({1e-7, 1e-5, 1e-4});
    view.drop = drop_in_frame({per_m2 * random.between(0.9, 1.1), per_m2}, view.forward);
    CAPTURE(seed, eye.x, eye.y, eye.z, per_m2);
    // Depths of 1e4 m sink by 1e4 m at most, to 1e-12 m, and cells by a thousandth of a metre.
    check(grid, view, tally, 1e-8L);
  }
  WARN(tally.certain << " silhouettes, " << tally.listed << " listed, " << tally.doubtful
                     << " may be");
  CHECK(tally.certain > enough(10000));
  CHECK(tally.listed < tally.certain + tally.certain / 4);
}

TEST_CASE("seen from far away, only rounding is in doubt: the list is the definition's") {
  for (std::uint64_t seed = 1; seed <= last_seed(300); ++seed) {
    Random random(seed);
    const Grid grid = random_grid(random);
    CAPTURE(seed);
    const View view = eye_view({random.between(3000, 4000), random.between(-5000, -4000), 777.7},
                               random.between(0, 360));
    const auto [certain, possible] = Definition(grid, view).silhouettes(1e-12L);
    REQUIRE(certain == possible);
    REQUIRE(found_in(grid, view) == certain);
  }
}

TEST_CASE("a face exactly edge-on counts as turned away, and as seen") {
  // A ramp through the eye, between ground that is seen and ground that is turned away.
  // Rows from the north; the eye is in the south, at height 10.
  Grid grid{2, 4, PlaneLattice{{0, 0}, {10, 0}, {0, -10}}, std::vector<float>()};
  const View view = eye_view({5, -130, 10}, 0);
  SECTION("turned away behind it") {
    grid.heights_m = std::vector<float>{0, 0, 10, 10, 10, 10, 5, 5};
    const auto edges = found_in(grid, view);
    CHECK(edges.contains({4, 5})); // where the level strip begins
    CHECK(edges.contains({2, 3})); // and where it ends
  }
  SECTION("seen behind it") {
    grid.heights_m = std::vector<float>{20, 20, 10, 10, 10, 10, 5, 5};
    CHECK(found_in(grid, view).contains({4, 5}));
  }
}

TEST_CASE("water at the eye's height has an edge before it in any case") {
  // A basin: a shore all around that rises from the water, seen from a place on the water.
  Grid grid{7, 7, PlaneLattice{{0, 0}, {10, 0}, {0, -10}}, std::vector<float>()};
  std::vector<double> heights(grid.size(), 5);
  for (int r = 0; r < 7; ++r)
    for (int c = 0; c < 7; ++c)
      if (r == 0 || c == 0 || r == 6 || c == 6) heights[grid.index(c, r)] = 8;
  grid.heights_m = heights;
  for (const double above : {0.0, 1e-300, 1e-15, 1e-3}) {
    const View view = eye_view({31, -29, 5 + above}, 10);
    const auto certain = Definition(grid, view).silhouettes(0).certain;
    const auto listed = found_in(grid, view);
    CHECK(std::includes(listed.begin(), listed.end(), certain.begin(), certain.end()));
    // With the eye in the water's plane, each of its faces may be seen and may be turned away, but
    // none of its own edges is where it bends.
    CHECK(!listed.empty());
    for (const auto& [from, to] : listed) {
      const auto is_inside = [](std::uint32_t vertex) {
        const auto c = vertex % 7, r = vertex / 7;
        return c >= 2 && c <= 4 && r >= 2 && r <= 4;
      };
      CHECK_FALSE((is_inside(from) && is_inside(to)));
    }
    if (above == 1e-3) CHECK(listed == certain);
  }
}

TEST_CASE("heights of 1e30, 1e-30 and denormals") {
  for (const double unit : {1e30, 1e-30, 1e-310}) {
    Tally tally;
    for (std::uint64_t seed = 1; seed <= last_seed(200); ++seed) {
      Random random(seed);
      Grid grid =
          made_grid(random, {6, 6, {}, {1, 0}, {0, -1}}, {0, 1, 0.1, random.chance(0.3), true});
      for (double& height : std::get<Heights<double>>(grid.heights_m).own()) height *= unit;
      CAPTURE(unit, seed);
      const View view = eye_view({random.between(-3, 8), -20, random.pick({0.0, 0.5, 1.0}) * unit},
                                 random.between(0, 360));
      check(grid, view, tally);
    }
    CHECK(tally.certain > enough(100));
  }
}

} // namespace orograph::silhouettes_test
