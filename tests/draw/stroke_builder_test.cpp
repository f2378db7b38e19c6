// SPDX-License-Identifier: GPL-3.0-or-later
// Strokes against sampled points of the polylines that they come from.
#include "draw/stroke_builder.hpp"
#include "tests/catch.hpp"
#include "tests/draw/to_segment.hpp"
#include "tests/support/random.hpp"

#include <algorithm>
#include <cmath>

using namespace orograph;

namespace {

// A camera at height 0 that descends by an angle, its picture on a page.
Homography camera(double descent, double mm) {
  const double s = std::sin(descent), c = std::cos(descent);
  return compose({{mm, 0, 100, 0, -mm, 70, 0, 0, 1}}, {{1, 0, 0, 0, c, s, 0, -s, c}});
}

struct PlacedView {
  StrokeSettings settings;
  bool perspective = false;
  std::vector<StrokePoint> points;
};

StrokePoint seen(ProfilePoint p, bool perspective) {
  if (perspective) return {{p.u, p.z, p.v}, p};
  return {{p.u, p.z + 0.5 * p.v, 1}, p};
}

Vec2 plane_of(const StrokePoint& p) {
  return {p.plane.x / p.plane.z, p.plane.y / p.plane.z};
}

PlacedView made_scene(Random& random) {
  PlacedView scene;
  StrokeSettings& settings = scene.settings;
  scene.perspective = random.chance(0.7);
  settings.frame_mm = {{10, 10}, {190, 140}};
  settings.simplify_mm = 0;
  settings.to_map = [](ProfilePoint p) { return Vec3{p.u, p.v, p.z}; };
  // Upwards steep enough, and points have no picture; on a whole-number page they lie on the frame.
  const bool whole = random.chance(0.3);
  settings.to_page = scene.perspective ? camera(random.pick({0.3, -0.9, 0.0}), 150)
                                       : Homography{{10, 0, 100, 0, -10, 70, 0, 0, 1}};
  const double reach = random.pick({3.0, 9.0, 30.0});
  for (int i = random.whole(0, 25); i > 0; --i) {
    ProfilePoint p{random.between(-reach, reach), random.between(1, 9),
                   random.between(-reach, reach)};
    if (whole) p = {std::round(p.u), 2.0 * random.whole(1, 2), std::round(p.z)};
    scene.points.push_back(seen(p, scene.perspective));
    if (random.chance(0.1)) scene.points.push_back(scene.points.back());
  }
  return scene;
}

Layer drawn(const PlacedView& scene) {
  Layer layer;
  StrokeBuilder builder(scene.settings, layer);
  builder.begin(3, 250);
  for (const StrokePoint& p : scene.points) builder.add(p);
  builder.end();
  return layer;
}

double to_strokes(Vec2 p, const Layer& layer) {
  double least = HUGE_VAL;
  for (const Stroke& stroke : layer.strokes) {
    const auto points = layer.points(stroke);
    for (std::size_t i = 0; i + 1 < points.size(); ++i)
      least = std::min(least, to_segment(p, points[i], points[i + 1]));
  }
  return least;
}

// Distance in the visibility plane of a point's picture to the polyline, and in space.
struct Nearness {
  double plane, space;
};
Nearness to_polyline(const PlacedView& scene, Vec3 map) {
  const StrokePoint p = seen({map.x, map.y, map.z}, scene.perspective);
  Nearness least{HUGE_VAL, HUGE_VAL};
  for (std::size_t i = 0; i + 1 < scene.points.size(); ++i) {
    const StrokePoint &a = scene.points[i], &b = scene.points[i + 1];
    least.plane = std::min(least.plane, to_segment(plane_of(p), plane_of(a), plane_of(b)));
    const Vec3 from{a.scene.u, a.scene.v, a.scene.z}, to{b.scene.u, b.scene.v, b.scene.z};
    const double squared = dot(to - from, to - from);
    const double t = squared > 0 ? std::clamp(dot(map - from, to - from) / squared, 0.0, 1.0) : 0;
    least.space = std::min(least.space, length(map - (from + t * (to - from))));
  }
  return least;
}

} // namespace

