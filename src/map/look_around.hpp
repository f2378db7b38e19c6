// SPDX-License-Identifier: GPL-3.0-or-later
// What an eye sees of a terrain, without a picture: which places, and its skyline all round.
#pragma once

#include "dem/terrain.hpp"
#include "geometry/box.hpp"
#include "geometry/vec.hpp"
#include "map/place_sight.hpp"
#include "placing/observer.hpp"
#include "profiles/outline.hpp"
#include "profiles/sight_lines.hpp"
#include "profiles/sight_over_blocks.hpp"

#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace orograph {

/// An eye over its terrain. Its answers don't depend on the number of threads.
class LookAround {
public:
  /// REQUIRES a terrain with ground, that it outlives this, and `border_edges` of it.
  LookAround(const TerrainData& terrain, std::span<const BorderEdge> border,
             const Observer& observer);
  /// With `block_bounds` of its grid, of which the ellipsoid turns no triangle over, `sights` of
  /// places on the ground take less time, and tell the same but for `tied`. REQUIRES that the
  /// bounds outlive this.
  LookAround(const TerrainData& terrain, std::span<const BorderEdge> border,
             const Observer& observer, const BlockBounds& bounds);

  /// Of places in map coordinates (longitudes in any turn), `above_m` above the ground, which
  /// exaggeration leaves as it is. Cost: some 5 ns for a triangle on the way to each.
  /// `progress` is told the share done.
  std::vector<PlaceSight> sights(std::span<const Vec2> places, double above_m,
                                 const std::function<void(double)>& progress = {}) const;

  /// Of a point of the surface, at `map` and in the profile frame of a view from this eye, whether
  /// it is seen or not.
  Bearing bearing_of(Vec2 map, ProfilePoint at) const;

  /// From north clockwise, every `step_deg` below 360. The most distant place is that of directions
  /// no farther apart than a cell at the terrain's farthest corner, or 0.01 degrees.
  Skyline skyline(double step_deg, const std::function<void(double)>& progress = {}) const;

private:
  PlaceSight sight_of(Vec2 place, double above_m) const;
  SightLine sight_line(Vec2 towards, double distance_m, std::optional<double> ground_z_m) const;
  SkylinePlace place_of(Vec2 towards, const SightLine& sight) const;
  Vec2 direction(double true_azimuth_deg) const;
  std::optional<Bearing> geodesic_to(Vec2 map) const;
  Vec3 to_map(Vec2 direction, double distance_m, double z_m) const;

  const TerrainData& terrain_;
  View view_;
  SightLines lines_;
  std::optional<SightOverBlocks> over_blocks_;
  Box2 bounds_; ///< of the terrain, in map coordinates
  Vec3 eye_map_;
  std::optional<Vec2> eye_lonlat_; ///< none where the CRS isn't on the earth
};

} // namespace orograph
