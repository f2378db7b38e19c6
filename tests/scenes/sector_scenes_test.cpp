// SPDX-License-Identifier: GPL-3.0-or-later
// Cameras that look straight down or up, or far aside: drawn in two sectors, without a seam.
#include "geometry/error.hpp"
#include "profiles/profile.hpp"
#include "tests/scenes/asked_scenes.hpp"
#include "tests/scenes/look_down.hpp"
#include "tests/scenes/random_scene.hpp"
#include "tests/support/grid_of.hpp"
#include "tests/support/random.hpp"
#include "view/sectors.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace orograph::sector_scenes_test {
namespace {

const std::uint64_t kScenes = last_seed(350);

// A low hill, all of which can be seen from straight above.
TerrainData gentle(int columns, int rows) {
  TerrainData terrain;
  Grid grid;
  grid.columns = columns;
  grid.rows = rows;
  grid.plane().first_vertex_m = {-10.0 * (columns - 1) / 2, 10.0 * (rows - 1) / 2};
  grid.plane().column_step_m = {10, 0};
  grid.plane().row_step_m = {0, -10};
  std::vector<double> heights;
  for (int r = 0; r < rows; ++r)
    for (int c = 0; c < columns; ++c)
      heights.push_back(100 + 3 * std::sin(0.4 * c) + 2 * std::cos(0.5 * r));
  grid.heights_m = std::move(heights);
  terrain.surface = std::move(grid);
  return terrain;
}

const Layer& layer_named(const Drawing& drawing, const std::string& name) {
  const auto layer = std::find_if(drawing.layers.begin(), drawing.layers.end(),
                                  [&](const Layer& l) { return l.name == name; });
  REQUIRE(layer != drawing.layers.end());
  return *layer;
}

} // namespace

TEST_CASE("the ray walk agrees with cameras that look straight down, and nearly", "[slow]") {
  Asked sum;
  int two_sectors = 0, refused = 0;
  for (std::uint64_t seed = 1; seed <= kScenes; ++seed) {
    RandomScene scene = random_scene(seed);
    Random random(seed + 400000);
    look_down(scene.spec, scene.terrain, random);
    if (random.chance(0.3)) scene.spec.style.layers.push_back("edges");
    CAPTURE(seed, scene.what, scene.spec.view.eye_map->x, scene.spec.view.eye_map->y,
            *scene.spec.view.eye_map->z, scene.spec.view.look_at_map->x,
            scene.spec.view.look_at_map->y);
    try {
      const PlacedView placed = placed_view(scene.terrain, scene.spec);
      two_sectors += placed.sectors.size() == 2;
      sum.add(ask(scene.terrain, scene.spec, 2000));
    } catch (const Error&) {
      ++refused; // the eye's height rounds to under the ground
    }
  }
  report("looking down", sum);
  WARN(two_sectors << " in two sectors");
  CHECK(two_sectors > static_cast<int>(kScenes / 2));
  CHECK(refused < static_cast<int>(kScenes / 20));
  CHECK(sum.ties < sum.asked / 10);
}

TEST_CASE("who looks down at their own feet sees ground, whatever the terrain's relief") {
  TerrainData terrain = gentle(41, 41);
  const auto heights = std::get<Heights<double>>(grid_of(terrain).heights_m).own();
  heights[3] = -2000; // far off, a gorge
  for (const double pitch : {-90.0, -60.0, -30.0}) {
    MapSpec spec;
    spec.view.eye_map = GivenPlace(3, 4); // at a man's height
    spec.view.look_azimuth = Angle::degrees(40);
    spec.view.pitch = Angle::degrees(pitch);
    spec.view.exaggeration = 1;
    const PlacedView scene = placed_view(terrain, spec);
    const Map drawn = draw_map(terrain, scene, spec, [](double) {});
    CAPTURE(pitch, scene.depths_m.size());
    // 0.6 mm apart on A4, on what of the page shows ground.
    CHECK(layer_named(drawn.drawing, "profiles").strokes.size() > 60);
    CHECK(scene.depths_m.size() < 5000);
  }
}

