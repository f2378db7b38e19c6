// SPDX-License-Identifier: GPL-3.0-or-later
// Solids above a sheet with two sides, below it and across it: each covers the other as they stand.
#include "hidden_lines/sector_pass.hpp"
#include "placing/placed_view.hpp"
#include "profiles/slab_lines.hpp"
#include "reference/sheet_walk.hpp"
#include "tests/blocks/block_walk.hpp"
#include "tests/blocks/way_to_eye.hpp"
#include "tests/catch.hpp"
#include "tests/scenes/random_solid_scene.hpp"
#include "tests/scenes/sector_found.hpp"
#include "tests/scenes/vary_view.hpp"
#include "tests/support/random.hpp"
#include "view/sectors.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
#include <optional>
#include <vector>

namespace orograph::sheet_solids_test {
namespace {

const std::uint64_t kScenes = last_seed(150);

struct Tally {
  std::uint64_t asked = 0, unsure = 0, visible = 0, by_solid = 0, by_ground = 0, wrong = 0;
};

enum class Hidden { no, by_solid, by_ground };

// All triangles there are, asked of by rays alone, and of points on the sheet by the walk.
class Asked {
public:
  Asked(const TerrainData& terrain, const PlacedView& placed, const View& view)
      : view_(view), walk_(terrain.surface, view) {
    for (const StandingSolid& of : placed.solids)
      for (const auto& corners : of.solid->triangles) {
        std::array<Vec3, 3>& triangle = solids_.emplace_back();
        for (std::size_t k = 0; k < 3; ++k)
          triangle[k] = as_vec(to_profile_frame(view, of.vertices_m[corners[k]]));
      }
    for (const auto& [a, b, c] : triangles_in(terrain, view))
      ground_.push_back({as_vec(a), as_vec(b), as_vec(c)});
  }

  // None where a little aside it is otherwise.
  std::optional<Hidden> on_sheet(const ProfileLine& line, double t, double sure_m) const {
    using Sight = SheetWalk::Sight;
    const ProfilePoint at = point_between(line.from, line.to, t);
    const double aside = 1e-5 * std::hypot(at.u, at.v);
    const double size = std::hypot(line.to.u - line.from.u, line.to.v - line.from.v);
    const double beside = std::min(1e-4, aside / std::max(1e-9, size));
    const Sight here = walk_.sight(at, sure_m);
    for (const double near_t : {t - beside, t + beside})
      if (walk_.sight(point_between(line.from, line.to, near_t), sure_m) != here)
        return std::nullopt;
    if (here == Sight::unsure) return std::nullopt;
    if (here == Sight::hidden) return Hidden::by_ground;
    const bool by_solid = passes_any(solids_, at, sure_m);
    // In front of what it lies on.
    if (!is_same_around(at, {0.0, 20 * aside}, aside,
                        [&](ProfilePoint p) { return passes_any(solids_, p, sure_m) == by_solid; }))
      return std::nullopt;
    return by_solid ? Hidden::by_solid : Hidden::no;
  }

  // The same; none as well where it touches the ground.
  std::optional<Hidden> on_solid(ProfilePoint at, double sure_m) const {
    const double aside = 1e-5 * std::hypot(at.u, at.v);
    const bool by_ground = passes_any(ground_, at, sure_m);
    if (passes_any(ground_, at, sure_m, true) != by_ground) return std::nullopt; // right at the eye
    if (!is_same_around(at, {-20 * aside, 0.0, 20 * aside}, aside, [&](ProfilePoint p) {
          return passes_any(ground_, p, sure_m) == by_ground;
        }))
      return std::nullopt;
    if (by_ground) return Hidden::by_ground;
    const bool by_solid = passes_any(solids_, at, sure_m);
    if (!is_same_around(at, {0.0, 20 * aside}, aside,
                        [&](ProfilePoint p) { return passes_any(solids_, p, sure_m) == by_solid; }))
      return std::nullopt;
    return by_solid ? Hidden::by_solid : Hidden::no;
  }

private:
  bool passes_any(const std::vector<std::array<Vec3, 3>>& triangles, ProfilePoint at, double sure_m,
                  bool to_near_plane = false) const {
    Way way = way_to_eye(view_, at);
    if (to_near_plane && view_.is_perspective()) way.end = 1 - view_.near_m / at.v;
    const double begin = sure_m / length(way.step);
    return std::ranges::any_of(triangles, [&](const std::array<Vec3, 3>& triangle) {
      return passes(way, triangle, begin);
    });
  }

  template <class Test>
  bool is_same_around(ProfilePoint at, std::initializer_list<double> nearer_m, double aside,
                      const Test& test) const {
    const double along = u_along_ray(view_, at), size = std::hypot(along, 1);
    for (const double across : {-aside, aside})
      for (const double up : {-aside, aside})
        for (const double nearer : nearer_m)
          if (!test({at.u + (across - nearer * along) / size,
                     at.v - (across * along + nearer) / size,
                     at.z + up - nearer / size * z_along_ray(view_, at)}))
            return false;
    return true;
  }

