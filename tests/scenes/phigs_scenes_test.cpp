// SPDX-License-Identifier: GPL-3.0-or-later
// Views by PHIGS's parameters over made terrain: any plate, any direction, with planes that cut.
#include "dem/extent.hpp"
#include "dem/mesh/verify_tin.hpp"
#include "geometry/error.hpp"
#include "placing/terrain_of_view.hpp"
#include "placing/view_in_frame.hpp"
#include "profiles/profile.hpp"
#include "tests/scenes/asked_scenes.hpp"
#include "tests/scenes/random_scene.hpp"
#include "tests/support/grid_of.hpp"
#include "tests/support/random.hpp"
#include "tests/view/random_phigs_view.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace orograph::phigs_scenes_test {
namespace {

const std::uint64_t kScenes = last_seed(250);

Vec3 turned(Vec3 p, double angle) {
  return {std::cos(angle) * p.x - std::sin(angle) * p.y,
          std::sin(angle) * p.x + std::cos(angle) * p.y, p.z};
}

// A view plane through the terrain's middle, tilted anyhow, seen from above.
ViewFile view_of(const TerrainData& terrain, Random& random) {
  const Box3 box = extent_of(terrain.surface).box;
  const double size = std::max(box.high.x - box.low.x, box.high.y - box.low.y);
  ViewFile view;
  view.projection = random.pick({PhigsProjection::perspective, PhigsProjection::parallel});
  view.vrp_map = box.centre();
  view.vpn = turned({0, -1, random.pick({0.0, 0.3, 1.0, 5.0, 1e3})}, random.between(0, 6.28));
  view.vup = random.pick({Vec3{0, 0, 1}, Vec3{0.3, 0.2, 1}, Vec3{1, 0.5, -0.3}});
  const Vec2 centre{random.between(-0.2, 0.2) * size, random.between(-0.2, 0.2) * size};
  const Vec2 half{random.between(0.2, 0.8) * size, random.between(0.2, 0.8) * size};
  view.window_m = {centre - half, centre + half};
  view.prp_m = {centre.x + random.pick({0.0, random.between(-1, 1) * size}),
                centre.y + random.pick({0.0, random.between(0, 1) * size}),
                random.between(0.6, 2) * size};
  if (random.chance(0.6)) view.front_m = random.between(0, 0.4) * size;
  if (random.chance(0.6)) view.back_m = random.between(-0.5, -0.05) * size;
  view.exaggeration = random.pick({1.0, 2.0});
  return view;
}

// Visible stretches by what they belong to: a profile's vertex, or a line other than a profile.
class Visible : public LineObserver {
public:
  std::map<std::pair<double, std::uint32_t>, std::vector<std::pair<double, double>>> stretches;
  void see(const SeenProfile& seen) override {
    const auto& [sector, clipped, profile, segments, visible] = seen;
    for (const Piece& p : visible) {
      // Which profile, by its depth to a millimetre.
      const double depth = std::round(profile.depth_m * 1e3);
      stretches[{depth, left_vertex(segments[p.segment])}].emplace_back(p.t_begin, p.t_end);
    }
  }
  void see(const SeenLines& seen) override {
    const auto& visible = seen.visible;
    for (const LinePart& p : visible) stretches[{-1e99, p.line}].emplace_back(p.t_begin, p.t_end);
  }
};

// Length, in shares of lines, that is visible in one and not in the other.
double difference(const Visible& a, const Visible& b) {
  double sum = 0;
  const auto of = [](const Visible& v, const auto& key) {
    const auto at = v.stretches.find(key);
    return at == v.stretches.end() ? std::vector<std::pair<double, double>>{} : at->second;
  };
  std::map<std::pair<double, std::uint32_t>, int> keys;
  for (const auto* v : {&a, &b})
    for (const auto& [key, stretches] : v->stretches) keys[key] = 0;
  for (const auto& [key, unused] : keys) {
    const auto in_a = of(a, key), in_b = of(b, key);
    double length_a = 0, length_b = 0, both = 0;
    for (const auto& [begin, end] : in_a) length_a += end - begin;
    for (const auto& [begin, end] : in_b) length_b += end - begin;
    for (const auto& [begin, end] : in_a)
      for (const auto& [from, to] : in_b)
        both += std::max(0.0, std::min(end, to) - std::max(begin, from));
    sum += length_a + length_b - 2 * both;
  }
  return sum;
}

} // namespace

TEST_CASE("the ray walk agrees with any PHIGS view, cut by its planes or not", "[slow]") {
  Asked sum;
  int refused = 0, cut = 0, parallel = 0;
  for (std::uint64_t seed = 1; seed <= kScenes; ++seed) {
    RandomScene scene = random_scene(seed);
    Random random(seed + 600000);
    scene.spec.view.file = view_of(scene.terrain, random);
    scene.spec.view.exaggeration.reset();
    CAPTURE(seed, scene.what);
    try {
      if (auto kept = cut_by_view(scene.terrain, scene.spec.view)) scene.terrain = std::move(*kept);
      if (const Tin* tin = std::get_if<Tin>(&scene.terrain.surface)) {
        const auto fault = verify(*tin);
        INFO((fault ? fault->what : ""));
        REQUIRE(!fault);
        ++cut;
      }
      sum.add(ask(scene.terrain, scene.spec, 2000));
      parallel += scene.spec.view.file->projection == PhigsProjection::parallel;
    } catch (const Error& error) {
      ++refused; // planes that leave nothing, a parallel view that looks up, an eye under ground
    }
  }
  report("PHIGS views", sum);
  WARN(refused << " refused, " << cut << " cut, " << parallel << " parallel");
  CHECK(refused < static_cast<int>(kScenes / 4));
  CHECK(cut > static_cast<int>(kScenes / 4));
  CHECK(parallel > static_cast<int>(kScenes / 8));
  CHECK(sum.ties < sum.asked / 10);
}