TEST_CASE("from straight above nothing of a gentle hill is missing, and no line has a seam") {
  for (const auto& [columns, rows] : {std::pair{21, 15}, {20, 14}, {21, 14}}) {
    const TerrainData terrain = gentle(columns, rows);
    const Grid& grid = grid_of(terrain);
    for (const double azimuth : {180.0, 90.0, 33.0, 225.0}) {
      CAPTURE(columns, rows, azimuth);
      MapSpec spec;
      spec.view.from_azimuth = Angle::degrees(azimuth);
      spec.view.from_elevation = Angle::degrees(90);
      spec.view.exaggeration = 1;
      spec.view.look_at_map = Vec3{0, 0, 100}; // with 21 columns, rows over the eye's own place
      spec.style.layers = {"profiles", "border", "edges"};
      spec.style.simplify_mm = 0;
      spec.style.plan = ProfileCount{24};
      const PlacedView scene = placed_view(terrain, spec);
      REQUIRE(scene.sectors.size() == 2);
      const Drawing drawing =
          draw_map(terrain, scene, spec, [](double) {}, {.order_always = true}).drawing;
      REQUIRE(!find_fault(drawing));

      const Layer& border = layer_named(drawing, "border");
      REQUIRE(border.strokes.size() == 1);
      const auto ring = border.points(border.strokes[0]);
      CHECK(ring.front() == ring.back());
      // Each profile is one stroke, and they are all there, in both sectors.
      const Layer& profiles = layer_named(drawing, "profiles");
      CHECK(profiles.strokes.size() == 24);
      std::vector<int> numbers;
      for (const Stroke& stroke : profiles.strokes) {
        numbers.push_back(stroke.profile);
        CHECK(stroke.depth_m == scene.depths_m[static_cast<std::size_t>(stroke.profile)]);
      }
      std::sort(numbers.begin(), numbers.end());
      for (int i = 0; i < 24; ++i) CHECK(numbers[static_cast<std::size_t>(i)] == i);

      // Every edge is drawn as long as it is in the picture.
      double drawn_mm = 0, whole_mm = 0;
      for (const char* name : {"border", "edges"}) {
        const Layer& layer = layer_named(drawing, name);
        for (const Stroke& stroke : layer.strokes) {
          const auto points = layer.points(stroke);
          for (std::size_t i = 1; i < points.size(); ++i)
            drawn_mm += length(points[i] - points[i - 1]);
        }
      }
      const auto page = [&](int column, int row) {
        const Vec2 at = grid.plane().position_m(column, row);
        const Vec3 p = scene.to_page.of(project_homogeneous(
            scene.view, to_profile_frame(scene.view, {at.x, at.y, grid.height_m(column, row)})));
        return Vec2{p.x / p.z, p.y / p.z};
      };
      int edges = 0;
      for (int r = 0; r < rows; ++r)
        for (int c = 0; c < columns; ++c)
          for (const auto& [dc, dr] : {std::pair{1, 0}, {0, 1}, {1, 1}})
            if (c + dc < columns && r + dr < rows) {
              whole_mm += length(page(c + dc, r + dr) - page(c, r));
              ++edges;
            }
      // Ends are rounded to 1e-4 mm.
      CHECK(std::abs(drawn_mm - whole_mm) <= edges * 2e-4);
    }
  }
}

TEST_CASE("what is visible doesn't depend on pitch, roll or field, to the bit") {
  class Seen : public LineObserver {
  public:
    std::vector<double> parts;
    void see(const SeenProfile& seen) override {
      const auto& [sector, clipped, profile, segments, visible] = seen;
      for (const Piece& p : visible)
        parts.insert(parts.end(),
                     {sector.behind ? -profile.depth_m : profile.depth_m,
                      static_cast<double>(left_vertex(segments[p.segment])), p.t_begin, p.t_end});
    }
    void see(const SeenLines& seen) override {
      const auto& [sector, clipped, lines, visible, listed] = seen;
      for (const LinePart& p : visible)
        parts.insert(parts.end(),
                     {sector.behind ? 1.0 : 0, static_cast<double>(p.line), p.t_begin, p.t_end});
    }
  };
  int compared = 0, in_two_sectors = 0;
  for (std::uint64_t seed = 1; seed <= kScenes / 4; ++seed) {
    RandomScene scene = random_scene(seed);
    MapSpec& spec = scene.spec;
    Random random(seed + 500000);
    look_down(spec, scene.terrain, random);
    spec.style.visibility_tolerance_mm = 0;
    const Vec3 eye{spec.view.eye_map->x, spec.view.eye_map->y, spec.view.eye_map->z.value()};
    const Box3 box = extent_of(scene.terrain.surface).box;
    spec.style.plan = GroundSpacing{(box.high.x - box.low.x) / 15};
    const double heading = random.between(0, 6.28);
    std::vector<double> first[2]; // by the number of sectors
    for (int i = 0; i < 6; ++i) {
      // The horizontal view direction to the bit: it is a difference of coordinates.
      spec.view.look_at_map =
          Vec3{eye.x + 1000 * std::sin(heading), eye.y + 1000 * std::cos(heading),
               eye.z - random.pick({100.0, 300.0, 1000.0, 4000.0})};
      spec.view.field_of_view = Angle::degrees(random.between(60, 150));
      spec.view.roll = Angle::degrees(random.between(-180, 180));
      std::optional<PlacedView> found;
      try {
        found = placed_view(scene.terrain, spec);
      } catch (const Error&) {
        continue; // looks away from the terrain
      }
      const PlacedView& placed = *found;
      Seen seen;
      draw_map(scene.terrain, placed, spec, [](double) {},
               {.observers = {&seen}, .beyond_page = true, .order_always = true});
      auto& parts = first[shows_beside(placed.view) ? 1 : 0];
      CAPTURE(seed, scene.what, i);
      if (parts.empty()) {
        parts = seen.parts;
        continue;
      }
      REQUIRE(seen.parts == parts);
      ++compared;
      in_two_sectors += placed.sectors.size() == 2;
    }
  }
  CHECK(compared > static_cast<int>(kScenes / 2));
  CHECK(in_two_sectors > static_cast<int>(kScenes / 8));
}

} // namespace orograph::sector_scenes_test
