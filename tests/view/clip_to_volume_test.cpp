// SPDX-License-Identifier: GPL-3.0-or-later
// Clipping to the canonical volumes against exact arithmetic, and on edges that are hard.
#include "tests/catch.hpp"
#include "tests/support/random.hpp"
#include "tests/view/exact_interval.hpp"
#include "tests/view/matrices.hpp"
#include "view/pipeline.hpp"

using namespace orograph;

namespace {

constexpr double kTolerance = 1e-12;
constexpr int kEdges = 1'000'000;

struct Edge {
  Eigen::Vector4d from, to;
};

Eigen::Vector4d lattice_point(const Eigen::Vector4d& p) {
  const double w = std::nearbyint(p.w() * 0x1p46) * 0x1p-46;
  return {on_lattice(p.x()), on_lattice(p.y()), on_lattice(p.z()), w};
}

CanonicalVolume random_volume(Random& random) {
  if (random.chance(0.5)) return {PhigsProjection::parallel, 0};
  return {PhigsProjection::perspective, random.whole(-1023, -1) / 1024.0};
}

// Anywhere about the volume; w is 1, or positive, or of any sign.
Eigen::Vector4d random_end(Random& random) {
  const double reach = random.pick({1.0, 1.5, 3.0});
  const double w = random.pick({1.0, 1.0, random.between(0.1, 2), random.between(-1.5, 1.5)});
  return lattice_point({random.between(-reach, reach), random.between(-reach, reach),
                        random.between(-reach, 0.5 * reach), w});
}

Eigen::Vector4d corner(Random& random, const CanonicalVolume& volume) {
  const double z = random.chance(0.5) ? -1 : volume.z_min;
  const double reach = volume.projection == PhigsProjection::perspective ? -z : 1;
  return {random.pick({-reach, reach}), random.pick({-reach, reach}), z, 1};
}

// Brings a point onto one of the planes: exactly, since a coordinate is copied.
Eigen::Vector4d onto_plane(Random& random, Eigen::Vector4d p, const CanonicalVolume& volume) {
  const double reach = volume.projection == PhigsProjection::perspective ? -p.z() : p.w();
  switch (random.whole(0, 3)) {
  case 0:
    p.x() = random.pick({-reach, reach});
    break;
  case 1:
    p.y() = random.pick({-reach, reach});
    break;
  case 2:
    p.z() = -p.w();
    break;
  default:
    p.w() = 1;
    p.z() = volume.z_min;
  }
  return p;
}

Edge general_edge(Random& random) {
  return {random_end(random), random_end(random)};
}

// Made to be hard: through corners, along faces, from planes, tiny, single points, on a coarse
// lattice where many crossings coincide.
Edge hard_edge(Random& random, const CanonicalVolume& volume) {
  Edge edge = general_edge(random);
  switch (random.whole(0, 6)) {
  case 0: {
    const Eigen::Vector4d at = corner(random, volume), along = 0.5 * (edge.to - edge.from);
    const double share = random.pick({0.5, 1.0, random.share()});
    return {at - share * along, at + (1 - share) * along};
  }
  case 1: // along a face, where the plane is the same for both ends
    edge.from = onto_plane(random, edge.from, volume);
    edge.to = edge.from;
    edge.to[random.whole(0, 2)] = random.between(-2, 2);
    return edge;
  case 2:
    edge.from = onto_plane(random, edge.from, volume);
    edge.to = onto_plane(random, edge.to, volume);
    return edge;
  case 3: // tiny, about a corner
    edge.from = corner(random, volume) + 1e-9 * edge.from;
    edge.to = corner(random, volume) + 1e-9 * edge.to;
    return edge;
  case 4:
    edge.to = edge.from;
    return edge;
  case 5: // a hair aside from a corner or an edge of the volume
    edge.from = corner(random, volume) + random.pick({1e-5, 1e-10, 1e-14}) * edge.from;
    return edge;
  default:
    for (Eigen::Vector4d* end : {&edge.from, &edge.to})
      *end << random.whole(-4, 4) / 2.0, random.whole(-4, 4) / 2.0, random.whole(-4, 2) / 2.0,
          random.pick({1.0, 1.0, 0.5, 0.0, -1.0});
    return edge;
  }
}

// Returns true where the two differ and rounding may decide.
bool compare(Edge edge, const CanonicalVolume& volume) {
  edge = {lattice_point(edge.from), lattice_point(edge.to)};
  const Eigen::Vector4d along = edge.to - edge.from;
  // The zero vector is no point; nothing of the scene becomes one.
  if (edge.from.isZero() || edge.to.isZero()) return false;
  const ExactInterval exact = exact_interval(edge.from, edge.to, volume);
  const auto found = clip_to_volume(edge.from, edge.to, volume);
  const long double extent = along.cwiseAbs().maxCoeff();
  if (found.has_value() == exact.empty) {
    CAPTURE(exact.empty, static_cast<double>(exact.room()));
    REQUIRE(std::abs(exact.room()) * extent < kTolerance);
    return true;
  }
  if (exact.empty) return false;
  REQUIRE(found->t_begin <= found->t_end);
  REQUIRE(std::min(found->begin.w(), found->end.w()) > -kTolerance);
  const auto close = [&](double t, const Eigen::Vector4d& end, Share share) {
    if (std::abs(t - share.value()) * extent >= kTolerance) return false;
    for (int i = 0; i < 4; ++i) {
      const long double expected =
          edge.from[i] + share.value() * (static_cast<long double>(edge.to[i]) - edge.from[i]);
      if (!(std::abs(end[i] - expected) < kTolerance)) return false;
    }
    return true;
  };
  REQUIRE(close(found->t_begin, found->begin, exact.first));
  REQUIRE(close(found->t_end, found->end, exact.last));
  return false;
}

Edge straight(Vec3 from, Vec3 to) {
  return {homogeneous(from), homogeneous(to)};
}

} // namespace

