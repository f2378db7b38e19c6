// SPDX-License-Identifier: GPL-3.0-or-later
// What random solid scenes promise.
#include "placing/placed_view.hpp"
#include "tests/catch.hpp"
#include "tests/scenes/random_solid_scene.hpp"
#include "tests/support/made_solids.hpp"
#include "tests/support/random.hpp"

#include <array>
#include <map>

namespace orograph::random_solid_scene_test {
namespace {

// Every edge of every triangle is in the list once, with its triangles on the right sides.
void check_closed(const Solid& solid) {
  std::map<std::array<std::uint32_t, 2>, std::uint32_t> left;
  for (std::uint32_t t = 0; t < solid.triangles.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k) {
      const auto [found, is_new] =
          left.insert({{solid.triangles[t][k], solid.triangles[t][(k + 1) % 3]}, t});
      REQUIRE(is_new);
    }
  std::size_t sides = 0;
  for (const SolidEdge& edge : solid.edges) {
    REQUIRE(edge.from < solid.vertices_m.size());
    REQUIRE(edge.to < solid.vertices_m.size());
    if (edge.is_wire()) {
      REQUIRE(edge.right == SolidEdge::kNoTriangle);
      continue;
    }
    REQUIRE(left.at({edge.from, edge.to}) == edge.left);
    REQUIRE(left.at({edge.to, edge.from}) == edge.right);
    sides += 2;
  }
  REQUIRE(sides == left.size());
}

} // namespace

TEST_CASE("made solids are closed and right side out") {
  const auto here = [](Vec3 p) { return p; };
  const Solid box = made_box(), ring = made_cells({"###", "#.#", "###"});
  CHECK(volume_m3(stand(box, false, here)) == 1);
  CHECK(volume_m3(stand(ring, false, here)) == 8);
  CHECK(box.edges.size() == 18);
  CHECK(std::count_if(box.edges.begin(), box.edges.end(),
                      [](const SolidEdge& e) { return e.smooth; }) == 6);
  CHECK(winding_number(stand(ring, false, here), {0.5, 0.5, 0.5}) > 0.99);
  CHECK(winding_number(stand(ring, false, here), {1.5, 1.5, 0.5}) < 0.01);
  CHECK(volume_m3(stand(made_pyramid(), false, here)) == Approx(1 / 3.0));
  CHECK(volume_m3(stand(made_tetrahedron(), false, here)) == Approx(1 / 6.0));
  CHECK(volume_m3(stand(made_nested(), false, here)) == Approx(1.125));
}

TEST_CASE("random solid scenes: closed, mirrored as they say, with the eye outside") {
  std::map<Projection, int> projections;
  std::size_t solids = 0, mirrored = 0, wires = 0, beside_the_eye = 0;
  for (std::uint64_t seed = 1; seed <= last_seed(400); ++seed) {
    const SolidScene scene = random_solid_scene(seed);
    CAPTURE(seed, scene.what);
    REQUIRE(scene.standing.size() >= 1);
    REQUIRE(scene.standing.size() <= 6);
    const View view = placed_view(scene.terrain, scene.spec).view;
    ++projections[view.projection];
    for (const StandingSolid& standing : scene.standing) {
      REQUIRE(standing.vertices_m.size() == standing.solid->vertices_m.size());
      check_closed(*standing.solid);
      ++solids;
      if (standing.solid->triangles.empty()) {
        ++wires;
        continue;
      }
      mirrored += standing.mirrored;
      REQUIRE((volume_m3(standing) < 0) == standing.mirrored);
      REQUIRE(volume_m3(standing) != 0);
      if (!view.is_perspective()) continue;
      bool ahead = false, behind = false;
      for (const Vec3& vertex : standing.vertices_m) {
        const double v = to_profile_frame(view, vertex).v;
        ahead = ahead || v > 0;
        behind = behind || v < 0;
      }
      beside_the_eye += ahead && behind;
      const Vec2 eye = view.depth_origin_m;
      REQUIRE(std::abs(winding_number(standing, {eye.x, eye.y, view.eye_z_m / view.exaggeration})) <
              0.5);
    }
  }
  WARN(solids << " solids, " << mirrored << " mirrored, " << wires << " of wires, "
              << beside_the_eye << " ahead of the eye and behind it");
  CHECK(solids > enough(1000));
  CHECK(mirrored > solids / 10);
  CHECK(wires > solids / 40);
  CHECK(beside_the_eye > enough(20));
  CHECK(projections[Projection::perspective] > enough(100));
  CHECK(projections[Projection::orthographic] > enough(60));
  CHECK(projections[Projection::oblique] > enough(30));
}

TEST_CASE("and the same seed makes the same scene") {
  for (const std::uint64_t seed : {1, 2, 5, 7}) {
    const SolidScene a = random_solid_scene(seed), b = random_solid_scene(seed);
    REQUIRE(a.standing.size() == b.standing.size());
    CHECK(a.what == b.what);
    for (std::size_t i = 0; i < a.standing.size(); ++i) {
      CHECK(a.standing[i].vertices_m == b.standing[i].vertices_m);
      CHECK(*a.standing[i].solid == *b.standing[i].solid);
    }
  }
}

} // namespace orograph::random_solid_scene_test
