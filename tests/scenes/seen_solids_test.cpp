// SPDX-License-Identifier: GPL-3.0-or-later
// What is drawn of solids, and what they hide of the ground, asked of the reference: every face and
// every triangle of the ground, by rays.
#include "hidden_lines/sector_pass.hpp"
#include "hidden_lines/surface_lines.hpp"
#include "map/draw_map.hpp"
#include "tests/catch.hpp"
#include "tests/scenes/check_shares.hpp"
#include "tests/scenes/random_solid_scene.hpp"
#include "tests/scenes/same_drawing.hpp"
#include "tests/support/random.hpp"

#include <map>

namespace orograph::seen_solids_test {
namespace {

const std::uint64_t kScenes = last_seed(100);
constexpr int kGroundLines = 20;

// A scene as it is drawn: what of it lies ahead of the eye.
struct DrawnSolids {
  SolidScene made;
  PlacedView scene;
  std::map<std::uint32_t, std::vector<LineShare>> visible, hidden; // by edge
  std::vector<std::uint32_t> first_edge;

  explicit DrawnSolids(std::uint64_t seed)
      : made(random_solid_scene(seed)), scene(placed_view(made.terrain, made.spec)) {
    scene.solids = made.standing;
    first_edge.push_back(0);
    for (const StandingSolid& standing : made.standing)
      first_edge.push_back(first_edge.back() +
                           static_cast<std::uint32_t>(standing.solid->edges.size()));
    // All ground is looked at: solids are asked of beside the page as well.
    const LinesOfView lines{lines_of(made.terrain, scene, made.spec.style), {}, std::nullopt};
    Counts counts;
    StageSeconds seconds;
    const SectorLines found =
        sector_pass(made.terrain, scene, scene.sectors.front(), lines, nullptr, made.spec.style,
                    {.beyond_page = true}, nullptr, {counts, seconds}, [] {});
    for (const LinePart& part : found.solids.visible)
      visible[part.line].push_back({part.t_begin, part.t_end});
    for (const LinePart& part : found.solids.hidden)
      hidden[part.line].push_back({part.t_begin, part.t_end});
  }

