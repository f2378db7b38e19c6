// SPDX-License-Identifier: GPL-3.0-or-later
// Edges of TINs: those of a grid and of its triangles are the same, and with walls silhouettes are
// where Y, walking away along a ray, rises up to the edge and doesn't rise beyond it.
#include "dem/approximate/tin_of_grid.hpp"
#include "profiles/level_ground.hpp"
#include "profiles/outline.hpp"
#include "profiles/silhouettes.hpp"
#include "profiles/surface_edges.hpp"
#include "tests/catch.hpp"
#include "tests/profiles/triangle_cuts.hpp"
#include "tests/support/made_grid.hpp"
#include "tests/support/made_tin.hpp"
#include "tests/support/notched_tin.hpp"
#include "tests/support/random.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace orograph::tin_silhouettes_test {
namespace {

View eye_view(Vec3 eye, double azimuth_deg, double exaggeration = 1) {
  View view =
      looking(direction_of_azimuth(Angle::degrees(azimuth_deg)), {eye.x, eye.y}, exaggeration);
  view.projection = Projection::perspective;
  view.eye_z_m = eye.z * exaggeration;
  return view;
}

View parallel_view(double azimuth_deg, double elevation_deg, double exaggeration = 1) {
  View view = looking(direction_of_azimuth(Angle::degrees(azimuth_deg)), {}, exaggeration);
  view.elevation = Angle::degrees(elevation_deg);
  view.y_per_v = sin(view.elevation);
  view.y_per_z = cos(view.elevation);
  return view;
}

// Of grid vertices, which the TIN numbers anew.
class Renumbered {
public:
  Renumbered(const Grid& grid, const Tin& tin) {
    // In the grid's order, those that a triangle has.
    std::set<std::uint32_t> used;
    for (const GridTriangle& t : triangles_of(grid))
      used.insert(t.vertices.begin(), t.vertices.end());
    for (const std::uint32_t v : used) number_.emplace(v, number_.size());
    REQUIRE(number_.size() == tin.vertices_m.size());
    for (const auto& [v, n] : number_) REQUIRE(vertex_m(grid, v) == tin.vertices_m[n]);
  }
  SurfaceEdge operator()(SurfaceEdge e) const {
    return {static_cast<std::uint32_t>(number_.at(e.from)),
            static_cast<std::uint32_t>(number_.at(e.to))};
  }
  std::vector<SurfaceEdge> operator()(std::vector<SurfaceEdge> edges) const {
    for (SurfaceEdge& e : edges) e = (*this)(e);
    return edges;
  }

private:
  std::map<std::uint32_t, std::size_t> number_;
};

Grid random_grid(Random& random) {
  const int columns = random.whole(2, 20), rows = random.whole(2, 20);
  GridLattice lattice{columns, rows, {}, {30, 0}, {0, -20}};
  if (random.chance(0.5))
    lattice = turned_lattice(columns, rows, {30, 25}, random.between(-0.7, 0.7),
                             random.between(-0.3, 0.3));
  lattice.first_vertex_m = {random.between(-500, 500), random.between(-500, 500)};
  Grid grid = made_grid(random, lattice,
                        {random.between(-50, 0), random.pick({1.0, 3.0, random.between(0, 100)}),
                         random.pick({0.0, 0.1, 0.4}), random.chance(0.4), random.chance(0.5)});
  if (random.chance(0.2)) // the rows run the other way
    grid.plane().row_step_m = -1.0 * grid.plane().row_step_m;
  return grid;
}

// On a vertex, above a grid line, above the ground, or far away.
View random_view(const Grid& grid, Random& random, double height_unit = 1) {
  const double exaggeration = random.pick({1.0, 1.0, 2.5});
  const double azimuth = random.chance(0.5) ? 45.0 * random.whole(0, 7) : random.between(0, 360);
  if (random.chance(0.4))
    return parallel_view(azimuth, random.pick({0.0, 1e-9, 10.0, 45.0, 90.0}), exaggeration);
  double c = random.between(-1, grid.columns), r = random.between(-1, grid.rows);
  if (random.chance(0.5)) c = std::floor(c);
  if (random.chance(0.5)) r = std::floor(r);
  const Vec2 at =
      grid.plane().first_vertex_m + c * grid.plane().column_step_m + r * grid.plane().row_step_m;
  const double height = random.pick({-10.0, 0.0, 1.0, 40.0, 1000.0}) * height_unit;
  return eye_view({at.x, at.y, height}, azimuth, exaggeration);
}

struct Compared {
  std::size_t silhouettes = 0, shores = 0, border = 0;
};

void compare(const Grid& grid, const View& view, Compared& sum) {
  const Tin tin = tin_of(grid);
  const Renumbered renumbered(grid, tin);
  const std::vector<SurfaceEdge> silhouettes = silhouette_edges(tin, view);
  REQUIRE(silhouettes == renumbered(silhouette_edges(grid, view)));
  REQUIRE(edges_of(tin) == renumbered(edges_of(grid)));
  REQUIRE(edges_behind_walls(Surface(tin), view).empty());
  const std::vector<BorderEdge> of_tin = border_edges(tin), of_grid = border_edges(grid, false);
  REQUIRE(of_tin.size() == of_grid.size());
  for (std::size_t i = 0; i < of_tin.size(); ++i) {
    REQUIRE(of_tin[i].edge == renumbered(of_grid[i].edge));
    // To the left seen from above: a mirrored grid's own order is the other way round.
    REQUIRE((of_tin[i].left == of_grid[i].left ||
             cross(grid.plane().column_step_m, grid.plane().row_step_m) > 0));
  }
  for (const std::size_t smallest : {std::size_t{1}, std::size_t{5}}) {
    const double triangle_m2 =
        0.5 * std::abs(cross(grid.plane().column_step_m, grid.plane().row_step_m));
    const LevelGround grid_level = find_level_ground(grid, smallest),
                      tin_level = find_level_ground(tin, (static_cast<double>(smallest) - 0.5) *
                                                             triangle_m2);
    REQUIRE(grid_level.regions == tin_level.regions);
    REQUIRE(tin_level.shores == renumbered(grid_level.shores));
    std::size_t t = 0;
    for (const GridTriangle& g : triangles_of(grid)) {
      const bool level = !grid_level.triangles.empty() &&
                         grid_level.triangles.has(grid_triangle(grid, g.column, g.row, g.half));
      REQUIRE(level == (!tin_level.triangles.empty() && tin_level.triangles.has(t)));
      ++t;
    }
    sum.shores += tin_level.shores.size();
  }
  sum.silhouettes += silhouettes.size();
  sum.border += of_tin.size();
}

using Point = std::array<long double, 3>; // u, v, z

// By definition, for one TIN and view: at the middle of an edge.
class Definition {
public:
  Definition(const Tin& tin, const View& view) : tin_(tin), view_(view) {
    for (const Vec3& vertex : tin.vertices_m) {
      const ProfilePoint p = to_profile_frame(view, vertex);
      points_.push_back({p.u, p.v, p.z});
    }
    for (std::uint32_t t = 0; t < tin.triangles.size(); ++t)
      for (std::size_t k = 0; k < 3; ++k)
        left_of_[{tin.triangles[t][k], tin.triangles[t][(k + 1) % 3]}] = t;
  }

