// SPDX-License-Identifier: GPL-3.0-or-later
// Strokes of profiles against their definition, span after span.
#include "hidden_lines/profile_strokes.hpp"
#include "tests/catch.hpp"
#include "tests/support/random.hpp"

#include <algorithm>
#include <utility>

using namespace orograph;

namespace {

Profile made_profile(Random& random) {
  Profile profile;
  profile.depth_m = random.pick({20.0, 70.0});
  double u = -50;
  for (int i = random.pick({2, 5, 40, 400}); i > 0; --i) {
    profile.u_m.push_back(u);
    profile.z_m.push_back(random.between(-9, 9));
    profile.after.push_back(random.chance(0.2)   ? Span::level
                            : random.chance(0.1) ? Span::wall
                                                 : Span::slope);
    u += random.between(0.01, 0.2);
  }
  profile.after.back() = Span::gap;
  return profile;
}

// In order, some of them meeting at a vertex or in one span. What ends at a vertex ends at the end
// of the span in front of it.
std::vector<VisibleRun> made_runs(Random& random, std::uint32_t spans) {
  std::vector<std::pair<std::uint32_t, double>> places;
  for (int i = 2 * random.whole(0, 6); i > 0; --i)
    places.emplace_back(random.whole(0, static_cast<int>(spans) - 1),
                        random.pick({0.0, 1.0, 0.25, 0.5}));
  std::sort(places.begin(), places.end());
  std::vector<VisibleRun> runs;
  for (std::size_t i = 0; i + 1 < places.size(); i += 2)
    if (places[i] != places[i + 1] && places[i + 1].second > 0)
      runs.push_back(
          {places[i].first, places[i + 1].first, places[i].second, places[i + 1].second});
  return runs;
}

using Polyline = std::vector<Vec3>; // in the view's frame

std::vector<Polyline> by_definition(const Profile& profile, const std::vector<VisibleRun>& runs,
                                    bool draws_level, double sign) {
  const auto at = [&](std::uint32_t span, double t) {
    const double u = profile.u_m[span], z = profile.z_m[span];
    return Vec3{sign * (t >= 1 ? profile.u_m[span + 1] : u + t * (profile.u_m[span + 1] - u)),
                sign * profile.depth_m,
                t >= 1 ? profile.z_m[span + 1] : z + t * (profile.z_m[span + 1] - z)};
  };
  std::vector<Polyline> out;
  std::pair<std::uint32_t, double> last{0, -1};
  for (const auto& [first_span, last_span, t_begin, t_end] : runs)
    for (std::uint32_t span = first_span; span <= last_span; ++span) {
      if (profile.after[span] == Span::level && !draws_level) continue;
      const double begin = span == first_span ? t_begin : 0, end = span == last_span ? t_end : 1;
      // Runs that meet between two vertices are two strokes.
      if (last != std::pair{span, begin} || begin > 0) out.push_back({at(span, begin)});
      out.back().push_back(at(span, end));
      last = end >= 1 ? std::pair{span + 1, 0.0} : std::pair{span, end};
    }
  return out;
}

} // namespace

TEST_CASE("strokes are what is visible of a profile, joined at vertices") {
  View ahead;
  ahead.eye_z_m = 3;
  View parallel;
  parallel.projection = Projection::orthographic;
  parallel.x_per_v = 0.25;
  parallel.y_per_z = 0.5;
  parallel.y_per_v = 0.125;
  std::size_t strokes = 0;
  for (std::uint64_t seed = 1; seed <= 3000; ++seed) {
    Random random(seed);
    INFO("seed " << seed);
    const Profile profile = made_profile(random);
    const auto runs = made_runs(random, static_cast<std::uint32_t>(profile.size()) - 1);
    const View& view = random.chance(0.5) ? ahead : parallel;
    Sector sector;
    sector.view = view;
    sector.behind = view.is_perspective() && random.chance(0.3);
    StrokeSettings settings;
    // Of what is behind the eye w is below 0 before the homography and above 0 behind it.
    if (sector.behind) settings.to_page = {{-1, 0, 0, 0, -1, 0, 0, 0, -1}};
    settings.frame_mm = {{-1e4, -1e4}, {1e4, 1e4}};
    settings.simplify_mm = 0;
    settings.to_map = [](ProfilePoint p) { return Vec3{p.u, p.v, p.z}; };
    const bool draws_level = random.chance(0.3);
    Layer layer;
    StrokeBuilder builder(settings, layer);
    ProfileStrokes(view, sector, draws_level, builder).add(profile, {profile.depth_m, 5}, runs);

    const double sign = sector.behind ? -1 : 1;
    const auto expected = by_definition(profile, runs, draws_level, sign);
    REQUIRE(layer.strokes.size() == expected.size());
    for (std::size_t i = 0; i < expected.size(); ++i) {
      const Stroke& stroke = layer.strokes[i];
      REQUIRE(stroke.profile == 5);
      REQUIRE(stroke.depth_m == sign * profile.depth_m);
      REQUIRE(stroke.point_count == expected[i].size());
      for (std::uint32_t k = 0; k < stroke.point_count; ++k) {
        const Vec3 p = expected[i][k];
        REQUIRE(layer.map[stroke.first_point + k] == p);
        const Vec3 page = settings.to_page.of(project_homogeneous(view, {p.x, p.y, p.z}));
        REQUIRE(layer.page_mm[stroke.first_point + k] == Vec2{page.x / page.z, page.y / page.z});
      }
    }
    strokes += expected.size();
  }
  REQUIRE(strokes > 10000);
}