TEST_CASE("what is visible doesn't depend on the plate, its window or its turn") {
  int compared = 0;
  double greatest = 0;
  for (std::uint64_t seed = 1; seed <= kScenes / 4; ++seed) {
    RandomScene scene = random_scene(seed);
    MapSpec& spec = scene.spec;
    Random random(seed + 700000);
    spec.style.visibility_tolerance_mm = 0;
    spec.view.exaggeration.reset();
    const Box3 box = extent_of(scene.terrain.surface).box;
    const double size = std::max(box.high.x - box.low.x, box.high.y - box.low.y);
    spec.style.plan = GroundSpacing{size / 15};
    const bool parallel = random.chance(0.5);
    const double heading = random.between(0, 6.28);
    const Vec3 middle = box.centre();
    // In perspective the eye; else towards the viewer.
    const Vec3 towards = turned({random.pick({0.0, 0.3}), -1, random.between(0.2, 1.2)}, heading);
    const Vec3 eye = middle + 2 * size * towards;
    std::vector<Visible> seen;
    for (int i = 0; i < 4; ++i) {
      // Plates across the same heading, tilted by more or less, turned in themselves.
      PhigsView plate;
      plate.vpn = turned({0, -1, random.pick({0.0, 0.2, 0.5, 1.0})}, heading);
      const double roll = random.between(-3, 3);
      plate.vup = std::cos(roll) * Vec3{0, 0, 1} + std::sin(roll) * turned({1, 0, 0}, heading);
      plate.vrp_m = middle;
      const auto [u, v, n] = axes_of(plate);
      ViewFile view;
      view.projection = parallel ? PhigsProjection::parallel : PhigsProjection::perspective;
      view.vrp_map = plate.vrp_m;
      view.vpn = plate.vpn;
      view.vup = plate.vup;
      const Vec2 half{random.between(0.5, 1) * size, random.between(0.5, 1) * size};
      if (parallel) {
        const Vec2 centre{random.between(-0.1, 0.1) * size, random.between(-0.1, 0.1) * size};
        view.window_m = {centre - half, centre + half};
        view.prp_m = {centre.x + dot(towards, u), centre.y + dot(towards, v), dot(towards, n)};
      } else {
        view.window_m = {Vec2{} - half, half};
        view.prp_m = {dot(eye - middle, u), dot(eye - middle, v), dot(eye - middle, n)};
      }
      spec.view.file = view;
      const PlacedView placed = placed_view(scene.terrain, spec);
      if (placed.sectors.size() > 1) continue; // cut at another near plane
      draw_map(scene.terrain, placed, spec, [](double) {},
               {.observers = {&seen.emplace_back()}, .beyond_page = true, .order_always = true});
    }
    for (std::size_t i = 1; i < seen.size(); ++i) {
      CAPTURE(seed, scene.what, parallel, i);
      const double found = difference(seen[0], seen[i]);
      greatest = std::max(greatest, found);
      // The eye and the direction come out of each plate rounded to some 1e-16.
      REQUIRE(found <= 1e-6);
      ++compared;
    }
  }
  WARN(compared << " compared, greatest difference " << greatest << " of a line");
  CHECK(compared > static_cast<int>(kScenes / 4));
}

TEST_CASE("terrain of any size comes back through a view file") {
  for (const double size : {1e-3, 1.0, 1e4})
    for (const char* projection : {"perspective", "orthographic", "oblique"}) {
      RandomScene scene = random_scene(3);
      Grid& grid = grid_of(scene.terrain);
      for (Vec2* step :
           {&grid.plane().column_step_m, &grid.plane().row_step_m, &grid.plane().first_vertex_m})
        *step = size * *step;
      std::visit(
          [&](auto& heights) {
            for (auto& h : heights.own()) h *= static_cast<float>(size);
          },
          grid.heights_m);
      MapSpec& spec = scene.spec;
      spec = {};
      spec.view.from_azimuth = Angle::degrees(200);
      spec.view.from_elevation = Angle::degrees(40);
      spec.view.exaggeration = 1.5;
      spec.view.projection = projection[0] == 'p'   ? Projection::perspective
                             : projection[1] == 'r' ? Projection::orthographic
                                                    : Projection::oblique;
      spec.style.plan = ProfileCount{20};
      const PlacedView placed = placed_view(scene.terrain, spec);
      const Map named = draw_map(scene.terrain, placed, spec, [](double) {});
      MapSpec by_file = spec;
      by_file.view.file = view_file_of(placed.view, scene.terrain.map);
      by_file.view.exaggeration.reset();
      const PlacedView again = placed_view(scene.terrain, by_file);
      const Map filed = draw_map(scene.terrain, again, by_file, [](double) {});
      CAPTURE(size, projection);
      CHECK(named.facts.counts.strokes > 20);
      CHECK(std::abs(static_cast<double>(named.facts.counts.strokes) -
                     static_cast<double>(filed.facts.counts.strokes)) <=
            0.02 * static_cast<double>(named.facts.counts.strokes)); // ties, by rounding
      // The same place of the page for a point of the terrain.
      const auto page = [&](const PlacedView& of, Vec3 at) {
        const Vec3 image =
            of.to_page.of(project_homogeneous(of.view, to_profile_frame(of.view, at)));
        return Vec2{image.x / image.z, image.y / image.z};
      };
      const Vec3 centre = placed.extent.box.centre();
      for (const Vec3& at : {centre, placed.extent.box.low, placed.extent.box.high})
        CHECK(length(page(placed, at) - page(again, at)) <= 1e-6);
    }
}

} // namespace orograph::phigs_scenes_test
