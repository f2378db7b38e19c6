// SPDX-License-Identifier: GPL-3.0-or-later
// Panoramas of whole scenes: what is seen, where it is drawn, and that nobody sees where their
// sectors meet, or where their pages begin.
#include "dem/height_at.hpp"
#include "draw/round_drawing.hpp"
#include "geometry/error.hpp"
#include "geometry/on_all_cores.hpp"
#include "placing/panorama.hpp"
#include "tests/catch.hpp"
#include "tests/draw/to_segment.hpp"
#include "tests/scenes/asked_scenes.hpp"
#include "tests/scenes/random_scene.hpp"
#include "tests/scenes/same_drawing.hpp"
#include "tests/support/grid_of.hpp"
#include "tests/support/random.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

using namespace orograph;

namespace {

struct PanoramaScene {
  TerrainData terrain;
  MapSpec spec;
};

// From an eye above the ground, all round.
PanoramaScene made_panorama(std::uint64_t seed, int most = 24) {
  Random random(seed + 3900);
  PanoramaScene out{random_scene(seed, most).terrain, {}};
  const Grid& grid = grid_of(out.terrain);
  Vec2 at;
  std::optional<double> height;
  while (!height) { // not over a gap
    at = grid.plane().position_m(0, 0) +
         random.between(0.1, 0.9) * (grid.columns - 1) * grid.plane().column_step_m +
         random.between(0.1, 0.9) * (grid.rows - 1) * grid.plane().row_step_m;
    height = height_at(grid, at);
  }
  out.spec.view.projection = random.pick({Projection::cylindrical, Projection::equirectangular});
  out.spec.view.eye_map =
      GivenPlace(out.terrain.map.to_map({at.x, at.y, *height + random.pick({0.5, 20.0, 200.0})}));
  out.spec.view.exaggeration = random.pick({1.0, 1.5});
  out.spec.view.curvature = random.pick({Curvature::on, Curvature::off});
  out.spec.page.width_mm = random.pick({300.0, 1000.0});
  out.spec.page.height_mm.reset();
  out.spec.page.orientation = Orientation::as_given;
  out.spec.style.plan = ProfileCount{random.whole(10, 40)};
  out.spec.style.light.reset();
  return out;
}

Map drawn(const PanoramaScene& scene, const MapSpec& spec) {
  const PlacedView placed = placed_view(scene.terrain, spec);
  return draw_map(scene.terrain, placed, spec, [](double) {});
}
Map drawn(const PanoramaScene& scene) {
  return drawn(scene, scene.spec);
}

// An end of a stroke.
struct End {
  Vec2 at;
  double width_mm;
  bool goes_left; // its stroke does, from here
};

std::vector<End> ends_at(const Layer& layer, double x_mm) {
  std::vector<End> out;
  for (const Stroke& stroke : layer.strokes) {
    const auto points = layer.points(stroke);
    for (const auto& [end, next] : {std::pair{points.front(), points[1]},
                                    std::pair{points.back(), points[points.size() - 2]}})
      if (std::abs(end.x - x_mm) <= kPageStep_mm)
        out.push_back({end, stroke.width_mm, next.x < end.x});
  }
  return out;
}

double line_length_mm_of(const Layer& layer) {
  double sum = 0;
  for (const Stroke& stroke : layer.strokes) sum += line_length_mm(layer.points(stroke));
  return sum;
}

bool crosses(std::span<const Vec2> points, double x_mm) {
  const auto [low, high] = std::minmax({points.front().x, points.back().x});
  return low < x_mm - 1 && high > x_mm + 1;
}

} // namespace

TEST_CASE("what a panorama draws is visible, and nothing visible is missing") {
  Asked sum;
  for (std::uint64_t seed = 1; seed <= last_seed(60); ++seed) {
    PanoramaScene scene = made_panorama(seed);
    if (seed % 3 == 0)
      scene.spec.view.azimuth_range = AzimuthRange{
          Angle::degrees(350), Angle::degrees(350 + 10.0 * static_cast<double>(seed % 7 + 1))};
    CAPTURE(seed);
    try {
      sum.add(ask(scene.terrain, scene.spec, 1000));
    } catch (const Error& error) {
      CHECK(std::string(error.what()).find("no terrain in the directions") != std::string::npos);
    }
  }
  report("panoramas", sum);
  CHECK(sum.scenes >= enough(50));
  CHECK(sum.asked >= enough(50000)); // of 1000 a scene
}

