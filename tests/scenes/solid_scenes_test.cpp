// SPDX-License-Identifier: GPL-3.0-or-later
// Solids on terrains of every awkward kind, asked of the reference.
#include "placing/placed_view.hpp"
#include "tests/catch.hpp"
#include "tests/scenes/check_shares.hpp"
#include "tests/scenes/random_solid_scene.hpp"
#include "tests/support/random.hpp"

#include <algorithm>
#include <functional>

namespace orograph::solid_scenes_test {
namespace {

const std::uint64_t kScenes = last_seed(16);

// Where `is_in` is true along a line: looked for in steps, their ends by halving.
std::vector<LineShare> shares_by_halving(const std::function<bool(double)>& is_in) {
  constexpr int kSteps = 16;
  std::vector<LineShare> shares;
  bool before = false;
  double last = 0;
  for (int i = 0; i <= kSteps + 1; ++i) {
    const double t = std::clamp(static_cast<double>(i) / kSteps, 1e-9, 1 - 1e-9);
    const bool now = i <= kSteps && is_in(t);
    double in = now ? t : last, out = now ? last : t;
    if (i == 0 && now) in = 0;
    for (int k = 0; k < 50 && i > 0 && i <= kSteps && now != before; ++k) {
      const double middle = 0.5 * (in + out);
      (is_in(middle) ? in : out) = middle;
    }
    if (now && !before) shares.push_back({in, 1});
    if (!now && before) shares.back().end = i > kSteps ? 1 : in;
    before = now;
    last = t;
  }
  std::erase_if(shares, [](const LineShare& share) { return !(share.begin < share.end); });
  return shares;
}

// A scene with its reference, and what that would draw itself.
struct Asked {
  SolidScene scene;
  View view;
  Sight sight;
  ShareCheck check;

  explicit Asked(std::uint64_t seed)
      : scene(random_solid_scene(seed)), view(placed_view(scene.terrain, scene.spec).view),
        sight(scene.terrain.surface, scene.standing, view),
        check(share_check(view, scene.standing)) {}

  bool faces_eye(const StandingSolid& standing, std::uint32_t triangle) const {
    std::array<ProfilePoint, 3> p;
    for (std::size_t k = 0; k < 3; ++k)
      p[k] = to_profile_frame(view, standing.vertices_m[standing.solid->triangles[triangle][k]]);
    // As seen in the picture, in front of the eye or not: by the volume with it.
    const auto h = [&](std::size_t k) { return project_homogeneous(view, p[k]); };
    return (dot(h(0), cross(h(1), h(2))) < 0) == standing.mirrored;
  }

  std::vector<LineShare> visible_shares(std::size_t s, std::size_t e) const {
    const StandingSolid& standing = scene.standing[s];
    const SolidEdge& edge = standing.solid->edges[e];
    if (!edge.is_wire()) {
      const bool left = faces_eye(standing, edge.left), right = faces_eye(standing, edge.right);
      if (!left && !right) return {};
      if (edge.smooth && left == right) return {};
    }
    const ProfilePoint from = to_profile_frame(view, standing.vertices_m[edge.from]),
                       to = to_profile_frame(view, standing.vertices_m[edge.to]);
    const Own own{edge.is_wire() ? Own::Which::none : Own::Which::edge, s, e};
    return shares_by_halving([&](double t) {
      const ProfilePoint p = point_between(from, to, t);
      return p.v >= check.nearest_m && !sight.ask(p, 0, own).hidden();
    });
  }

  std::vector<LineShare> shares_by_solids(ProfilePoint from, ProfilePoint to) const {
    return shares_by_halving([&](double t) {
      return sight.by_solids(point_between(from, to, t), 0, {Own::Which::none}).hidden;
    });
  }

