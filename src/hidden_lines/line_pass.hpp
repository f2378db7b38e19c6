// SPDX-License-Identifier: GPL-3.0-or-later
// The pass front to back of lines other than profiles, slab by slab.
#pragma once

#include "draw/stroke_builder.hpp"
#include "hidden_lines/line_pictures.hpp"
#include "horizon/surface_line.hpp"
#include "profiles/slab_lines.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace orograph {

/// Takes lines slab by slab: collects what is visible of those that are drawn, and raises the
/// horizon by those that hide.
class LinePass {
public:
  /// Takes the lines `which` (of `lines_by_range`). REQUIRES that `pictures` outlives the pass.
  LinePass(const LinePictures& pictures, std::span<const LineAtDepth> which,
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

private:
  struct WholeLine {
    const LinePictures* pictures;
    ProfileLine operator()(std::uint32_t line) const { return pictures->whole(line); }
    // By depth lines are all over the memory.
    void fetch(std::span<const std::uint32_t> by_depth, std::size_t at) const {
      constexpr std::size_t kLineAhead = 16, kPointsAhead = 8;
      if (at + kLineAhead < by_depth.size()) pictures->fetch(by_depth[at + kLineAhead]);
      if (at + kPointsAhead < by_depth.size()) pictures->fetch_points(by_depth[at + kPointsAhead]);
    }
  };
  bool in_plane(const ProfileLine& whole, double depth_m) const;
  SurfaceLine in_slab(const SlabPiece& piece, const LinePicture& p, double to_m) const;
  template <class AnyHorizon>
  void begin_slab(double to_m, const AnyHorizon& horizon);
  void add_visible(std::span<const VisibleLinePart> visible);
  void end_slab();

  const LinePictures& pictures_;
  TieTolerance tolerance_;
  SlabLines<WholeLine> slabs_;
  SlabHorizon slab_horizon_;
  std::vector<SurfaceLine> in_slab_;
  std::vector<LinePicture> taken_; ///< by tag
  std::vector<HorizonPiece> occluders_, in_last_plane_;
  std::vector<HorizonPiece>* record_ = nullptr;
  std::vector<HorizonPiece> record_in_last_plane_;
  std::vector<LinePart> parts_;
};

/// Brings the parts of several sectors, a vector after another, in order by line, and joins those
/// that only the strip between the sectors parts; `strip_m` wide to either side, 0 where what is in
/// it is left out. `view` is that of the first sector, `points` are
/// those of lines on the ground.
void join_sectors(const Surface& surface, std::span<const ProfilePoint> points, const View& view,
                  const std::vector<EdgeLine>& lines, double strip_m, std::vector<LinePart>& parts);

/// Draws parts of lines as long strokes, joined at shared vertices.
void draw_parts(const Surface& surface, std::span<const ProfilePoint> points, const View& view,
                const std::vector<EdgeLine>& lines, const std::vector<LinePart>& parts,
                StrokeBuilder& builder);

} // namespace orograph