  std::vector<LineShare> shares(std::size_t solid, std::size_t edge) const {
    const auto at = visible.find(first_edge[solid] + static_cast<std::uint32_t>(edge));
    return at == visible.end() ? std::vector<LineShare>{} : at->second;
  }
};

std::vector<LineShare> hidden_by(const SolidsInView& solids, ProfilePoint from, ProfilePoint to) {
  std::vector<Share> hidden;
  solids.add_hidden(line_in_view(solids.view(), as_vec(from), as_vec(to)), {}, hidden);
  unite(hidden, solids.sliver_m() / length(as_vec(to) - as_vec(from)));
  std::vector<LineShare> out;
  for (const Share& share : hidden) out.push_back({share.begin, share.end});
  return out;
}

// Between neighbouring vertices of the surface; none where there is no height, or no picture.
std::optional<ProfileLine> ground_line(const SolidScene& made, const View& view, Random& random) {
  const auto profile = [&](Vec3 vertex) { return to_profile_frame(view, vertex); };
  ProfileLine line;
  if (const Tin* tin = std::get_if<Tin>(&made.terrain.surface)) {
    const auto& t = tin->triangles[static_cast<std::size_t>(
        random.whole(0, static_cast<int>(tin->triangles.size()) - 1))];
    line = {profile(tin->vertices_m[t[0]]), profile(tin->vertices_m[t[1]])};
  } else {
    const Grid& grid = std::get<Grid>(made.terrain.surface);
    const int c = random.whole(0, grid.columns - 2), r = random.whole(0, grid.rows - 2);
    line = {profile(grid.vertex_m(c, r)), profile(grid.vertex_m(c + 1, r + 1))};
  }
  const bool has_picture =
      !view.is_perspective() || (line.from.v > view.near_m && line.to.v > view.near_m);
  return has_picture && std::isfinite(line.from.z + line.to.z) ? std::optional(line) : std::nullopt;
}

} // namespace

TEST_CASE("edges of solids are drawn where the eye sees them, and nowhere else", "[slow]") {
  ShareTally tally;
  for (std::uint64_t seed = 1; seed <= kScenes; ++seed) {
    const DrawnSolids drawn(seed);
    const View& view = drawn.scene.sectors.front().view;
    const Sight sight(drawn.made.terrain.surface, drawn.made.standing, view);
    CAPTURE(seed, drawn.made.what);
    Random random(seed);
    const ShareTally found = check_edges(
        sight, view, drawn.made.standing,
        [&](std::size_t solid, std::size_t edge) { return drawn.shares(solid, edge); }, random,
        share_check(view, drawn.made.standing));
    CAPTURE(found.first_wrong, found.drawn_but_hidden, found.missing, found.disordered);
    CHECK(found.wrong() == 0);
    tally.add(found);
  }
  WARN(tally.lines << " edges in " << kScenes << " scenes, " << tally.asked << " points asked, "
                   << tally.unsure << " unsure, " << tally.visible << " visible, " << tally.wrong()
                   << " wrong");
  CHECK(tally.visible > 20 * kScenes);
  CHECK(tally.unsure < tally.asked / 4);
}

TEST_CASE("lines on the ground are left out where solids hide them, and nowhere else") {
  ShareTally tally;
  for (std::uint64_t seed = 1; seed <= kScenes; ++seed) {
    const SolidScene made = random_solid_scene(seed);
    const PlacedView scene = placed_view(made.terrain, made.spec);
    const View& view = scene.sectors.front().view;
    const Sight sight(made.terrain.surface, made.standing, view);
    const SolidsInView solids(made.standing, view);
    CAPTURE(seed, made.what);
    Random random(seed);
    for (int i = 0; i < kGroundLines; ++i) {
      const auto line = ground_line(made, view, random);
      if (!line) continue;
      const ShareTally found = check_ground_line(
          sight, line->from, line->to,
          [&](ProfilePoint from, ProfilePoint to) { return hidden_by(solids, from, to); }, random,
          share_check(view, made.standing));
      CAPTURE(found.first_wrong, found.drawn_but_hidden, found.missing);
      CHECK(found.wrong() == 0);
      tally.add(found);
    }
  }
  WARN(tally.lines << " lines, " << tally.asked << " points asked, " << tally.unsure << " unsure, "
                   << tally.shares << " hidden shares, " << tally.wrong() << " wrong");
  CHECK(tally.shares > kScenes);
}

// Every edge that isn't smooth is in one of the two lists all along, as far as it has a picture.
TEST_CASE("what isn't visible of edges is hidden") {
  for (std::uint64_t seed = 1; seed <= kScenes / 5; ++seed) {
    const DrawnSolids drawn(seed);
    const View& view = drawn.scene.sectors.front().view;
    CAPTURE(seed, drawn.made.what);
    for (std::size_t s = 0; s < drawn.made.standing.size(); ++s) {
      const StandingSolid& standing = drawn.made.standing[s];
      for (std::uint32_t e = 0; e < standing.solid->edges.size(); ++e) {
        const SolidEdge& edge = standing.solid->edges[e];
        const double v_from = to_profile_frame(view, standing.vertices_m[edge.from]).v,
                     v_to = to_profile_frame(view, standing.vertices_m[edge.to]).v;
        if (edge.smooth || (view.is_perspective() && std::min(v_from, v_to) < view.near_m))
          continue;
        double sum = 0;
        for (const auto* shares : {&drawn.visible, &drawn.hidden})
          if (const auto at = shares->find(drawn.first_edge[s] + e); at != shares->end())
            for (const LineShare& share : at->second) sum += share.end - share.begin;
        CHECK(sum == Approx(1).epsilon(1e-9));
      }
    }
  }
}

TEST_CASE("what isn't looked at changes nothing of solids") {
  int solids = 0;
  for (std::uint64_t seed = 1; seed <= kScenes / 5; ++seed) {
    SolidScene made = random_solid_scene(seed);
    made.spec.style.layers = {"profiles", "border", "silhouettes", "skyline", "solids", "hidden"};
    PlacedView scene = placed_view(made.terrain, made.spec);
    scene.solids = made.standing;
    const auto draw = [&](const Instruments& instruments) {
      return draw_map(
                 made.terrain, scene, made.spec, [](double) {}, instruments)
          .drawing;
    };
    CAPTURE(seed, made.what);
    const Drawing drawing = draw({});
    REQUIRE(difference(drawing, draw({.hidden_ground = true})) == "");
    solids += drawing.layers.back().strokes.empty() ? 0 : 1;
  }
  CHECK(solids > static_cast<int>(kScenes / 10));
}

} // namespace orograph::seen_solids_test
