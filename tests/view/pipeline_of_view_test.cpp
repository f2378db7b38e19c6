// SPDX-License-Identifier: GPL-3.0-or-later
// The views of the command line, given to the pipeline of the papers: the same pictures.
#include "tests/catch.hpp"
#include "tests/view/made_terrain.hpp"
#include "tests/view/matrices.hpp"
#include "view/phigs_view.hpp"
#include "view/pipeline.hpp"

using namespace orograph;

namespace {

// The picture plane of a View is at distance 1 from the eye; a parallel one is measured from the
// target's place at height 0.
PhigsView as_phigs(const View& view) {
  PhigsView phigs;
  const Vec3 forward{view.forward.x, view.forward.y, 0}, right{view.right.x, view.right.y, 0},
      up{0, 0, 1};
  const double c = cos(view.elevation), s = sin(view.elevation);
  const Vec3 axis = view.projection == Projection::oblique ? forward : c * forward - s * up;
  const Vec3 upright = cross(right, axis);
  const double roll = view.roll.in_radians();
  phigs.vpn = -1.0 * axis;
  phigs.vup = std::cos(roll) * upright - std::sin(roll) * right; // the picture turns clockwise
  phigs.window_m = view.window;
  phigs.back_m = -1e6;
  if (view.is_perspective()) {
    const Vec3 eye{view.depth_origin_m.x, view.depth_origin_m.y, view.eye_z_m};
    phigs.vrp_m = eye + axis;
    phigs.prp_m = {0, 0, 1};
    phigs.front_m = 0.5;
    return phigs;
  }
  phigs.projection = PhigsProjection::parallel;
  phigs.vrp_m = {view.depth_origin_m.x, view.depth_origin_m.y, 0};
  phigs.front_m = 1e5;
  // Towards the viewer from the window's centre, in (u, v, n).
  const Vec2 centre = view.window.centre();
  const double turned_x = std::cos(roll) * view.x_per_v + std::sin(roll) * view.y_per_v,
               turned_y = std::cos(roll) * view.y_per_v - std::sin(roll) * view.x_per_v;
  const bool oblique = view.projection == Projection::oblique;
  phigs.prp_m = {centre.x + (oblique ? turned_x : 0), centre.y + (oblique ? turned_y : 0), 1};
  return phigs;
}

} // namespace

TEST_CASE("perspective, orthographic and oblique views are the pipeline's") {
  int compared = 0;
  for (std::uint64_t seed = 1; seed <= 1000; ++seed) {
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
        compose(Eigen::Matrix4d::Identity(), as_phigs(view),
                {{window.low.x, -window.high.y}, {window.high.x, -window.low.y}});
    for (const Vec3& vertex : terrain.vertices) {
      const Vec3 image = moved(to_page, exaggerated(vertex, request.exaggeration));
      const Vec2 picture = picture_of(view, vertex);
      CAPTURE(seed, static_cast<int>(request.projection), image.x, -image.y, picture.x, picture.y);
      // Coordinates of some thousand metres are divided by windows of a few hundred.
      REQUIRE(largest(Vec2{image.x, -image.y} - picture) <=
              1e-9 * std::max(window.width(), largest(picture)));
      ++compared;
    }
  }
  CHECK(compared > 10000);
}
