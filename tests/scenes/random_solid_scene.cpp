// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/scenes/random_solid_scene.hpp"

#include "dem/extent.hpp"
#include "dem/height_at.hpp"
#include "geometry/box.hpp"
#include "geometry/error.hpp"
#include "placing/placed_view.hpp"
#include "reference/sight_segment.hpp"
#include "tests/scenes/put_eye.hpp"
#include "tests/scenes/random_scene.hpp"
#include "tests/scenes/random_tin_scene.hpp"
#include "tests/support/made_grid.hpp"
#include "tests/support/made_solids.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace orograph {
namespace {

constexpr double kLatticeStep_m = 8;

// Whole coordinates and heights; seen along rows, columns or diagonals, from heights that a
// parallel view keeps whole too.
void put_lattice(SolidScene& scene, Random& random) {
  GridLattice lattice{
      random.whole(4, 12), random.whole(4, 12), {}, {kLatticeStep_m, 0}, {0, -kLatticeStep_m}};
  lattice.first_vertex_m = {kLatticeStep_m * random.whole(-9, 9),
                            kLatticeStep_m * random.whole(-9, 9)};
  const double high = random.pick({0.5, 8.0, 40.0});
  scene.terrain.surface = made_grid(random, lattice, {0, high, 0, true, true});
  MapSpec& spec = scene.spec;
  spec.view.exaggeration = 1;
  spec.view.from_azimuth = Angle::degrees(45.0 * random.whole(0, 7));
  spec.view.projection =
      random.pick({Projection::perspective, Projection::orthographic, Projection::oblique});
  spec.view.oblique = random.pick({kCavalier, kCabinet, kMilitary, Oblique{1, Angle()}});
  const bool perspective = spec.view.projection == Projection::perspective;
  spec.view.from_elevation = Angle::degrees(perspective ? random.pick({0.0, 10.0, 30.0, 50.0})
                                                        : random.pick({0.0, 30.0, 45.0, 90.0}));
  scene.what = "lattice";
}

void put_terrain(SolidScene& scene, std::uint64_t seed, Random& random) {
  const auto take = [&](auto made) {
    scene.terrain = std::move(made.terrain);
    scene.spec = std::move(made.spec);
    scene.what = made.what;
  };
  const auto kind = seed % 8;
  if (kind == 2 || kind == 6) return put_lattice(scene, random);
  if (kind == 5) return take(random_tin_scene(seed, false));
  take(random_scene(seed, 16));
  const SurfaceExtent extent = extent_of(scene.terrain.surface);
  // put_eye needs two places on the ground that aren't close together.
  if ((kind != 3 && kind != 7) || 2 * extent.valid < std::get<Grid>(scene.terrain.surface).size())
    return;
  const MapSpec without = scene.spec;
  put_eye(scene.spec, std::get<Grid>(scene.terrain.surface), random);
  try {
    placed_view(scene.terrain, scene.spec);
    scene.what += ", from the ground";
  } catch (const Error&) { // under the ground by rounding
    scene.spec = without;
  }
}

// One place and posture: p of the solid's own frame goes to at + x p.x + y p.y + z p.z.
struct Posture {
  Vec3 at, x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};
  Vec3 of(Vec3 p) const { return at + p.x * x + p.y * y + p.z * z; }
  bool mirrors() const { return dot(cross(x, y), z) < 0; }
};

void turn_about_z(Posture& posture, double by_rad) {
  const double s = std::sin(by_rad), c = std::cos(by_rad);
  for (Vec3* axis : {&posture.x, &posture.y, &posture.z})
    *axis = {c * axis->x - s * axis->y, s * axis->x + c * axis->y, axis->z};
}

void tilt(Posture& posture, double by_rad) {
  const double s = std::sin(by_rad), c = std::cos(by_rad);
  for (Vec3* axis : {&posture.x, &posture.y, &posture.z})
    *axis = {axis->x, c * axis->y - s * axis->z, s * axis->y + c * axis->z};
}

