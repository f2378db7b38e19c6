// SPDX-License-Identifier: GPL-3.0-or-later
// Blocks that are closed below, seen from anywhere: what is drawn of them is what an eye sees.
#include "dem/approximate/tin_of_grid.hpp"
#include "hidden_lines/instruments.hpp"
#include "map/draw_map.hpp"
#include "placing/placed_view.hpp"
#include "placing/sector.hpp"
#include "profiles/profile.hpp"
#include "profiles/slab_lines.hpp"
#include "reference/closed_block_judge.hpp"
#include "tests/blocks/look_anywhere.hpp"
#include "tests/blocks/scene_with_voids.hpp"
#include "tests/catch.hpp"
#include "tests/scenes/random_scene.hpp"
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

constexpr std::uint64_t kScenes = last_seed(150);

struct Tally {
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
  }

private:
  bool prepare(const Sector& sector) {
    if (&sector == sector_) return can_ask_;
    sector_ = &sector;
    view_ = &sector.view;
    can_ask_ = view_->is_perspective() || view_->y_per_z > 1e-3; // not from straight above or below
    judge_.emplace(terrain_, *placed_.block_base_m, *view_, tie_tolerance(sector, 1e-4));
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
    if (sight == Sight::seen && !is_drawn) ++tally_.missing;
  }

  const TerrainData& terrain_;
  const PlacedView& placed_;
  Random& random_;
  Tally& tally_;
  const Sector* sector_ = nullptr;
  const View* view_ = nullptr;
  bool can_ask_ = false;
  std::optional<ClosedBlockJudge> judge_;
};

} // namespace

TEST_CASE("a block that is closed below is drawn as it is seen, from below as well") {
  Tally sum;
  std::uint64_t drawn = 0, from_below = 0;
  for (std::uint64_t seed = 1; seed <= kScenes; ++seed) {
    Random random(seed);
    RandomScene scene = scene_with_voids(seed, random);
    look_anywhere(scene.spec, scene.terrain, random);
    Style& style = scene.spec.style;
    style.underside = Underside::draw;
    style.block.sides = BlockSides::lines;
    style.pen_width_mm = 2; // so that hatching is wide
    std::erase_if(style.layers, [](const LayerSpec& of) {
      return of.name.starts_with("hidden") || of.name == "solids" || of.name == "pen-up";
    });
    for (const char* layer : {"block", "contours", "edges", "border"})
      if (!style.asks_for(layer)) style.layers.emplace_back(layer);
    const bool is_tin = seed % 4 == 0;
    if (is_tin) {
      const Grid grid = grid_of(scene.terrain);
      scene.terrain.surface = tin_of(grid);
    }
    INFO("seed " << seed << ": " << scene.what << (is_tin ? ", a TIN" : ""));
    const std::optional<PlacedView> placed = placed_if_any(scene.terrain, scene.spec);
    if (!placed || placed->extent.turned_over > 0) continue;
    const Tally before = sum;
    ClosedCheck check(scene.terrain, *placed, random, sum);
    Instruments instruments;
    instruments.observers = {&check};
    instruments.vertices_a_strip = random.pick({600.0, 7.0});
    draw_map(
        scene.terrain, *placed, scene.spec, [](double) {}, instruments);
    CHECK(sum.drawn_wrong == before.drawn_wrong);
    CHECK(sum.missing == before.missing);
    ++drawn;
    const View& view = placed->view;
    const double base_z = *placed->block_base_m * view.exaggeration;
    if (view.is_perspective() ? view.eye_z_m < base_z : view.y_per_v < 0) ++from_below;
  }
  WARN(drawn << " drawn, " << from_below << " from below, " << sum.asked << " asked, " << sum.unsure
             << " unsure, " << sum.visible << " visible, " << sum.of_base
             << " of base and corners, " << sum.drawn_wrong << " drawn wrong, " << sum.missing
             << " missing");
  CHECK(drawn > kScenes / 2);
  CHECK(from_below > kScenes / 8);
  CHECK(sum.visible > 5 * drawn);
  CHECK(sum.of_base > 3 * drawn);
  CHECK(sum.unsure < sum.asked / 5);
}

} // namespace orograph::closed_block_test
