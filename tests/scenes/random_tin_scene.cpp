// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/scenes/random_tin_scene.hpp"

#include "dem/triangulate/triangulate.hpp"
#include "tests/support/made_tin.hpp"
#include "tests/support/notched_tin.hpp"

#include <algorithm>
#include <cmath>

namespace orograph {
namespace {

Tin lattice(Random& random, bool cracks, std::string& what) {
  MadeTin wanted;
  wanted.columns = random.whole(2, 18);
  wanted.rows = random.whole(2, 18);
  wanted.step_m = random.pick({8.0, 8.0, 16.0, 16.0, 8192.0});
  wanted.whole = random.chance(0.6);
  wanted.moved = random.pick({0.0, 0.2, 0.24});
  wanted.high_m = random.pick({8.0, 20.0, 60.0});
  wanted.missing = random.pick({0.0, 0.0, 0.05, 0.4});
  wanted.walls = random.pick({0.0, 0.3, 0.8});
  if (!cracks && wanted.missing > 0) wanted.walls = 0;
  wanted.shuffled = random.chance(0.5);
  const double away_m = random.pick({8.0, 8.0, 40000.0}); // coordinates up to 800 km
  wanted.first_vertex_m = {away_m * random.whole(-20, 20), away_m * random.whole(-20, 20)};
  Tin tin = made_tin(random, wanted);
  what = "lattice";
  if ((cracks || wanted.missing == 0) && random.chance(0.4)) {
    add_notches(tin, random, random.pick({0.03, 0.3}));
    what += " with notches";
  }
  return tin;
}

Vec3 any_point(Random& random, double side_m, double high_m) {
  return {random.between(0, side_m), random.between(0, side_m), random.between(0, high_m)};
}

// Points on hills, cut by breaklines: a dam, a ditch, lines that cross and touch.
Tin survey(Random& random, std::string& what) {
  what = "survey";
  Survey survey;
  const double side_m = 400, high_m = random.pick({20.0, 120.0});
  for (int i = random.whole(3, 250); i > 0; --i) {
    Vec3 p = any_point(random, side_m, 1);
    p.z = high_m * (std::sin(p.x / 60) * std::cos(p.y / 45) + 0.2 * p.z);
    survey.points_m.push_back(p);
  }
  for (int i = random.whole(0, 5); i > 0; --i) {
    std::vector<Vec3> line;
    for (int k = random.whole(2, 6); k > 0; --k) line.push_back(any_point(random, side_m, high_m));
    survey.breaklines_m.push_back(line);
  }
  if (random.chance(0.5)) { // a dam: two lines close together, the ground beside it far below
    const Vec3 a = any_point(random, side_m, high_m), b = any_point(random, side_m, high_m);
    const double away = random.pick({1e-6, 1e-3, 1.0});
    survey.breaklines_m.push_back({a, b});
    survey.breaklines_m.push_back(
        {{a.x + away, a.y, a.z - high_m}, {b.x + away, b.y, b.z - high_m}});
  }
  if (random.chance(0.3)) survey.max_edge_m = 100;
  return triangulate(survey).tin;
}

// From a millimetre to kilometres.
Tin clusters(Random& random, std::string& what) {
  what = "clusters";
  Survey survey;
  const int centres = random.whole(1, 4);
  for (int c = 0; c < centres; ++c) {
    const Vec3 centre = any_point(random, 2e5, 1e3);
    for (int i = random.whole(20, 120); i > 0; --i) {
      const double away = std::pow(10, random.between(-2, 5)), turn = random.between(0, 6.283);
      survey.points_m.push_back({centre.x + away * std::cos(turn), centre.y + away * std::sin(turn),
                                 centre.z + random.between(-0.4, 0.4) * std::min(away, 3e3)});
    }
  }
  survey.points_m.push_back({-4e5, -4e5, 0});
  survey.points_m.push_back({6e5, -4e5, 500});
  survey.points_m.push_back({6e5, 6e5, 0});
  return triangulate(survey).tin;
}

} // namespace

RandomTinScene random_tin_scene(std::uint64_t seed, bool cracks) {
  Random random(seed);
  RandomTinScene scene;
  Tin tin;
  while (tin.triangles.empty())
    tin = seed % 8 == 6   ? clusters(random, scene.what)
          : seed % 4 == 1 ? survey(random, scene.what)
                          : lattice(random, cracks, scene.what);
  scene.terrain.surface = std::move(tin);

  MapSpec& spec = scene.spec;
  const int kind = random.whole(0, 3);
  spec.view.from_azimuth = Angle::degrees(kind <= 1   ? 90.0 * random.whole(0, 3)
                                          : kind == 2 ? 45 + 90.0 * random.whole(0, 3)
                                                      : random.between(0, 360));
  spec.view.projection = random.chance(0.5) ? Projection::perspective : Projection::orthographic;
  const bool perspective = spec.view.projection == Projection::perspective;
  spec.view.from_elevation = Angle::degrees(random.chance(0.1) ? 0
                                            : random.chance(0.1) && !perspective
                                                ? 90
                                                : random.between(0, perspective ? 50 : 90));
  spec.view.exaggeration = random.chance(0.5) ? 1 : random.between(0.5, 4);
  spec.style.plan = ProfileCount{random.whole(5, 40)};
  spec.style.layers.push_back("edges");
  scene.what += perspective ? ", perspective" : ", orthographic";
  return scene;
}

} // namespace orograph
