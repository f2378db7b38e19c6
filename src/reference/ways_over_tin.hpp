// SPDX-License-Identifier: GPL-3.0-or-later
// Straight ways to the eye, and the triangles of a terrain that they pass, seen from above. What
// walks of sheets and of closed blocks are made of; shares no code with the pass.
#pragma once

#include "dem/mesh/tin_index.hpp"
#include "dem/surface.hpp"
#include "dem/tin.hpp"
#include "geometry/profile_point.hpp"
#include "reference/spatial.hpp"
#include "view/view.hpp"

#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

namespace orograph {

/// The places from + s * step, for s from 0 to `end`, in a view's profile frame.
struct StraightWay {
  Spatial from, step;
  double end;
  double z_m(double s) const { return from.z + s * step.z; }

  /// From a point towards the eye, as far as the near plane; without an end in a parallel view.
  /// REQUIRES of that that it isn't straight down or up.
  static StraightWay to_eye(const View& view, ProfilePoint point);
};

/// Where a way passes a triangle, or touches it.
struct TrianglePassage {
  std::uint32_t triangle;
  double low, high;          ///< of s
  double z_m, b_z_m, c_z_m;  ///< of its first corner, and by how much the others are higher
  double b_0, b_s, c_0, c_s; ///< shares of these two corners at s: b_0 + s * b_s, c_0 + s * c_s

  double b(double s) const { return b_0 + s * b_s; }
  double c(double s) const { return c_0 + s * c_s; }
  double height_m(double s) const { return z_m + b(s) * b_z_m + c(s) * c_z_m; }
};

class WaysOverTin {
public:
  /// REQUIRES that the surface outlives it. Cost: of a grid the TIN of its triangles.
  explicit WaysOverTin(const Surface& surface);
  const Tin& tin() const { return *tin_; }

  /// Calls `take` for each triangle, those that are upright left out, that the way passes within
  /// `beside_m`, in the order of their numbers or in another. Not from several threads at a time.
  void for_each(const View& view, const StraightWay& way, double beside_m,
                const std::function<void(const TrianglePassage&)>& take) const;

private:
  std::shared_ptr<const Tin> own_; ///< of a grid
  const Tin* tin_;
  std::shared_ptr<const TinIndex> index_;
  double reach_m_ = 0;                      ///< bound on coordinates in the ground frame
  mutable std::vector<std::uint32_t> near_; ///< triangles, reused from way to way
};

} // namespace orograph