class Placing {
public:
  Placing(SolidScene& scene, Random& random)
      : scene_(scene), random_(random), view_(placed_view(scene.terrain, scene.spec).view),
        box_(extent_of(scene.terrain.surface).box), cell_m_(cell_size_m(scene.terrain.surface)),
        is_lattice_(scene.what == "lattice") {
    side_m_ = std::max(box_.high.x - box_.low.x, box_.high.y - box_.low.y);
    if (view_.is_perspective())
      eye_ = {view_.depth_origin_m.x, view_.depth_origin_m.y, view_.eye_z_m / view_.exaggeration};
  }

  void add_solids() {
    const int count = random_.whole(1, 6);
    for (int tries = 0; static_cast<int>(scene_.standing.size()) < count; ++tries) {
      // What meets the eye at every place is made small.
      const double at_most_m = tries < 100 ? side_m_ : cell_m_;
      add(at_most_m);
    }
  }

private:
  Solid any_solid() {
    switch (random_.whole(0, 12)) {
    case 0:
    case 1:
      return made_box();
    case 2:
      return made_pyramid();
    case 3:
      return made_tetrahedron();
    case 4:
      return named("L", made_cells({"#.", "##"}));
    case 5:
      return named("U", made_cells({"#.#", "###"}));
    case 6:
      return named("ring", made_cells({"###", "#.#", "###"}));
    case 7:
      return named("star", made_star(random_.whole(3, 6)));
    case 8:
      return named("tower", made_round(random_.whole(3, 10), false));
    case 9:
      return named("cone", made_round(random_.whole(3, 10), true));
    case 10:
      return named("nested", made_nested());
    case 11:
      return named("wires", made_wires());
    default:
      return named("comb", made_cells({"#.#.#", "#####", "..#.."}));
    }
  }
  Solid named(const char* name, Solid solid) {
    scene_.what += std::string(", ") + name;
    return solid;
  }

  double ground_at(Vec2 at) const {
    return height_at(scene_.terrain.surface, at).value_or(box_.low.z);
  }

  Vec2 anywhere() {
    for (int tries = 0; tries < 50; ++tries) {
      const Vec2 at{random_.between(box_.low.x, box_.high.x),
                    random_.between(box_.low.y, box_.high.y)};
      if (height_at(scene_.terrain.surface, at)) return at;
    }
    return {box_.centre().x, box_.centre().y};
  }

  // Before or behind the highest of some places.
  Vec2 beside_a_summit() {
    Vec2 highest = anywhere();
    for (int i = 0; i < 40; ++i) {
      const Vec2 other = anywhere();
      if (ground_at(other) > ground_at(highest)) highest = other;
    }
    return highest + random_.pick({-2.0, -1.0, 1.0, 2.0}) * cell_m_ * view_.forward;
  }

  double any_size_m(double at_most_m) {
    const double low = std::log(0.1 * cell_m_), high = std::log(std::max(0.5 * side_m_, cell_m_));
    return std::min(std::exp(random_.between(low, high)), at_most_m);
  }

  // How the foot of something `high_m` high stands over the ground.
  double any_foot_m(double high_m) {
    return random_.pick({0.0, 0.0, -0.3, -0.7, 0.5, 2.0, -1.0, -3.0}) * high_m;
  }

  Posture whole_posture() {
    Posture posture;
    const auto size = [&] { return static_cast<double>(random_.pick({1, 2, 4, 8, 8, 16})); };
    posture.x = {size(), 0, 0};
    posture.y = {0, size(), 0};
    posture.z = {0, 0, size()};
    if (random_.chance(0.2)) posture.x.x = -posture.x.x;
    if (random_.chance(0.3)) {
      std::swap(posture.x, posture.y); // mirrors too
      posture.y = -1 * posture.y;
    }
    const double step = random_.pick({1.0, 4.0, 8.0, 8.0});
    const auto on_step = [&](double number) { return step * std::round(number / step); };
    const Vec2 at = anywhere();
    posture.at = {on_step(at.x), on_step(at.y), 0};
    posture.at.z = std::round(ground_at({posture.at.x, posture.at.y}) + any_foot_m(posture.z.z));
    return posture;
  }

