// SPDX-License-Identifier: GPL-3.0-or-later
// Views by PHIGS's parameters, placed for the cut and the clip: their pictures against the
// definition of projection, and the way back.
#include "geometry/error.hpp"
#include "tests/catch.hpp"
#include "tests/support/random.hpp"
#include "tests/view/made_terrain.hpp"
#include "tests/view/random_phigs_view.hpp"
#include "view/phigs_view.hpp"
#include "view/sectors.hpp"

using namespace orograph;

namespace {

// On the view plane, y up, from the homogeneous coordinates of the visibility plane.
Vec2 picture_by_view(const View& view, Vec3 ground_m) {
  const Vec3 image =
      view.to_picture.of(project_homogeneous(view, to_profile_frame(view, ground_m)));
  return {image.x / image.z, image.y / image.z};
}

// A parallel view that looks up isn't drawn.
bool looks_up(const PhigsView& view) {
  const auto [u, v, n] = axes_of(view);
  const Vec3 ray = projectors_of(view);
  return view.projection == PhigsProjection::parallel && ray.x * u.z + ray.y * v.z - n.z > 0;
}

} // namespace

TEST_CASE("a PHIGS view's picture is that of the definition, ahead of the eye and behind it") {
  int compared = 0, beside = 0;
  for (const PhigsProjection projection : {PhigsProjection::perspective, PhigsProjection::parallel})
    for (std::uint64_t seed = 1; seed <= last_seed(1000); ++seed) {
      Random random(seed);
      INFO("seed " << seed << (projection == PhigsProjection::parallel ? " parallel" : ""));
      const PhigsView phigs = random_phigs_view(random, projection);
      if (looks_up(phigs)) REQUIRE(place_phigs_view(phigs, 1, 10).y_per_v < 0);
      const double exaggeration = random.pick({1.0, 2.5});
      const View view = place_phigs_view(phigs, exaggeration, 10);
      REQUIRE(view.window.low == phigs.window_m.low);
      REQUIRE(view.window.high == phigs.window_m.high);
      beside += shows_beside(view);
      REQUIRE(view.near_m == (!view.is_perspective() ? 0
                              : shows_beside(view)   ? 10 * kNearShareBetweenSectors
                                                     : 10 * kNearShareOfCell));
      for (int i = 0; i < 20; ++i) {
        const Vec3 uvn = point_within(random, phigs);
        const Vec3 scene = world_of(phigs, uvn);
        const Vec3 ground{scene.x, scene.y, scene.z / exaggeration};
        // y down from the window's upper side at 0, by the window's own size.
        const Vec2 page = page_by_definition(phigs, phigs.window_m, scene);
        const Vec2 expected{page.x, phigs.window_m.low.y + phigs.window_m.high.y - page.y};
        const Vec2 found = picture_by_view(view, ground);
        CAPTURE(uvn.x, uvn.y, uvn.z, expected.x, found.x, expected.y, found.y);
        const double size = std::max({phigs.window_m.width(), phigs.window_m.height(),
                                      largest(phigs.window_m.low), largest(phigs.window_m.high)});
        // World coordinates of some thousand metres, in a window of at least 0.2.
        REQUIRE(largest(found - expected) <= 1e-10 * std::max(size, 100.0));
        ++compared;
        if (!view.is_perspective()) continue;
        // In the sector that the point is in, by its plane coordinates.
        const double depth = to_profile_frame(view, ground).v;
        const View sector = depth > 0 ? view : sector_behind(view);
        if (std::abs(depth) < 1e-3 * size) continue;
        const Vec2 plane = project(sector, to_profile_frame(sector, ground));
        REQUIRE(sector.to_picture.w(plane) > 0);
        REQUIRE(largest(sector.to_picture(plane) - expected) <= 1e-9 * std::max(size, 100.0));
      }
    }
  CHECK(compared > enough(20000));
  CHECK(beside > enough(100));
}

TEST_CASE("the sector behind is the same place turned round, to the bit") {
  Random random(3);
  for (int i = 0; i < 1000; ++i) {
    const View view =
        place_phigs_view(random_phigs_view(random, PhigsProjection::perspective), 1, 10);
    const View behind = sector_behind(view);
    const Vec3 at = random_point(random, 5000);
    const ProfilePoint p = to_profile_frame(view, at), q = to_profile_frame(behind, at);
    REQUIRE(p.u == -q.u);
    REQUIRE(p.v == -q.v);
    REQUIRE(p.z == q.z);
    REQUIRE(sector_behind(behind).to_picture.m == view.to_picture.m);
  }
}

TEST_CASE("a window shows rays beside the eye just if one of its points does") {
  int yes = 0, no = 0;
  for (std::uint64_t seed = 1; seed <= last_seed(2000); ++seed) {
    Random random(seed);
    INFO("seed " << seed);
    const PhigsView phigs = random_phigs_view(random, PhigsProjection::perspective);
    const View view = place_phigs_view(phigs, 1, 10);
    const auto [u, v, n] = axes_of(phigs);
    const Vec3 forward{view.forward.x, view.forward.y, 0};
    double least = 1;
    for (int x = 0; x <= 20; ++x)
      for (int y = 0; y <= 20; ++y) {
        const Box2& w = phigs.window_m;
        const Vec3 to{w.low.x + w.width() * x / 20 - phigs.prp_m.x,
                      w.low.y + w.height() * y / 20 - phigs.prp_m.y, -phigs.prp_m.z};
        const Vec3 ray = to.x * u + to.y * v + to.z * n;
        least = std::min(least, dot(ray, forward) / length(ray));
      }
    if (std::abs(least - 0.05) < 1e-9) continue;
    REQUIRE(shows_beside(view) == (least < 0.05));
    ++(least < 0.05 ? yes : no);
  }
  CHECK(yes > enough(200));
  CHECK(no > enough(200));
}
