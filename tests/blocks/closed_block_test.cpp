// SPDX-License-Identifier: GPL-3.0-or-later
// Blocks that are closed below, seen from anywhere: what is drawn of them is what an eye sees.
#include "dem/approximate/tin_of_grid.hpp"
#include "hidden_lines/instruments.hpp"
#include "map/draw_map.hpp"
#include "map/tied_with_drawn.hpp"
#include "placing/placed_view.hpp"
#include "placing/sector.hpp"
#include "profiles/profile.hpp"
#include "profiles/slab_lines.hpp"
#include "profiles/surface_edges.hpp"
#include "reference/closed_block_judge.hpp"
#include "tests/blocks/look_anywhere.hpp"
#include "tests/blocks/scene_with_voids.hpp"
#include "tests/catch.hpp"
#include "tests/scenes/random_scene.hpp"
#include "tests/scenes/random_tin_scene.hpp"
#include "tests/scenes/vary_view.hpp"
#include "tests/support/grid_of.hpp"
#include "tests/support/random.hpp"
#include "view/sectors.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

namespace orograph::closed_block_test {
namespace {

const std::uint64_t kScenes = last_seed(150);

struct Tally {
  std::uint64_t drawn = 0, from_below = 0; // scenes
  std::uint64_t asked = 0, unsure = 0, visible = 0, of_base = 0, drawn_wrong = 0, missing = 0;
};

class ClosedCheck : public LineObserver {
public:
  ClosedCheck(const TerrainData& terrain, const PlacedView& placed, Random& random, Tally& tally)
      : terrain_(terrain), placed_(placed), random_(random), tally_(tally) {}

  void see(const SeenProfile& seen) override {
    if (!prepare(seen.sector) || seen.segments.empty()) return;
    for (int k = 0; k < 4; ++k) {
      const auto number =
          static_cast<std::uint32_t>(random_.whole(0, static_cast<int>(seen.segments.size()) - 1));
      const double t = random_.between(0.001, 0.999);
      const std::uint32_t left = left_vertex(seen.segments[number]);
      const Profile& profile = seen.profile;
      const ProfilePoint a{profile.u_m[left], profile.depth_m, profile.z_m[left]},
          b{profile.u_m[left + 1], profile.depth_m, profile.z_m[left + 1]};
      ask(seen.clipped, {a, b}, t, std::ranges::any_of(seen.visible, [&](const Piece& piece) {
            return piece.segment == number && piece.t_begin <= t && t <= piece.t_end;
          }));
    }
  }
  void see_underside(const SeenProfile& seen) override { CHECK(seen.visible.empty()); }

  void see(const SeenLines& seen) override {
    if (!prepare(seen.sector)) return;
    std::vector<std::uint32_t> lines, on_walls;
    for (std::uint32_t i = 0; i < seen.lines.size(); ++i) {
      if (!seen.lines.line(i).drawn || seen.lines.is_moved(seen.lines.line(i).edge)) continue;
      lines.push_back(i);
      if (is_on_wall(seen.lines.line(i).kind)) on_walls.push_back(i);
    }
    for (int k = 0; k < 100 && !lines.empty(); ++k) {
      const auto& from = k % 2 == 0 && !on_walls.empty() ? on_walls : lines;
      const std::uint32_t line =
          from[static_cast<std::size_t>(random_.whole(0, static_cast<int>(from.size()) - 1))];
      const auto part = std::find_if(seen.visible.begin(), seen.visible.end(),
                                     [&](const LinePart& p) { return p.line == line; });
      double t = random_.between(0, 1);
      if (part != seen.visible.end() && random_.chance(0.4))
        t = (random_.chance(0.5) ? part->t_begin : part->t_end) + random_.pick({-1e-3, 1e-3});
      if (!(t > 1e-4 && t < 1 - 1e-4)) continue;
      bool is_drawn = false;
      for (auto p = part; p != seen.visible.end() && p->line == line; ++p)
        is_drawn = is_drawn || (p->t_begin <= t && t <= p->t_end);
      if (is_drawn && seen.lines.line(line).kind == LineKind::block) ++tally_.of_base;
      ask(seen.clipped, seen.lines.whole(line), t, is_drawn);
    }
    const std::uint64_t tied = undrawn_.count(seen);
    tally_.missing -= tied;
    tally_.unsure += tied;
  }

private:
  bool prepare(const Sector& sector) {
    if (&sector == sector_) return can_ask_;
    sector_ = &sector;
    view_ = &sector.view;
    can_ask_ = view_->is_perspective() || view_->y_per_z > 1e-3; // not from straight above or below
    tolerance_ = tie_tolerance(sector, 1e-4);
    judge_.emplace(terrain_, *placed_.block_base_m, *view_, tolerance_);
    return can_ask_;
  }