TEST_CASE(
    "points of a panorama are at the azimuth and the altitude of their places on the ground") {
  std::uint64_t asked = 0;
  for (std::uint64_t seed = 1; seed <= last_seed(24); ++seed) {
    PanoramaScene scene = made_panorama(seed);
    scene.spec.view.curvature = Curvature::off; // straight lines sag less than the ground does
    scene.spec.ground_points = true;
    scene.spec.style.contours.interval = 20;
    scene.spec.style.layers.push_back("contours");
    scene.spec.style.layers.push_back("edges");
    scene.spec.page.strips = seed % 2 == 0 ? 3 : 1;
    scene.spec.view.look_azimuth = Angle::degrees(17.0 * static_cast<double>(seed));
    const PlacedView placed = placed_view(scene.terrain, scene.spec);
    const Map map = draw_map(scene.terrain, placed, scene.spec, [](double) {});
    const Panorama& panorama = *placed.panorama;
    const Vec3 eye = *scene.spec.view.eye_map->z >= 0
                         ? Vec3{scene.spec.view.eye_map->x, scene.spec.view.eye_map->y,
                                *scene.spec.view.eye_map->z}
                         : Vec3{};
    const long double turn = 2 * std::numbers::pi_v<long double>;
    const long double middle = 17.0L * static_cast<long double>(seed) * turn / 360;
    for (const Layer& layer : map.drawing.layers)
      for (std::size_t i = 0; i < layer.page_mm.size(); ++i) {
        const long double x = static_cast<long double>(layer.map[i].x) - eye.x,
                          y = static_cast<long double>(layer.map[i].y) - eye.y,
                          z = (static_cast<long double>(layer.map[i].z) - eye.z) *
                              placed.exaggeration;
        const long double azimuth = std::remainder(std::atan2(x, y) - middle, turn);
        const long double tangent = z / std::hypot(x, y);
        const double across = static_cast<double>(panorama.page.radius_mm * azimuth),
                     up = static_cast<double>(panorama.page.radius_mm *
                                              (panorama.kind == PanoramaKind::cylindrical
                                                   ? tangent
                                                   : std::atan(tangent)));
        // On either side of the seam, and in whatever strip.
        double least = 1e9;
        for (const double side : {0.0, 1.0, -1.0}) {
          const double at_x = panorama.page.ahead_mm.x + across +
                              side * static_cast<double>(panorama.page.radius_mm * turn);
          const double at_y = panorama.page.ahead_mm.y - up;
          for (std::size_t k = 0; k < std::max<std::size_t>(1, panorama.strips.size()); ++k) {
            const Vec2 shift = panorama.strips.empty() ? Vec2{} : panorama.strips[k].shift_mm;
            least = std::min(least, length(layer.page_mm[i] - Vec2{at_x, at_y} - shift));
          }
        }
        ++asked;
        INFO(layer.name << " " << seed);
        // Rounding; ends that are cut at the frame or a strip keep a neighbour's place on the map.
        if (least > page_rounding_mm() + 2e-5 + 1e-6) {
          const Vec2 p = layer.page_mm[i];
          const bool at_frame = std::abs(p.y - placed.frame_mm.low.y) < 1e-3 ||
                                std::abs(p.y - placed.frame_mm.high.y) < 1e-3 ||
                                !panorama.strips.empty();
          REQUIRE(at_frame);
        }
      }
  }
  CHECK(asked >= enough(20000));
}

TEST_CASE("strokes go on where a panorama's sectors meet", "[unsanitized]") {
  std::uint64_t through = 0, ends = 0;
  for (std::uint64_t seed = 1; seed <= last_seed(12); ++seed) {
    PanoramaScene scene = made_panorama(seed);
    scene.spec.view.curvature = Curvature::off;
    if (seed % 2 == 0) {
      scene.spec.style.light = LightSpec{};
      scene.spec.style.light->of_picture = seed % 4 == 0;
      scene.spec.style.plan.reset();
    }
    const PlacedView placed = placed_view(scene.terrain, scene.spec);
    const Map map = draw_map(scene.terrain, placed, scene.spec, [](double) {});
    for (std::size_t k = 0; k + 1 < placed.sectors.size(); ++k) {
      const double border_mm = placed.sectors[k].frame_mm->high.x;
      for (const Layer& layer : map.drawing.layers) {
        for (const Stroke& stroke : layer.strokes)
          through += crosses(layer.points(stroke), border_mm) ? 1 : 0;
        const std::vector<End> there = ends_at(layer, border_mm);
        ends += there.size();
        for (const End& a : there)
          for (const End& b : there) {
            INFO(layer.name << " " << seed << ": " << a.at.x << " " << a.at.y);
            // Both are rounded.
            const bool meet = a.goes_left && !b.goes_left && a.width_mm == b.width_mm &&
                              std::abs(a.at.y - b.at.y) <= 2 * kPageStep_mm;
            REQUIRE(!meet);
          }
      }
    }
  }
  CHECK(through >= enough(2000));
  // A sector has some eight columns of tone here, and lines begin, end and widen between them: up
  // to a fifth, as between the columns in a sector's middle.
  CHECK(4 * ends <= through);
  WARN("panoramas' borders: " << through << " strokes go through, " << ends << " end there");
}

