// SPDX-License-Identifier: GPL-3.0-or-later
// The homography of a view maps (X, Y) of a point to where the pipeline projects the point.
#include "tests/support/random.hpp"
#include "tests/view/matrices.hpp"
#include "tests/view/random_phigs_view.hpp"
#include "view/phigs_view.hpp"
#include "view/pipeline.hpp"

using namespace orograph;

namespace {

const Box2 kShown{{15, 20}, {225, 160}};
constexpr double kOfThePage = 1e-10;

struct FramePoint {
  double u, v, z;
};

FramePoint in_frame(const ProfileFrame& frame, Vec3 world) {
  const Vec3 p = world - frame.origin_m;
  const Vec2 right{frame.forward.y, -frame.forward.x}; // F x up
  return {dot(Vec2{p.x, p.y}, right), dot(Vec2{p.x, p.y}, frame.forward), p.z};
}

bool lands_on_page(Vec2 page) {
  return page.x >= kShown.low.x && page.x <= kShown.high.x && page.y >= kShown.low.y &&
         page.y <= kShown.high.y;
}

// Compares at points of the view volume with v > 0; returns how many there were.
int compare(Random& random, const PhigsView& view, const ProfileFrame& frame) {
  const Eigen::Matrix4d page = compose(Eigen::Matrix4d::Identity(), view, kShown);
  const Homography homography = homography_of(view, frame, kShown);
  const Vec3 along = direction_of_projection(view);
  const FramePoint d = in_frame({{}, frame.forward}, along);
  int compared = 0;
  for (int i = 0; i < 20; ++i) {
    const Vec3 world = world_of(view, point_within(random, view));
    const auto [u, v, z] = in_frame(frame, world);
    Vec2 plane{u / v, z / v};
    if (view.projection == PhigsProjection::parallel)
      plane = d.v > 0 ? Vec2{u - v * d.u / d.v, z - v * d.z / d.v} : Vec2{u, v};
    else if (!(v > 0))
      continue;
    const Vec3 image = moved(page, world);
    const Vec2 expected{image.x, image.y};
    if (!lands_on_page(expected)) continue;
    REQUIRE(homography.w(plane) > 0);
    CAPTURE(expected.x, expected.y, plane.x, plane.y);
    REQUIRE(length(homography(plane) - expected) < kOfThePage * kShown.height());
    ++compared;
  }
  return compared;
}

Vec2 random_heading(Random& random) {
  const double azimuth = random.between(0, 2 * M_PI);
  return {std::sin(azimuth), std::cos(azimuth)};
}

} // namespace

TEST_CASE("perspective: the homography agrees with the pipeline") {
  int compared = 0;
  for (std::uint64_t seed = 1; seed <= last_seed(1000); ++seed) {
    Random random(seed);
    INFO("seed " << seed);
    const PhigsView view = random_phigs_view(random, PhigsProjection::perspective);
    const ProfileFrame frame = frame_of(view);
    compared += compare(random, view, frame);
    compared += compare(random, view, {frame.origin_m, random_heading(random)}); // another sector
  }
  CHECK(compared > enough(10000));
}

TEST_CASE("parallel: the homography agrees with the pipeline") {
  int compared = 0;
  for (std::uint64_t seed = 1; seed <= last_seed(1000); ++seed) {
    Random random(seed);
    INFO("seed " << seed);
    const PhigsView view = random_phigs_view(random, PhigsProjection::parallel);
    const ProfileFrame frame = frame_of(view);
    compared += compare(random, view, frame);
    const Homography homography = homography_of(view, frame, kShown);
    REQUIRE(homography.m[6] == 0);
    REQUIRE(homography.m[7] == 0);
    REQUIRE(homography.m[8] == 1);
  }
  CHECK(compared > enough(19000));
}