TEST_CASE("what lies in the frame is drawn, and nothing else", "[slow]") {
  // Page coordinates up to 200, from plane coordinates up to 30: some ten roundings.
  constexpr double rounding_mm = 1e-9;
  std::size_t strokes = 0;
  for (std::uint64_t seed = 1; seed <= last_seed(3000); ++seed) {
    Random random(seed);
    INFO("seed " << seed);
    const PlacedView scene = made_scene(random);
    const Layer layer = drawn(scene);
    const Box2& frame = scene.settings.frame_mm;
    const Homography& to_page = scene.settings.to_page;
    strokes += layer.strokes.size();

    REQUIRE(layer.map.size() == layer.page_mm.size());
    std::size_t next = 0;
    for (const Stroke& stroke : layer.strokes) {
      REQUIRE(stroke.first_point == next);
      REQUIRE(stroke.point_count >= 2);
      REQUIRE(stroke.profile == 3);
      REQUIRE(stroke.depth_m == 250);
      next += stroke.point_count;
    }
    REQUIRE(next == layer.page_mm.size());
    for (std::size_t i = 0; i < layer.page_mm.size(); ++i) {
      const Vec2 p = layer.page_mm[i];
      REQUIRE((p.x >= frame.low.x && p.x <= frame.high.x));
      REQUIRE((p.y >= frame.low.y && p.y <= frame.high.y));
      // The map point lies on the line in space, and its picture is the page point.
      const Vec3 map = layer.map[i];
      const Nearness near = to_polyline(scene, map);
      REQUIRE(near.space <= 1e-12 * 100);
      const Vec2 plane = plane_of(seen({map.x, map.y, map.z}, scene.perspective));
      REQUIRE(to_page.w(plane) > 0);
      REQUIRE(length(to_page(plane) - p) <= rounding_mm);
    }

    for (std::size_t i = 0; i + 1 < scene.points.size(); ++i)
      for (int k = 0; k <= 60; ++k) {
        const Vec2 a = plane_of(scene.points[i]), b = plane_of(scene.points[i + 1]);
        if (a == b) continue;
        const Vec2 p = a + (k / 60.0) * (b - a);
        if (!(to_page.w(p) > 1e-6)) continue;
        const Vec2 page = to_page(p);
        const double inside = std::min({page.x - frame.low.x, frame.high.x - page.x,
                                        page.y - frame.low.y, frame.high.y - page.y});
        CAPTURE(i, k, page.x, page.y);
        if (inside > rounding_mm) REQUIRE(to_strokes(page, layer) <= rounding_mm);
      }
    // Nothing between the points of a stroke that isn't on the polyline.
    for (const Stroke& stroke : layer.strokes) {
      const auto points = layer.points(stroke);
      for (std::size_t k = 0; k + 1 < points.size(); ++k) {
        const std::size_t at = stroke.first_point + k;
        const Nearness near = to_polyline(scene, 0.5 * (layer.map[at] + layer.map[at + 1]));
        REQUIRE(near.space <= 1e-10);
      }
    }
  }
  REQUIRE(strokes > enough(3000));
}

TEST_CASE("a polyline that comes in through a vertex on the frame goes on from there") {
  PlacedView scene;
  scene.settings.frame_mm = {{10, 10}, {190, 140}};
  for (const double x : {5.0, 10.0, 20.0, 190.0, 195.0, 190.0, 150.0})
    scene.points.push_back({{x, 50 + x, 1}, {x, 0, 0}});
  scene.settings.frame_mm.high.y = 300;
  scene.settings.simplify_mm = 0;
  const Layer layer = drawn(scene);
  REQUIRE(layer.strokes.size() == 2);
  CHECK(layer.points(layer.strokes[0]).front() == Vec2{10, 60});
  CHECK(layer.points(layer.strokes[0]).back() == Vec2{190, 240});
  CHECK(layer.points(layer.strokes[1]).front() == Vec2{190, 240});
  CHECK(layer.points(layer.strokes[1]).back() == Vec2{150, 200});
  CHECK(layer.map.empty());
}

TEST_CASE("strokes are simplified within the tolerance, and points counted before") {
  PlacedView scene;
  scene.settings.frame_mm = {{0, 0}, {300, 300}};
  scene.settings.simplify_mm = 0.02;
  for (int i = 0; i <= 100; ++i)
    scene.points.push_back({{1.0 * i, 50 + (i % 2) * 0.01, 1}, {1.0 * i, 0, 0}});
  Layer layer;
  StrokeBuilder builder(scene.settings, layer);
  for (int times = 0; times < 2; ++times) {
    builder.begin(-1, 0);
    for (const StrokePoint& p : scene.points) builder.add(p);
    builder.end();
  }
  REQUIRE(layer.strokes.size() == 2);
  CHECK(layer.strokes[1].point_count == 2);
  CHECK(layer.page_mm[2] == Vec2{0, 50});
}

