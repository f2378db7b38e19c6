// SPDX-License-Identifier: GPL-3.0-or-later
// SETUP to ACTUAL, against the numbers of example 9.1 (Angell and Jones 1983) and definitions.
#include "tests/support/random.hpp"
#include "tests/view/matrices.hpp"
#include "tests/view/random_phigs_view.hpp"
#include "view/pipeline.hpp"

#include <Eigen/LU>

#include <limits>

using namespace orograph;

namespace {

const Angle kAlpha = atan2_angle(-4, 3); // cosine 3/5, sine -4/5

Eigen::Matrix4d example_9_1() {
  return model_transform(
      {rotation({0, 0, 1}, kAlpha), translation({-1, 0, 0}), rotation({0, 1, 0}, -kAlpha)});
}

} // namespace

TEST_CASE("example 9.1: the cube's eight vertices, integers over 25") {
  const Vec3 setup[8] = {{1, 1, 1},  {1, 1, -1},  {1, -1, -1},  {1, -1, 1},
                         {-1, 1, 1}, {-1, 1, -1}, {-1, -1, -1}, {-1, -1, 1}};
  const int actual[8][3] = {{26, -5, 7}, {-14, -5, -23}, {-38, -35, 9}, {2, -35, 39},
                            {8, 35, 31}, {-32, 35, 1},   {-56, 5, 33},  {-16, 5, 63}};
  const Eigen::Matrix4d p = example_9_1();
  for (int i = 0; i < 8; ++i) {
    INFO("vertex " << i + 1);
    const Vec3 found = 25 * moved(p, setup[i]);
    CHECK(distance(found, {double(actual[i][0]), double(actual[i][1]), double(actual[i][2])}) <
          1e-13);
  }
  Eigen::Matrix4d expected;
  expected << 9, 12, 20, -15, -20, 15, 0, 0, -12, -16, 15, 20, 0, 0, 0, 25;
  CHECK((25 * p - expected).cwiseAbs().maxCoeff() < 1e-13);
}

TEST_CASE("a rotation turns about its axis, right-handed") {
  CHECK(moved(rotation({0, 0, 7}, Angle::degrees(90)), {1, 0, 5}) == Vec3{0, 1, 5});
  CHECK(moved(rotation({3, 0, 0}, Angle::degrees(90)), {5, 1, 0}) == Vec3{5, 0, 1});
  CHECK(moved(rotation({0, 1, 0}, Angle::degrees(90)), {0, 5, 1}) == Vec3{1, 5, 0});
  CHECK(moved(rotation({0, 0, -1}, Angle::degrees(-270)), {1, 0, 5}) == Vec3{0, -1, 5});
  for (std::uint64_t seed = 1; seed <= last_seed(1000); ++seed) {
    Random random(seed);
    INFO("seed " << seed);
    const Vec3 axis = random_direction(random), p = random_aside(random, axis);
    const double degrees = random.between(-180, 180);
    const Eigen::Matrix4d r = rotation(axis, Angle::degrees(degrees));
    REQUIRE(distance(moved(r, axis), axis) < 1e-14 * length(axis));
    // About the axis, p turns by the angle: measured between its parts at right angles to it.
    const Vec3 unit = (1 / length(axis)) * axis, q = moved(r, p);
    const Vec3 from = p - dot(p, unit) * unit, to = q - dot(q, unit) * unit;
    const double square = dot(from, from);
    REQUIRE(std::abs(dot(p, unit) - dot(q, unit)) < 1e-13 * length(p));
    REQUIRE(std::abs(dot(from, to) / square - std::cos(degrees / 180 * M_PI)) < 1e-11);
    REQUIRE(std::abs(dot(cross(from, to), unit) / square - std::sin(degrees / 180 * M_PI)) < 1e-11);
  }
}

TEST_CASE("translation, scaling and shear") {
  CHECK(moved(translation({1, 2, 3}), {10, 20, 30}) == Vec3{11, 22, 33});
  CHECK(moved(scaling({1, 2, -3}), {10, 20, 30}) == Vec3{10, 40, -90});
  CHECK(moved(shear_along_z(2, -3), {10, 20, 30}) == Vec3{70, -70, 30});
  CHECK(moved(shear_along_z(2, -3), {10, 20, 0}) == Vec3{10, 20, 0});
}

TEST_CASE("a model transform is its stages, one after the other") {
  CHECK(model_transform({}) == Eigen::Matrix4d::Identity());
  for (std::uint64_t seed = 1; seed <= last_seed(1000); ++seed) {
    Random random(seed);
    INFO("seed " << seed);
    const Eigen::Matrix4d first = rotation(random_direction(random),
                                           Angle::degrees(random.between(-180, 180))),
                          second = translation(random_point(random, 5)),
                          third = scaling({random.between(0.5, 2), random.between(-2, -0.5), 1}),
                          fourth = shear_along_z(random.between(-2, 2), random.between(-2, 2));
    const Vec3 p = random_point(random, 5);
    const Vec3 expected = moved(fourth, moved(third, moved(second, moved(first, p))));
    REQUIRE(distance(moved(model_transform({first, second, third, fourth}), p), expected) <
            1e-12 * (1 + length(expected)));
  }
}

TEST_CASE("model transforms that are none are refused") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto refused = [](std::initializer_list<Eigen::Matrix4d> stages, const char* words) {
    check_refused([&] { model_transform(stages); }, words);
  };
  const Eigen::Matrix4d tilt = rotation({1, 2, 3}, Angle::degrees(37));
  refused({scaling({1, 0, 1})}, "singular");
  refused({tilt, scaling({1, 1, 0}), tilt}, "singular");
  refused({scaling({0, 0, 0})}, "singular");
  refused({translation({nan, 0, 0})}, "not finite");
  refused({scaling({1e200, 1, 1}), scaling({1e200, 1, 1})}, "not finite");
  Eigen::Matrix4d projective = Eigen::Matrix4d::Identity();
  projective(3, 2) = -1;
  refused({projective}, "not affine");
  Eigen::Matrix4d folded = Eigen::Matrix4d::Identity(); // the three axes in one plane
  folded.topLeftCorner<3, 3>() << 1, 4, 7, 2, 5, 8, 3, 6, 9;
  refused({folded}, "singular");
  check_refused([] { rotation({0, 0, 0}, Angle::degrees(10)); }, "axis of a rotation has length 0");
  check_refused([&] { rotation({nan, 0, 1}, Angle()); }, "axis of a rotation is not a finite");
  check_refused([&] { rotation({0, 0, 1}, Angle::degrees(nan)); }, "angle of a rotation");

  // Small and flat, but not to rounding.
  CHECK_NOTHROW(model_transform({tilt, scaling({1, 1, 1e-10}), tilt}));
  CHECK_NOTHROW(model_transform({scaling({1e-200, 1e-200, 1e-200}), tilt}));
  CHECK_NOTHROW(model_transform({scaling({1e150, 1e-150, 1})}));
}
