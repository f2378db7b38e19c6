// SPDX-License-Identifier: GPL-3.0-or-later
// What panoramas draw of solids, sector by sector, asked of the reference.
#include "geometry/error.hpp"
#include "hidden_lines/sector_pass.hpp"
#include "hidden_lines/surface_lines.hpp"
#include "placing/sector.hpp"
#include "placing/terrain_facts.hpp"
#include "tests/catch.hpp"
#include "tests/scenes/check_shares.hpp"
#include "tests/scenes/random_solid_scene.hpp"
#include "tests/support/random.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>

namespace orograph::panorama_solids_test {
namespace {

const std::uint64_t kScenes = last_seed(20);

struct Scene {
  SolidScene made;
  PlacedView placed;
};

// All round from somewhere above the ground; none where that is in a solid, or where there is no
// ground. It stays where it is, since the placed view refers to the terrain.
std::unique_ptr<const Scene> panorama_among_solids(std::uint64_t seed) {
  Random random(seed + 2700);
  auto scene = std::make_unique<Scene>(Scene{random_solid_scene(seed), {}});
  SolidScene& made = scene->made;
  const Box2 bounds = map_bounds(made.terrain);
  MapSpec& spec = made.spec;
  spec.view = {};
  spec.view.projection = random.pick({Projection::cylindrical, Projection::equirectangular});
  spec.view.eye_map = GivenPlace(bounds.low.x + random.between(0.1, 0.9) * bounds.width(),
                                 bounds.low.y + random.between(0.1, 0.9) * bounds.height());
  spec.view.eye_height_m = bounds.width() * random.pick({0.01, 0.1, 0.3});
  spec.view.altitude_range = AltitudeRange{Angle::degrees(-70), Angle::degrees(70)};
  spec.page = {};
  try {
    scene->placed = placed_view(made.terrain, spec);
    scene->placed.solids = made.standing;
    if (std::ranges::any_of(made.standing, [&](const StandingSolid& standing) {
          return holds_eye(standing, scene->placed.view);
        }))
      return nullptr;
    return scene;
  } catch (const Error&) {
    return nullptr;
  }
}

using SharesByEdge = std::map<std::uint32_t, std::vector<LineShare>>;
SharesByEdge by_edge(const std::vector<LinePart>& parts) {
  SharesByEdge out;
  for (const LinePart& part : parts) out[part.line].push_back({part.t_begin, part.t_end});
  return out;
}

// Of the edge at a place among all of them.
const std::vector<LineShare>& shares_of(const SharesByEdge& shares, std::uint32_t edge) {
  static const std::vector<LineShare> none;
  const auto at = shares.find(edge);
  return at == shares.end() ? none : at->second;
}

bool is_in(const std::vector<LineShare>& shares, double t, double beside) {
  return std::ranges::any_of(shares, [&](const LineShare& share) {
    return share.begin - beside <= t && t <= share.end + beside;
  });
}

} // namespace

TEST_CASE("a panorama draws edges of solids where the eye sees them, and calls the rest hidden") {
  ShareTally tally;
  std::uint64_t scenes = 0, parted = 0, hidden_points = 0;
  for (std::uint64_t seed = 1; seed <= kScenes; ++seed) {
    const auto scene = panorama_among_solids(seed);
    if (!scene) continue;
    ++scenes;
    const auto& [made, placed] = *scene;
    CAPTURE(seed, made.what);
    Random random(seed);
    // All ground is looked at, as where hidden edges are drawn.
    const LinesOfView lines =
        lines_of_view(made.terrain, placed, made.spec.style, {.hidden_ground = true}, nullptr);
    for (const Sector& sector : placed.sectors) {
      Counts counts;
      StageSeconds seconds;
      const SectorLines found =
          sector_pass(made.terrain, placed, sector, lines, nullptr, made.spec.style,
                      {.hidden_ground = true}, nullptr, {counts, seconds}, [] {});
      const SharesByEdge visible = by_edge(found.solids.visible),
                         hidden = by_edge(found.solids.hidden);
      const Sight sight(made.terrain.surface, placed.solids, sector.view);
      ShareCheck check = share_check(sector.view, placed.solids);
      check.x = page_range(sector);
      std::vector<std::uint32_t> first_edge{0};
      for (const StandingSolid& standing : placed.solids)
        first_edge.push_back(first_edge.back() +
                             static_cast<std::uint32_t>(standing.solid->edges.size()));
      const auto number = [&](std::size_t solid, std::size_t edge) {
        return first_edge[solid] + static_cast<std::uint32_t>(edge);
      };
      const ShareTally of_sector = check_edges(
          sight, sector.view, placed.solids,
          [&](std::size_t solid, std::size_t edge) {
            return shares_of(visible, number(solid, edge));
          },
          random, check);
      CAPTURE(sector.azimuth, of_sector.first_wrong);
      CHECK(of_sector.wrong() == 0);
      tally.add(of_sector);
      for (std::size_t s = 0; s < placed.solids.size(); ++s) {
        const StandingSolid& standing = placed.solids[s];
        for (std::size_t e = 0; e < standing.solid->edges.size(); ++e) {
          const SolidEdge& edge = standing.solid->edges[e];
          if (edge.smooth) continue;
          const ProfilePoint from = to_profile_frame(sector.view, standing.vertices_m[edge.from]),
                             to = to_profile_frame(sector.view, standing.vertices_m[edge.to]);
          const auto &shown = shares_of(visible, number(s, e)),
                     &covered = shares_of(hidden, number(s, e));
          parted += !shown.empty() && !covered.empty();
          for (int i = 0; i < 4; ++i) {
            const double t = random.share();
            const ProfilePoint p = point_between(from, to, t);
            if (p.v < 2 * sector.view.near_m || !(p.u > check.x.begin * p.v + 1e-9) ||
                !(p.u < check.x.end * p.v - 1e-9))
              continue;
            ++hidden_points;
            INFO("solid " << s << ", edge " << e << " at " << t);
            CHECK((is_in(shown, t, 1e-9) || is_in(covered, t, 1e-9)));
            CHECK(!(is_in(shown, t, -1e-9) && is_in(covered, t, -1e-9)));
          }
        }
      }
    }
  }
  WARN(scenes << " panoramas, " << tally.asked << " points asked, " << tally.unsure << " unsure, "
              << tally.visible << " visible; " << parted << " edges in part, " << hidden_points
              << " points in either list");
  CHECK(scenes >= enough(12));
  CHECK(tally.visible >= enough(1000));
  CHECK(tally.unsure < tally.asked / 4);
  CHECK(parted >= enough(50));
  CHECK(hidden_points >= enough(1000));
}

} // namespace orograph::panorama_solids_test