  Posture any_posture(double at_most_m) {
    Posture posture;
    const double size = any_size_m(at_most_m);
    const auto side = [&] { return size * random_.pick({1.0, 1.0, 0.5, 0.1}); };
    posture.x = {side(), 0, 0};
    posture.y = {0, side(), 0};
    posture.z = {0, 0, side()};
    if (random_.chance(0.2)) posture.x.x = -posture.x.x;
    if (random_.chance(0.3)) tilt(posture, random_.between(-3, 3));
    if (random_.chance(0.7)) turn_about_z(posture, random_.between(0, 6.283));
    const Vec2 at = random_.chance(0.3) ? beside_a_summit() : anywhere();
    posture.at = {at.x, at.y, ground_at(at) + any_foot_m(std::abs(posture.z.z))};
    if (eye_ && random_.chance(0.3)) { // ahead of it, beside it or behind it
      const double turn = random_.between(0, 6.283);
      posture.at = *eye_ + random_.between(0.2, 2.5) * size *
                               Vec3{std::cos(turn), std::sin(turn), random_.between(-1, 0.3)};
    }
    return posture;
  }

  // Beside, on or across the last one: sharing a face, part of it, an edge or a corner; or in it.
  Posture neighbour_of(const Posture& last) {
    Posture posture = last;
    const auto step = [&](double share) { return random_.pick({0.0, 0.0, share, 1.0, -1.0}); };
    const double share = random_.chance(0.5) ? 0.5 : random_.between(-1, 1);
    const double a = step(share), b = step(share), c = step(share);
    posture.at = last.at + a * last.x + b * last.y + c * last.z;
    if (a == 0 && b == 0 && c == 0) posture.at = last.at + last.z;
    if (random_.chance(0.3)) posture.x = 0.5 * posture.x;
    if (random_.chance(0.3)) posture.z = 2 * posture.z;
    return posture;
  }

  // In the exaggerated scene, as the eye sees it.
  bool spares_the_eye(const StandingSolid& standing) const {
    if (!eye_) return true;
    StandingSolid seen{standing.solid, {}, standing.mirrored};
    std::vector<LongVec> places;
    Box3 around;
    for (const Vec3& vertex : standing.vertices_m) {
      const ProfilePoint p = to_profile_frame(view_, vertex);
      seen.vertices_m.push_back({p.u, p.v, p.z});
      around.include(seen.vertices_m.back());
      places.push_back(long_vec(p));
    }
    const double least_m = 2e-3 * length(around.high - around.low);
    for (const auto& [a, b, c] : standing.solid->triangles)
      if (distance_m(LongVec{0, 0, view_.eye_z_m}, LongTriangle{places[a], places[b], places[c]}) <
          least_m)
        return false;
    return std::abs(winding_number(seen, {0, 0, view_.eye_z_m})) < 0.5;
  }

  void add(double at_most_m) {
    const std::string what = scene_.what;
    const bool again = last_ && random_.chance(0.4);
    const Posture posture = again                                ? neighbour_of(*last_)
                            : is_lattice_ && random_.chance(0.8) ? whole_posture()
                                                                 : any_posture(at_most_m);
    const bool reuse = again && random_.chance(0.5);
    if (!reuse) scene_.solids.push_back(any_solid());
    const bool mirrored = posture.mirrors();
    StandingSolid standing = stand(reuse ? *scene_.standing.back().solid : scene_.solids.back(),
                                   mirrored, [&](Vec3 p) { return posture.of(p); });
    if (!spares_the_eye(standing)) {
      if (!reuse) scene_.solids.pop_back();
      scene_.what = what;
      last_.reset();
      return;
    }
    scene_.standing.push_back(std::move(standing));
    last_ = posture;
  }

  SolidScene& scene_;
  Random& random_;
  View view_;
  Box3 box_;
  double cell_m_ = 0, side_m_ = 0;
  bool is_lattice_ = false;
  std::optional<Vec3> eye_;
  std::optional<Posture> last_;
};

} // namespace

SolidScene random_solid_scene(std::uint64_t seed) {
  Random random(seed * 2 + 1000001);
  SolidScene scene;
  put_terrain(scene, seed, random);
  Placing(scene, random).add_solids();
  return scene;
}

} // namespace orograph