  struct Found {
    std::set<SurfaceEdge> certain, possible;
  };
  Found silhouettes(long double slack) const {
    Found found;
    for (const auto& [edge, left] : left_of_) {
      if (edge.first > edge.second) continue;
      const auto other = left_of_.find({edge.second, edge.first});
      if (other == left_of_.end()) continue;
      const int answer = is_silhouette(edge.first, edge.second, left, other->second, slack);
      if (answer > 0) found.certain.insert({edge.first, edge.second});
      if (answer >= 0) found.possible.insert({edge.first, edge.second});
    }
    return found;
  }

private:
  // 1 yes, -1 no, 0 in doubt.
  int is_silhouette(std::uint32_t a, std::uint32_t b, std::uint32_t left, std::uint32_t right,
                    long double slack) const {
    const int one = rise_into(left, a, b, slack), two = rise_into(right, a, b, slack);
    if (one == 0 || two == 0) return 0;
    return one < 0 && two < 0 ? 1 : -1;
  }

  // Whether Y rises (1) or falls (-1) where one walks from the edge's middle into a triangle, along
  // the ray, or up or down a wall; 0 where that can't be told. A silhouette falls on both sides:
  // walking away from the eye, Y rises up to it and falls beyond.
  int rise_into(std::uint32_t t, std::uint32_t from, std::uint32_t to, long double slack) const {
    const Point &a = points_[from], &b = points_[to], &c = points_[apex(t, from, to)];
    Point m{};
    for (std::size_t i = 0; i < 3; ++i) m[i] = 0.5L * (a[i] + b[i]);
    // The plane of the ray holds what has one X; across it, for a point q: side(q - m).
    const auto side = [&](const Point& d) {
      return view_.is_perspective() ? d[0] * m[1] - m[0] * d[1] : d[0];
    };
    Point e{}, f{};
    for (std::size_t i = 0; i < 3; ++i) e[i] = b[i] - a[i], f[i] = c[i] - m[i];
    const long double size_e = std::hypot(e[0], e[1], e[2]), size_f = std::hypot(f[0], f[1], f[2]);
    const long double across = view_.is_perspective() ? std::hypot(m[0], m[1]) : 1;
    if (std::abs(side(e)) <= slack * size_e * across) return 0; // runs along the ray
    // f + s e lies in the plane of the ray.
    const long double s = -side(f) / side(e);
    Point d{};
    for (std::size_t i = 0; i < 3; ++i) d[i] = f[i] + s * e[i];
    const long double size = size_f + std::abs(s) * size_e;
    // Y grows with z and, in depth, by the ray's own steepness.
    long double rise = 0, terms = 0;
    if (view_.is_perspective()) {
      const long double steepness = (m[2] - view_.eye_z_m) / m[1];
      rise = d[2] - steepness * d[1];
      terms = (1 + std::abs(steepness)) * size;
    } else {
      rise = d[2] * view_.y_per_z + d[1] * view_.y_per_v;
      terms = size;
    }
    if (std::abs(rise) <= slack * terms) return 0;
    return rise > 0 ? 1 : -1;
  }

