// SPDX-License-Identifier: GPL-3.0-or-later
// What the two passes through a sector share: in strips (hidden_lines/strip_pass.hpp) and with the
// horizon in one list (hidden_lines/sector_pass.cpp).
#pragma once

#include "dem/terrain.hpp"
#include "draw/drawing.hpp"
#include "geometry/segment.hpp"
#include "hidden_lines/contour_chains.hpp"
#include "hidden_lines/counts.hpp"
#include "hidden_lines/folds.hpp"
#include "hidden_lines/ground_lines.hpp"
#include "hidden_lines/line_pictures.hpp"
#include "horizon/clip.hpp"
#include "horizon/clip_profile.hpp"
#include "placing/placed_view.hpp"
#include "profiles/cut_surface.hpp"
#include "profiles/earth_strips.hpp"
#include "profiles/profile.hpp"
#include "profiles/seen_ground.hpp"
#include "profiles/sheet.hpp"
#include "profiles/sheet_part.hpp"
#include "profiles/silhouettes.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace orograph {
/// Where spans of a profile are among a lattice's strips of cells.
struct SpansByStrip {
  /// One after another in one strip: from `first` on, `end` not included.
  struct Run {
    int strip;
    std::uint32_t first, end;
  };
  std::vector<Run> runs; ///< by strip, then from left to right
  std::vector<std::uint32_t>
      cells; ///< of each span: twice the cell's number, and its triangle's half

  int cell(std::size_t span) const { return static_cast<int>(cells[span] / 2); }
  bool is_lower(std::size_t span) const { return cells[span] % 2 == 0; }
};

/// A profile and what is found of it. Memory is reused from profile to profile.
struct ProfileInWork {
  PlannedProfile planned{};
  std::size_t index = 0; ///< among the sector's
  Profile profile;
  ProjectedProfile projected;
  std::vector<Segment> uprights;                 ///< along walls
  SpansByStrip on_earth;                         ///< where it is taken in the order of strips there
  std::vector<std::vector<VisibleRun>> by_strip; ///< in each strip's range
  std::vector<std::size_t> horizon_sizes;        ///< of each strip, in front of the profile
  std::vector<VisibleRun> visible;               ///< along all of the profile
  /// The same of its underside, where the surface has one: then the others are of the upper side.
  std::vector<std::vector<VisibleRun>> underside_by_strip;
  std::vector<VisibleRun> underside;
  Layer strokes;           ///< rounded
  Layer hidden_strokes;    ///< of what isn't visible, if it is asked for
  Layer underside_strokes; ///< not rounded
  double left_out_mm = 0;
  std::size_t dropped_strokes = 0;
};

/// Of a profile whose triangles are known; they are forgotten.
SpansByStrip spans_by_strip(Profile& profile, const EarthStrips& strips);

/// Puts the strips' visible runs together: what is cut where two strips meet is one again.
void join_strips(ProfileInWork& work);

/// The same as segments and pieces of them, for those who watch.
struct PiecesOfProfile {
  std::vector<Segment> segments;
  std::vector<Piece> visible, underside;
};
PiecesOfProfile pieces_of(const ProfileInWork& work, const View& view);

/// What a pass needs of its sector. REQUIRES that all outlive it.
struct SectorInWork {
  const TerrainData& terrain;
  const PlacedView& placed;
  const Sector& sector;
  const std::vector<EdgeLine>& lines; ///< last those on the ground
  const GroundLines& on_ground;
  const SurfaceCutter& cutter;
  const TieTolerance& tolerance;
  double from_m;            ///< depth from which on terrain is looked at
  XRange range;             ///< of X that is asked for
  bool whole_profiles;      ///< whether profiles are cut beyond it as well, for those who watch
  const SeenGround* ground; ///< what is looked at, where that isn't all
  double vertices_a_strip;
  /// The silhouettes, where they aren't among the lines: then the pass finds them itself, and
  /// leaves folds out.
  const SilhouetteMarks* silhouettes = nullptr;
  const Folds* folds = nullptr;
  bool draws_silhouettes = false;
  /// Rising, of contours that aren't among the lines; the pass finds them itself.
  std::span<const double> contour_levels_m = {};
  bool hidden_profiles = false; ///< whether what isn't visible of profiles is drawn as well
  /// Of the lines that may reach into the range, where those aren't all.
  const std::vector<std::uint32_t>* line_numbers = nullptr;
  const Sheet* sheet = nullptr;              ///< the surface, where it has two sides
  const SheetPart* sheet_part = nullptr;     ///< what of it is looked at, where that isn't all
  const EarthStrips* earth_strips = nullptr; ///< of a grid on the earth that has such an order
  bool passes_over_profiles = false; ///< they are neither cut nor drawn, and nobody watches them
  /// For each line on the ground a mark of those that are visible from end to end, which are nearly
  /// all that are seen of millions; none where each has to be a part.
  std::span<std::uint8_t> whole_on_ground = {};
  std::span<const SeenWith> seen_with = {}; ///< lines that aren't asked for themselves
  bool draws_profiles = true; ///< or else they may be watched, and a line tied with them is drawn

