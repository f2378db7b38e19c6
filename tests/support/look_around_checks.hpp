// SPDX-License-Identifier: GPL-3.0-or-later
// What an eye sees of places, asked of the ray walk, with which looking around shares no code.
#pragma once

#include "dem/height_at.hpp"
#include "dem/read/lonlat.hpp"
#include "map/look_around.hpp"
#include "placing/observer.hpp"
#include "placing/places.hpp"
#include "placing/terrain_facts.hpp"
#include "placing/terrain_of_view.hpp"
#include "profiles/seen_ground.hpp"
#include "reference/ray_walk.hpp"
#include "tests/support/random.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace orograph {

struct SightCounts {
  std::uint64_t asked = 0, seen = 0, hidden = 0, ties = 0, beside = 0;
  std::uint64_t wrong = 0;   ///< seen and hidden, or the other way round
  std::uint64_t unlike = 0;  ///< with bounds of blocks and without
  double greatest_off_m = 0; ///< of the height that a hidden place lacks
};

/// An eye's view towards one of the four quarters, as the ray walk takes it: the places that it is
/// asked for have the greater part of their way in front of it.
inline View quarter(const View& north, int number) {
  static constexpr std::array<Vec2, 4> kForward{{{0, 1}, {1, 0}, {0, -1}, {-1, 0}}};
  View view = north;
  view.forward = kForward[static_cast<std::size_t>(number)];
  view.right = {view.forward.y, -view.forward.x};
  view.drop = drop_in_frame({north.drop.per_vv, north.drop.per_uu}, view.forward);
  view.near_m = 1e-4; // nearer ground is not in question
  return view;
}

/// Asks for `count` random places within the terrain's bounds, on its vertices among them.
inline SightCounts compare_with_ray_walk(const TerrainData& whole, const ViewSpec& spec,
                                         std::size_t count, double above_m, Random& random) {
  const TerrainOfView terrain(whole, spec);
  const Observer observer = observer_of(spec, *terrain);
  const std::vector<BorderEdge> border = border_of(terrain->surface);
  const LookAround around(*terrain, border, observer);
  const SightLines lines(terrain->surface, border, observer.view);
  std::array<std::unique_ptr<RayWalk>, 4> walks;
  const Box2 bounds = map_bounds(*terrain);
  std::vector<Vec2> places(count);
  for (Vec2& place : places) {
    place = {random.between(bounds.low.x, bounds.high.x),
             random.between(bounds.low.y, bounds.high.y)};
    if (!random.chance(0.3)) continue;
    if (const Grid* grid = std::get_if<Grid>(&terrain->surface)) {
      const int c = random.whole(0, grid->columns - 1), r = random.whole(0, grid->rows - 1);
      if (grid->is_on_earth()) {
        const DegreeLattice& lattice = grid->earth().degrees();
        place = Vec2{lattice.lon_deg(c), lattice.lat_deg(r)};
        place = (1 / terrain->map.earth->unit_deg) * place;
      } else {
        const Vec2 at = grid->plane().position_m(c, r);
        const Vec3 on_map = terrain->map.to_map({at.x, at.y, 0});
        place = {on_map.x, on_map.y};
      }
    }
  }
  const std::vector<PlaceSight> sights = around.sights(places, above_m);

  SightCounts counts;
  if (const Grid* grid = std::get_if<Grid>(&terrain->surface)) {
    const BlockBounds blocks = block_bounds(*grid);
    const LookAround by_blocks(*terrain, border, observer, blocks);
    const std::vector<PlaceSight> others = by_blocks.sights(places, above_m);
    for (std::size_t i = 0; i < count; ++i)
      counts.unlike += sights[i].state != others[i].state ||
                       std::abs(sights[i].hidden_m - others[i].hidden_m) > 1e-9;
  }
  for (std::size_t i = 0; i < count; ++i) {
    ++counts.asked;
    const PlaceSight& sight = sights[i];
    if (sight.state == PlaceState::gap || sight.state == PlaceState::outside) {
      ++counts.beside;
      continue;
    }
    const std::optional<Vec3> on_earth =
        terrain->map.earth ? ground_at(places[i], *terrain) : std::nullopt;
    const Vec3 ground =
        on_earth ? *on_earth : terrain->map.to_ground_m({places[i].x, places[i].y, 0});
    const ProfilePoint from_eye = to_profile_frame(observer.view, ground);
    const int number = std::abs(from_eye.v) >= std::abs(from_eye.u) ? (from_eye.v >= 0 ? 0 : 2)
                                                                    : (from_eye.u >= 0 ? 1 : 3);
    const View view = quarter(observer.view, number);
    auto& walk = walks[static_cast<std::size_t>(number)];
    if (!walk) walk = std::make_unique<RayWalk>(terrain->surface, view);
    ProfilePoint p = to_profile_frame(view, ground);
    if (p.v < 1e-3) continue; // under the eye
    // On the triangles as they are drawn, which sink at their vertices alone.
    if (const Grid* grid = std::get_if<Grid>(&terrain->surface); grid && !grid->is_on_earth()) {
      const auto z = height_at(*grid, {ground.x, ground.y}, [&](int column, int row) {
        return to_profile_frame(view, grid->vertex_m(column, row)).z;
      });
      if (!z) continue;
      p.z = *z;
    } else {
      const double away_m = std::hypot(from_eye.u, from_eye.v);
      const SightLine own = lines.up_to({from_eye.u / away_m, from_eye.v / away_m}, away_m);
      if (own.ground) p.z = own.ground->z_m;
    }
    double rise_m = above_m;
    if (terrain->map.earth && above_m > 0) { // along its own upright
      const Vec3 on_map = terrain->map.to_map(ground);
      const double up = above_m / terrain->map.earth->exaggeration; // it isn't exaggerated
      const Vec3 top = terrain->map.to_ground_m({on_map.x, on_map.y, on_map.z + up}) - ground;
      const double away_m = std::hypot(from_eye.u, from_eye.v);
      const double along_m = (top.x * from_eye.u + top.y * from_eye.v) / away_m;
      const double share = 1 + along_m / away_m; // its place is that much farther away
      rise_m = (p.z + top.z - view.eye_z_m) / share + view.eye_z_m - p.z;
    }
    const InFront front = walk->in_front(p);
    const double own_y = (p.z + rise_m - view.eye_z_m) / p.v;
    const bool is_hidden = front.greatest_y > own_y;
    if (sight.tied || std::abs(front.greatest_y - own_y) <= 2 * front.rounding + 1e-13) {
      ++counts.ties;
      continue;
    }
    ++(is_hidden ? counts.hidden : counts.seen);
    if (is_hidden != (sight.state == PlaceState::hidden)) {
      ++counts.wrong;
      continue;
    }
    if (!is_hidden || terrain->map.earth) continue;
    const double off_m = std::abs(sight.hidden_m - (front.greatest_y - own_y) * p.v);
    counts.greatest_off_m = std::max(counts.greatest_off_m, off_m);
  }
  return counts;
}

} // namespace orograph
