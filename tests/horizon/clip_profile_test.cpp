// SPDX-License-Identifier: GPL-3.0-or-later
// The horizon in blocks against the one in a list, and the quick clip of profiles against `clip`.
#include "horizon/clip.hpp"
#include "horizon/clip_profile.hpp"
#include "tests/catch.hpp"
#include "tests/horizon/flat_scenes.hpp"
#include "tests/support/random.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace orograph::clip_profile_test {
namespace {

// Segments as a profile: neighbours that meet are joined. `spans` are the segments' numbers.
struct AsProfile {
  ProjectedProfile profile;
  std::map<std::uint32_t, std::uint32_t> span_of_segment;
};

AsProfile profile_of(const std::vector<Segment>& segments) {
  AsProfile out;
  auto& [x, y, runs] = out.profile;
  const auto add = [&](double at_x, double at_y) {
    x.push_back(at_x);
    y.push_back(at_y);
    return static_cast<std::uint32_t>(x.size() - 1);
  };
  for (std::uint32_t i = 0; i < segments.size(); ++i) {
    const Segment& s = segments[i];
    if (runs.empty() || x.back() != s.x0 || y.back() != s.y0) {
      const std::uint32_t first = add(s.x0, s.y0);
      runs.push_back({first, first});
    }
    out.span_of_segment[i] = static_cast<std::uint32_t>(x.size() - 1);
    runs.back().last = add(s.x1, s.y1);
  }
  return out;
}

bool is_joined(const ProjectedProfile& profile, std::uint32_t vertex) {
  return std::any_of(profile.runs.begin(), profile.runs.end(),
                     [&](const VertexRun& run) { return run.first < vertex && vertex < run.last; });
}

// What meets is one.
void add_joined(std::vector<VisibleRun>& runs, const VisibleRun& next,
                const ProjectedProfile& profile) {
  if (!runs.empty()) {
    VisibleRun& last = runs.back();
    const bool in_span = last.last == next.first && last.t_end == next.t_begin;
    const bool at_vertex = last.last + 1 == next.first && last.t_end >= 1 && next.t_begin <= 0 &&
                           is_joined(profile, next.first);
    if (in_span || at_vertex) {
      last.last = next.last;
      last.t_end = next.t_end;
      return;
    }
  }
  runs.push_back(next);
}

std::vector<VisibleRun> runs_of(const std::vector<Piece>& pieces, const AsProfile& as) {
  std::vector<VisibleRun> runs;
  for (const Piece& piece : pieces) {
    const std::uint32_t span = as.span_of_segment.at(piece.segment);
    add_joined(runs, {span, span, piece.t_begin, piece.t_end}, as.profile);
  }
  return runs;
}

bool same_pieces(const Horizon& a, const Horizon& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const HorizonPiece& p, const HorizonPiece& q) {
                      return p.x_begin == q.x_begin && p.x_end == q.x_end &&
                             p.source.id == q.source.id && p.inked == q.inked;
                    });
}

std::pair<double, double> x_range(const FlatScene& scene) {
  double low = HUGE_VAL, high = -HUGE_VAL;
  for (const auto& list : scene)
    for (const Segment& s : list) {
      low = std::min(low, s.x0);
      high = std::max(high, s.x1);
    }
  return {low, high};
}

} // namespace

