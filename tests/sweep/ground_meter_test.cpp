// SPDX-License-Identifier: GPL-3.0-or-later
// How much of the ground a picture shows: closed forms, and a line of sight from every place.
#include "geometry/vec.hpp"
#include "tests/catch.hpp"
#include "tests/support/random.hpp"
#include "tests/sweep/made_sweep.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

using namespace orograph;

namespace {

constexpr double kDegree = 3.14159265358979323846 / 180;

// The rows of a sweep with many profiles and true heights.
nlohmann::json rows_of(const MadeFolder& folder, const Words& arguments) {
  run_well(folder,
           Words{"sweep"} + Words{arguments.front(), "out"} +
               Words(arguments.begin() + 1, arguments.end()) +
               words("-q --overwrite --no-seconds --layers profiles --flat draw --detail file"));
  return nlohmann::json::parse(folder.read("out/sweep.json"))["views"];
}

double share_of(const nlohmann::json& row) {
  return row["visible_share"].get<double>();
}

// 24 x 24 vertices from 5 to 235.
void write_plane(const MadeFolder& folder, const HeightOf& height_m) {
  folder.write("plane.asc", ascii_grid(24, 24, height_m));
}

const Words kTrue = words("plane.asc --exaggeration 1 --curvature off --page 80x80 --margin 2 "
                          "--profiles 400");

} // namespace

TEST_CASE("from above everything is seen") {
  const MadeFolder folder;
  Random random(20);
  write_plane(folder, [&](int, int) { return random.between(0, 5); });
  for (const auto& row : rows_of(folder, kTrue + words("--azimuth 0,33 --elevation 90")))
    CHECK(std::abs(share_of(row) - 1) < 1e-6);
  write_plane(folder, [](int, int) { return 7.0; });
  for (const auto& row : rows_of(folder, kTrue + words("--azimuth 0,33,90 --elevation 2,40,90")))
    CHECK(std::abs(share_of(row) - 1) < 1e-6);
}

TEST_CASE("behind a ridge lies its shadow") {
  const MadeFolder folder;
  constexpr double kTop = 20, kCrest = 125, kFoot = 20, kSouth = 5, kNorth = 235;
  // Row 11 from the north is at y = 125.
  write_plane(folder, [&](int, int row) {
    return std::max(0.0, kTop * (1 - std::abs(235 - 10.0 * row - kCrest) / kFoot));
  });
  const auto shown = [&](double shadow_end) { // the far slope is hidden as well
    return 1 - (std::min(shadow_end, kNorth) - kCrest) / (kNorth - kSouth);
  };
  const auto rows = rows_of(folder, kTrue + words("--projection orthographic --elevation 5:40:5"));
  REQUIRE(rows.size() == 8);
  for (const auto& row : rows) {
    const double elevation = row["elevation_deg"].get<double>();
    INFO("from " << elevation << " degrees");
    CHECK(std::abs(share_of(row) - shown(kCrest + kTop / std::tan(elevation * kDegree))) < 0.005);
  }
  // Far enough away for the frame to hold all of the ground.
  folder.write("eyes.csv", "id,WKT\n1,\"LINESTRING Z(120 -300 60,120 -300.5 90,120 -301 150)\"\n");
  for (const auto& row :
       rows_of(folder, kTrue + words("--eye-path eyes.csv --look-at 120,120 --fov 80"))) {
    const double y = row["eye_y"].get<double>(), z = row["eye_z"].get<double>();
    INFO("from a height of " << z);
    CHECK(std::abs(share_of(row) - shown(kCrest + kTop * (kCrest - y) / (z - kTop))) < 0.005);
  }
}

TEST_CASE("what is outside of the frame isn't seen") {
  const MadeFolder folder;
  write_plane(folder, [](int, int) { return 7.0; });
  // The frame's right or left edge stands on the middle of the ground.
  folder.write("eye.csv", "id,WKT\n1,\"LINESTRING Z(120 -300 107,120 -299 107)\"\n");
  for (const auto& row : rows_of(folder, kTrue + words("--eye-path eye.csv --fov 60 --look-azimuth "
                                                       "-30,30"))) {
    INFO(row["name"]);
    CHECK(std::abs(share_of(row) - 0.5) < 0.005);
  }
  // In its midst, 40 m up, looking level: a quarter turn, from where the frame's lower edge meets
  // the ground on. Profiles cut what is ahead from there.
  folder.write("midst.csv", "id,WKT\n1,\"LINESTRING Z(120 120 47,120 121 47)\"\n");
  const auto midst =
      rows_of(folder, kTrue + words("--eye-path midst.csv --fov 90 --look-azimuth 0 --pitch 0"));
  CHECK(std::abs(share_of(midst[0]) - (115.0 * 115 - 40.0 * 40) / (230 * (115 - 40))) < 0.01);
}

