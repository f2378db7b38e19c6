// SPDX-License-Identifier: GPL-3.0-or-later
// Lines on the surface within one slab: what they hide of each other, and of what is behind.
#pragma once

#include "geometry/segment.hpp"
#include "horizon/blocked_horizon.hpp"
#include "horizon/compare.hpp"
#include "horizon/horizon.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace orograph {

/// A straight line on the surface, projected, and the part of it that lies in a slab. `nearness` is
/// a number that is linear in X along the projected line and greater for what is nearer: 1 / v in
/// perspective, -v in a parallel view.
///
/// A line with no extent in X (straight away from the eye) has source.x0 == source.x1, its nearer
/// end as (x0, y0), begin and end as shares of the way along its picture, and `beside`: what is
/// that close in X counts as being at its X. Of a vertical line both ends are
/// as near: it shows where it is above what stands in front of it on either side of its X, since
/// the tops of walls end at their corners.
struct SurfaceLine {
  Segment source;
  double nearness0, nearness1; ///< at the source's ends
  double begin, end;           ///< the part in the slab, as abscissae
  bool hides;                  ///< is an occluder
  bool drawn;                  ///< asked about, and drawn where visible
  double beside = 0;
  /// Bound on the rounding of positions on the ground (0: they are exact). Lines that are no
  /// farther apart in nearness are at one place on the ground; there a line hides what is below it
  /// just if it `covers`: if the ground that ends at it is in front of it.
  double rounding_m = 0;
  bool perspective = false; ///< how nearness is reckoned
  bool covers = false;
  /// Lies in the slab's last plane: hides only what is behind that.
  bool in_last_plane = false;
  std::uint32_t tag = 0;  ///< the caller's number for it, kept where lines are dropped
  bool is_lifted = false; ///< higher than the ground, which doesn't hide it by itself
  bool is_clear = false;  ///< is known to be above all of the horizon in front of the slab

  bool upright() const { return source.x0 == source.x1; }
  bool vertical() const { return upright() && nearness0 == nearness1; }
};

/// Appends to `parts`, left to right, what of a line that isn't upright is above `horizon`.
template <class AnyHorizon> // Horizon or BlockedHorizon
void add_above_horizon(const SurfaceLine& line, std::uint32_t number, const AnyHorizon& horizon,
                       const TieTolerance& tolerance, std::vector<VisibleLinePart>& parts);
/// The same of a line straight away from the eye that has `height` in front of it. Of one on the
/// ground that doesn't rise nothing is: its own nearer end hides it.
void add_above_height(const SurfaceLine& line, std::uint32_t number, double height,
                      std::vector<VisibleLinePart>& parts);

/// What a line straight away from the eye has in front of it at its X, where the horizon is made of
/// all of that and of nothing else.
double height_in_front(const SurfaceLine& upright, const BlockedHorizon& horizon);
/// The same where on one side of it the horizon may hold what is farther: that of the lower side.
double lower_height_beside(const SurfaceLine& upright, const BlockedHorizon& horizon);

/// Finds, slab by slab, what is visible of lines on the surface, and raises a horizon by those that
/// hide. Memory is reused from slab to slab.
class SlabHorizon {
public:
  /// The visible parts of the drawn lines of a slab: above `horizon`, which is made of what stands
  /// in front of the slab, and above what hides in the slab and is nearer. Along the X that two
  /// lines share, each of "nearer" and "higher" changes at most once, so hidden stretches are found
  /// in closed form; ends that two lines share count as exactly equal. Lines that are wholly below
  /// `horizon` are dropped from `lines` first, unless none is drawn.
  template <class AnyHorizon> // Horizon or BlockedHorizon
  std::span<const VisibleLinePart> visible_parts(std::vector<SurfaceLine>& lines,
                                                 const AnyHorizon& horizon,
                                                 const TieTolerance& tolerance = {});

  /// Where a line begins.
  struct Begin {
    double x;
    std::uint64_t id; ///< of its source
    std::uint32_t line;
  };
  /// The lines that `visible_parts` has left, those that aren't upright in the order of
  /// `is_raised_before`.
  const std::vector<Begin>& by_x() const { return by_x_; }

private:
  struct Active {
    double last_x;
    std::uint32_t line;
  };
  struct Hidden {
    std::uint32_t line;
    double begin, end;
  };
  void hide_behind(std::span<const SurfaceLine> lines, std::uint32_t front, std::uint32_t behind,
                   const TieTolerance& tolerance);

  std::vector<Begin> by_x_;
  std::vector<Active> active_hiding_, active_; ///< the second of those that hide nothing
  std::vector<Hidden> hidden_;
  std::vector<VisibleLinePart> parts_;
};

} // namespace orograph
