// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/accuracy/exact_run.hpp"

#include "profiles/cut_surface.hpp"
#include "profiles/profile.hpp"
#include "reference/exact_clip.hpp"

#include <algorithm>
#include <chrono>
#include <limits>

namespace orograph {

Map draw_exactly(const TerrainData& terrain, const PlacedView& scene,
                 const std::vector<LineObserver*>& observers) {
  using Clock = std::chrono::steady_clock;
  const auto since = [](Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
  };
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  Map out;
  StageSeconds& seconds = out.facts.seconds;
  Counts& counts = out.facts.counts;
  seconds.facing = seconds.cut = seconds.project = seconds.clip = seconds.layout = 0;
  for (const Sector& sector : scene.sectors) {
    const SurfaceCutter cutter(terrain.surface, sector.view, scene.level.triangles, scene.border);
    std::vector<Profile> profiles(sector.profiles.size());
    std::vector<std::vector<Segment>> segments(sector.profiles.size());
    std::vector<Segment> uprights; // of walls: the exact clip compares what has an extent in X
    std::vector<ExactList> lists;
    for (std::size_t i = 0; i < sector.profiles.size(); ++i) {
      auto start = Clock::now();
      cutter.cut(sector.profiles[i].depth_m, profiles[i]);
      seconds.cut += since(start);
      start = Clock::now();
      project_profile(profiles[i], static_cast<std::uint32_t>(sector.profiles[i].number),
                      sector.view, segments[i], uprights);
      seconds.project += since(start);
      counts.segments += segments[i].size();
      lists.push_back({segments[i], Role::drawn_occluder});
    }
    const auto start = Clock::now();
    const std::vector<ExactClip> clipped = exact_clip(lists);
    seconds.clip += since(start);
    for (std::size_t i = 0; i < clipped.size(); ++i) {
      counts.largest_horizon =
          std::max<std::uint64_t>(counts.largest_horizon, clipped[i].least_horizon);
      for (LineObserver* observer : observers)
        observer->see(SeenProfile{
            sector, {-kInfinity, kInfinity}, profiles[i], segments[i], clipped[i].visible});
    }
  }
  return out;
}

} // namespace orograph
