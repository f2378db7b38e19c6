// SPDX-License-Identifier: GPL-3.0-or-later
// The whole pipeline against its stages and against projection by its definition.
#include "tests/support/random.hpp"
#include "tests/view/matrices.hpp"
#include "tests/view/random_phigs_view.hpp"
#include "view/pipeline.hpp"

#include <Eigen/LU>

#include <limits>

using namespace orograph;

namespace {

constexpr PhigsProjection kBoth[] = {PhigsProjection::perspective, PhigsProjection::parallel};
const Box2 kViewport{{15, 20}, {225, 160}};

Vec2 on_page(const Eigen::Matrix4d& page, Vec3 world) {
  const Vec3 image = moved(page, world);
  return {image.x, image.y};
}

} // namespace

TEST_CASE("the workstation transformation puts the window into the viewport") {
  const Eigen::Matrix4d d = workstation_transformation(kWholeWindow, kViewport);
  CHECK(distance(moved(d, {-1, 1, -0.25}), {15, 20, -0.25}) < 1e-13); // upper left
  CHECK(distance(moved(d, {1, -1, -0.75}), {225, 160, -0.75}) < 1e-13);
  CHECK(distance(moved(d, {0, 0, 0}), {120, 90, 0}) < 1e-13);
  const Eigen::Matrix4d part = workstation_transformation({{0, -0.5}, {0.5, 1}}, kViewport);
  CHECK(distance(moved(part, {0, 1, 0}), {15, 20, 0}) < 1e-13);
  CHECK(distance(moved(part, {0.5, -0.5, 0}), {225, 160, 0}) < 1e-13);

  check_refused([] { workstation_transformation({{0, 0}, {0, 1}}, kViewport); }, "is empty");
  check_refused(
      [] {
        workstation_transformation(kWholeWindow, {{0, 9}, {9, 9}});
      },
      "the viewport is empty");
  check_refused(
      [] {
        workstation_transformation(kWholeWindow, {{0, 0}, {NAN, 9}});
      },
      "the viewport is not a finite number");
}

TEST_CASE("the pipeline is the product of its stages") {
  for (const PhigsProjection projection : kBoth)
    for (std::uint64_t seed = 1; seed <= last_seed(1000); ++seed) {
      Random random(seed);
      INFO("seed " << seed << (projection == PhigsProjection::parallel ? " parallel" : ""));
      const PhigsView view = random_phigs_view(random, projection);
      const Eigen::Matrix4d model = model_transform(
          {rotation(random_direction(random), Angle::degrees(random.between(-180, 180))),
           scaling({random.between(0.5, 2), random.between(0.5, 2), random.between(0.5, 2)}),
           translation(random_point(random, 10))});
      const CanonicalVolume volume = canonical_volume(view);
      const Vec3 world = world_of(view, point_within(random, view));
      const Vec3 setup = moved(model.inverse(), world);

      Vec3 p = moved(model, setup);
      p = moved(view_orientation(view.vrp_m, view.vpn, view.vup), p);
      p = moved(view_mapping(view), p);
      if (projection == PhigsProjection::perspective)
        p = moved(perspective_transformation(volume.z_min), p);
      REQUIRE(std::max({std::abs(p.x), std::abs(p.y), std::abs(2 * p.z + 1)}) < 1 + 1e-9);
      p = moved(workstation_transformation(kWholeWindow, kViewport), p);

      // 1e-12 of the page for each metre-sized digit that the world's coordinates cost.
      const double lost = length(world) / view.window_m.width();
      REQUIRE(distance(moved(compose(model, view, kViewport), setup), p) <
              1e-12 * kViewport.width() * std::max(1.0, lost));
    }
}

