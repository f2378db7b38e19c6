// SPDX-License-Identifier: GPL-3.0-or-later
// A panorama's strokes against the places that azimuths and altitudes give points of lines, in long
// double and by no formula of the builder's.
#include "draw/stroke_builder.hpp"
#include "tests/catch.hpp"
#include "tests/draw/to_segment.hpp"
#include "tests/support/random.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

using namespace orograph;

namespace {

// Every so often beside a seam, under the eye or straight ahead.
ProfilePoint made_point(Random& random, double eye_z) {
  const double away = std::pow(10, random.between(0, 4.5));
  const double azimuth = random.chance(0.2) ? random.pick({0.0, 90.0, 180.0, -180.0, -90.0})
                                            : random.between(-180, 180);
  const double radians = azimuth * std::numbers::pi / 180;
  return {away * std::sin(radians), away * std::cos(radians),
          eye_z + away * random.between(-0.8, 0.4)};
}

Vec2 by_definition(const PanoramaPage& page, ProfilePoint p) {
  const long double u = p.u, v = p.v, up = static_cast<long double>(p.z) - page.eye_z_m;
  const long double altitude = std::atan2(up, std::hypot(u, v));
  const long double height = page.kind == PanoramaKind::cylindrical ? std::tan(altitude) : altitude;
  return {static_cast<double>(page.ahead_mm.x + page.radius_mm * std::atan2(u, v)),
          static_cast<double>(page.ahead_mm.y - page.radius_mm * height)};
}

double distance_mm(const Layer& layer, Vec2 p) {
  double least = std::numeric_limits<double>::infinity();
  for (const Stroke& stroke : layer.strokes) {
    const auto points = layer.points(stroke);
    for (std::size_t i = 1; i < points.size(); ++i)
      if (std::min(points[i - 1].x, points[i].x) <= p.x + 1 &&
          std::max(points[i - 1].x, points[i].x) >= p.x - 1)
        least = std::min(least, to_segment(p, points[i - 1], points[i]));
  }
  return least;
}

} // namespace

TEST_CASE("a panorama's strokes lie where azimuths and altitudes put their lines") {
  Random random(39);
  std::uint64_t asked = 0, crossed = 0, outside = 0;
  double worst_mm = 0;
  for (int round = 0; round < rounds(400); ++round) {
    StrokeSettings settings;
    const double eye_z = random.between(0, 3000), radius_mm = random.between(20, 300);
    settings.panorama =
        PanoramaPage{random.pick({PanoramaKind::cylindrical, PanoramaKind::equirectangular}),
                     radius_mm,
                     {10 + radius_mm * std::numbers::pi, 80},
                     eye_z};
    const double half = random.chance(0.5) ? std::numbers::pi : random.between(0.1, 3);
    const Vec2 ahead = settings.panorama->ahead_mm;
    settings.frame_mm = {
        {ahead.x - radius_mm * half, ahead.y - random.between(0.1, 0.5) * radius_mm},
        {ahead.x + radius_mm * half, ahead.y + random.between(0.1, 1) * radius_mm}};
    const bool simplifies = random.chance(0.3);
    settings.simplify_mm = simplifies ? 0.02 : 0;
    settings.bend_mm = simplifies ? 2e-5 : 5e-7;
    // The bend is lost once more where what was bent is simplified; and rounding.
    const double bound_mm = simplifies ? 0.02 + 2e-5 + 1e-9 : 1e-6;
    Layer layer;
    StrokeBuilder builder(settings, layer);
    std::vector<ProfilePoint> line;
    const int count = random.whole(2, 5);
    for (int i = 0; i < count; ++i) line.push_back(made_point(random, eye_z));
    builder.begin(-1, 0);
    for (const ProfilePoint& p : line) builder.add({{}, p});
    builder.end();
    for (std::size_t i = 1; i < line.size(); ++i)
      crossed += seam_crossing(line[i - 1], line[i]) ? 1 : 0;
    for (const Stroke& stroke : layer.strokes)
      for (const Vec2 p : layer.points(stroke))
        outside += p.x < settings.frame_mm.low.x || p.x > settings.frame_mm.high.x ||
                           p.y < settings.frame_mm.low.y || p.y > settings.frame_mm.high.y
                       ? 1
                       : 0;
    for (int k = 0; k < 250; ++k) {
      const auto i = static_cast<std::size_t>(random.whole(1, count - 1));
      const Vec2 p =
          by_definition(*settings.panorama, point_between(line[i - 1], line[i], random.share()));
      const Box2& frame = settings.frame_mm;
      // Just at the frame it is cut, and there a simplified line may be elsewhere.
      constexpr double kAtFrame_mm = 0.1;
      if (!(p.x > frame.low.x + kAtFrame_mm && p.x < frame.high.x - kAtFrame_mm &&
            p.y > frame.low.y + kAtFrame_mm && p.y < frame.high.y - kAtFrame_mm))
        continue;
      ++asked;
      const double away_mm = distance_mm(layer, p);
      if (!(away_mm <= bound_mm)) {
        INFO("round " << round << ", " << p.x << " " << p.y);
        REQUIRE(away_mm <= bound_mm);
      }
      if (!simplifies) worst_mm = std::max(worst_mm, away_mm);
    }
  }
  CHECK(outside == 0);
  CHECK(asked >= enough(20000));
  CHECK(crossed >= enough(50));
  CHECK(worst_mm <= 1e-6);
}

TEST_CASE("a small step on a panorama's page is as long as by differences") {
  Random random(40);
  for (int round = 0; round < rounds(2000); ++round) {
    const PanoramaPage page{random.pick({PanoramaKind::cylindrical, PanoramaKind::equirectangular}),
                            random.between(20, 300),
                            {500, 100},
                            random.between(0, 3000)};
    ProfilePoint p = made_point(random, page.eye_z_m);
    p.v = std::abs(p.v); // not across the seam
    const double away = std::hypot(p.u, p.v), h = 1e-6 * away;
    const Vec3 step{random.between(-1, 1), random.between(-1, 1), random.between(-1, 1)};
    const Vec2 a = page({p.u - h * step.x, p.v - h * step.y, p.z - h * step.z}),
               b = page({p.u + h * step.x, p.v + h * step.y, p.z + h * step.z});
    // Differences of six digits' length lose as many, and third derivatives.
    CHECK(page.mm_per_step(p, step) * 2 * h == Approx(length(b - a)).epsilon(1e-6).margin(1e-9));
  }
}
