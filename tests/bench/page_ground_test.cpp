// SPDX-License-Identifier: GPL-3.0-or-later
// The ground that a page shows at a point is the one that the ray walk calls visible there.
#include "bench/page/page_ground.hpp"
#include "dem/height_at.hpp"
#include "geometry/error.hpp"
#include "reference/ray_walk.hpp"
#include "tests/bench/made_slopes.hpp"
#include "tests/catch.hpp"
#include "tests/scenes/look_down.hpp"
#include "tests/scenes/put_eye.hpp"
#include "tests/scenes/random_scene.hpp"
#include "tests/support/grid_of.hpp"
#include "tests/support/random.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

using namespace orograph;

namespace {

const std::uint64_t kScenes = last_seed(300);

Vec2 page_of(const Sector& sector, ProfilePoint p) {
  return sector.to_page.at(project_homogeneous(sector.view, p));
}

// By how much of Y the point is above all that is in front; the reference's word.
double above(const RayWalk& walk, const View& view, ProfilePoint p) {
  return project(view, p).y - walk.in_front(p).greatest_y;
}

} // namespace

TEST_CASE("ground on the page is visible, and what is visible is on the page", "[bench]") {
  std::size_t shown_points = 0, bare_points = 0, visible_points = 0, behind_points = 0;
  for (std::uint64_t seed = 1; seed <= kScenes; ++seed) {
    Random random(seed + 77000);
    RandomScene made = random_scene(seed);
    if (random.chance(0.3)) put_eye(made.spec, grid_of(made.terrain), random);
    if (random.chance(0.2)) look_down(made.spec, made.terrain, random);
    CAPTURE(seed, made.what);
    std::optional<PlacedView> scene;
    try {
      scene = placed_view(made.terrain, made.spec);
    } catch (const Error&) {
      continue; // an eye in the ground
    }
    const Grid& grid = grid_of(made.terrain);
    const PageGround ground(grid, *scene);
    const Box2& frame = scene->frame_mm;
    for (int i = 0; i < 60; ++i) {
      const Vec2 page{random.between(frame.low.x, frame.high.x),
                      random.between(frame.low.y, frame.high.y)};
      const auto shown = ground.at(page);
      if (!shown) {
        ++bare_points;
        continue;
      }
      ++shown_points;
      if (shown->sector->behind) ++behind_points;
      const View& view = shown->sector->view;
      CAPTURE(page.x, page.y, shown->at.u, shown->at.v, shown->at.z);
      CHECK(length(page_of(*shown->sector, shown->at) - page) < 1e-5);
      const Vec3 place = to_ground_m(view, shown->at);
      if (const auto height = height_at(grid, {place.x, place.y}))
        CHECK(place.z == Approx(*height).margin(1e-5));
      const double y = project(view, shown->at).y;
      CHECK(above(RayWalk(grid, view), view, shown->at) > -1e-7 * std::max(1.0, std::abs(y)));
      CHECK(shown->normal.z > 0);
      CHECK(length(shown->normal) == Approx(1));
    }
    for (const Sector& sector : scene->sectors) {
      const View& view = sector.view;
      const RayWalk walk(grid, view);
      for (int i = 0; i < 60; ++i) {
        const Vec3 vertex =
            grid.vertex_m(random.whole(0, grid.columns - 2), random.whole(0, grid.rows - 2));
        const Vec2 aside{random.between(-0.4, 0.4) * grid.plane().column_step_m.x,
                         random.between(-0.4, 0.4) * grid.plane().row_step_m.y};
        const Vec2 place{vertex.x + aside.x, vertex.y + aside.y};
        const auto height = height_at(grid, place);
        if (!height) continue;
        const ProfilePoint p = to_profile_frame(view, {place.x, place.y, *height});
        // Curved earth sinks between vertices.
        if (view.drop.any() || (view.is_perspective() && p.v < 2 * view.near_m)) continue;
        const Vec3 image = sector.to_page.of(project_homogeneous(view, p));
        if (!(image.z > 0)) continue;
        const Vec2 page{image.x / image.z, image.y / image.z};
        if (page.x <= frame.low.x || page.x >= frame.high.x || page.y <= frame.low.y ||
            page.y >= frame.high.y || p.v < view.drawn_from_m)
          continue;
        const double size = std::max(1.0, std::abs(project(view, p).y));
        if (above(walk, view, p) < 1e-6 * size) continue;
        ++visible_points;
        const auto shown = ground.at(page);
        CAPTURE(page.x, page.y, p.u, p.v, p.z);
        REQUIRE(shown);
        CHECK(length(page_of(*shown->sector, shown->at) - page) < 1e-5);
        // At a grazing angle, depth is sure to a rounding of Y over the angle.
        CHECK(shown->at.v ==
              Approx(p.v).epsilon(1e-4).margin(0.05 * length(grid.plane().row_step_m)));
      }
    }
  }
  CHECK(shown_points > enough(15 * 300));
  CHECK(behind_points > enough(300 / 4));
  CHECK(bare_points > enough(10 * 300));
  CHECK(visible_points > enough(10 * 300));
}

TEST_CASE("ground jumps where another surface stands in front, and nowhere else", "[bench]") {
  const TerrainData terrain = terrace();
  for (const Projection projection : {Projection::orthographic, Projection::perspective}) {
    MapSpec spec;
    spec.view.projection = projection;
    spec.view.from_elevation = Angle::degrees(20);
    spec.view.exaggeration = 1;
    const PlacedView scene = placed_view(terrain, spec);
    const PageGround ground(grid_of(terrain), scene);
    const Sector& sector = scene.sectors.front();
    const auto page = [&](double y_m) {
      return page_of(sector, to_profile_frame(sector.view,
                                              {300, y_m, *height_at(terrain.surface, {300, y_m})}));
    };
    const Vec2 below = page(100), foot = page(180), top = page(280), far = page(550),
               farther = page(580);
    CHECK_FALSE(ground.jumps_between(below, foot));
    CHECK_FALSE(ground.jumps_between(foot, top)); // up the step: steep ground, all of it seen
    CHECK_FALSE(ground.jumps_between(far, farther));
    CHECK(ground.jumps_between(top, far)); // behind its brink
    CHECK(ground.jumps_between(far, top));
    CHECK(ground.jumps_between(far, {far.x, far.y - 100})); // into the sky
    REQUIRE_FALSE(ground.at({far.x, scene.frame_mm.low.y - 1}));
  }
}