TEST_CASE("the pipeline projects along straight lines to the view plane") {
  for (const PhigsProjection projection : kBoth)
    for (std::uint64_t seed = 1; seed <= last_seed(1000); ++seed) {
      Random random(seed);
      INFO("seed " << seed << (projection == PhigsProjection::parallel ? " parallel" : ""));
      const PhigsView view = random_phigs_view(random, projection);
      const Eigen::Matrix4d page = compose(Eigen::Matrix4d::Identity(), view, kViewport);
      const double lost = length(view.vrp_m) / view.window_m.width();
      for (int i = 0; i < 10; ++i) {
        const Vec3 uvn = point_within(random, view), world = world_of(view, uvn);
        const Vec2 expected = page_by_definition(view, kViewport, world);
        REQUIRE(length(on_page(page, world) - expected) <
                1e-12 * kViewport.width() * std::max(1.0, lost));
        REQUIRE((page * homogeneous(world)).w() > 0);
      }
    }
}

TEST_CASE("the pipeline mirrors nothing") {
  for (const PhigsProjection projection : kBoth)
    for (std::uint64_t seed = 1; seed <= last_seed(1000); ++seed) {
      Random random(seed);
      INFO("seed " << seed << (projection == PhigsProjection::parallel ? " parallel" : ""));
      const PhigsView view = random_phigs_view(random, projection);
      const Eigen::Matrix4d page = compose(Eigen::Matrix4d::Identity(), view, kViewport);
      REQUIRE(page.determinant() < 0); // only by the page's y, which runs down
      const Vec3 uvn = point_within(random, view);
      const double step = 0.1 * view.window_m.width();
      const Vec2 at = on_page(page, world_of(view, uvn)),
                 right = on_page(page, world_of(view, uvn + Vec3{step, 0, 0})),
                 up = on_page(page, world_of(view, uvn + Vec3{0, step, 0}));
      REQUIRE(right.x > at.x);
      REQUIRE(up.y < at.y);
      REQUIRE(cross(right - at, up - at) < 0); // counterclockwise where y runs down
    }
  // A viewer in the south, at 10 m height, looks north: what is east is on the right of the page.
  PhigsView view;
  view.vrp_m = {0, -99, 10};
  view.back_m = -200;
  const Eigen::Matrix4d page = compose(Eigen::Matrix4d::Identity(), view, kViewport);
  CHECK(length(on_page(page, {0, 5, 10}) - Vec2{120, 90}) < 1e-12); // straight in front
  CHECK(length(on_page(page, {0, 60, 10}) - Vec2{120, 90}) < 1e-12);
  CHECK(on_page(page, {20, 5, 10}).x > 121);
  CHECK(on_page(page, {-20, 5, 10}).x < 119);
  CHECK(on_page(page, {0, 5, 20}).y < 89);
  CHECK(on_page(page, {0, 5, 0}).y > 91);
}

TEST_CASE("straight in front of the eye, a point stays on the axis") {
  for (std::uint64_t seed = 1; seed <= last_seed(1000); ++seed) {
    Random random(seed);
    INFO("seed " << seed);
    PhigsView view = random_phigs_view(random, PhigsProjection::perspective);
    view.vrp_m = random_point(random, 10);
    view.prp_m.x = view.window_m.centre().x;
    view.prp_m.y = view.window_m.centre().y;
    const Eigen::Matrix4d page = compose(Eigen::Matrix4d::Identity(), view, kViewport);
    for (const double n : {view.front_m, 0.0, view.back_m, 10 * view.back_m - 10}) {
      if (n >= view.front_m + 1) continue;
      const Vec2 at = on_page(page, world_of(view, {view.prp_m.x, view.prp_m.y, n}));
      REQUIRE(length(at - kViewport.centre()) < 1e-9);
    }
  }
}

TEST_CASE("the pipeline passes on what its stages refuse") {
  const Eigen::Matrix4d identity = Eigen::Matrix4d::Identity();
  PhigsView view;
  CHECK_NOTHROW(compose(identity, view, kViewport));
  check_refused([&] { compose(scaling({1, 1, 0}), view, kViewport); }, "singular");
  check_refused([&] { compose(identity, view, {}); }, "the viewport is");
  view.vpn = view.vup;
  check_refused([&] { compose(identity, view, kViewport); }, "parallel");
  view = {};
  view.window_m = {};
  check_refused([&] { compose(identity, view, kViewport); }, "the window is");
  view = {};
  view.window_m = {{0, 0}, {5e-324, 5e-324}};
  check_refused([&] { compose(identity, view, kViewport); }, "too large or too small");
}