TEST_CASE("the frame of a view") {
  for (const PhigsProjection projection : {PhigsProjection::perspective, PhigsProjection::parallel})
    for (std::uint64_t seed = 1; seed <= last_seed(1000); ++seed) {
      Random random(seed);
      INFO("seed " << seed << (projection == PhigsProjection::parallel ? " parallel" : ""));
      const PhigsView view = random_phigs_view(random, projection);
      const Vec3 n = axes_of(view).n, along = direction_of_projection(view);
      const ProfileFrame frame = frame_of(view);
      REQUIRE(std::abs(length(frame.forward) - 1) < 1e-15);
      const Vec3 ray = projectors_of(view);
      const auto [u, v, away] = axes_of(view);
      const Vec3 expected = ray.x * u + ray.y * v - away;
      REQUIRE(distance(along, (1 / length(expected)) * expected) < 1e-13);
      if (projection == PhigsProjection::perspective) {
        REQUIRE(distance(frame.origin_m, world_of(view, view.prp_m)) < 1e-11);
        REQUIRE(distance(eye_m(view), frame.origin_m) == 0);
      } else {
        REQUIRE(frame.origin_m == Vec3{view.vrp_m.x, view.vrp_m.y, 0});
        REQUIRE(dot(frame.forward, Vec2{along.x, along.y}) > 0);
      }
      const double against = dot(Vec2{along.x, along.y}, Vec2{n.x, n.y});
      if (projection == PhigsProjection::perspective || against < -2e-3 * length(Vec2{n.x, n.y})) {
        REQUIRE(std::abs(cross(frame.forward, Vec2{n.x, n.y})) < 1e-12); // parallel to the plate
        REQUIRE(dot(frame.forward, Vec2{n.x, n.y}) < 0);
      }
    }
}

TEST_CASE("level and upright view planes") {
  PhigsView view;
  view.projection = PhigsProjection::parallel;
  Random random(1);

  // A plan: straight down, north up. Depth runs up the page.
  view.vpn = {0, 0, 1};
  view.vup = {0, 5, 0};
  CHECK(frame_of(view).forward == Vec2{0, 1});
  CHECK(compare(random, view, frame_of(view)) > 0);

  // A military view: the ground stays as it is, lines of sight come down northwards at 45 degrees.
  view.prp_m = {0, -1, 1};
  CHECK(length(frame_of(view).forward - Vec2{0, 1}) < 1e-15);
  CHECK(compare(random, view, frame_of(view)) > 0);
  const Homography plan = homography_of(view, frame_of(view), kShown);
  // A step up in height goes as far up the page as a step north on the ground.
  CHECK(plan({0, 0}).y - plan({0, 1}).y == Approx(kShown.height() / 2));

  view.vpn = {1e-12, -1e-12, 1}; // level but for rounding
  CHECK(length(frame_of(view).forward - Vec2{0, 1}) < 1e-9);
  CHECK(compare(random, view, frame_of(view)) > 0);

  // A cavalier view: the plate is upright and faces south, depth goes up and to the right.
  view.vpn = {0, -1, 0};
  view.vup = {0, 0, 1};
  view.prp_m = {std::sqrt(0.5), std::sqrt(0.5), 1};
  CHECK(frame_of(view).forward == Vec2{0, 1});
  CHECK(compare(random, view, frame_of(view)) > 0);

  // Lines of sight along the plate's horizontal, and against it.
  view.vpn = {0, -0.6, 0.8};
  view.prp_m = {1, 0.75, 1}; // d horizontally along -u only
  CHECK(length(frame_of(view).forward - Vec2{-1, 0}) < 1e-12);
  CHECK(compare(random, view, frame_of(view)) > 0);
  view.prp_m = {0, 10, 1};
  CHECK(length(frame_of(view).forward - Vec2{0, -1}) < 1e-12);
  CHECK(compare(random, view, frame_of(view)) > 0);

  // A camera straight down.
  view = {};
  view.vpn = {0, 0, 1};
  view.vup = {1, 1, 0};
  CHECK(length(frame_of(view).forward - Vec2{std::sqrt(0.5), std::sqrt(0.5)}) < 1e-15);
  CHECK(compare(random, view, frame_of(view)) > 0);
}
