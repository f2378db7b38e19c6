// SPDX-License-Identifier: GPL-3.0-or-later
// Whether an eye is inside, against the solid angles of all triangles.
#include "solids/solids_in_view.hpp"
#include "tests/catch.hpp"
#include "tests/support/made_solids.hpp"
#include "tests/support/random.hpp"

#include <cmath>

using namespace orograph;

namespace {

// Looking in any direction, from a point of the ground frame of true heights.
View view_from(Random& random, Vec3 eye, double exaggeration) {
  View view;
  const double azimuth = random.between(0, 6.3);
  view.forward = {std::sin(azimuth), std::cos(azimuth)};
  view.right = {view.forward.y, -view.forward.x};
  view.depth_origin_m = {eye.x, eye.y};
  view.eye_z_m = eye.z * exaggeration;
  view.exaggeration = exaggeration;
  return view;
}

int winding_at(const StandingSolid& standing, Vec3 point) {
  return static_cast<int>(std::lround(winding_number(standing, point)));
}

} // namespace

TEST_CASE("an eye is inside of a solid where the solid surrounds it") {
  Random random(94);
  std::size_t inside = 0, asked = 0;
  for (const Solid& solid :
       {made_box(), made_cells({"##.", ".#.", "###"}), made_star(5), made_round(12, false),
        made_round(9, true), made_pyramid(), made_tetrahedron(), made_nested()})
    for (int i = 0; i < 400; ++i) {
      const bool mirrored = i % 2 == 1;
      const Vec3 size{random.between(1, 30), random.between(1, 30), random.between(1, 30)};
      const Vec3 at{5e5, 5e6, random.between(-50, 900)};
      const StandingSolid standing = stand(solid, mirrored, [&](Vec3 v) {
        return at + Vec3{(mirrored ? -1 : 1) * size.x * v.x, size.y * v.y, size.z * v.z};
      });
      // Above and under vertices and edges, too.
      const bool on_lattice = random.whole(0, 1) == 0;
      const auto share = [&] {
        return on_lattice ? 0.25 * random.whole(-5, 13) : random.between(-1.2, 3.2);
      };
      const Vec3 eye = at + Vec3{(mirrored ? -1 : 1) * size.x * share(), size.y * share(),
                                 size.z * random.between(-0.3, 1.3)};
      const int winding = winding_at(standing, eye);
      bool on_surface = false;
      for (const Vec3 aside : {Vec3{1, 2, 3}, {-2, 1, -3}, {2, -3, -1}, {-1, -2, 3}})
        on_surface = on_surface || winding_at(standing, eye + 1e-5 * aside) != winding;
      if (on_surface) continue;
      const bool is_inside = (mirrored ? -winding : winding) > 0;
      INFO("eye " << (eye - at).x / size.x << " " << (eye - at).y / size.y << " "
                  << (eye - at).z / size.z << ", winding " << winding << ", " << i);
      CHECK(holds_eye(standing, view_from(random, eye, random.between(0.5, 4))) == is_inside);
      inside += is_inside;
      ++asked;
    }
  CHECK(asked > 2800);
  CHECK(inside > 120);
}

// A side that stands upright there has the eye in its plane, to rounding.
TEST_CASE("an eye straight over a corner of a solid is outside of it") {
  Random random(96);
  for (int i = 0; i < 400; ++i) {
    const bool mirrored = i % 2 == 1;
    const Vec3 size{random.between(1, 30), random.between(1, 30), random.between(1, 30)};
    const Vec3 at{5e5, 5e6, random.between(-50, 900)};
    const Solid solid = i % 4 < 2 ? made_tetrahedron() : made_pyramid();
    const StandingSolid standing = stand(solid, mirrored, [&](Vec3 v) {
      return at + Vec3{(mirrored ? -1 : 1) * size.x * v.x, size.y * v.y, size.z * v.z};
    });
    for (const Vec3& corner : standing.vertices_m) {
      const Vec3 over{corner.x, corner.y, corner.z + 0.2 * size.z};
      if (std::abs(winding_number(standing, over)) > 1e-6) continue; // within, or on a side
      INFO(i);
      CHECK_FALSE(holds_eye(standing, view_from(random, over, random.between(0.5, 4))));
    }
  }
}

TEST_CASE("an eye inside is found however finely the surface is divided, wires hold none") {
  Random random(95);
  const Solid round = made_round(3000, false);
  const auto as_it_is = [](Vec3 v) { return v; };
  const StandingSolid tower = stand(round, false, as_it_is);
  for (int i = 0; i < 200; ++i) {
    const Vec3 eye{random.between(-0.7, 0.7), random.between(-0.7, 0.7),
                   random.between(0.01, 0.99)};
    CHECK(holds_eye(tower, view_from(random, eye, 1)));
    CHECK_FALSE(holds_eye(tower, view_from(random, eye + Vec3{0, 0, 1}, 1)));
    CHECK_FALSE(holds_eye(tower, view_from(random, eye - Vec3{0, 0, 1}, 1)));
    CHECK_FALSE(holds_eye(tower, view_from(random, eye + Vec3{1.8, 0, 0}, 1)));
  }
  const Solid wires = made_wires();
  const StandingSolid mast = stand(wires, false, as_it_is);
  CHECK_FALSE(holds_eye(mast, view_from(random, {0.01, 0.01, 0.4}, 1)));
}