TEST_CASE("strokes end at the front and back plane, and lines in a plane stay whole") {
  PlacedView scene;
  scene.settings.frame_mm = {{-1000, -1000}, {1000, 1000}};
  scene.settings.simplify_mm = 0;
  scene.settings.to_map = [](ProfilePoint p) { return Vec3{p.u, p.v, p.z}; };
  // The front plane at depth 2, the back plane at 12; they leave a 1e-9 of that more.
  constexpr double slack_m = 2e-8;
  scene.settings.depth = VolumeDepth{0, -0.1, 0, 0.2};
  for (const ProfilePoint& p : {ProfilePoint{0, 0, 1}, {1, 10, 2}, {1, 20, 3}, {2, 5, 0}})
    scene.points.push_back(seen(p, false));
  const Layer layer = drawn(scene);
  REQUIRE(layer.strokes.size() == 2);
  REQUIRE(layer.map.size() == 5);
  CHECK(length(layer.map[0] - Vec3{0.2, 2, 1.2}) <= slack_m);
  CHECK(layer.map[1] == Vec3{1, 10, 2});
  CHECK(length(layer.map[2] - Vec3{1, 12, 2.2}) <= slack_m);
  CHECK(length(layer.map[3] - Vec3{1 + 8 / 15., 12, 3 - 8 / 5.}) <= slack_m);
  CHECK(layer.map[4] == Vec3{2, 5, 0});

  scene.points.clear();
  for (int i = 0; i < 30; ++i) // to rounding in the front plane
    scene.points.push_back(seen({1.0 * i, 2 + (i % 2 ? 1e-12 : -1e-12), 0}, false));
  CHECK(drawn(scene).map.size() == 30);
}

TEST_CASE("points at one depth are drawn as one by one, to the bit") {
  std::size_t strokes = 0, points = 0;
  for (std::uint64_t seed = 1; seed <= last_seed(1000); ++seed) {
    Random random(seed);
    INFO("seed " << seed);
    StrokeSettings settings;
    settings.frame_mm = {{10, 10}, {190, 140}};
    settings.simplify_mm = random.pick({0.0, 0.02});
    settings.min_stroke_mm = random.pick({0.0, 30.0});
    if (random.chance(0.3)) settings.to_map = [](ProfilePoint p) { return Vec3{p.u, p.v, p.z}; };
    if (random.chance(0.2)) settings.depth = VolumeDepth{0.1, -0.1, 0, 0.2};
    const bool perspective = random.chance(0.6);
    // The shorter camera sees so wide that what is behind it would be in the frame as well.
    settings.to_page = perspective
                           ? camera(random.pick({0.3, -0.9, 0.0}), random.pick({150.0, 20.0}))
                           : Homography{{10, 0, 100, 0, -10, 70, 0, 0, 1}};
    const double depth_m = random.pick({4.0, -4.0}); // behind the eye
    const PointsAtDepth depth =
        perspective ? PointsAtDepth{depth_m < 0 ? -1. : 1., depth_m, 0, 1, -2, depth_m}
                    : PointsAtDepth{1, depth_m, 0.5, 0.9, 0.3 * depth_m, 1};
    // Far inside the frame, about its sides, on them, or nearly all outside.
    const double reach = random.pick({1.0, 5.0, 9.0, 40.0});
    const bool whole = random.chance(0.3);
    Layer one_by_one, at_once;
    StrokeBuilder first(settings, one_by_one), second(settings, at_once);
    for (int polyline = 0; polyline < 5; ++polyline) {
      std::vector<double> u, z;
      double at = random.between(-reach, reach);
      for (int i = random.pick({1, 3, 6, 127, 128, 129, 300, 700}); i > 0; --i) {
        at = std::clamp(at + random.between(-0.1, 0.1) * reach, -reach, reach);
        u.push_back(whole ? std::round(at) : at);
        z.push_back(whole ? std::round(random.between(-reach, reach)) : at + random.between(-1, 1));
      }
      first.begin(polyline, depth_m);
      second.begin(polyline, depth_m);
      for (std::size_t i = 0; i < u.size(); ++i) first.add(depth.at(u[i], z[i]));
      // In parts, some of them empty or of one point.
      for (std::size_t done = 0; done < u.size();) {
        const auto most = static_cast<int>(std::min<std::size_t>(u.size() - done, 400));
        const auto count = static_cast<std::size_t>(random.whole(0, most));
        second.add(depth, std::span(u).subspan(done, count), std::span(z).subspan(done, count));
        done += count;
      }
      first.end();
      second.end();
    }
    REQUIRE(one_by_one.strokes.size() == at_once.strokes.size());
    for (std::size_t i = 0; i < at_once.strokes.size(); ++i)
      REQUIRE(one_by_one.strokes[i].point_count == at_once.strokes[i].point_count);
    REQUIRE(one_by_one.page_mm == at_once.page_mm);
    REQUIRE(one_by_one.map == at_once.map);
    REQUIRE(first.left_out_mm() == second.left_out_mm());
    strokes += at_once.strokes.size();
    points += at_once.page_mm.size();
  }
  REQUIRE(strokes > enough(1000));
  REQUIRE(points > enough(100000));
}
