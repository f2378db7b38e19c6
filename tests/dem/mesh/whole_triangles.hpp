// SPDX-License-Identifier: GPL-3.0-or-later
// What a Tin promises, by definition, for small whole coordinates: everything in whole numbers, all
// pairs of triangles looked at.
#pragma once

#include "dem/mesh/verify_tin.hpp"

#include <array>
#include <cstdint>
#include <set>
#include <vector>

namespace orograph {

using Whole = std::int64_t; ///< enough for coordinates below 200: cut points are in lowest terms

/// A point of the plane, (x / w, y / w), w > 0.
struct WholePoint {
  Whole x, y, w = 1;
};

/// Twice the area of a, b, c, times the product of their w.
Whole area(const WholePoint& a, const WholePoint& b, const WholePoint& c);

/// The insides of two counterclockwise triangles meet: one cut down by the other's edges has an
/// area left.
bool share_ground(const std::array<WholePoint, 3>& a, const std::array<WholePoint, 3>& b);

/// The triangle seen from above. REQUIRES whole coordinates below 200.
std::array<WholePoint, 3> seen_from_above(const Tin& tin, std::size_t triangle);

/// All kinds of fault that the Tin has. Where indices are wrong or coordinates aren't finite, only
/// that.
std::set<TinFault::Kind> faults_by_definition(const Tin& tin);

} // namespace orograph