  std::uint32_t apex(std::uint32_t t, std::uint32_t from, std::uint32_t to) const {
    for (const std::uint32_t v : tin_.triangles[t])
      if (v != from && v != to) return v;
    return from;
  }

  const Tin& tin_;
  const View& view_;
  std::vector<Point> points_;
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> left_of_;
};

} // namespace

TEST_CASE("a grid and the TIN of its triangles have the same edges of every kind") {
  Compared sum;
  for (std::uint64_t seed = 1; seed <= last_seed(1500); ++seed) {
    Random random(seed);
    INFO("seed " << seed);
    const Grid grid = random_grid(random);
    if (triangles_of(grid).empty()) continue;
    compare(grid, random_view(grid, random), sum);
  }
  WARN(sum.silhouettes << " silhouettes, " << sum.shores << " shores, " << sum.border
                       << " border edges");
  CHECK(sum.silhouettes > enough(20000));
  CHECK(sum.shores > enough(500));
}

TEST_CASE("also of water at the eye's height, and of heights of 1e30, 1e-30 and denormals") {
  Compared sum;
  for (const double unit : {1.0, 1e30, 1e-30, 1e-310})
    for (std::uint64_t seed = 1; seed <= last_seed(150); ++seed) {
      Random random(seed);
      CAPTURE(unit, seed);
      Grid grid = made_grid(random, {7, 6, {}, {10, 0}, {0, -10}},
                            {0, random.pick({1.0, 2.0, 3.0}), 0.1, random.chance(0.6), true});
      for (double& height : std::get<Heights<double>>(grid.heights_m).own()) height *= unit;
      compare(grid, random_view(grid, random, random.pick({0.0, 1.0}) * unit), sum);
    }
  CHECK(sum.silhouettes > enough(2000));
}

TEST_CASE("silhouettes of TINs with walls are those of the definition") {
  std::size_t certain_count = 0, listed_count = 0, possible_count = 0;
  for (std::uint64_t seed = 1; seed <= last_seed(2000); ++seed) {
    Random random(seed);
    CAPTURE(seed);
    MadeTin wanted;
    wanted.columns = random.whole(2, 12);
    wanted.rows = random.whole(3, 12);
    wanted.whole = random.chance(0.5);
    wanted.step_m = 8;
    wanted.missing = random.pick({0.0, 0.1});
    wanted.walls = random.pick({0.3, 0.9});
    wanted.shuffled = random.chance(0.5);
    Tin tin = made_tin(random, wanted);
    if (tin.triangles.empty()) continue;
    if (random.chance(0.5)) add_notches(tin, random, 0.2);
    const double azimuth = random.chance(0.3) ? 90.0 * random.whole(0, 3) : random.between(0, 360);
    // In perspective in front of all, so that every edge has a depth.
    const View view = random.chance(0.5)
                          ? parallel_view(azimuth, random.pick({0.0, 10.0, 45.0, 80.0, 90.0}))
                          : [&] {
                              const Vec2 f = direction_of_azimuth(Angle::degrees(azimuth));
                              return eye_view({44 - 150 * f.x, 44 - 150 * f.y,
                                               random.pick({-20.0, 0.0, 20.0, 100.0})},
                                              azimuth + random.between(-5, 5));
                            }();
    const auto [certain, possible] = Definition(tin, view).silhouettes(1e-12L);
    const std::vector<SurfaceEdge> list = silhouette_edges(tin, view);
    REQUIRE(std::is_sorted(list.begin(), list.end()));
    REQUIRE(std::adjacent_find(list.begin(), list.end()) == list.end());
    std::vector<SurfaceEdge> missed, false_ones;
    std::set_difference(certain.begin(), certain.end(), list.begin(), list.end(),
                        std::back_inserter(missed));
    std::set_difference(list.begin(), list.end(), possible.begin(), possible.end(),
                        std::back_inserter(false_ones));
    for (const auto* edges : {&missed, &false_ones})
      for (const SurfaceEdge& e : *edges) {
        const Vec3 a = tin.vertices_m[e.from], b = tin.vertices_m[e.to];
        UNSCOPED_INFO((edges == &missed ? "missed " : "false ")
                      << e.from << " (" << a.x << ", " << a.y << ", " << a.z << ") to " << e.to
                      << " (" << b.x << ", " << b.y << ", " << b.z << ")");
      }
    REQUIRE(missed.empty());
    REQUIRE(false_ones.empty());
    certain_count += certain.size();
    listed_count += list.size();
    possible_count += possible.size();
  }
  WARN(certain_count << " silhouettes, " << listed_count << " listed, " << possible_count
                     << " may be");
  CHECK(certain_count > enough(20000));
}

} // namespace orograph::tin_silhouettes_test
