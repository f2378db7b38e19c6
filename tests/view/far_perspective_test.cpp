// SPDX-License-Identifier: GPL-3.0-or-later
// An orthographic view is a perspective one from very far away. With x, y, q a point's coordinates
// across and along the camera's axis, from the target, perspective shows (x, y) / (D + q), which
// times D differs from (x, y) by (x, y) q / (D + q): at most delta = R^2 / (D - R) where all points
// are within R of the target. Positions on the page are (x - left) / width, so they differ by at
// most (2 delta + |position| 2 delta) / width.
#include "tests/catch.hpp"
#include "tests/support/random.hpp"
#include "tests/view/made_terrain.hpp"

#include <limits>

using namespace orograph;

TEST_CASE("orthographic equals perspective from very far away") {
  for (std::uint64_t seed = 1; seed <= last_seed(200); ++seed) {
    Random random(seed);
    INFO("seed " << seed);
    const MadeTerrain terrain = made_terrain(random, 12, random.pick({0.0, 0.1}));
    ViewRequest request;
    request.from_azimuth = Angle::degrees(random.between(0, 360));
    request.from_elevation = Angle::degrees(random.between(0, 80));
    request.roll = Angle::degrees(random.pick({0.0, 20.0}));
    request.exaggeration = random.pick({1.0, 2.0});
    request.projection = Projection::orthographic;
    const View parallel = place_view(request, terrain.shape(), 0.7);

    const Vec3 target = exaggerated(parallel.look_at_m, request.exaggeration);
    double reach = 0;
    for (const Vec3& p : terrain.vertices)
      reach = std::max(reach, length(exaggerated(p, request.exaggeration) - target));
    request.projection = Projection::perspective;
    for (const double times : {30.0, 1e3, 1e5}) {
      const double distance = times * reach;
      CAPTURE(times);
      request.distance_m = distance;
      const View far = place_view(request, terrain.shape(), 0.7);
      const double width = parallel.window.width();
      const double delta = reach * reach / (distance - reach);
      // The picture plane's coordinates, about 1 / times, are differences of numbers about 1.
      const double rounding =
          32 * std::numeric_limits<double>::epsilon() * times * std::max(1.0, reach / width);
      for (const Vec3& p : terrain.vertices) {
        const auto on_page = [&](const View& view) {
          const Vec2 at = picture_of(view, p);
          return (1 / view.window.width()) *
                 Vec2{at.x - view.window.low.x, view.window.high.y - at.y};
        };
        const Vec2 expected = on_page(parallel), found = on_page(far);
        const double bound = 2 * delta * (1 + largest(found)) / width + rounding;
        CAPTURE(expected.x, found.x, expected.y, found.y, bound);
        REQUIRE(largest(found - expected) <= bound);
      }
    }
  }
}