  const View& view_;
  SheetWalk walk_;
  std::vector<std::array<Vec3, 3>> solids_, ground_;
};

} // namespace

TEST_CASE("solids and both sides of a sheet cover each other as they stand") {
  Tally of_sheet, of_solids;
  std::uint64_t drawn = 0;
  for (std::uint64_t seed = 1; seed <= kScenes; ++seed) {
    SolidScene made = random_solid_scene(seed);
    const auto wrong_lines = of_sheet.wrong, wrong_solids = of_solids.wrong;
    Random random(seed);
    Style& style = made.spec.style;
    style.underside = Underside::draw;
    std::erase_if(style.layers, [](const LayerSpec& of) { return of.name.starts_with("hidden"); });
    for (const char* layer : {"voids", "edges", "border"})
      if (!style.asks_for(layer)) style.layers.emplace_back(layer);
    if (!made.spec.view.has_eye())
      made.spec.view.from_elevation = Angle::degrees(random.between(-80, 80));
    INFO("seed " << seed << ": " << made.what);
    std::optional<PlacedView> placed = placed_if_any(made.terrain, made.spec);
    if (!placed) continue;
    const Box3 box = placed->extent.box;
    // Many off the ground, above it and below.
    for (StandingSolid& solid : made.standing) {
      if (random.chance(0.4)) continue;
      const Vec3 by{0, 0, random.between(-0.5, 0.5) * (box.high.x - box.low.x)};
      for (Vec3& vertex : solid.vertices_m) vertex = vertex + by;
    }
    placed->solids = made.standing;
    const Sector& sector = placed->sectors.front();
    const View& view = sector.view;
    if (!view.is_perspective() && !(view.y_per_z > 1e-3)) continue; // from straight above or below
    if (view.is_perspective() &&
        std::ranges::any_of(made.standing,
                            [&](const StandingSolid& solid) { return holds_eye(solid, view); }))
      continue;
    ++drawn;
    const Instruments instruments{.beyond_page = true, .hidden_ground = true};
    const LinesOfView lines = lines_of_view(made.terrain, *placed, style, instruments, nullptr);
    const SectorFound found(made.terrain, *placed, sector, lines, style, instruments);
    const Asked asked(made.terrain, *placed, view);
    const double from_m = std::max(kNearPlanesAhead * view.near_m, view.drawn_from_m);
    const TieTolerance tolerance = tie_tolerance(sector, style.visibility_tolerance_mm);
    const auto ask = [&](const ProfileLine& line, double t, bool is_drawn, Tally& tally) {
      const ProfilePoint at = point_between(line.from, line.to, t);
      if (view.is_perspective() && at.v <= 1.01 * from_m) return;
      const Vec2 plane = project(view, at);
      if (!(plane.x > found.range.begin && plane.x < found.range.end)) return;
      ++tally.asked;
      const double sure_m = 1e-5 + 2 * tolerance.at(plane.x, plane.y) *
                                       (view.is_perspective() ? at.v : 1 / view.y_per_z);
      const auto hidden =
          &tally == &of_sheet ? asked.on_sheet(line, t, sure_m) : asked.on_solid(at, sure_m);
      if (!hidden) {
        ++tally.unsure;
        return;
      }
      if (*hidden == Hidden::no) ++tally.visible;
      if (*hidden == Hidden::by_solid) ++tally.by_solid;
      if (*hidden == Hidden::by_ground) ++tally.by_ground;
      if ((*hidden == Hidden::no) != is_drawn) ++tally.wrong;
    };
    std::vector<std::uint32_t> on_sheet;
    for (std::uint32_t i = 0; i < lines.listed.size(); ++i) {
      const EdgeLine& line = lines.listed[i];
      if (line.drawn && (line.kind == LineKind::border || line.kind == LineKind::void_edge ||
                         line.kind == LineKind::edge))
        on_sheet.push_back(i);
    }
    for (int k = 0; k < 60 && !on_sheet.empty(); ++k) {
      const std::uint32_t line = on_sheet[static_cast<std::size_t>(
          random.whole(0, static_cast<int>(on_sheet.size()) - 1))];
      const double t = random.between(0.01, 0.99);
      const bool is_drawn = std::ranges::any_of(found.visible, [&](const LinePart& part) {
        return part.line == line && part.t_begin <= t && t <= part.t_end;
      });
      const ProfileLine whole = found.pictures.whole(line);
      // Along a ray it has other ground on either side.
      if (!found.pictures.picture(line, whole).is_upright()) ask(whole, t, is_drawn, of_sheet);
    }
    std::uint32_t first_edge = 0;
    for (const StandingSolid& solid : placed->solids) {
      const auto& edges = solid.solid->edges;
      for (int k = 0; k < 15; ++k) {
        const auto e =
            static_cast<std::uint32_t>(random.whole(0, static_cast<int>(edges.size()) - 1));
        if (edges[e].smooth) continue; // drawn where it is an outline alone
        const double t = random.between(0.01, 0.99);
        const bool is_drawn =
            std::ranges::any_of(found.found.solids.visible, [&](const LinePart& part) {
              return part.line == first_edge + e && part.t_begin <= t && t <= part.t_end;
            });
        ask({to_profile_frame(view, solid.vertices_m[edges[e].from]),
             to_profile_frame(view, solid.vertices_m[edges[e].to])},
            t, is_drawn, of_solids);
      }
      first_edge += static_cast<std::uint32_t>(edges.size());
    }
    CHECK(of_sheet.wrong == wrong_lines);
    CHECK(of_solids.wrong == wrong_solids);
  }
  WARN(drawn << " drawn");
  for (const auto& [what, of] : {std::pair{"on the sheet", &of_sheet}, {"on solids", &of_solids}})
    WARN(what << ": " << of->asked << " asked, " << of->unsure << " unsure, " << of->visible
              << " visible, " << of->by_solid << " behind solids, " << of->by_ground
              << " behind the sheet, " << of->wrong << " wrong");
  CHECK(of_sheet.visible > 5 * drawn);
  CHECK(of_sheet.by_solid > drawn / 2);
  CHECK(of_solids.by_ground > drawn);
  CHECK(of_solids.visible > 3 * drawn);
}

} // namespace orograph::sheet_solids_test