  void ask(XRange clipped, const ProfileLine& line, double t, bool is_drawn) {
    const ProfilePoint at = point_between(line.from, line.to, t);
    const double from_m = std::max(kNearPlanesAhead * view_->near_m, view_->drawn_from_m);
    if (view_->is_perspective() && at.v <= 1.01 * from_m) return;
    const Vec2 plane = project(*view_, at);
    if (!(plane.x > clipped.begin && plane.x < clipped.end)) return;
    ++tally_.asked;
    using Sight = ClosedBlockJudge::Sight;
    const Sight sight = judge_->sight(line, t);
    if (sight == Sight::unsure) ++tally_.unsure;
    if (sight == Sight::seen) ++tally_.visible;
    if (sight == Sight::hidden && is_drawn) ++tally_.drawn_wrong;
    if (sight == Sight::seen && !is_drawn) {
      ++tally_.missing;
      undrawn_.add(plane, tolerance_.at(plane.x, plane.y));
    }
  }

  const TerrainData& terrain_;
  const PlacedView& placed_;
  Random& random_;
  Tally& tally_;
  const Sector* sector_ = nullptr;
  const View* view_ = nullptr;
  bool can_ask_ = false;
  TieTolerance tolerance_;
  std::optional<ClosedBlockJudge> judge_;
  TiedWithDrawn undrawn_; ///< what is seen and not drawn
};

void close_below(Style& style) {
  style.underside = Underside::draw;
  style.block.sides = BlockSides::lines;
  style.pen_width_mm = 2; // so that hatching is wide
  std::erase_if(style.layers, [](const LayerSpec& of) {
    return of.name.starts_with("hidden") || of.name == "solids" || of.name == "pen-up";
  });
  for (const char* layer : {"block", "contours", "edges", "border"})
    if (!style.asks_for(layer)) style.layers.emplace_back(layer);
}

// Tells whether it was drawn, and not refused.
bool check(const TerrainData& terrain, const MapSpec& spec, Random& random, Tally& sum) {
  const std::optional<PlacedView> placed = placed_if_any(terrain, spec);
  if (!placed) return false;
  const Tally before = sum;
  ClosedCheck check(terrain, *placed, random, sum);
  Instruments instruments;
  instruments.observers = {&check};
  instruments.vertices_a_strip = random.pick({600.0, 7.0});
  draw_map(
      terrain, *placed, spec, [](double) {}, instruments);
  CHECK(sum.drawn_wrong == before.drawn_wrong);
  CHECK(sum.missing == before.missing);
  ++sum.drawn;
  const View& view = placed->view;
  const double base_z = *placed->block_base_m * view.exaggeration;
  if (view.is_perspective() ? view.eye_z_m < base_z : view.y_per_v < 0) ++sum.from_below;
  return true;
}

void tell(const Tally& sum) {
  WARN(sum.drawn << " drawn, " << sum.from_below << " from below, " << sum.asked << " asked, "
                 << sum.unsure << " unsure, " << sum.visible << " visible, " << sum.of_base
                 << " of base and corners, " << sum.drawn_wrong << " drawn wrong, " << sum.missing
                 << " missing");
  CHECK(sum.from_below > kScenes / 8);
  CHECK(sum.visible > 5 * sum.drawn);
  CHECK(sum.of_base > 3 * sum.drawn);
  CHECK(sum.unsure < sum.asked / 5);
}

} // namespace

TEST_CASE("a block that is closed below is drawn as it is seen, from below as well") {
  Tally sum;
  // The first were wrong: feet straight away from the eye, a profile that touches a vertex.
  std::vector<std::uint64_t> seeds{1044, 1966, 2123};
  for (std::uint64_t seed = 1; seed <= kScenes; ++seed) seeds.push_back(seed);
  for (const std::uint64_t seed : seeds) {
    Random random(seed);
    RandomScene scene = scene_with_voids(seed, random);
    look_anywhere(scene.spec, scene.terrain, random);
    close_below(scene.spec.style);
    const bool is_tin = seed % 4 == 0;
    if (is_tin) {
      const Grid grid = grid_of(scene.terrain);
      scene.terrain.surface = tin_of(grid);
    }
    INFO("seed " << seed << ": " << scene.what << (is_tin ? ", a TIN" : ""));
    check(scene.terrain, scene.spec, random, sum);
  }
  tell(sum);
  CHECK(sum.drawn > kScenes / 2);
}

TEST_CASE("and so is one of a survey or a lattice with vertical walls") {
  Tally sum;
  std::uint64_t with_walls = 0;
  // The first were wrong: an upright step of the border, an edge up a wall of which one side is
  // seen, rims that meet at a void's corner, a wall beside a narrow notch.
  std::vector<std::uint64_t> seeds{3655, 188, 1226, 253};
  for (std::uint64_t seed = 1; seed <= kScenes; ++seed) seeds.push_back(seed);
  for (const std::uint64_t seed : seeds) {
    Random random(seed);
    RandomTinScene scene = random_tin_scene(seed, false);
    scene.spec.view.from_elevation = Angle::degrees(random.between(-80, 80));
    close_below(scene.spec.style);
    INFO("seed " << seed << ": " << scene.what);
    if (check(scene.terrain, scene.spec, random, sum) &&
        !walls_of(std::get<Tin>(scene.terrain.surface)).empty())
      ++with_walls;
  }
  tell(sum);
  WARN(with_walls << " with walls");
  CHECK(with_walls >= enough(kScenes / 10));
}

} // namespace orograph::closed_block_test
