// SPDX-License-Identifier: GPL-3.0-or-later
// ACTUAL to OBSERVED: by definition, and against the numbers of figure 9.1d (Angell and Jones
// 1983), whose triad looks along +z and so is left-handed where ours is right-handed.
#include "tests/support/random.hpp"
#include "tests/view/matrices.hpp"
#include "tests/view/random_phigs_view.hpp"
#include "view/pipeline.hpp"

#include <Eigen/LU>

#include <limits>

using namespace orograph;

namespace {

// Figure 9.1d: eye (-2, 2, 2), looked at (-1, 0, 0), y vertical.
Eigen::Matrix4d figure_9_1d() {
  Eigen::Matrix4d q;
  q << -.894427191, 0, -.4472135955, -.894427191,       //
      .298142397, .7453559925, -.596284794, .298142397, //
      1.0 / 3, -2.0 / 3, -2.0 / 3, 10.0 / 3,            //
      0, 0, 0, 1;
  return q;
}

double largest_difference(const Eigen::Matrix4d& a, const Eigen::Matrix4d& b) {
  return (a - b).cwiseAbs().maxCoeff();
}

// Turns a left-handed triad that looks along +z into ours.
const Eigen::Matrix4d kMirror = scaling({-1, 1, -1});

} // namespace

TEST_CASE("Q of figure 9.1d, mirrored, is the view from its eye") {
  const Vec3 eye{-2, 2, 2}, target{-1, 0, 0};
  const Eigen::Matrix4d q = view_orientation(eye, eye - target, {0, 1, 0});
  CHECK(largest_difference(kMirror * q, figure_9_1d()) < 1e-9); // printed with ten digits

  // look_at's vertical is z: the figure's (x, y, z) are its (y, z, x).
  Eigen::Matrix4d renamed;
  renamed << 0, 0, 1, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 1;
  const Eigen::Matrix4d looked = look_at({2, -2, 2}, {0, -1, 0}, Angle());
  CHECK(largest_difference(looked * renamed, q) < 1e-15);
}

TEST_CASE("Q of figure 9.1d as the five steps of its source") {
  // Eye from target (-1, 2, 2): D, E by -atan2(2, -1) about z, F by 180 - theta about y, H by beta
  // about z, G. What a vertical becomes after F gives beta.
  const Vec3 eye{-2, 2, 2}, target{-1, 0, 0}, f = eye - target;
  const double r = std::hypot(f.x, f.y), s = length(f);
  const Eigen::Matrix4d k =
      model_transform({translation(-1 * target), rotation({0, 0, 1}, -atan2_angle(f.y, f.x)),
                       rotation({0, 1, 0}, Angle::degrees(180) + -atan2_angle(r, f.z))});
  CHECK(distance(moved(k, eye), {0, 0, -s}) < 1e-15);
  const Vec3 vertical = turned(k, {0, 1, 0});
  const Eigen::Matrix4d q = model_transform(
      {k, rotation({0, 0, 1}, atan2_angle(vertical.x, vertical.y)), translation({0, 0, s})});
  CHECK(largest_difference(q, figure_9_1d()) < 1e-9);
}

