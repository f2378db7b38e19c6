// SPDX-License-Identifier: GPL-3.0-or-later
// The views of the command line, given to the pipeline of the papers: the same pictures.
#include "tests/catch.hpp"
#include "tests/support/random.hpp"
#include "tests/view/made_terrain.hpp"
#include "tests/view/matrices.hpp"
#include "view/phigs_view.hpp"
#include "view/pipeline.hpp"

using namespace orograph;

TEST_CASE("perspective, orthographic and oblique views are the pipeline's") {
  int compared = 0;
  for (std::uint64_t seed = 1; seed <= last_seed(1000); ++seed) {
    Random random(seed);
    const MadeTerrain terrain = made_terrain(random, 8);
    ViewRequest request;
    request.projection =
        random.pick({Projection::perspective, Projection::orthographic, Projection::oblique});
    request.oblique = {random.between(0.2, 1.5), Angle::degrees(random.between(0, 180))};
    request.from_azimuth = Angle::degrees(random.between(0, 360));
    request.from_elevation = Angle::degrees(random.between(0, 45));
    request.exaggeration = random.pick({1.0, 2.0});
    request.roll = Angle::degrees(random.pick({0.0, random.between(-180, 180)}));
    const View view = place_view(request, terrain.shape(), 0.7);
    // Onto a page on which y runs down: the window itself, upside down.
    const Box2 window = view.window;
    const Eigen::Matrix4d to_page =
        compose(Eigen::Matrix4d::Identity(), phigs_of(view),
                {{window.low.x, -window.high.y}, {window.high.x, -window.low.y}});
    // And back: the same profiles and visibility plane.
    const View back = place_phigs_view(phigs_of(view), view.exaggeration, 10);
    REQUIRE(length(back.forward - view.forward) <= 1e-12);
    if (view.is_perspective()) {
      REQUIRE(std::abs(back.eye_z_m - view.eye_z_m) <= 1e-12 * std::abs(view.eye_z_m));
      REQUIRE(length(back.depth_origin_m - view.depth_origin_m) <= 1e-9);
    }
    for (const Vec3& vertex : terrain.vertices) {
      REQUIRE(largest(picture_of(back, vertex) - picture_of(view, vertex)) <=
              1e-9 * std::max(window.width(), largest(picture_of(view, vertex))));
      const Vec3 image = moved(to_page, exaggerated(vertex, request.exaggeration));
      const Vec2 picture = picture_of(view, vertex);
      CAPTURE(seed, static_cast<int>(request.projection), image.x, -image.y, picture.x, picture.y);
      // Coordinates of some thousand metres are divided by windows of a few hundred.
      REQUIRE(largest(Vec2{image.x, -image.y} - picture) <=
              1e-9 * std::max(window.width(), largest(picture)));
      ++compared;
    }
  }
  CHECK(compared > enough(10000));
}
