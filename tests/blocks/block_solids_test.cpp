// SPDX-License-Identifier: GPL-3.0-or-later
// Solids on a block and beside it, and of one that is closed below in it and beneath it: they cover
// it, and it covers them.
#include "hidden_lines/sector_pass.hpp"
#include "placing/placed_view.hpp"
#include "reference/closed_block_judge.hpp"
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
#include <optional>
#include <vector>

namespace orograph::block_solids_test {
namespace {

const std::uint64_t kScenes = last_seed(200);

struct Tally {
  std::uint64_t asked = 0, unsure = 0, visible = 0, by_solid = 0, by_block = 0, wrong = 0;
};

// A block with solids, asked of by rays alone.
class Asked {
public:
  Asked(const TerrainData& terrain, const PlacedView& placed, const Sector& sector,
        const Style& style)
      : view_(sector.view),
        walk_(triangles_in(terrain, view_), walls_in(terrain, placed, view_), view_) {
    if (style.underside == Underside::draw) {
      closed_.emplace(terrain, *placed.block_base_m, view_);
      judge_.emplace(terrain, *placed.block_base_m, view_, tie_tolerance(sector, 1e-4));
    }
    for (const StandingSolid& of : placed.solids)
      for (const auto& corners : of.solid->triangles) {
        std::array<Vec3, 3>& triangle = triangles_.emplace_back();
        for (std::size_t k = 0; k < 3; ++k)
          triangle[k] = as_vec(to_profile_frame(view_, of.vertices_m[corners[k]]));
      }
  }

  enum class Hidden { no, by_solid, by_block };
  // Of a place on one of the block's lines.
  std::optional<Hidden> on_block(const ProfileLine& line, double t, double sure_m) const {
    const ProfilePoint at = point_between(line.from, line.to, t);
    if (!judge_) return hidden(at, sure_m, false);
    using Sight = ClosedBlockJudge::Sight;
    // Rounding puts what is on a wall within it or in front of it.
    const auto in_front = [&](ProfilePoint p) {
      return moved(p, 0, 0, 1e-6 * std::hypot(p.u, p.v));
    };
    const Sight sight = judge_->sight({in_front(line.from), in_front(line.to)}, t);
    if (sight == Sight::unsure) return std::nullopt;
    if (sight == Sight::hidden) return Hidden::by_block;
    const Hidden here = behind_solids(at, sure_m);
    const double aside = 1e-5 * std::hypot(at.u, at.v);
    for (const double across : {-aside, aside})
      for (const double up : {-aside, aside})
        for (const double nearer : {0.0, 20 * aside})
          if (behind_solids(moved(at, across, up, nearer), sure_m) != here) return std::nullopt;
    return here;
  }

  // None where a little aside it is otherwise; of a solid a little behind as well, where it may
  // touch a wall.
  std::optional<Hidden> hidden(ProfilePoint at, double sure_m, bool of_solid) const {
    const auto here = hidden_just(at, sure_m);
    const double aside = 1e-5 * std::hypot(at.u, at.v);
    for (const double across : {-aside, aside})
      for (const double up : {-aside, aside}) // in front of what it lies on
        if (hidden_just(moved(at, across, up, 20 * aside), sure_m) != here) return std::nullopt;
    if (of_solid && here != Hidden::by_block &&
        hidden_just(moved(at, 0, 0, -20 * aside), sure_m) == Hidden::by_block)
      return std::nullopt;
    return here;
  }

private:
  ProfilePoint moved(ProfilePoint at, double across, double up, double nearer) const {
    const double along = u_along_ray(view_, at), size = std::hypot(along, 1);
    return {at.u + (across - nearer * along) / size, at.v - (across * along + nearer) / size,
            at.z + up - nearer / size * z_along_ray(view_, at)};
  }

  std::optional<Hidden> hidden_just(ProfilePoint at, double sure_m) const {
    const double inside_m = closed_ ? closed_->depth_inside_m(at) : walk_.depth_inside_m(at);
    if (std::abs(inside_m) <= sure_m) return std::nullopt;
    return inside_m > 0 ? Hidden::by_block : behind_solids(at, sure_m);
  }
  Hidden behind_solids(ProfilePoint at, double sure_m) const {
    const Way way = way_to_eye(view_, at);
    const double begin = sure_m / length(way.step);
    for (const auto& triangle : triangles_)
      if (passes(way, triangle, begin)) return Hidden::by_solid;
    return Hidden::no;
  }

