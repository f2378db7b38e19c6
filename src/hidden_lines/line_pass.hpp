// SPDX-License-Identifier: GPL-3.0-or-later
// The pass front to back of lines other than profiles: silhouettes, shores, the border.
#pragma once

#include "draw/stroke_builder.hpp"
#include "hidden_lines/line_parts.hpp"
#include "horizon/clip_profile.hpp"
#include "horizon/surface_line.hpp"
#include "placing/placed_view.hpp"
#include "profiles/slab_lines.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace orograph {

/// Which layer a line is drawn in, if it is drawn.
enum class LineKind : std::uint8_t { silhouette, shore, border, void_edge, edge };

struct EdgeLine {
  SurfaceEdge edge;
  LineKind kind;
  bool hides; ///< is an occluder
  bool drawn;
  bool covers; ///< ground in front of it ends there, above what else is at its place
};

/// Takes lines slab by slab: collects what is visible of those that are drawn, and raises the
/// horizon by those that hide.
class LinePass {
public:
  /// Takes the lines `which` (of `lines_by_range`), within `range` of X. REQUIRES that surface,
  /// sector and lines outlive the pass. `from_m` is where the first slab begins.
  LinePass(const Surface& surface, const Sector& sector, const std::vector<EdgeLine>& lines,
           std::span<const LineAtDepth> which, XRange range, double from_m,
           const TieTolerance& tolerance);
  LinePass(const LinePass&) = delete;
  LinePass& operator=(const LinePass&) = delete;

  /// The slab up to the plane at `to_m`. `horizon` is made of what stands in front of the slab, and
  /// then of what stands in the slab as well, but for lines that lie in its last plane: they hide
  /// only what is behind that plane. `raise` raises the horizon by a list of occluders, in the
  /// order of `is_raised_before`.
  template <class AnyHorizon, class Raise>
  void take_slab(double to_m, AnyHorizon& horizon, const Raise& raise) {
    raise(in_last_plane_, horizon);
    begin_slab(to_m, horizon);
    add_visible(slab_horizon_.visible_parts(in_slab_, horizon, tolerance_));
    end_slab();
    raise(occluders_, horizon);
  }
  /// From now on every occluder, hidden ones too, is added to `all` when it raises the horizon.
  void record(std::vector<HorizonPiece>& all) { record_ = &all; }

  /// What was visible so far, slab by slab.
  const std::vector<LinePart>& visible_parts() const { return parts_; }
  /// X that is looked at: the range, and what is beside it by rounding.
  XRange looked_at() const { return beside_range_; }
  /// The parts of drawn silhouettes that `horizon`, the one behind everything, is made of, visible
  /// or not.
  std::vector<LinePart> skyline(const Horizon& horizon) const;

  /// Bound on the rounding of u and v.
  double rounding_m() const { return rounding_m_; }
  const EdgeLine& line(std::uint32_t i) const { return lines_[i]; }
  std::size_t size() const { return lines_.size(); }
  ProfileLine whole(std::uint32_t i) const;
  /// The point at a place along a line.
  ProfilePoint point(std::uint32_t line, double t) const;

private:
  // A line as projected: its source, and which of the edge's ends is on the left (nearer, if
  // upright).
  struct Projected {
    Segment source;
    double t_left, t_right; ///< along the edge, at the source's ends
    ProfilePoint left, right;
    double nearness_left, nearness_right;
    double beside; ///< rounding of X
  };
  // From shares of the way along the picture, left to right, to shares along the edge.
  struct AlongEdge {
    double t_left, t_right, v_left, v_right;
  };
  struct WholeLine {
    const LinePass* pass;
    ProfileLine operator()(std::uint32_t line) const { return pass->whole(line); }
  };
  Projected project_line(std::uint32_t line, const ProfileLine& whole) const;
  bool in_plane(const ProfileLine& whole, double depth_m) const;
  bool cut_to_range(SurfaceLine& line) const;
  SurfaceLine in_slab(const SlabPiece& piece, const Projected& p, double to_m) const;
  bool is_hidden(const Projected& p, const BlockedHorizon& horizon) const;
  template <class AnyHorizon>
  void begin_slab(double to_m, const AnyHorizon& horizon);
  void add_visible(std::span<const VisibleLinePart> visible);
  void end_slab();
  double along_edge(const AlongEdge& along, double share) const;

  EdgeEnds ends_;
  const Sector& sector_;
  const View& view_;
  const std::vector<EdgeLine>& lines_;
  XRange range_, beside_range_; ///< the second with what is beside the first by rounding
  double from_m_;
  TieTolerance tolerance_;
  double rounding_m_; ///< bound on the rounding of u and v
  SlabLines<WholeLine> slabs_;
  SlabHorizon slab_horizon_;
  std::vector<SurfaceLine> in_slab_;
  std::vector<AlongEdge> along_; ///< by tag
  std::vector<HorizonPiece> occluders_, in_last_plane_;
  std::vector<HorizonPiece>* record_ = nullptr;
  std::vector<HorizonPiece> record_in_last_plane_;
  std::vector<LinePart> parts_;
};

/// For each of the ranges the lines that reach into it.
std::vector<std::vector<LineAtDepth>> lines_by_range(const Surface& surface, const Sector& sector,
                                                     const std::vector<EdgeLine>& lines,
                                                     std::span<const XRange> ranges, double from_m);

/// Brings the parts of several sectors, a vector after another, in order by line, and joins those
/// that only the strip between the sectors parts; `strip_m` wide to either side, 0 where what is in
/// it is left out. `view` is that of the first sector.
void join_sectors(const Surface& surface, const View& view, const std::vector<EdgeLine>& lines,
                  double strip_m, std::vector<LinePart>& parts);

/// Draws parts of lines as long strokes, joined at shared vertices.
void draw_parts(const Surface& surface, const View& view, const std::vector<EdgeLine>& lines,
                const std::vector<LinePart>& parts, StrokeBuilder& builder);

} // namespace orograph
