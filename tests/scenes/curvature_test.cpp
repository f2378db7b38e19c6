// SPDX-License-Identifier: GPL-3.0-or-later
// The earth's curvature, less refraction: the horizon of the sea, mountains beyond it, and made
// scenes on a small planet, where it shows.
#include "dem/approximate/tin_of_grid.hpp"
#include "dem/mesh/verify_tin.hpp"
#include "placing/geodesy.hpp"
#include "profiles/profile.hpp"
#include "tests/scenes/asked_scenes.hpp"
#include "tests/scenes/random_scene.hpp"
#include "tests/scenes/visible_parts.hpp"
#include "tests/support/grid_of.hpp"
#include "tests/support/random.hpp"
#include "view/sectors.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numbers>

namespace orograph::curvature_test {
namespace {

const std::uint64_t kScenes = last_seed(400);

constexpr double kRadius_m = 6371000;

constexpr const char* kUtm32 =
    "PROJCS[\"WGS 84 / UTM zone 32N\",GEOGCS[\"WGS 84\",DATUM[\"WGS_1984\","
    "SPHEROID[\"WGS 84\",6378137,298.257223563]],PRIMEM[\"Greenwich\",0],"
    "UNIT[\"degree\",0.0174532925199433]],PROJECTION[\"Transverse_Mercator\"],"
    "PARAMETER[\"latitude_of_origin\",0],PARAMETER[\"central_meridian\",9],"
    "PARAMETER[\"scale_factor\",0.9996],PARAMETER[\"false_easting\",500000],"
    "PARAMETER[\"false_northing\",0],UNIT[\"metre\",1]]";

// A strip of sea to the north of (0, 0), which begins 100 m behind it, of square cells.
TerrainData sea(double length_m, double cell_m) {
  TerrainData terrain;
  Grid grid;
  grid.columns = 9;
  grid.rows = static_cast<int>(std::ceil((length_m + 100) / cell_m)) + 1;
  grid.plane().first_vertex_m = {-4 * cell_m, (grid.rows - 1) * cell_m - 100};
  grid.plane().column_step_m = {cell_m, 0};
  grid.plane().row_step_m = {0, -cell_m};
  grid.heights_m = std::vector<double>(grid.size(), 0.0);
  terrain.surface = std::move(grid);
  terrain.map.radii = CurvatureRadii{kRadius_m, kRadius_m};
  return terrain;
}

MapSpec northwards(double eye_m, double refraction) {
  MapSpec spec;
  spec.view.eye_map = Vec3{0, 0, eye_m};
  spec.view.look_at_map = Vec3{0, 10000, eye_m};
  spec.view.field_of_view = Angle::degrees(2);
  spec.view.curvature = Curvature::on;
  spec.view.refraction = refraction;
  spec.style.simplify_mm = 0;
  spec.style.silhouette_jump = 0;
  spec.style.flat = FlatGround::draw;
  spec.style.plan = ProfileCount{200};
  return spec;
}

// The greatest Y, straight ahead, of what is drawn.
double highest_y(const TerrainData& terrain, const MapSpec& spec) {
  class Seen : public LineObserver {
  public:
    const View* view = nullptr;
    double highest = -1e9;
    void see(const SeenProfile&) override {}
    void see(const SeenLines& seen) override {
      const auto& [sector, clipped, lines, visible, listed] = seen;
      for (const LinePart& part : visible)
        for (const double t : {part.t_begin, part.t_end}) {
          const Vec2 at = project(sector.view, lines.point(part.line, t));
          if (std::abs(at.x) < 0.01) highest = std::max(highest, at.y);
        }
    }
  } seen;
  const PlacedView scene = placed_view(terrain, spec);
  REQUIRE(scene.curvature.applied);
  draw_map(terrain, scene, spec, [](double) {}, {.observers = {&seen}, .beyond_page = true});
  return seen.highest;
}

// A small planet, on which made scenes of some hundred metres bend.
void shrink_the_earth(RandomScene& scene, Random& random) {
  const Box3 box = extent_of(scene.terrain.surface).box;
  const double size = std::max(box.high.x - box.low.x, box.high.y - box.low.y);
  const double radius = size * random.pick({1.0, 10.0, 1000.0});
  scene.terrain.map.radii = CurvatureRadii{radius, radius * random.between(1, 1.3)};
  scene.spec.view.curvature = Curvature::on;
  scene.spec.view.refraction = random.pick({0.0, 0.13, 0.9, -0.5});
}

} // namespace

TEST_CASE("the sea ends at its horizon") {
  for (const double refraction : {0.0, 0.13})
    for (const double eye : {2.0, 50.0, 1000.0, 9000.0}) {
      const double effective = kRadius_m / (1 - refraction);
      const double distance = std::sqrt(2 * effective * eye);
      const double cell = distance / 400;
      const TerrainData terrain = sea(1.5 * distance, cell);
      MapSpec spec = northwards(eye, refraction);
      const double dip = std::sqrt(2 * eye / effective); // its tangent, of a parabola
      spec.view.look_at_map->z = eye - 10000 * dip;
      CAPTURE(eye, refraction, distance);
      // Between vertices the sea is flat: too low by cell^2 / 8R, seen at the horizon's distance;
      // and the farthest that is seen is a vertex, up to half a cell from the horizon.
      const double chord = cell * cell / (8 * effective) / distance;
      CHECK(std::abs(highest_y(terrain, spec) + dip) <= 2 * chord);
      // Degrees: at 9 km 3.0427 without refraction (3.0437 on a sphere, which a parabola isn't).
      if (eye == 9000 && refraction == 0)
        CHECK(std::abs(std::atan(dip) * 180 / std::numbers::pi - 3.0427) < 1e-3);
    }
}

TEST_CASE("a mountain beyond the horizon shows from its limiting height on") {
  for (const double refraction : {0.0, 0.13})
    for (const double eye : {10.0, 500.0}) {
      const double effective = kRadius_m / (1 - refraction);
      const double horizon = std::sqrt(2 * effective * eye), away = 2.5 * horizon;
      const double limit = (away - horizon) * (away - horizon) / (2 * effective);
      const double cell = horizon / 200;
      for (const double times : {0.97, 1.03}) {
        TerrainData terrain = sea(1.1 * away, cell);
        Grid& grid = grid_of(terrain);
        const int row = static_cast<int>(std::round((grid.plane().first_vertex_m.y - away) / cell));
        const auto heights = std::get<Heights<double>>(grid.heights_m).own();
        heights[grid.index(4, row)] = times * limit;
        MapSpec spec = northwards(eye, refraction);
        const double dip = std::sqrt(2 * eye / effective);
        spec.view.look_at_map->z = eye - 10000 * dip;
        CAPTURE(eye, refraction, times, limit);
        const double top = highest_y(terrain, spec) + dip;
        const double expected = (times - 1) * limit / away;
        if (times < 1)
          CHECK(top < 0.02 * limit / away);
        else
          CHECK(std::abs(top - expected) < 0.2 * expected); // of the summit's own place
      }
    }
}

TEST_CASE("on a flat map the sea has no end") {
  const TerrainData terrain = sea(20000, 50);
  MapSpec spec = northwards(100, 0.13);
  spec.view.curvature = Curvature::off;
  const PlacedView scene = placed_view(terrain, spec);
  CHECK_FALSE(scene.curvature.applied);
  CHECK_FALSE(scene.view.drop.any());
}

TEST_CASE("curvature is drawn by itself where it would show, and not in parallel views") {
  MapSpec spec;
  for (const double length : {300.0, 60000.0}) {
    TerrainData terrain = sea(length, length / 100);
    const auto heights = std::get<Heights<double>>(grid_of(terrain).heights_m).own();
    for (std::size_t i = 0; i < heights.size(); ++i) heights[i] = i % 7;
    const PlacedView scene = placed_view(terrain, spec);
    CAPTURE(length, scene.curvature.would_move_mm);
    CHECK(scene.curvature.applied == (length > 1000));
    MapSpec flat = spec;
    flat.view.projection = Projection::orthographic;
    CHECK_FALSE(placed_view(terrain, flat).curvature.applied);
    flat.view.curvature = Curvature::on;
    CHECK(placed_view(terrain, flat).curvature.applied);
    terrain.map.radii.reset(); // without a CRS
    CHECK_FALSE(placed_view(terrain, spec).curvature.applied);
  }
}

TEST_CASE("a vertex sinks by the square of its distance, by Euler's radius in its azimuth") {
  Random random(1);
  for (int i = 0; i < 1000; ++i) {
    const double m = random.between(1e3, 7e6), n = random.between(1e3, 7e6);
    const double k = random.between(0, 1);
    MapFrame map;
    map.radii = CurvatureRadii{m, n};
    View view;
    view.depth_origin_m = {random.between(-1000, 1000), random.between(-1000, 1000)};
    const double heading = random.between(0, 6.28);
    view.forward = {std::sin(heading), std::cos(heading)};
    view.right = {view.forward.y, -view.forward.x};
    view.exaggeration = random.pick({1.0, 2.0});
    view.drop = drop_in_frame(earth_drop(map, k), view.forward);
    const double azimuth = random.between(0, 6.28), distance = random.between(0, 5e3);
    const Vec3 at{view.depth_origin_m.x + distance * std::sin(azimuth),
                  view.depth_origin_m.y + distance * std::cos(azimuth), random.between(0, 100)};
    const double radius =
        1 / (std::cos(azimuth) * std::cos(azimuth) / m + std::sin(azimuth) * std::sin(azimuth) / n);
    const double expected = at.z * view.exaggeration - (1 - k) * distance * distance / (2 * radius);
    const ProfilePoint p = to_profile_frame(view, at);
    CAPTURE(m, n, k, azimuth, distance);
    REQUIRE(std::abs(p.z - expected) <= 1e-12 * (100 + std::abs(expected)));
    REQUIRE(length(to_ground_m(view, p) - at) <= 1e-9);
    const ProfilePoint behind = to_profile_frame(sector_behind(view), at);
    REQUIRE(behind.z == p.z);
  }
}

TEST_CASE("what is looked at is in the picture's middle on a round earth too") {
  for (std::uint64_t seed = 1; seed <= last_seed(200); ++seed) {
    RandomScene scene = random_scene(seed);
    Random random(seed + 850000);
    shrink_the_earth(scene, random);
    MapSpec& spec = scene.spec;
    spec.view.projection = Projection::perspective;
    const Box3 box = extent_of(scene.terrain.surface).box;
    const Vec3 target = box.centre();
    spec.view.look_at_map = target;
    spec.view.exaggeration = random.pick({1.0, 2.0});
    spec.view.field_of_view = Angle::degrees(40);
    if (random.chance(0.5))
      spec.view.eye_map = target + Vec3{random.between(-1, 1) * (box.high.x - box.low.x),
                                        box.high.y - box.low.y, box.high.z - box.low.z + 100};
    else
      spec.view.distance_m = 2 * (box.high.x - box.low.x);
    const PlacedView placed = placed_view(scene.terrain, spec);
    const View& view = placed.view;
    const Vec3 image =
        view.to_picture.of(project_homogeneous(view, to_profile_frame(view, target)));
    CAPTURE(seed, image.x, image.y, image.z);
    REQUIRE(placed.curvature.applied);
    REQUIRE(image.z > 0);
    CHECK(std::hypot(image.x, image.y) <= 1e-9 * image.z);
  }
}

TEST_CASE("the ray walk agrees on a small planet, in any view", "[slow]") {
  Asked sum;
  for (std::uint64_t seed = 1; seed <= kScenes; ++seed) {
    RandomScene scene = random_scene(seed);
    Random random(seed + 800000);
    shrink_the_earth(scene, random);
    if (random.chance(0.3)) { // straight down, in two sectors
      scene.spec.view.projection = Projection::perspective;
      scene.spec.view.from_elevation = Angle::degrees(random.between(75, 90));
    }
    if (random.chance(0.3)) scene.spec.style.layers.push_back("edges");
    CAPTURE(seed, scene.what, scene.spec.view.refraction, scene.terrain.map.radii->meridian_m);
    sum.add(ask(scene.terrain, scene.spec, 2000));
  }
  report("small planets", sum);
  CHECK(sum.ties < sum.asked / 20);
}

TEST_CASE("and of a grid and its TIN the same is seen there") {
  std::size_t compared = 0, tied = 0;
  for (std::uint64_t seed = 1; seed <= kScenes / 4; ++seed) {
    RandomScene scene = random_scene(seed);
    Random random(seed + 900000);
    shrink_the_earth(scene, random);
    scene.spec.style.flat = FlatGround::draw;
    std::erase(scene.spec.style.layers, LayerSpec("shores"));
    TerrainData as_tin = scene.terrain;
    as_tin.surface = tin_of(grid_of(scene.terrain));
    const PlacedView placed = placed_view(scene.terrain, scene.spec);
    PlacedView of_tin = placed;
    of_tin.border = border_edges(std::get<Tin>(as_tin.surface));
    of_tin.level = {}; // which has the numbers of the grid's triangles
    VisibleParts by_grid(placed), by_tin(of_tin);
    draw_map(scene.terrain, placed, scene.spec, [](double) {},
             {.observers = {&by_grid}, .beyond_page = true, .order_always = true});
    draw_map(as_tin, of_tin, scene.spec, [](double) {},
             {.observers = {&by_tin}, .beyond_page = true});
    const VisibleDifference found = difference(
        by_grid, by_tin, placed,
        judges_of(scene.terrain.surface, placed, scene.spec.style.visibility_tolerance_mm));
    INFO(seed << ", " << scene.what << ": " << found.first_wrong);
    CHECK(found.wrong() == 0);
    compared += by_grid.lines.size();
    tied += found.tied;
  }
  WARN(compared << " lines; " << tied << " stretches differ and are tied");
  CHECK(tied <= compared / 10000);
  CHECK(compared > enough(10000));
}

// Along a transverse Mercator, from a point E1, N1 (from the central meridian) to E2, N2: the line
// of the map is off the geodesic by (N2 - N1) (2 E1 + E2) / 6 R^2, and scale grows by E^2 / 2 R^2
// (Snyder 1987, Map projections: a working manual, chapter 8).
TEST_CASE("the map plane's own errors are in the budget, where the map is distorted") {
  for (const double east_m : {0.0, 250e3}) {
    TerrainData terrain;
    Grid grid;
    grid.columns = grid.rows = 51;
    grid.plane().first_vertex_m = {-25e3, 25e3};
    grid.plane().column_step_m = {1000, 0};
    grid.plane().row_step_m = {0, -1000};
    grid.heights_m = std::vector<double>(grid.size(), 0.0);
    std::get<Heights<double>>(grid.heights_m).own()[1300] = 500;
    terrain.surface = std::move(grid);
    terrain.map.origin = {500e3 + east_m, 5200e3};
    terrain.map.crs_wkt = kUtm32;
    MapSpec spec;
    spec.view.eye_map = Vec3{500e3 + east_m, 5175e3, 3000};
    spec.view.look_at_map = Vec3{500e3 + east_m, 5200e3, 0};
    const PlacedView scene = placed_view(terrain, spec);
    const double r2 = kRadius_m * kRadius_m;
    const double turn = 50e3 * (3 * east_m + 25e3) / (6 * r2);
    const double stretch = 0.0004 - (east_m + 25e3) * (east_m + 25e3) / (2 * r2); // of a given eye
    // The page is 277 mm wide, 2 tan 15 degrees at distance 1.
    const double per_radian = 277 / (2 * std::tan(std::numbers::pi / 12));
    const double found = map_plane_mm(scene, terrain.map, true).value();
    CAPTURE(east_m, turn, stretch, found);
    CHECK(found >= 0.7 * per_radian * turn);
    CHECK(found <= 1.3 * per_radian * std::hypot(turn, 0.3 * std::abs(stretch)));
    CHECK(map_plane_mm(scene, terrain.map, false).value() < found);
    terrain.map.crs_wkt.clear();
    CHECK_FALSE(map_plane_mm(scene, terrain.map, true));
  }
}

} // namespace orograph::curvature_test
