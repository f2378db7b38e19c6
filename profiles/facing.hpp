// SPDX-License-Identifier: GPL-3.0-or-later
// Whether the eye sees a triangle's upper side, and whether an edge is a ridge or a valley: the
// signs that decide silhouettes (docs/how-it-works.md).
#pragma once

#include "geometry/profile_point.hpp"
#include "view/view.hpp"

#include <cmath>
#include <cstdint>
#include <limits>

namespace orograph {

/// Bits of a triangle: what its facing may be. Both where the sign is within its rounding bound.
constexpr std::uint8_t kMayFace = 1, kMayTurn = 2;

/// Whether of two triangles one may be seen and the other turned away. No bits: it isn't there.
inline bool are_seen_and_turned(std::uint8_t a, std::uint8_t b) {
  return a != 0 && b != 0 && (a | b) == (kMayFace | kMayTurn);
}

/// A sum of three terms, and a bound on its rounding where each term is a product of three factors
/// that are differences of given numbers: seven roundings at most, of half an ulp each.
struct BoundedSum {
  double sum, bound;
};
inline BoundedSum triple_product(ProfilePoint a, ProfilePoint b, ProfilePoint c) {
  const double bc_uv = b.u * c.v, cb_uv = b.v * c.u, bc_vz = b.v * c.z, cb_vz = b.z * c.v,
               bc_zu = b.z * c.u, cb_zu = b.u * c.z;
  return {a.u * (bc_vz - cb_vz) + a.v * (bc_zu - cb_zu) + a.z * (bc_uv - cb_uv),
          4 * std::numeric_limits<double>::epsilon() *
              (std::abs(a.u) * (std::abs(bc_vz) + std::abs(cb_vz)) +
               std::abs(a.v) * (std::abs(bc_zu) + std::abs(cb_zu)) +
               std::abs(a.z) * (std::abs(bc_uv) + std::abs(cb_uv)))};
}

inline ProfilePoint from_to(ProfilePoint a, ProfilePoint b) {
  return {b.u - a.u, b.v - a.v, b.z - a.z};
}

/// Of the triangle a, b, c, counterclockwise seen from above (a wall as its neighbours have it):
/// the sign of N . (E - P), where zero counts as turned away. The same for a surface's triangle
/// wherever it is asked, if `a` is its vertex of lowest index.
inline std::uint8_t facing_of(const View& view, ProfilePoint a, ProfilePoint b, ProfilePoint c) {
  const ProfilePoint to_eye = view.is_perspective() ? ProfilePoint{-a.u, -a.v, view.eye_z_m - a.z}
                                                    : ProfilePoint{view.x_per_v * view.y_per_z,
                                                                   -view.y_per_z, view.y_per_v};
  const auto [sum, bound] = triple_product(to_eye, from_to(a, b), from_to(a, c));
  return static_cast<std::uint8_t>((sum >= -bound ? kMayFace : 0) | (sum <= bound ? kMayTurn : 0));
}

/// Whether the surface may bend downwards over the edge from -> to, whose two triangles have their
/// third vertices at `left` and `right` of it. Where one triangle is seen and the other turned
/// away, the nearer one is seen just if it does: of a wall as well, which is neither nearer nor
/// farther than its edge.
inline bool may_be_ridge(ProfilePoint from, ProfilePoint to, ProfilePoint left,
                         ProfilePoint right) {
  const auto [sum, bound] =
      triple_product(from_to(from, to), from_to(from, left), from_to(from, right));
  // On level ground both are exactly 0: it doesn't bend, though rounding may turn one of the two.
  return sum <= bound && (sum != 0 || bound != 0);
}

} // namespace orograph