TEST_CASE("the share is what a line of sight from every place finds") {
  const MadeFolder folder;
  Random random(21);
  constexpr int kSize = 12;
  std::vector<double> heights(kSize * kSize);
  // On the triangles, north-west corner at (5, 115), cells of 10 m; split from north-west to
  // south-east.
  const auto ground = [&](double x, double y) {
    const double column = (x - 5) / 10, row = (115 - y) / 10;
    const int c = std::clamp(static_cast<int>(column), 0, kSize - 2),
              r = std::clamp(static_cast<int>(row), 0, kSize - 2);
    const double s = column - c, t = row - r;
    const auto at = [&](int dc, int dr) {
      return heights[static_cast<std::size_t>((r + dr) * kSize + c + dc)];
    };
    return s > t ? at(0, 0) + s * (at(1, 0) - at(0, 0)) + t * (at(1, 1) - at(1, 0))
                 : at(0, 0) + t * (at(0, 1) - at(0, 0)) + s * (at(1, 1) - at(0, 1));
  };
  // Towards the eye, in steps of less than a metre.
  const auto seen = [&](Vec3 from, Vec3 to_eye) {
    constexpr double kStep_m = 0.7, kTouch_m = 1e-6;
    const Vec3 step = kStep_m / std::hypot(to_eye.x, to_eye.y) * to_eye;
    for (Vec3 p = from + 0.01 * step; p.x > 5 && p.x < 115 && p.y > 5 && p.y < 115; p = p + step)
      if (ground(p.x, p.y) > p.z + kTouch_m) return false;
    return true;
  };
  for (int i = 0; i < 3; ++i) {
    for (double& height : heights) height = random.whole(0, 25);
    folder.write("plane.asc", ascii_grid(kSize, kSize, [&](int column, int row) {
                   return heights[static_cast<std::size_t>(row * kSize + column)];
                 }));
    for (const bool parallel : {false, true}) {
      const auto rows =
          rows_of(folder, kTrue + words("--azimuth 200,310 --elevation 12,30") +
                              words(parallel ? "--projection orthographic" : "--fov 40"));
      for (const auto& row : rows) {
        const double a = row["azimuth_deg"].get<double>() * kDegree,
                     e = row["elevation_deg"].get<double>() * kDegree;
        const Vec3 aside{std::sin(a) * std::cos(e), std::cos(a) * std::cos(e), std::sin(e)};
        int asked = 0, found = 0;
        for (double x = 5.6; x < 115; x += 1.1)
          for (double y = 5.6; y < 115; y += 1.1) {
            const Vec3 from{x, y, ground(x, y)};
            const Vec3 to_eye = parallel
                                    ? aside
                                    : Vec3{row["eye_x"].get<double>(), row["eye_y"].get<double>(),
                                           row["eye_z"].get<double>()} -
                                          from;
            ++asked;
            found += seen(from, to_eye);
          }
        INFO(row["name"] << (parallel ? ", parallel" : ", in perspective"));
        CHECK(std::abs(share_of(row) - static_cast<double>(found) / asked) < 0.012);
      }
    }
  }
}

TEST_CASE("the visible length is that of the lines drawn") {
  const MadeFolder folder;
  make_terrains(folder);
  folder.write("eyes.csv", "id,WKT\n1,\"LINESTRING(120 50,60 60,120 100)\"\n");
  const Words whole =
      words("hill.asc --simplify 0 --join 0 --min-stroke 0 --page 100x80 --margin 3 --profiles 60 "
            "--light off"); // joints of lines of several widths are rounded as well
  for (const Words& views :
       {words("--azimuth 0:300:60 --elevation 8,45,90"), words("--projection orthographic"),
        words("--eye-path eyes.csv --eye-height 40 --look-azimuth 10,200 --fov 70,150 --pitch -50"),
        words("--occluder profiles --azimuth 40")}) {
    for (const auto& row : rows_of(folder, whole + views)) {
      const std::string name = row["name"];
      const double points = row["points"].get<double>(),
                   visible_mm = row["visible_mm"].get<double>();
      INFO(name);
      // Every point is rounded to 1e-4 mm.
      CHECK(visible_mm > 10);
      CHECK(std::abs(visible_mm - row["pen_down_mm"].get<double>()) < 1e-4 * points);
    }
  }
}
