// SPDX-License-Identifier: GPL-3.0-or-later
// Terrains in degrees: nothing drawn is hidden and nothing visible is missing; grid and TIN are
// one; whatever longitude it is at, a terrain looks the same.
#include "dem/approximate/tin_of_grid.hpp"
#include "geometry/error.hpp"
#include "placing/terrain_of_view.hpp"
#include "profiles/profile.hpp"
#include "tests/scenes/asked_scenes.hpp"
#include "tests/scenes/random_earth_scene.hpp"
#include "tests/support/grid_of.hpp"
#include "tests/support/random.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <optional>

namespace orograph::earth_scenes_test {
namespace {

const std::uint64_t kScenes = last_seed(150);

struct Tally {
  Asked asked;
  int two_sectors = 0, with_refraction = 0, refused = 0, limited = 0;
};

void ask_from(Stand stand, std::uint64_t probes, Tally& tally) {
  for (std::uint64_t seed = 1; seed <= kScenes; ++seed) {
    RandomScene scene = random_earth_scene(seed, stand);
    // Edges in the plane beside the eye are drawn a hair ahead of it, and then are off the slope by
    // what the page may show: 2e-4 mm.
    if (seed % 3 == 0 && stand != Stand::looking_down) scene.spec.style.layers.push_back("edges");
    CAPTURE(seed, scene.what, scene.spec.view.refraction);
    try {
      stand_on_earth(scene.terrain, scene.spec.view);
      const PlacedView placed = placed_view(scene.terrain, scene.spec);
      REQUIRE(placed.curvature.on_ellipsoid);
      CHECK(placed.extent.turned_over == 0);
      tally.limited += grid_of(scene.terrain).earth().lean_limits() ? 1 : 0;
      tally.two_sectors += placed.sectors.size() == 2;
      tally.with_refraction += placed.view.drop.any();
      tally.asked.add(ask(scene.terrain, scene.spec, probes));
    } catch (const Error& error) {
      UNSCOPED_INFO(error.what());
      ++tally.refused;
    }
  }
}

void report(const char* what, const Tally& tally) {
  report(what, tally.asked);
  WARN(tally.two_sectors << " in two sectors, " << tally.with_refraction << " with refraction, "
                         << tally.refused << " refused, " << tally.limited
                         << " with cliffs that would lean over");
  CHECK(tally.refused == 0); // all stand on the ground or above, and look at ground
}

// What is visible, before anything is laid out on the page.
class Seen : public LineObserver {
public:
  struct Part {
    ProfilePoint from, to;
    int kind; ///< -1 for a profile
    double t_begin, t_end;
    Vec2 begin_mm, end_mm;
  };
  std::vector<Part> parts;

