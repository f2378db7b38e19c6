// SPDX-License-Identifier: GPL-3.0-or-later
// Views that frame the terrain, by looking at every vertex, and along rays at the lower side.
#include "geometry/error.hpp"
#include "tests/catch.hpp"
#include "tests/support/random.hpp"
#include "tests/view/made_terrain.hpp"

#include <algorithm>
#include <limits>
#include <optional>

using namespace orograph;

namespace {

ViewRequest random_request(Random& random, const MadeTerrain& terrain) {
  ViewRequest request;
  const bool parallel = random.chance(0.4);
  request.projection = parallel ? Projection::orthographic : Projection::perspective;
  request.from_azimuth =
      Angle::degrees(random.chance(0.5) ? 45.0 * random.whole(0, 7) : random.between(0, 360));
  request.from_elevation =
      Angle::degrees(parallel ? random.pick({0.0, 90.0, random.between(0, 90)})
                              : random.pick({90.0, random.between(0, 60), random.between(0, 90)}));
  request.roll = Angle::degrees(random.pick({0.0, 0.0, 180.0, random.between(-180, 180)}));
  request.exaggeration = random.pick({1.0, 1.5});
  if (random.chance(0.3))
    request.look_at_m = terrain.vertices[static_cast<std::size_t>(
        random.whole(0, static_cast<int>(terrain.vertices.size()) - 1))];
  if (random.chance(0.3))
    request.distance_m = random.between(500, 5000);
  else
    request.field_of_view = Angle::degrees(random.pick({5.0, 30.0, random.between(1, 70)}));
  return request;
}

// The camera from the request alone; the distance is taken from the view.
Pinhole camera_of(const ViewRequest& request, const View& view) {
  const double e = request.from_elevation.in_radians(), a = request.from_azimuth.in_radians();
  const Vec3 to_viewer{std::cos(e) * std::sin(a), std::cos(e) * std::cos(a), std::sin(e)};
  const Vec3 target = exaggerated(view.look_at_m, request.exaggeration);
  const bool parallel = request.projection == Projection::orthographic;
  // A parallel picture is measured from the target's ground point at height 0.
  const Vec3 eye = parallel ? Vec3{target.x, target.y, 0} : target + view.distance_m * to_viewer;
  // From straight above, up is where the viewer would look from a little less high.
  const Vec3 upward = e < 1.57 ? Vec3{0, 0, 1} : Vec3{-std::sin(a), -std::cos(a), 0};
  Pinhole camera = pinhole(eye, -1.0 * to_viewer, request.roll.in_degrees(), upward);
  camera.parallel = parallel;
  return camera;
}

// In the visibility plane from the definition: the terrain is entered where a ray at X crosses the
// outline for the first, third, ... time. Gives the lowest picture Y of these, seen just beside
// every outline vertex, where it is lowest.
double lowest_entered(const View& view, const MadeTerrain& terrain) {
  const bool parallel = !view.is_perspective();
  double lowest = std::numeric_limits<double>::infinity();
  const auto x_of = [&](const ProfilePoint& p) { return parallel ? p.u : p.u / p.v; };
  std::vector<std::pair<ProfilePoint, ProfilePoint>> edges;
  double left = lowest, right = -lowest;
  for (const auto& [from, to] : terrain.outline) {
    edges.emplace_back(to_profile_frame(view, from), to_profile_frame(view, to));
    left = std::min(left, x_of(edges.back().first));
    right = std::max(right, x_of(edges.back().first));
  }
  for (const auto& edge : edges)
    for (const double side : {-1e-7, 1e-7}) {
      const double x = x_of(edge.first) + side * (right - left);
      std::vector<std::pair<double, ProfilePoint>> met;
      for (const auto& [a, b] : edges) {
        // u - x v (u - x in a parallel view) changes its sign along an edge that is met.
        const double at_a = a.u - x * (parallel ? 1 : a.v), at_b = b.u - x * (parallel ? 1 : b.v);
        if ((at_a < 0) == (at_b < 0)) continue;
        const double t = at_a / (at_a - at_b);
        const ProfilePoint p{a.u + t * (b.u - a.u), a.v + t * (b.v - a.v), a.z + t * (b.z - a.z)};
        met.emplace_back(p.v, p);
      }
      std::sort(met.begin(), met.end(),
                [](const auto& p, const auto& q) { return p.first < q.first; });
      for (std::size_t i = 0; i < met.size(); i += 2)
        lowest = std::min(lowest, view.to_picture(project(view, met[i].second)).y);
    }
  return lowest;
}

std::optional<View> placed(const ViewRequest& request, const MadeTerrain& terrain,
                           std::string& refusal) {
  try {
    return place_view(request, terrain.shape(), 0.7);
  } catch (const Error& error) {
    refusal = error.what();
    return std::nullopt;
  }
}

} // namespace

