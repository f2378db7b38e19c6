// SPDX-License-Identifier: GPL-3.0-or-later
// The picture of the visibility plane on the page: one 3x3 matrix (docs/how-it-works.md).
#pragma once

#include "geometry/vec.hpp"

#include <array>

namespace orograph {

/// Maps a direction (X, Y, 1) of the visibility plane to page millimetres, x to the right and y
/// *down* from the page's upper left corner. Row-major. In a parallel view the last row is
/// (0, 0, 1). `w` > 0 in front of the picture plane; points with w <= 0 have no picture.
struct Homography {
  std::array<double, 9> m{1, 0, 0, 0, 1, 0, 0, 0, 1};

  double w(Vec2 p) const { return m[6] * p.x + m[7] * p.y + m[8]; }
  /// The image of a point in homogeneous coordinates (X w, Y w, w), likewise.
  Vec3 of(Vec3 p) const {
    return {m[0] * p.x + m[1] * p.y + m[2] * p.z, m[3] * p.x + m[4] * p.y + m[5] * p.z,
            m[6] * p.x + m[7] * p.y + m[8] * p.z};
  }
  /// REQUIRES w(p) > 0.
  Vec2 operator()(Vec2 p) const {
    const double scale = 1 / w(p);
    return {(m[0] * p.x + m[1] * p.y + m[2]) * scale, (m[3] * p.x + m[4] * p.y + m[5]) * scale};
  }
  /// Likewise, over its last coordinate. REQUIRES that this is above 0.
  Vec2 at(Vec3 p) const {
    const Vec3 image = of(p);
    return {image.x / image.z, image.y / image.z};
  }
  /// Length on the page, in mm, of a small step from p, both in homogeneous coordinates, over the
  /// step's. REQUIRES that the image of p has its last coordinate above 0.
  double mm_per_step(Vec3 p, Vec3 step) const {
    const Vec3 image = of(p), moved = of(step);
    return std::hypot(moved.x - image.x / image.z * moved.z,
                      moved.y - image.y / image.z * moved.z) /
           image.z;
  }
  /// The same of a unit step of Y at p.
  double mm_per_y(Vec2 p) const { return mm_per_step({p.x, p.y, 1}, {0, 1, 0}); }
};

/// The matrix product: first `inner`, then `outer`.
constexpr Homography compose(const Homography& outer, const Homography& inner) {
  Homography product;
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 3; ++column) {
      double sum = 0;
      for (int k = 0; k < 3; ++k) sum += outer.m[3 * row + k] * inner.m[3 * k + column];
      product.m[3 * row + column] = sum;
    }
  return product;
}

/// Its product with `homography` is the identity, to rounding. REQUIRES that it is regular.
constexpr Homography inverse(const Homography& homography) {
  const auto& m = homography.m;
  Homography out{{m[4] * m[8] - m[5] * m[7], m[2] * m[7] - m[1] * m[8], m[1] * m[5] - m[2] * m[4],
                  m[5] * m[6] - m[3] * m[8], m[0] * m[8] - m[2] * m[6], m[2] * m[3] - m[0] * m[5],
                  m[3] * m[7] - m[4] * m[6], m[1] * m[6] - m[0] * m[7], m[0] * m[4] - m[1] * m[3]}};
  const double determinant = m[0] * out.m[0] + m[1] * out.m[3] + m[2] * out.m[6];
  for (double& entry : out.m) entry /= determinant;
  return out;
}

} // namespace orograph