  const View& view_;
  BlockWalk walk_;
  std::optional<ClosedBlockWalk> closed_;
  std::optional<ClosedBlockJudge> judge_; ///< of its lines
  std::vector<std::array<Vec3, 3>> triangles_;
};

struct Tallies {
  Tally of_block, of_solids;
  std::uint64_t drawn = 0, from_below = 0; ///< scenes
};

// Of one made scene; nothing where its view is refused.
void ask_scene(std::uint64_t seed, bool is_closed, Tallies& sum) {
  auto& [of_block, of_solids, drawn, from_below] = sum;
  SolidScene made = random_solid_scene(seed);
  const auto wrong_lines = of_block.wrong, wrong_solids = of_solids.wrong;
  Random random(seed);
  Style& style = made.spec.style;
  const Box3 box = placed_view(made.terrain, made.spec).extent.box;
  style.block.base = box.low.z - 0.1 * (box.high.x - box.low.x);
  style.block.unit_m = 1;
  for (const char* layer : {"block", "contours"})
    if (!style.asks_for(layer)) style.layers.emplace_back(layer);
  style.block.sides = BlockSides::lines;
  style.pen_width_mm = 2;
  double lowest_m = *style.block.base;
  if (is_closed) {
    style.underside = Underside::draw;
    std::erase_if(style.layers, [](const LayerSpec& of) { return of.name.starts_with("hidden"); });
    lowest_m -= 0.3 * (box.high.x - box.low.x);
    ViewSpec& view = made.spec.view;
    if (!view.has_eye())
      view.from_elevation = Angle::degrees(random.between(-80, 80));
    else if (view.eye_map && view.eye_map->z && random.chance(0.5))
      *view.eye_map->z = lowest_m;
  }
  INFO("seed " << seed << ": " << made.what);
  std::optional<PlacedView> placed = placed_if_any(made.terrain, made.spec);
  if (!placed) return;
  // Most beside the block, in front of it and behind it, between its base and its top.
  for (StandingSolid& solid : made.standing) {
    if (random.chance(0.4)) continue;
    const double azimuth = random.between(0, 6.283), out = random.between(is_closed ? 0 : 0.5, 0.9);
    const Vec3 by{out * (box.high.x - box.low.x) * std::cos(azimuth),
                  out * (box.high.y - box.low.y) * std::sin(azimuth),
                  random.between(lowest_m, box.high.z) - solid.vertices_m.front().z};
    for (Vec3& vertex : solid.vertices_m) vertex = vertex + by;
  }
  placed->solids = made.standing;
  const Sector& sector = placed->sectors.front();
  const View& view = sector.view;
  if (!view.is_perspective() && !(view.y_per_z > 1e-3)) return; // from straight above or below
  if (view.is_perspective() && std::ranges::any_of(made.standing, [&](const StandingSolid& solid) {
        return holds_eye(solid, view);
      }))
    return;
  ++drawn;
  if (view.is_perspective() ? view.eye_z_m < *style.block.base * view.exaggeration
                            : view.y_per_v < 0)
    ++from_below;
  const Instruments instruments{.beyond_page = true};
  const LinesOfView lines = lines_of_view(made.terrain, *placed, style, instruments, nullptr);
  const SectorFound found(made.terrain, *placed, sector, lines, style, instruments);
  const Asked asked(made.terrain, *placed, sector, style);
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
        &tally == &of_block ? asked.on_block(line, t, sure_m) : asked.hidden(at, sure_m, true);
    if (!hidden) {
      ++tally.unsure;
      return;
    }
    if (*hidden == Asked::Hidden::no) ++tally.visible;
    if (*hidden == Asked::Hidden::by_solid) ++tally.by_solid;
    if (*hidden == Asked::Hidden::by_block) ++tally.by_block;
    if ((*hidden == Asked::Hidden::no) != is_drawn) ++tally.wrong;
  };
  std::vector<std::uint32_t> on_walls;
  for (std::uint32_t i = 0; i < lines.listed.size(); ++i)
    if (is_on_wall(lines.listed[i].kind)) on_walls.push_back(i);
  for (int k = 0; k < 60 && !on_walls.empty(); ++k) {
    const std::uint32_t line =
        on_walls[static_cast<std::size_t>(random.whole(0, static_cast<int>(on_walls.size()) - 1))];
    const double t = random.between(0.01, 0.99);
    const bool is_drawn = std::ranges::any_of(found.visible, [&](const LinePart& part) {
      return part.line == line && part.t_begin <= t && t <= part.t_end;
    });
    ask(found.pictures.whole(line), t, is_drawn, of_block);
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
  CHECK(of_block.wrong == wrong_lines);
  CHECK(of_solids.wrong == wrong_solids);
}

Tallies ask_scenes(bool is_closed) {
  Tallies sum;
  for (std::uint64_t seed = 1; seed <= (is_closed ? kScenes / 2 : kScenes); ++seed)
    ask_scene(seed, is_closed, sum);
  WARN(sum.drawn << " drawn, " << sum.from_below << " from below");
  const auto& [of_block, of_solids, drawn, from_below] = sum;
  for (const auto& [what, of] : {std::pair{"on walls", &of_block}, {"on solids", &of_solids}})
    WARN(what << ": " << of->asked << " asked, " << of->unsure << " unsure, " << of->visible
              << " visible, " << of->by_solid << " behind solids, " << of->by_block
              << " behind the block, " << of->wrong << " wrong");
  CHECK(of_block.by_solid > drawn / 3);
  CHECK(of_block.visible > 5 * drawn);
  CHECK(of_solids.by_block > drawn);
  CHECK(of_solids.visible > 3 * drawn);
  return sum;
}

} // namespace

TEST_CASE("solids and a block's walls cover each other as they stand") {
  CHECK(ask_scenes(false).drawn > kScenes / 2);
}

TEST_CASE("solids and a block that is closed below cover each other, seen from anywhere") {
  const Tallies sum = ask_scenes(true);
  CHECK(sum.drawn > kScenes / 4);
  CHECK(sum.from_below > kScenes / 40);
}

} // namespace orograph::block_solids_test