TEST_CASE("view reference coordinates are right-handed") {
  // The viewer stands in the south and looks north: n points south.
  const Eigen::Matrix4d north = view_orientation({0, -10, 3}, {0, -5, 0}, {0, 0.2, 2});
  CHECK(moved(north, {1, -10, 3}) == Vec3{1, 0, 0}); // east is on the right
  CHECK(moved(north, {0, -10, 4}) == Vec3{0, 1, 0}); // up is up
  CHECK(moved(north, {0, -9, 3}) == Vec3{0, 0, -1}); // north is away
  for (std::uint64_t seed = 1; seed <= last_seed(1000); ++seed) {
    Random random(seed);
    INFO("seed " << seed);
    const Vec3 vrp = random_point(random, 1000), vpn = random_direction(random),
               vup = random_aside(random, vpn);
    const Eigen::Matrix4d m = view_orientation(vrp, vpn, vup);
    REQUIRE(distance(moved(m, vrp), {0, 0, 0}) < 1e-12);
    REQUIRE(distance(moved(m, vrp + vpn), {0, 0, length(vpn)}) < 1e-12);
    const Vec3 up = turned(m, vup);
    REQUIRE(std::abs(up.x) < 1e-13 * length(vup));
    REQUIRE(up.y > 0);
    const Eigen::Matrix3d turn = m.topLeftCorner<3, 3>();
    REQUIRE((turn * turn.transpose() - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff() < 1e-14);
    REQUIRE(std::abs(turn.determinant() - 1) < 1e-14);
  }
}

TEST_CASE("view reference coordinates stay rectangular where VUP is nearly parallel to VPN") {
  const Vec3 vpn{0.3, -0.5, 0.7};
  for (const double aside : {1e-3, 1e-6, 1e-8}) {
    const Eigen::Matrix3d turn =
        view_orientation({}, vpn, vpn + aside * Vec3{0.9, 0.1, 0.2}).topLeftCorner<3, 3>();
    CHECK((turn * turn.transpose() - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff() < 1e-15);
    CHECK(std::abs(turn.determinant() - 1) < 1e-15);
  }
  check_refused([&] { view_orientation({}, vpn, vpn + 1e-10 * Vec3{0.9, 0.1, 0.2}); }, "parallel");
}

TEST_CASE("looking at a point keeps it on the axis and verticals vertical") {
  for (std::uint64_t seed = 1; seed <= last_seed(1000); ++seed) {
    Random random(seed);
    INFO("seed " << seed);
    const Vec3 eye = random_point(random, 100), backwards = random_aside(random, {0, 0, 1});
    const Vec3 target = eye - backwards;
    const double distance_m = length(backwards);
    const Eigen::Matrix4d m = look_at(eye, target, Angle());
    REQUIRE(distance(moved(m, eye), {0, 0, 0}) < 1e-13);
    for (const double share : {0.25, 1.0, 30.0}) // straight in front of the eye
      REQUIRE(distance(moved(m, eye - share * backwards), {0, 0, -share * distance_m}) <
              1e-11 + 1e-13 * share * distance_m);
    const Vec3 up = turned(m, {0, 0, 1});
    REQUIRE(std::abs(up.x) < 1e-15);
    REQUIRE(up.y > 0);
    REQUIRE(std::abs(m.determinant() - 1) < 1e-14);

    // Rolled, the picture has turned clockwise: what was up points right for 0 to 180 degrees.
    const double degrees = random.between(1, 179);
    const Vec3 rolled = turned(look_at(eye, target, Angle::degrees(degrees)), {0, 0, 1});
    REQUIRE(rolled.x > 0);
    REQUIRE(std::abs(std::atan2(rolled.x, rolled.y) - degrees / 180 * M_PI) < 1e-12);
  }
}

TEST_CASE("view orientations that are none are refused") {
  const double nan = std::numeric_limits<double>::quiet_NaN(),
               infinity = std::numeric_limits<double>::infinity();
  check_refused([] { view_orientation({}, {0, 0, 0}, {0, 0, 1}); }, "(VPN) has length 0");
  check_refused([] { view_orientation({}, {0, 0, 1}, {0, 0, 0}); }, "(VUP) has length 0");
  check_refused([] { view_orientation({}, {1, 2, 3}, {2, 4, 6}); }, "(VPN) is parallel to the");
  check_refused([] { view_orientation({}, {1, 2, 3}, {-1, -2, -3}); }, "(VPN) is parallel to the");
  check_refused([&] { view_orientation({nan, 0, 0}, {0, 1, 0}, {0, 0, 1}); }, "(VRP) is not a");
  check_refused([&] { view_orientation({}, {0, infinity, 0}, {0, 0, 1}); }, "(VPN) is not a");
  check_refused([&] { view_orientation({}, {0, 1, 0}, {0, 0, nan}); }, "(VUP) is not a");
  check_refused([] { look_at({1, 2, 3}, {1, 2, 3}, Angle()); }, "coincide");
  check_refused([] { look_at({1, 2, 3}, {1, 2, 1}, Angle()); }, "straight above or below");
  check_refused([&] { look_at({1, 2, nan}, {1, 2, 1}, Angle()); }, "the eye is not a");
  check_refused([&] { look_at({}, {infinity, 0, 0}, Angle()); }, "the look-at point is not a");
  check_refused([&] { look_at({}, {1, 0, 0}, Angle::degrees(nan)); }, "the roll is not a");
  CHECK_NOTHROW(view_orientation({}, {0, -1e-200, 0}, {0, 0, 1e200})); // of any length
}
