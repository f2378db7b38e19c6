// SPDX-License-Identifier: GPL-3.0-or-later
#include "view/picture_ends.hpp"

#include "geometry/blocked_points.hpp"

#include <algorithm>
#include <cmath>

namespace orograph {

double PictureCoordinate::of(ProfilePoint p) const {
  if (view.is_perspective() && !(p.v >= nearest_m)) return kInfinity;
  const Vec3 image = view.to_picture.of(project_homogeneous(view, p));
  if (!(image.z > 0)) return kInfinity;
  return sign * ((row == 0 ? image.x : image.y) / image.z);
}

// Linear-fractional in a point of the profile frame, so greatest at a corner of the box. Ground
// of the box sinks by a plane, which keeps its faces flat, and a quadratic form about the box's
// middle, between 0 and its values at the corners.
double PictureCoordinate::bound_by_corners(const Box3& box) const {
  std::array<ProfilePoint, 8> corners;
  double least_drop = 0, most_drop = 0;
  const ProfilePoint middle = to_profile_frame(view, box.centre());
  for (int i = 0; i < 8; ++i) {
    ProfilePoint& p = corners[static_cast<std::size_t>(i)];
    p = to_profile_frame(view, corner_of(box, i));
    const double drop = view.drop.at(p.u - middle.u, p.v - middle.v);
    p.z += drop;
    least_drop = std::min(least_drop, drop);
    most_drop = std::max(most_drop, drop);
  }
  double most = -kInfinity;
  for (const ProfilePoint& p : corners) most = std::max(most, of({p.u, p.v, p.z - least_drop}));
  if (most_drop == least_drop) return most;
  for (const ProfilePoint& p : corners) most = std::max(most, of({p.u, p.v, p.z - most_drop}));
  return most;
}

// Numerator less `value` denominators is affine: its most in the box over the least denominator
// is no less than what the coordinate is more than `value`. So the bound is told from five places
// instead of sixteen, and by one division; a little greater than by corners, the farther from
// `value` the more. None near the eye.
std::optional<double> PictureCoordinate::bound_near(double value, const Box3& box) const {
  if (!std::isfinite(value)) return std::nullopt;
  struct Values {
    double above, denominator, v;
  };
  double size = 0; // of what is taken from each other
  const auto at = [&](ProfilePoint p) {
    const Vec3 image = view.to_picture.of(project_homogeneous(view, p));
    const double numerator = sign * (row == 0 ? image.x : image.y);
    size = std::max(size, std::abs(numerator) + std::abs(value * image.z) + std::abs(p.u) +
                              std::abs(p.v));
    return Values{numerator - value * image.z, image.z, p.v};
  };
  const Vec3 centre = box.centre();
  const ProfilePoint middle = to_profile_frame(view, centre);
  const Values there = at(middle);
  double most = there.above, least_denominator = there.denominator, nearest = there.v;
  const auto reach = [&](double above, double denominator, double v) {
    most += above;
    least_denominator -= denominator;
    nearest -= v;
  };
  std::array<Vec2, 2> aside; // in u and v
  const Vec3 half = box.high - centre;
  const std::array<Vec3, 3> sides{Vec3{half.x, 0, 0}, Vec3{0, half.y, 0}, Vec3{0, 0, half.z}};
  for (std::size_t i = 0; i < sides.size(); ++i) {
    ProfilePoint p = to_profile_frame(view, centre + sides[i]);
    const Vec2 by{p.u - middle.u, p.v - middle.v};
    p.z += view.drop.at(by.x, by.y);
    if (i < 2) aside[i] = by;
    const Values side = at(p);
    reach(std::abs(side.above - there.above), std::abs(side.denominator - there.denominator),
          std::abs(by.y));
  }
  if (view.drop.any()) {
    const Vec2 sum = aside[0] + aside[1], difference = aside[0] - aside[1];
    for (const double drop :
         {view.drop.at(sum.x, sum.y), view.drop.at(difference.x, difference.y)}) {
      const Values sunk = at({middle.u, middle.v, middle.z - drop});
      reach(std::max(0.0, sunk.above - there.above),
            std::max(0.0, there.denominator - sunk.denominator), 0);
    }
  }
  constexpr double kRounding = 1e-12;
  if (!(least_denominator > kRounding * size) ||
      (view.is_perspective() && !(nearest - kRounding * size > nearest_m)))
    return std::nullopt;
  return value + std::max(0.0, most + kRounding * size) / least_denominator * (1 + kRounding);
}

double PictureCoordinate::bound(const Box3& box, double found) const {
  const std::optional<double> near = bound_near(found, box);
  return near ? *near : bound_by_corners(box);
}

PictureEnds::PictureEnds(const View& view, std::span<const OutlineEdge> outline) {
  if (outline.empty()) return;
  nearest.resize(2);
  const double s_e = sin(view.elevation), c_e = cos(view.elevation);
  std::array<double, 2> least{kInfinity, kInfinity};
  for (const OutlineEdge& edge : outline) {
    const double ahead = dot({edge.from.x, edge.from.y}, view.forward);
    const std::array<double, 2> depths{ahead, ahead * c_e - edge.from.z * view.exaggeration * s_e};
    for (std::size_t i = 0; i < depths.size(); ++i)
      if (depths[i] < least[i]) {
        least[i] = depths[i];
        nearest[i] = edge.from;
      }
  }
}

double greatest(const TerrainShape& terrain, const PictureCoordinate& coordinate,
                PictureEnds& ends) {
  std::optional<Vec3>& end = ends.of(coordinate);
  Extreme known;
  if (end) {
    known.take(coordinate, *end);
  } else { // a good start: most of what bounds a picture is on or near the outline
    constexpr std::size_t kLookedAt = 64;
    const std::size_t every = terrain.outline.size() / kLookedAt + 1;
    for (std::size_t i = 0; i < terrain.outline.size(); i += every)
      known.take(coordinate, terrain.outline[i].from);
  }
  const auto bound = [&](const Box3& box, double best) { return coordinate.bound(box, best); };
  const Extreme found = greatest(terrain.beside, coordinate, bound,
                                 greatest(terrain.points, coordinate, bound, known));
  end = found.at;
  return found.value;
}

} // namespace orograph