TEST_CASE("random edges are clipped as in exact arithmetic") {
  Random random(5);
  int undecided = 0, accepted = 0;
  for (int i = 0; i < kEdges; ++i) {
    const CanonicalVolume volume = random_volume(random);
    const Edge edge = general_edge(random);
    undecided += compare(edge, volume) ? 1 : 0;
    accepted += clip_to_volume(edge.from, edge.to, volume).has_value() ? 1 : 0;
  }
  CHECK(undecided == 0);
  CHECK(accepted > kEdges / 10); // both happen
  CHECK(accepted < kEdges * 9 / 10);
}

TEST_CASE("hard edges are clipped as in exact arithmetic") {
  Random random(6);
  int undecided = 0;
  for (int i = 0; i < kEdges; ++i) {
    const CanonicalVolume volume = random_volume(random);
    undecided += compare(hard_edge(random, volume), volume) ? 1 : 0;
  }
  CHECK(undecided < kEdges / 100);
}

TEST_CASE("an edge that misses a corner is rejected") {
  const CanonicalVolume parallel{PhigsProjection::parallel, 0},
      perspective{PhigsProjection::perspective, -0.25};
  // From left of the volume to above it, past the upper left edge: no plane has both ends outside.
  const auto past = [](double aside) {
    return straight({-1.5 - aside, 0.5, -0.5}, {-0.5, 1.5 + aside, -0.5});
  };
  for (const double aside : {1.0, 1e-3, 1e-12}) {
    const Edge edge = past(aside);
    CHECK_FALSE(clip_to_volume(edge.from, edge.to, parallel));
    CHECK_FALSE(clip_to_volume(edge.to, edge.from, parallel));
  }
  const Edge crosses = past(-1e-3);
  CHECK(clip_to_volume(crosses.from, crosses.to, parallel));
  // Past a corner in all three directions.
  const Edge corner_edge = straight({0.5, 0.9, 0.8}, {1.2, 1.4, -0.9});
  CHECK_FALSE(clip_to_volume(corner_edge.from, corner_edge.to, parallel));
  const Edge pyramid_edge = straight({-0.8, 0, -0.5}, {0, 0.8, -0.5});
  CHECK(clip_to_volume(pyramid_edge.from, pyramid_edge.to, perspective));
  const Edge past_pyramid = straight({-1.1, 0, -0.5}, {0, 1.1, -0.5});
  CHECK_FALSE(clip_to_volume(past_pyramid.from, past_pyramid.to, perspective));
}