  void see(const SeenProfile& seen) override {
    const auto& [sector, clipped, profile, segments, visible] = seen;
    for (const Piece& piece : visible) {
      const std::uint32_t left = left_vertex(segments[piece.segment]);
      const auto at = [&](std::uint32_t i) {
        return ProfilePoint{profile.u_m[i], profile.depth_m, profile.z_m[i]};
      };
      add(sector, at(left), at(left + 1), -1, piece.t_begin, piece.t_end);
    }
  }
  void see(const SeenLines& seen) override {
    const auto& [sector, clipped, lines, visible, listed] = seen;
    for (const LinePart& part : visible) {
      const ProfileLine whole = lines.whole(part.line);
      add(sector, whole.from, whole.to, static_cast<int>(lines.line(part.line).kind), part.t_begin,
          part.t_end);
    }
  }

private:
  void add(const Sector& sector, ProfilePoint from, ProfilePoint to, int kind, double t_begin,
           double t_end) {
    const auto page = [&](double t) {
      const Vec3 p =
          sector.to_page.of(project_homogeneous(sector.view, point_between(from, to, t)));
      return Vec2{p.x / p.z, p.y / p.z};
    };
    parts.push_back({from, to, kind, t_begin, t_end, page(t_begin), page(t_end)});
  }
};

bool are_same(const std::vector<Seen::Part>& a, const std::vector<Seen::Part>& b) {
  return a.size() == b.size() &&
         std::equal(a.begin(), a.end(), b.begin(), [](const auto& p, const auto& q) {
           return std::memcmp(&p.from, &q.from, sizeof p.from) == 0 &&
                  std::memcmp(&p.to, &q.to, sizeof p.to) == 0 && p.kind == q.kind &&
                  p.t_begin == q.t_begin && p.t_end == q.t_end;
         });
}

// None where the scene is refused.
std::optional<Seen> seen_of(RandomScene scene) {
  try {
    stand_on_earth(scene.terrain, scene.spec.view);
    const PlacedView placed = placed_view(scene.terrain, scene.spec);
    Seen seen;
    draw_map(scene.terrain, placed, scene.spec, [](double) {},
             {.observers = {&seen}, .beyond_page = true});
    return seen;
  } catch (const Error&) {
    return std::nullopt;
  }
}

// Of a profile or a line, as far as it is visible without a gap.
struct Stretch {
  int kind;
  Vec2 begin_mm, end_mm;
};
constexpr double kRounding_mm = 1e-6;

std::vector<Stretch> stretches_of(const Seen& seen) {
  std::vector<Stretch> stretches;
  for (const Seen::Part& part : seen.parts) {
    if (!stretches.empty() && stretches.back().kind == part.kind &&
        length(stretches.back().end_mm - part.begin_mm) <= kRounding_mm)
      stretches.back().end_mm = part.end_mm;
    else
      stretches.push_back({part.kind, part.begin_mm, part.end_mm});
  }
  return stretches;
}

// Crumbs come and go.
std::size_t without_partner(const std::vector<Stretch>& stretches,
                            const std::vector<Stretch>& others) {
  return static_cast<std::size_t>(
      std::count_if(stretches.begin(), stretches.end(), [&](const Stretch& s) {
        return length(s.end_mm - s.begin_mm) > 2 * kRounding_mm &&
               std::none_of(others.begin(), others.end(), [&](const Stretch& o) {
                 return o.kind == s.kind && length(o.begin_mm - s.begin_mm) <= kRounding_mm &&
                        length(o.end_mm - s.end_mm) <= kRounding_mm;
               });
      }));
}

double length_mm(const std::vector<Stretch>& stretches) {
  double sum = 0;
  for (const Stretch& s : stretches) sum += length(s.end_mm - s.begin_mm);
  return sum;
}

// By so many degrees east, eye and target as well.
RandomScene turned(RandomScene scene, double by_deg) {
  Grid& grid = grid_of(scene.terrain);
  EarthFrame& frame = *scene.terrain.map.earth;
  DegreeLattice degrees = grid.earth().degrees();
  degrees.first_lon_deg += by_deg;
  frame.local = LocalFrame(frame.local.origin_lon_deg() + by_deg, frame.local.origin_lat_deg(),
                           frame.local.ellipsoid());
  grid.lattice = EarthLattice(degrees, frame.local, frame.exaggeration);
  scene.terrain.map.origin.x += by_deg;
  for (auto* place : {&scene.spec.view.eye_map, &scene.spec.view.look_at_map})
    if (*place) (*place)->x += by_deg;
  return scene;
}

} // namespace

TEST_CASE("the ray walk agrees with views that frame a terrain in degrees") {
  Tally tally;
  ask_from(Stand::frames_terrain, 1000, tally);
  report("framed", tally);
  CHECK(tally.asked.ties < tally.asked.asked / 20);
}

TEST_CASE("and from the ground of a terrain in degrees") {
  Tally tally;
  ask_from(Stand::on_ground, 1000, tally);
  report("on the ground", tally);
  CHECK(tally.asked.ties < tally.asked.asked / 5);
}

TEST_CASE("and from the air above and beside a terrain in degrees") {
  Tally tally;
  ask_from(Stand::in_air, 1000, tally);
  report("in the air", tally);
  CHECK(tally.asked.ties < tally.asked.asked / 20);
}

TEST_CASE("and looking down at a terrain in degrees") {
  Tally tally;
  ask_from(Stand::looking_down, 1000, tally);
  report("looking down", tally);
  CHECK(tally.two_sectors > static_cast<int>(kScenes / 4));
  CHECK(tally.asked.ties < tally.asked.asked / 10);
}

TEST_CASE("a grid in degrees and the TIN of its triangles are one drawing, bit for bit") {
  std::size_t compared = 0, scenes = 0;
  for (std::uint64_t seed = 1; seed <= kScenes; ++seed) {
    RandomScene scene = random_earth_scene(5000 + seed, static_cast<Stand>(seed % 4));
    scene.spec.style.flat = FlatGround::draw; // level ground is told by true heights, or by z
    std::erase(scene.spec.style.layers, LayerSpec("shores"));
    if (seed % 2 == 0) scene.spec.style.layers.push_back("voids");
    if (seed % 3 == 0) scene.spec.style.layers.push_back("edges");
    if (seed % 7 == 0) scene.spec.style.occluder = Occluder::profiles;
    CAPTURE(seed, scene.what);
    try {
      stand_on_earth(scene.terrain, scene.spec.view);
      PlacedView placed = placed_view(scene.terrain, scene.spec);
      TerrainData as_tin = scene.terrain;
      as_tin.surface = tin_of(grid_of(scene.terrain));
      Seen by_grid, by_tin;
      const Map grid_drawn = draw_map(scene.terrain, placed, scene.spec, [](double) {},
                                      {.observers = {&by_grid}, .beyond_page = true});
      placed.border = border_edges(std::get<Tin>(as_tin.surface));
      const Map tin_drawn = draw_map(as_tin, placed, scene.spec, [](double) {},
                                     {.observers = {&by_tin}, .beyond_page = true});
      REQUIRE(are_same(by_grid.parts, by_tin.parts));
      REQUIRE(grid_drawn.drawing.layers.size() == tin_drawn.drawing.layers.size());
      for (std::size_t i = 0; i < grid_drawn.drawing.layers.size(); ++i)
        REQUIRE((grid_drawn.drawing.layers[i].page_mm == tin_drawn.drawing.layers[i].page_mm));
      compared += by_grid.parts.size();
      ++scenes;
    } catch (const Error&) {
      continue; // the eye is under the ground
    }
  }
  WARN(scenes << " scenes, " << compared << " visible parts");
  CHECK(scenes > kScenes * 3 / 4);
  CHECK(compared > 500 * kScenes);
}

TEST_CASE("turned about the earth's axis a terrain looks the same") {
  std::size_t compared = 0, far = 0, exact = 0, scenes = 0;
  for (std::uint64_t seed = 1; seed <= kScenes; ++seed) {
    // On the ground a rounding of the eye's place may be as much as its height.
    const Stand stand = seed % 3 == 0   ? Stand::frames_terrain
                        : seed % 3 == 1 ? Stand::in_air
                                        : Stand::looking_down;
    const RandomScene scene = random_earth_scene(9000 + seed, stand);
    Random random(seed);
    const std::optional<Seen> one = seen_of(scene);
    const bool whole_turn = random.chance(0.3);
    const double by_deg =
        whole_turn ? random.pick({360.0, -360.0, 720.0}) : random.whole(-180 * 64, 180 * 64) / 64.0;
    const std::optional<Seen> other = seen_of(turned(scene, by_deg));
    CAPTURE(seed, scene.what, by_deg);
    REQUIRE(one.has_value() == other.has_value());
    if (!one) continue;
    ++scenes;
    if (whole_turn || stand == Stand::frames_terrain) {
      REQUIRE(are_same(one->parts, other->parts)); // nothing rounds
      ++exact;
      continue;
    }
    const std::vector<Stretch> stretches = stretches_of(*one), others = stretches_of(*other);
    const std::size_t apart =
        without_partner(stretches, others) + without_partner(others, stretches);
    compared += stretches.size();
    far += apart;
    const double whole = length_mm(stretches);
    CHECK(std::abs(length_mm(others) - whole) <= 1e-5 * whole);
  }
  WARN(scenes << " scenes, " << exact << " of them turned without rounding; of the others "
              << compared << " visible stretches, " << far << " elsewhere");
  CHECK(exact > kScenes / 4);
  CHECK(compared > 10 * kScenes);
  // Where lines nearly coincide rounding decides which is drawn.
  CHECK(far <= compared / 200);
}

} // namespace orograph::earth_scenes_test