TEST_CASE("a panorama that begins elsewhere is the same but where it begins", "[unsanitized]") {
  std::uint64_t asked = 0;
  Random random(83);
  for (std::uint64_t seed = 1; seed <= last_seed(8); ++seed) {
    PanoramaScene scene = made_panorama(seed);
    scene.spec.style.spread = Spread::planes;
    scene.spec.style.simplify_mm = 0; // which begins at the ends of what is cut open
    scene.spec.style.join_mm = 0;
    scene.spec.style.min_stroke_mm = 0;
    MapSpec turned = scene.spec;
    constexpr double kTurn_deg = 83;
    turned.view.look_azimuth = Angle::degrees(180 + kTurn_deg);
    const PlacedView placed = placed_view(scene.terrain, scene.spec);
    const Map a = drawn(scene), b = drawn(scene, turned);
    const double around_mm = placed.frame_mm.width(), left_mm = placed.frame_mm.low.x,
                 shift_mm = around_mm * kTurn_deg / 360;
    REQUIRE(a.drawing.layers.size() == b.drawing.layers.size());
    const auto is_there = [&](const Layer& layer, Vec2 p) {
      // Both rounded, and bent with points elsewhere where one of them is cut open.
      constexpr double kSame_mm = 2 * kPageStep_mm;
      for (const Stroke& stroke : layer.strokes) {
        const auto points = layer.points(stroke);
        for (std::size_t i = 1; i < points.size(); ++i)
          if (to_segment(p, points[i - 1], points[i]) <= kSame_mm) return true;
      }
      return false;
    };
    for (std::size_t i = 0; i < a.drawing.layers.size(); ++i) {
      const Layer &one = a.drawing.layers[i], &other = b.drawing.layers[i];
      const double ink_mm = line_length_mm_of(one), other_mm = line_length_mm_of(other);
      CHECK(std::abs(ink_mm - other_mm) <= 1e-4 * ink_mm + 0.1);
      for (int k = 0; k < 40 && !one.page_mm.empty(); ++k) {
        const Vec2 p = one.page_mm[static_cast<std::size_t>(
            random.whole(0, static_cast<int>(one.page_mm.size()) - 1))];
        // In the other drawing it is farther left, or around.
        const double x = p.x - shift_mm < left_mm ? p.x - shift_mm + around_mm : p.x - shift_mm;
        if (std::abs(p.x - shift_mm - left_mm) < 0.01) continue;
        ++asked;
        INFO(one.name << " " << seed << ": " << p.x << " " << p.y);
        CHECK(is_there(other, {x, p.y}));
      }
    }
  }
  CHECK(asked >= enough(500));
}

TEST_CASE("a panorama shows the skyline with sky above it, or the altitudes that are asked for") {
  for (std::uint64_t seed = 1; seed <= last_seed(20); ++seed) {
    PanoramaScene scene = made_panorama(seed);
    CAPTURE(seed);
    const Map map = drawn(scene);
    CHECK(map.facts.counts.strokes > 0);
    const PlacedView placed = placed_view(scene.terrain, scene.spec);
    double highest = -1e9;
    for (const Layer& layer : map.drawing.layers)
      for (const Vec2 p : layer.page_mm) highest = std::max(highest, -p.y);
    CHECK(-highest > placed.frame_mm.low.y); // not cut off
    MapSpec asked = scene.spec;
    asked.view.altitude_range = AltitudeRange{Angle::degrees(-12), Angle::degrees(7)};
    const PlacedView with = placed_view(scene.terrain, asked);
    const PanoramaPage& page = with.panorama->page;
    const bool on_cylinder = page.kind == PanoramaKind::cylindrical;
    const double deg = std::numbers::pi / 180;
    CHECK(with.frame_mm.low.y ==
          Approx(page.ahead_mm.y - page.radius_mm * (on_cylinder ? std::tan(7 * deg) : 7 * deg)));
    CHECK(with.frame_mm.high.y ==
          Approx(page.ahead_mm.y + page.radius_mm * (on_cylinder ? std::tan(12 * deg) : 12 * deg)));
    CHECK(with.frame_mm.width() == Approx(2 * std::numbers::pi * page.radius_mm));
  }
}

TEST_CASE("a panorama is the same on any number of cores", "[unsanitized]") {
  std::size_t strokes = 0;
  for (const std::uint64_t seed : {1, 2}) {
    PanoramaScene scene = made_panorama(seed);
    scene.spec.style.light = LightSpec{};
    scene.spec.style.plan.reset();
    scene.spec.page.strips = 3;
    std::vector<Map> maps(3);
    for (int jobs = 1; jobs <= 3; ++jobs)
      on_cores(jobs, {}, [&] { maps[static_cast<std::size_t>(jobs - 1)] = drawn(scene); });
    strokes += maps[0].facts.counts.strokes;
    CHECK(difference(maps[0].drawing, maps[1].drawing).empty());
    CHECK(difference(maps[0].drawing, maps[2].drawing).empty());
  }
  CHECK(strokes > 100);
}
