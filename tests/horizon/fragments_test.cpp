// SPDX-License-Identifier: GPL-3.0-or-later
// Collapse: what is kept is what was cut, with neighbours of one source joined.
#include "horizon/clip.hpp"
#include "tests/catch.hpp"
#include "tests/horizon/flat_scenes.hpp"

namespace orograph::fragments_test {
namespace {

Horizon joined(const Horizon& horizon) {
  Horizon out;
  for (const HorizonPiece& piece : horizon)
    if (!out.empty() && out.back().source.id == piece.source.id && out.back().inked == piece.inked)
      out.back().x_end = piece.x_end;
    else
      out.push_back(piece);
  return out;
}

bool same(const Horizon& a, const Horizon& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const HorizonPiece& p, const HorizonPiece& q) {
                      return p.x_begin == q.x_begin && p.x_end == q.x_end &&
                             p.source.id == q.source.id && p.inked == q.inked;
                    });
}

std::vector<HorizonPiece> occluders_of(const std::vector<Segment>& segments,
                                       const std::vector<Segment>& others) {
  std::vector<HorizonPiece> out;
  for (const auto& list : {segments, others})
    for (const Segment& s : list) out.push_back({s.x0, s.x1, s, false});
  return out;
}

} // namespace

TEST_CASE("joined, the fragmented horizon is the collapsed one") {
  for (const SceneKind& kind : {scene_kinds()[0], scene_kinds()[1], scene_kinds()[2]})
    for (std::uint64_t seed = 1; seed <= 10; ++seed) {
      CAPTURE(kind.name, seed);
      const FlatScene scene = flat_scene(kind, seed);
      Horizon collapsed = initial_horizon(), fragmented = initial_horizon();
      ClipWorkspace workspace;
      for (std::size_t i = 0; i + 1 < scene.size(); ++i) {
        if (i % 3 == 0) { // two lists that overlap
          std::vector<HorizonPiece> both = occluders_of(scene[i], scene[i + 1]), copy = both;
          raise(both, collapsed, workspace, true);
          raise(copy, fragmented, workspace, false);
        } else {
          const Role role = i % 3 == 1 ? Role::drawn_occluder : Role::compared;
          clip(scene[i], collapsed, {role, {}, true}, workspace);
          clip(scene[i], fragmented, {role, {}, false}, workspace);
        }
        REQUIRE(same(joined(fragmented), collapsed));
        REQUIRE(same(joined(collapsed), collapsed));
      }
      CHECK(fragmented.size() > collapsed.size());
    }
}

} // namespace orograph::fragments_test
