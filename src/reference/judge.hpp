// SPDX-License-Identifier: GPL-3.0-or-later
// Whether a place on a line is visible, by the ray walk.
#pragma once

#include "horizon/compare.hpp"
#include "profiles/slab_lines.hpp"
#include "reference/ray_walk.hpp"

namespace orograph {

enum class Verdict { visible, hidden, tied };

class Judge {
public:
  /// REQUIRES that surface and view outlive the judge.
  Judge(const Surface& surface, const View& view, const TieTolerance& tolerance);

  /// From now on it judges another view of the same surface, such as a panorama's next sector: what
  /// the walk knows of the surface, of a tile in degrees the index of all triangles, is kept.
  /// REQUIRES that the view outlives the judge.
  void set_view(const View& view, const TieTolerance& tolerance);

  /// How far the point's Y is above all that stands in front, negative below it. A point of an edge
  /// of the surface (`on_edge`) isn't hidden by that edge.
  double above(ProfilePoint at, bool on_edge) const;
  /// `tied` where that is within the tolerance and rounding.
  Verdict verdict(ProfilePoint at, bool on_edge) const;
  /// Of the place at share t of a line that is drawn there or isn't; `tied` also where rounding of
  /// the place decides.
  Verdict verdict(const ProfileLine& line, double t, bool on_edge, bool drawn) const;

private:
  struct Asked {
    InFront front;
    double above; ///< as `above` tells
    Verdict verdict;
  };
  Asked ask(ProfilePoint at, bool on_edge) const;

  const View* view_;
  TieTolerance tolerance_;
  RayWalk walk_;
};

} // namespace orograph