TEST_CASE("an edge through the volume is cut at its planes") {
  const Edge edge = straight({-3, 0, -0.5}, {5, 0, -0.5});
  const auto in_box = clip_to_volume(edge.from, edge.to, {PhigsProjection::parallel, 0});
  REQUIRE(in_box);
  CHECK(in_box->t_begin == 0.25);
  CHECK(in_box->t_end == 0.5);
  CHECK(in_box->begin == Eigen::Vector4d(-1, 0, -0.5, 1));
  CHECK(in_box->end == Eigen::Vector4d(1, 0, -0.5, 1));
  const auto in_pyramid = clip_to_volume(edge.from, edge.to, {PhigsProjection::perspective, -0.25});
  REQUIRE(in_pyramid);
  CHECK(in_pyramid->t_begin == 0.3125);
  CHECK(in_pyramid->t_end == 0.4375);

  const Edge within = straight({0.13, -0.57, -0.71}, {0.55, 0.51, -0.63});
  const auto whole = clip_to_volume(within.from, within.to, {PhigsProjection::perspective, -0.5});
  REQUIRE(whole);
  CHECK(whole->begin == within.from);
  CHECK(whole->end == within.to);
}

TEST_CASE("what is behind the eye is outside, and an edge from there is cut at the front plane") {
  const CanonicalVolume pyramid{PhigsProjection::perspective, -0.25};
  const Eigen::Vector4d behind(0.1, 0.1, 0.5, 1), inside(0.2, -0.1, -0.75, 1),
      far_behind(3, 0, 2, 1);
  CHECK_FALSE(clip_to_volume(behind, far_behind, pyramid));
  const auto part = clip_to_volume(behind, inside, pyramid);
  REQUIRE(part);
  CHECK(part->begin.z() == Approx(-0.25).epsilon(1e-15));
  CHECK(part->t_end == 1);

  // After the perspective transformation the same edge has w < 0 at its end behind the eye.
  const Eigen::Matrix4d p = perspective_transformation(pyramid.z_min);
  const CanonicalVolume box{PhigsProjection::parallel, 0};
  CHECK((p * behind).w() < 0);
  CHECK_FALSE(clip_to_volume(p * behind, p * far_behind, box));
  const auto image = clip_to_volume(p * behind, p * inside, box);
  REQUIRE(image);
  CHECK(image->t_begin == Approx(part->t_begin).epsilon(1e-14));
  CHECK(image->begin.w() > 0);
  // A picture that a division by w < 0 would put inside.
  CHECK_FALSE(clip_to_volume({-0.1, 0.1, 0.5, -1}, {-0.2, 0.1, 0.25, -1}, box));
}

TEST_CASE("clipping before the perspective transformation and after it is the same") {
  const int edges = kEdges / 10;
  Random random(7);
  int differ = 0;
  for (int i = 0; i < edges; ++i) {
    const CanonicalVolume pyramid{PhigsProjection::perspective, random.between(-0.9, -0.05)};
    Edge edge = general_edge(random);
    edge.from.w() = edge.to.w() = 1;
    const Eigen::Matrix4d p = perspective_transformation(pyramid.z_min);
    const auto before = clip_to_volume(edge.from, edge.to, pyramid);
    const auto after = clip_to_volume(p * edge.from, p * edge.to, {PhigsProjection::parallel, 0});
    if (before.has_value() != after.has_value()) {
      ++differ;
      continue;
    }
    if (!before) continue;
    REQUIRE(after->begin.w() > 0);
    REQUIRE((p * before->begin - after->begin).cwiseAbs().maxCoeff() < 1e-9);
    REQUIRE((p * before->end - after->end).cwiseAbs().maxCoeff() < 1e-9);
  }
  CHECK(differ == 0);
}
