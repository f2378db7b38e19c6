// SPDX-License-Identifier: GPL-3.0-or-later
// The whole pipeline over TINs, asked by the ray walk: nothing drawn is hidden, nothing visible is
// missing, in any layer.
#include "dem/extent.hpp"
#include "dem/height_at.hpp"
#include "dem/mesh/verify_tin.hpp"
#include "geometry/error.hpp"
#include "tests/catch.hpp"
#include "tests/scenes/asked_scenes.hpp"
#include "tests/scenes/random_tin_scene.hpp"
#include "tests/support/random.hpp"

#include <cmath>
#include <cstdlib>

namespace orograph::tin_scenes_test {
namespace {

const std::uint64_t kScenes = last_seed(350);

CheckCounts ask_tin(const TerrainData& terrain, const MapSpec& spec, std::uint64_t probes) {
  const auto fault = verify(std::get<Tin>(terrain.surface));
  INFO((fault ? fault->what : ""));
  REQUIRE(!fault);
  return ask(terrain, spec, probes);
}

// At the highest surface of a vertex, of an edge's middle or of any place on a triangle; or over no
// ground at all; looks at another vertex.
void put_eye(MapSpec& spec, const Tin& tin, Random& random) {
  const auto vertex = [&] {
    return tin.vertices_m[static_cast<std::size_t>(
        random.whole(0, static_cast<int>(tin.vertices_m.size()) - 1))];
  };
  const auto& corners = tin.triangles[static_cast<std::size_t>(
      random.whole(0, static_cast<int>(tin.triangles.size()) - 1))];
  const Vec3 a = tin.vertices_m[corners[0]], b = tin.vertices_m[corners[1]],
             c = tin.vertices_m[corners[2]];
  const int kind = random.whole(0, 3);
  Vec3 eye = a;
  if (kind == 1) eye = 0.5 * (a + b);
  if (kind == 2) {
    const double s = random.share(), t = random.share() * (1 - s);
    eye = a + s * (b - a) + t * (c - a);
  }
  if (kind == 3) eye = 0.5 * (vertex() + vertex());
  if (const auto height = height_at(tin, {eye.x, eye.y})) eye.z = *height;
  Vec3 target = vertex();
  for (int i = 0; i < 100 && std::hypot(target.x - eye.x, target.y - eye.y) < 1; ++i)
    target = vertex();
  const double away = std::hypot(target.x - eye.x, target.y - eye.y);
  eye.z += random.pick({0.0, 0.0, 0.001, 1.7, 50.0});
  target.z = eye.z + random.pick({0.0, 0.1, -0.1}) * away;
  spec.view.projection = Projection::perspective;
  spec.view.exaggeration = 1;
  spec.view.field_of_view = Angle::degrees(random.pick({30.0, 60.0, 90.0}));
  spec.view.eye_map = eye;
  spec.view.look_at_map = target;
}

} // namespace

TEST_CASE("the ray walk agrees with every line of made TINs", "[slow]") {
  Asked sum;
  std::uint64_t refused = 0;
  for (std::uint64_t seed = 1; seed <= kScenes; ++seed) {
    const RandomTinScene scene = random_tin_scene(seed);
    CAPTURE(seed, scene.what);
    try {
      sum.add(ask_tin(scene.terrain, scene.spec, 2000));
    } catch (const Error&) {
      ++refused; // too steep for a perspective of a narrow TIN
    }
  }
  report("made TINs", sum);
  CHECK(refused <= kScenes / 50);
  CHECK(sum.ties < sum.asked / 20);
}

TEST_CASE("and with profiles through vertices and along edges and walls", "[slow]") {
  Asked sum;
  for (std::uint64_t seed = 1; seed <= kScenes; ++seed) {
    RandomTinScene scene = random_tin_scene(8 * seed, false);
    Random random(seed + 200000);
    scene.spec.view.from_azimuth = Angle::degrees(90.0 * random.whole(0, 3));
    // The first profile is half of the spacing behind the nearest vertex.
    const double unit_m = cell_size_m(scene.terrain.surface) > 1000 ? 1024 : 1;
    scene.spec.style.plan = GroundSpacing{unit_m * random.pick({2.0, 4.0, 16.0, 32.0})};
    scene.spec.view.projection =
        random.chance(0.7) ? Projection::orthographic : Projection::perspective;
    if (scene.spec.view.projection == Projection::perspective)
      scene.spec.view.from_elevation = Angle::degrees(random.between(0, 30));
    CAPTURE(seed, scene.what);
    sum.add(ask_tin(scene.terrain, scene.spec, 2000));
  }
  report("along edges", sum);
  CHECK(sum.ties < sum.asked / 5);
}

TEST_CASE("and from an eye on the surface, on a vertex, in a hole, a millimetre above it",
          "[slow]") {
  Asked sum;
  std::uint64_t refused = 0;
  for (std::uint64_t seed = 1; seed <= kScenes; ++seed) {
    RandomTinScene scene = random_tin_scene(seed);
    Random random(seed + 100000);
    put_eye(scene.spec, std::get<Tin>(scene.terrain.surface), random);
    CAPTURE(seed, scene.what, scene.spec.view.eye_map->x, scene.spec.view.eye_map->y,
            *scene.spec.view.eye_map->z);
    try {
      sum.add(ask_tin(scene.terrain, scene.spec, 2000));
    } catch (const Error&) {
      ++refused; // the height below the eye rounds to above it, or the page shows the nadir
    }
  }
  report("eyes at the surface", sum);
  WARN(refused << " views refused");
  CHECK(sum.ties < sum.asked / 3);
}

} // namespace orograph::tin_scenes_test
