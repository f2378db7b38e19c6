// SPDX-License-Identifier: GPL-3.0-or-later
// View volumes to canonical volumes: corner by corner, and against the points of the source
// (Paoluzzi 2003, 9.2.6).
#include "tests/support/random.hpp"
#include "tests/view/matrices.hpp"
#include "tests/view/random_phigs_view.hpp"
#include "view/pipeline.hpp"

#include <Eigen/LU>

#include <limits>

using namespace orograph;

namespace {

constexpr PhigsProjection kKinds[] = {PhigsProjection::perspective, PhigsProjection::parallel};

// Numbered as by corners_of.
Vec3 canonical_corner(const CanonicalVolume& volume, int i) {
  const bool perspective = volume.projection == PhigsProjection::perspective;
  const double z = (i & 4) ? volume.z_min : -1;
  const double reach = perspective ? -z : 1;
  return {(i & 1) ? reach : -reach, (i & 2) ? reach : -reach, z};
}

} // namespace

TEST_CASE("the corners of the view volume go to the corners of the canonical volume") {
  for (const PhigsProjection projection : kKinds)
    for (std::uint64_t seed = 1; seed <= last_seed(1000); ++seed) {
      Random random(seed);
      INFO("seed " << seed << (projection == PhigsProjection::parallel ? " parallel" : ""));
      const PhigsView view = random_phigs_view(random, projection);
      const CanonicalVolume volume = canonical_volume(view);
      const Eigen::Matrix4d m = view_mapping(view);
      const auto corners = corners_of(view);
      for (int i = 0; i < 8; ++i) {
        INFO("corner " << i);
        REQUIRE(distance(moved(m, corners[i]), canonical_corner(volume, i)) < 1e-12);
      }
      REQUIRE(m.determinant() > 0); // nothing is mirrored
      REQUIRE(m.row(3) == Eigen::RowVector4d(0, 0, 0, 1));
    }
}

TEST_CASE("the eye goes to the origin, oblique projectors to lines along z") {
  for (std::uint64_t seed = 1; seed <= last_seed(1000); ++seed) {
    Random random(seed);
    INFO("seed " << seed);
    const PhigsView seen = random_phigs_view(random, PhigsProjection::perspective);
    REQUIRE(distance(moved(view_mapping(seen), seen.prp_m), {0, 0, 0}) < 1e-15);
    const CanonicalVolume volume = canonical_volume(seen);
    REQUIRE(volume.z_min > -1);
    REQUIRE(volume.z_min < 0);

    const PhigsView flat = random_phigs_view(random, PhigsProjection::parallel);
    const Vec3 along = turned(view_mapping(flat), projectors_of(flat));
    REQUIRE(std::hypot(along.x, along.y) < 1e-12);
    REQUIRE(std::abs(along.z + 1 / (flat.front_m - flat.back_m)) < 1e-12);
  }
}

TEST_CASE("the perspective transformation maps r to (1, 1, 0) and s to (1, 1, -1)") {
  for (const double z_min : {-0.999, -0.5, -1.0 / 3, -1e-3}) {
    const Eigen::Matrix4d p = perspective_transformation(z_min);
    CHECK(distance(moved(p, {-z_min, -z_min, z_min}), {1, 1, 0}) < 1e-12);
    CHECK(distance(moved(p, {1, 1, -1}), {1, 1, -1}) < 1e-12);
    CHECK(p.determinant() > 0);
    // The eye goes to infinity, along z; the back plane stays.
    CHECK((p * Eigen::Vector4d(0, 0, 0, 1)).w() == 0);
    CHECK((p * Eigen::Vector4d(0, 0, 0, 1)).head<2>() == Eigen::Vector2d(0, 0));
    CHECK(distance(moved(p, {0.3, -0.7, -1}), {0.3, -0.7, -1}) < 1e-12);
  }
}

TEST_CASE("the perspective transformation brings the one canonical volume to the other") {
  for (std::uint64_t seed = 1; seed <= last_seed(1000); ++seed) {
    Random random(seed);
    INFO("seed " << seed);
    const CanonicalVolume volume{PhigsProjection::perspective, random.between(-0.99, -0.01)};
    const Eigen::Matrix4d p = perspective_transformation(volume.z_min);
    for (int i = 0; i < 8; ++i)
      REQUIRE(distance(moved(p, canonical_corner(volume, i)),
                       canonical_corner({PhigsProjection::parallel, 0}, i)) < 1e-13);
    // What is nearer stays nearer, and lines through the eye become parallel to z.
    const double z = random.between(-1, volume.z_min), share = random.between(0.1, 0.9);
    const Vec3 far_point{random.between(-1, 1) * -z, random.between(-1, 1) * -z, z};
    const Vec3 far_image = moved(p, far_point), near_image = moved(p, share * far_point);
    REQUIRE(std::hypot(far_image.x - near_image.x, far_image.y - near_image.y) < 1e-15);
    REQUIRE(near_image.z > far_image.z);
  }
}

TEST_CASE("view volumes that are none are refused") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto refused = [](PhigsView view, PhigsProjection projection, const char* words) {
    view.projection = projection;
    check_refused([&] { view_mapping(view); }, words);
    check_refused([&] { canonical_volume(view); }, words);
  };
  for (const PhigsProjection projection : kKinds) {
    PhigsView view;
    view.window_m = {{1, -1}, {1, 1}};
    refused(view, projection, "window is empty");
    view.window_m = {{-1, 1}, {1, -1}};
    refused(view, projection, "window is empty");
    view = {};
    view.front_m = view.back_m = -2;
    refused(view, projection, "front plane lies at the back plane or behind");
    view.front_m = -3;
    refused(view, projection, "front plane lies at the back plane or behind");
    view = {};
    view.prp_m.z = -1;
    refused(view, projection, "lies behind the view plane");
    view = {};
    view.prp_m.x = nan;
    refused(view, projection, "(PRP) is not a finite number");
    view = {};
    view.window_m.high.y = nan;
    refused(view, projection, "the window is not a finite number");
    view = {};
    view.front_m = nan;
    refused(view, projection, "the front plane is not a finite number");
    view = {};
    view.back_m = -std::numeric_limits<double>::infinity();
    refused(view, projection, "the back plane is not a finite number");
  }
  PhigsView view;
  view.prp_m = {3, 4, 0};
  refused(view, PhigsProjection::perspective, "the eye (PRP) lies on the view plane");
  refused(view, PhigsProjection::parallel, "the direction of projection lies in the view plane");
  view.prp_m = {0, 0, 1};
  for (const double front : {1.0, 1.5}) {
    view.front_m = front;
    refused(view, PhigsProjection::perspective, "front plane lies at the eye (PRP) or behind it");
    view.projection = PhigsProjection::parallel; // there it may be anywhere
    CHECK_NOTHROW(view_mapping(view));
  }
}