  // Between neighbouring vertices of the surface.
  std::pair<ProfilePoint, ProfilePoint> ground_line(Random& random) const {
    const auto profile = [&](Vec3 vertex) { return to_profile_frame(view, vertex); };
    if (const Tin* tin = std::get_if<Tin>(&scene.terrain.surface)) {
      const auto& t = tin->triangles[static_cast<std::size_t>(
          random.whole(0, static_cast<int>(tin->triangles.size()) - 1))];
      return {profile(tin->vertices_m[t[0]]), profile(tin->vertices_m[t[1]])};
    }
    const Grid& grid = std::get<Grid>(scene.terrain.surface);
    for (;;) {
      const int c = random.whole(0, grid.columns - 2), r = random.whole(0, grid.rows - 2);
      const auto a = profile(grid.vertex_m(c, r)), b = profile(grid.vertex_m(c + 1, r + 1));
      if (std::isfinite(a.z) && std::isfinite(b.z)) return {a, b};
    }
  }
};

void report(const char* what, const ShareTally& tally) {
  WARN(what << ": " << tally.lines << " lines, " << tally.shares << " shares, " << tally.asked
            << " asked, " << tally.unsure << " unsure, " << tally.visible << " visible, "
            << tally.drawn_but_hidden << " drawn but hidden, " << tally.missing << " missing; "
            << tally.first_wrong);
}

} // namespace

TEST_CASE("the check of edges finds nothing wrong with the reference's own, and all that is wrong",
          "[slow][unsanitized]") {
  ShareTally own, all, none, moved;
  for (std::uint64_t seed = 1; seed <= kScenes; ++seed) {
    const Asked asked(seed);
    CAPTURE(seed, asked.scene.what);
    const auto tally = [&](const VisibleShares& shares) {
      Random random(seed);
      return check_edges(asked.sight, asked.view, asked.scene.standing, shares, random,
                         asked.check);
    };
    const auto right = [&](std::size_t s, std::size_t e) { return asked.visible_shares(s, e); };
    own.add(tally(right));
    all.add(tally([](std::size_t, std::size_t) { return std::vector<LineShare>{{0, 1}}; }));
    none.add(tally([](std::size_t, std::size_t) { return std::vector<LineShare>{}; }));
    moved.add(tally([&](std::size_t s, std::size_t e) {
      auto shares = right(s, e);
      for (LineShare& share : shares) {
        if (share.begin > 0) share.begin = std::max(0.0, share.begin - 1e-5);
        if (share.end < 1) share.end = std::max(share.begin, share.end - 1e-5);
      }
      return shares;
    }));
  }
  report("edges", own);
  report("all drawn", all);
  report("none drawn", none);
  report("ends moved", moved);
  // Steps miss what is smaller.
  CHECK(own.wrong() < own.asked / 500);
  CHECK(own.unsure < own.asked / 4);
  CHECK(own.visible > own.asked / 10);
  CHECK(all.drawn_but_hidden > all.asked / 10);
  CHECK(all.missing == 0);
  CHECK(none.missing > none.asked / 10);
  CHECK(none.drawn_but_hidden == 0);
  CHECK(moved.drawn_but_hidden > own.drawn_but_hidden + kScenes);
  CHECK(moved.missing > own.missing + kScenes);
}

TEST_CASE("the check of lines on the ground does so too") {
  ShareTally own, none;
  for (std::uint64_t seed = 1; seed <= 6 * kScenes; ++seed) {
    const Asked asked(seed);
    CAPTURE(seed, asked.scene.what);
    Random random(seed);
    for (int i = 0; i < 10; ++i) {
      const auto [from, to] = asked.ground_line(random);
      own.add(check_ground_line(
          asked.sight, from, to,
          [&](ProfilePoint a, ProfilePoint b) { return asked.shares_by_solids(a, b); }, random,
          asked.check));
      none.add(check_ground_line(
          asked.sight, from, to,
          [](ProfilePoint, ProfilePoint) { return std::vector<LineShare>{}; }, random,
          asked.check));
    }
  }
  report("lines on the ground", own);
  report("nothing hidden", none);
  CHECK(own.wrong() < own.asked / 500);
  CHECK(own.shares > 3 * kScenes);
  CHECK(none.drawn_but_hidden > 3 * kScenes);
  CHECK(none.missing == 0);
}

TEST_CASE("what the reference is sure of stays so where the point is moved within the slack") {
  std::size_t asked = 0, unsure = 0, hidden = 0, otherwise = 0;
  for (std::uint64_t seed = 1; seed <= 2 * kScenes; ++seed) {
    const Asked all(seed);
    CAPTURE(seed, all.scene.what);
    Random random(seed);
    for (int i = 0; i < 60; ++i) {
      const auto s = static_cast<std::size_t>(
          random.whole(0, static_cast<int>(all.scene.standing.size()) - 1));
      const StandingSolid& standing = all.scene.standing[s];
      const auto e = static_cast<std::size_t>(
          random.whole(0, static_cast<int>(standing.solid->edges.size()) - 1));
      const SolidEdge& edge = standing.solid->edges[e];
      const Vec3 a = standing.vertices_m[edge.from], b = standing.vertices_m[edge.to];
      const double slack_m = random.pick({1e-2, 1e-4, 1e-6}) * length(b - a);
      const ProfilePoint p = point_between(to_profile_frame(all.view, a),
                                           to_profile_frame(all.view, b), random.share());
      if (p.v < all.check.nearest_m + slack_m) continue;
      const Own own{edge.is_wire() ? Own::Which::none : Own::Which::edge, s, e};
      const Sight::Answer answer = all.sight.ask(p, slack_m, own);
      ++asked;
      unsure += answer.unsure;
      hidden += answer.hidden();
      for (int k = 0; k < 4; ++k) {
        const auto by = [&] { return random.between(-0.5, 0.5) * slack_m; };
        const ProfilePoint moved{p.u + by(), p.v + by(), p.z + by()};
        CAPTURE(p.u, p.v, p.z, moved.u, moved.v, moved.z, slack_m);
        const bool same = all.sight.ask(moved, 0, own).hidden() == answer.hidden();
        if (!answer.unsure) CHECK(same);
        otherwise += !same;
      }
    }
  }
  WARN(asked << " asked, " << unsure << " unsure, " << hidden << " hidden; " << otherwise
             << " moved to the other answer");
  CHECK(unsure < asked / 3);
  CHECK(hidden < asked / 10 * 9);
  CHECK(otherwise > kScenes);
}

TEST_CASE("shares out of order, or beyond the line, are wrong") {
  const Asked asked(1);
  Random random(1);
  for (const std::vector<LineShare>& shares : {std::vector<LineShare>{{0.5, 1}, {0, 0.2}},
                                               {{0.2, 0.5}, {0.4, 0.6}},
                                               {{-0.1, 0.5}},
                                               {{0.5, 1.1}},
                                               {{0.5, 0.5}}}) {
    const ShareTally tally = check_edges(
        asked.sight, asked.view, asked.scene.standing,
        [&](std::size_t, std::size_t) { return shares; }, random, asked.check);
    CHECK(tally.disordered == tally.lines);
    CHECK(!tally.first_wrong.empty());
  }
}

} // namespace orograph::solid_scenes_test