TEST_CASE("a framing window is the picture's box, but for ground below the near edge") {
  int framed = 0, beside = 0;
  for (std::uint64_t seed = 1; seed <= last_seed(1000); ++seed) {
    Random random(seed);
    INFO("seed " << seed);
    const MadeTerrain terrain =
        made_terrain(random, random.pick({3, 12, 12, 70}), random.pick({0.0, 0.0, 0.2}));
    const ViewRequest request = random_request(random, terrain);
    CAPTURE(request.from_azimuth.in_degrees(), request.from_elevation.in_degrees(),
            request.roll.in_degrees());
    std::string refusal;
    const auto view = placed(request, terrain, refusal);
    if (!view) {
      REQUIRE(refusal.find("beside or behind the eye") != std::string::npos);
      continue;
    }
    ++framed;
    REQUIRE(view->frames_terrain);
    const Pinhole camera = camera_of(request, *view);
    Box2 box;
    const double near_m = kNearShareOfCell * cell_size_m(*terrain.grid);
    bool all_ahead = true;
    for (const Vec3& p : terrain.vertices) {
      if (!camera.parallel) REQUIRE(camera.along(exaggerated(p, request.exaggeration)) > 0);
      all_ahead = all_ahead && (camera.parallel || to_profile_frame(*view, p).v >= near_m);
      box.include(camera.picture(exaggerated(p, request.exaggeration)));
    }
    const Box2& window = view->window;
    // A picture is right to some ten roundings of the numbers that it comes from: metres in a
    // parallel view; otherwise, up to about 60 degrees, 1 and heights over near depths.
    const double tolerance = camera.parallel ? 1e-11 : 1e-12 * std::max(1.0, largest(box.high));
    CAPTURE(box.low.x, window.low.x, box.high.x, window.high.x);
    REQUIRE(std::abs(window.low.x - box.low.x) <= tolerance);
    REQUIRE(std::abs(window.high.x - box.high.x) <= tolerance);
    REQUIRE(std::abs(window.high.y - box.high.y) <= tolerance);
    CAPTURE(box.low.y, window.low.y, window.high.y);
    if (request.roll == Angle() && all_ahead) {
      REQUIRE(window.low.y >= box.low.y - tolerance);
      const double lowest = lowest_entered(*view, terrain);
      CAPTURE(lowest);
      REQUIRE(window.low.y <= lowest + tolerance);
      REQUIRE(lowest - window.low.y <= 1e-4 * window.height()); // seen 1e-7 beside the vertices
    } else {
      REQUIRE(std::abs(window.low.y - box.low.y) <= tolerance);
    }
    if (!camera.parallel && !request.distance_m) {
      const double wanted = 2 * std::tan(0.5 * request.field_of_view->in_radians());
      // The eye doesn't go nearer to a target at the terrain's edge than half a cell.
      if (view->distance_m > 0.5 * cell_size_m(*terrain.grid)) {
        const double longer = std::max(box.width(), box.height()); // with what can't be seen
        const bool by_width = std::abs(window.width() - wanted) <= 1e-8 * wanted;
        CAPTURE(wanted, window.width(), longer, all_ahead);
        REQUIRE(((by_width && all_ahead) || std::abs(longer - wanted) <= 1e-8 * wanted));
        beside += all_ahead ? 0 : 1;
      } else {
        REQUIRE(window.width() < wanted);
      }
    }
    if (request.distance_m && !camera.parallel) REQUIRE(view->distance_m == *request.distance_m);
  }
  REQUIRE(framed > enough(700));
  REQUIRE(beside > enough(20));
}

TEST_CASE(
    "perspective is refused only where a given distance has ground behind the picture plane") {
  int refused = 0, steep = 0;
  for (std::uint64_t seed = 1; seed <= last_seed(400); ++seed) {
    Random random(seed);
    INFO("seed " << seed);
    const MadeTerrain terrain = made_terrain(random, 12);
    ViewRequest request = random_request(random, terrain);
    request.projection = Projection::perspective;
    request.from_elevation = Angle::degrees(random.pick({90.0, random.between(0, 90)}));
    if (request.distance_m) request.distance_m = random.between(20, 300);
    std::string text;
    const auto view = placed(request, terrain, text);
    if (!request.distance_m) REQUIRE(view);
    // The camera at the distance, to see what is behind it.
    View at_distance;
    at_distance.distance_m = request.distance_m.value_or(0);
    const Vec3 centre = terrain.extent.box.centre();
    at_distance.look_at_m =
        request.look_at_m.value_or(Vec3{centre.x, centre.y, terrain.extent.mean_height_m});
    const Pinhole camera = camera_of(request, view ? *view : at_distance);
    double nearest = std::numeric_limits<double>::infinity();
    for (const Vec3& p : terrain.vertices)
      nearest = std::min(nearest, camera.along(exaggerated(p, request.exaggeration)));
    CAPTURE(nearest, text);
    if (view) {
      REQUIRE(nearest > 0);
      steep += view->window.height() > 0 && nearest > 0 && request.from_elevation.in_degrees() > 80;
      continue;
    }
    ++refused;
    REQUIRE(nearest <= 1e-9);
    REQUIRE(text.find("`distance_m`") != std::string::npos);
  }
  CHECK(refused > enough(10));
  CHECK(steep > enough(100));
}