TEST_CASE("profiles clipped by blocks show what clip shows, whole and in ranges") {
  std::size_t runs_seen = 0, ranges = 0, steps = 0, ties = 0, split = 0;
  for (const SceneKind& kind : scene_kinds())
    for (std::uint64_t seed = 1; seed <= last_seed(60); ++seed) {
      CAPTURE(kind.name, seed);
      Random random(seed);
      const FlatScene scene = flat_scene(kind, seed);
      const auto [low, high] = x_range(scene);
      if (!(low < high)) continue;
      const double tolerance = random.pick({0.0, 0.0, 1e-9, 0.05}) * kind.y_scale;
      const ClipOptions compared{
          Role::compared, {tolerance, Homography{}, tolerance}, true, random.chance(0.8)};
      const auto blocks_at_first = static_cast<std::size_t>(random.pick({1, random.whole(1, 40)}));
      BlockedHorizon blocks(low, high, blocks_at_first);
      Horizon list_horizon = initial_horizon();
      ClipWorkspace workspace;
      for (std::size_t i = 0; i < scene.size(); ++i) {
        if (i % 2 == 0) {
          clip(scene[i], list_horizon, {Role::occluder, {}, true}, workspace);
          for (const Segment& s : scene[i]) blocks.raise({s.x0, s.x1, s, false});
          REQUIRE(same_pieces(blocks.joined(), list_horizon));
          continue;
        }
        const AsProfile as = profile_of(scene[i]);
        // In ranges, put together again, on a copy; marks of ties there are its own.
        std::vector<VisibleRun> in_ranges;
        ProfileClipCounts counts;
        BlockedHorizon copy = blocks;
        double from = -HUGE_VAL;
        const int count = random.whole(1, 4);
        for (int k = 1; k <= count; ++k) {
          const bool at_vertex = !as.profile.x.empty() && random.chance(0.3);
          double to = k == count  ? HUGE_VAL
                      : at_vertex ? as.profile.x[static_cast<std::size_t>(
                                        random.whole(0, static_cast<int>(as.profile.x.size()) - 1))]
                                  : random.between(low, high);
          to = std::max(from, to);
          std::vector<VisibleRun> part;
          clip_profile(as.profile, {from, to}, copy, compared.tolerance, compared.is_drawn, part,
                       counts);
          for (const VisibleRun& run : part) add_joined(in_ranges, run, as.profile);
          from = to;
          ++ranges;
        }
        std::vector<VisibleRun> visible;
        clip_profile(as.profile, {-HUGE_VAL, HUGE_VAL}, blocks, compared.tolerance,
                     compared.is_drawn, visible, counts);
        clip(scene[i], list_horizon, compared, workspace);
        REQUIRE(visible == runs_of(workspace.visible, as));
        REQUIRE(in_ranges == visible);
        REQUIRE(blocks.size() == list_horizon.size());
        REQUIRE(same_pieces(blocks.joined(), list_horizon));
        runs_seen += visible.size();
        steps += counts.steps;
        ties += counts.ties;
      }
      split += blocks.blocks().size() > blocks_at_first;
    }
  WARN(runs_seen << " visible runs, " << ranges << " ranges, " << steps << " steps, " << ties
                 << " ties, " << split << " horizons whose blocks were halved");
  CHECK(runs_seen > enough(10000));
  CHECK(ties > enough(100));
  CHECK(split > enough(50));
}

TEST_CASE("a horizon in blocks has bounds, and a cursor over all of its pieces") {
  for (const SceneKind& kind : scene_kinds())
    for (std::uint64_t seed = 1; seed <= last_seed(30); ++seed) {
      CAPTURE(kind.name, seed);
      Random random(seed);
      const FlatScene scene = flat_scene(kind, seed);
      const auto [low, high] = x_range(scene);
      if (!(low < high)) continue;
      BlockedHorizon horizon(low, high,
                             static_cast<std::size_t>(random.pick({1, random.whole(1, 30)})));
      for (const auto& list : scene)
        for (const Segment& s : list) horizon.raise({s.x0, s.x1, s, false});
      double end = -HUGE_VAL;
      for (const HorizonBlock& block : horizon.blocks()) {
        REQUIRE(block.x_begin == end);
        for (const HorizonPiece& piece : block.pieces) {
          REQUIRE(piece.x_begin == end);
          REQUIRE(piece.x_begin < piece.x_end);
          end = piece.x_end;
          if (is_sky(piece)) {
            REQUIRE(block.low == -HUGE_VAL);
            continue;
          }
          for (const double x : {piece.x_begin, piece.x_end}) {
            REQUIRE(height_at(piece.source, x) >= block.low);
            REQUIRE(height_at(piece.source, x) <= block.high);
          }
        }
        REQUIRE(block.x_end == end);
      }
      REQUIRE(end == HUGE_VAL);
      for (int i = 0; i < 20; ++i) {
        const double x = random.between(low, high);
        REQUIRE(horizon.blocks()[horizon.block_at(x)].x_begin <= x);
        REQUIRE(horizon.blocks()[horizon.block_at(x)].x_end > x);
        auto cursor = BlockedCursor(horizon, x);
        REQUIRE(cursor->x_end >= x);
        REQUIRE(cursor->x_begin <= x);
        double reached = cursor->x_end;
        for (++cursor; cursor; ++cursor) {
          REQUIRE(cursor->x_begin == reached);
          reached = cursor->x_end;
        }
        REQUIRE(reached == HUGE_VAL);
      }
    }
}

} // namespace orograph::clip_profile_test