  /// Marks the line of a part, and tells so, if the part is all of a line on the ground. Called
  /// from several threads.
  bool marks_whole(const LinePart& part) const {
    const std::size_t first = lines.size() - on_ground.lines.size();
    if (whole_on_ground.empty() || part.line < first || part.line >= lines.size() ||
        part.t_begin > 0 || part.t_end < 1)
      return false;
    std::atomic_ref(whole_on_ground[part.line - first]).store(1, std::memory_order_relaxed);
    return true;
  }
  /// Of a line on the ground.
  std::uint32_t triangle_of(std::uint32_t line) const {
    return on_ground.lines[line - (lines.size() - on_ground.lines.size())].triangle;
  }
};

struct SectorParts {
  std::vector<EdgeLine> found;   ///< lines behind those of the list, in order of their edges
  std::vector<LinePart> visible; ///< joined, by line; less what is marked as a whole
  std::vector<LinePart> skyline; ///< what of that the horizon behind everything is made of
  std::vector<LinePart> ridges;  ///< visible as well; known to be neither skyline nor fold
  double folded_mm = 0;          ///< length of folds that were left out
  SeenContours contours;         ///< those that the pass has found
};

/// Lays one profile's visible runs out in its own layer; called from several threads.
using LayOut = std::function<void(ProfileInWork&)>;
/// Is shown profiles in order, front to back.
using Show = std::function<void(ProfileInWork&)>;

/// Where the near plane cuts the terrain, a section begins: the cut hides. Empty in a parallel
/// view.
std::vector<Segment> near_cut(const SectorInWork& work);

/// Planes between slabs, front to back. Slabs are about a cell thick, so that few lines meet in
/// one; but slivers that a cut has left don't make millions of them.
class SlabPlanes {
public:
  explicit SlabPlanes(const SectorInWork& work)
      : last_m_(std::max(work.sector.nearest_m, work.from_m)),
        thickness_m_(
            std::max(work.placed.cell_m, (work.sector.farthest_m - last_m_) / kMostSlabs)) {}

  double last_m() const { return last_m_; }
  /// Takes slabs from the last plane on, the last one up to `to_m`.
  template <class Take>
  void take_to(double to_m, const Take& take) {
    const double count = std::ceil((to_m - last_m_) / thickness_m_);
    for (int i = 1; i < count; ++i) take(last_m_ + (to_m - last_m_) * (i / count));
    take(to_m);
    last_m_ = to_m;
  }

private:
  static constexpr double kMostSlabs = 1e5;
  double last_m_, thickness_m_;
};

/// Adds what of the profile's ways along walls, those within a range of X, is above the horizon.
/// `rounding_m` bounds the rounding of positions.
template <class AnyHorizon>
void add_visible_uprights(const ProfileInWork& profile, const View& view, XRange range,
                          const AnyHorizon& horizon, double rounding_m,
                          std::vector<VisibleRun>& visible) {
  for (const Segment& upright : profile.uprights) {
    if (upright.x0 < range.begin || upright.x0 >= range.end) continue;
    // What is that close in X counts as being at it.
    const double beside = view.is_perspective()
                              ? rounding_m * (1 + std::abs(upright.x0)) / profile.planned.depth_m
                              : rounding_m;
    const std::uint32_t vertex = left_vertex(upright);
    for (const Piece& piece : visible_uprights(std::span(&upright, 1), horizon, beside))
      visible.push_back({vertex, vertex, piece.t_begin, piece.t_end});
  }
}

} // namespace orograph
