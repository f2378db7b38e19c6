// SPDX-License-Identifier: GPL-3.0-or-later
// Lines on the surface other than profiles (silhouettes, shores, the border) as a sector sees them.
#pragma once

#include "hidden_lines/line_parts.hpp"
#include "horizon/blocked_horizon.hpp"
#include "horizon/surface_line.hpp"
#include "placing/placed_view.hpp"
#include "profiles/slab_lines.hpp"

#include <cmath>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace orograph {

/// Which layer a line is drawn in, if it is drawn: edges of the surface, then lines on the ground,
/// then those on a block's walls.
enum class LineKind : std::uint8_t {
  silhouette,
  shore,
  border,
  void_edge,
  edge,
  underside, ///< where that ends against what is behind it
  waterline,
  contour,
  index_contour,
  mesh,
  graticule,
  grid,
  drape,
  hachure,
  block,
  wall,
  wall_contour,
  wall_index_contour
};

/// Whether they are lines on the ground, which may run along edges or not.
inline bool is_on_ground(LineKind kind) {
  return kind >= LineKind::waterline;
}

/// Of these, whether they are on a wall below an edge of the border instead.
inline bool is_on_wall(LineKind kind) {
  return kind >= LineKind::block;
}

struct EdgeLine {
  SurfaceEdge edge;
  LineKind kind;
  bool hides; ///< is an occluder
  bool drawn;
  bool covers; ///< ground in front of it ends there, above what else is at its place
};

/// A line as projected: its source, and which of the edge's ends is on the left (nearer, if
/// upright).
struct LinePicture {
  Segment source;
  double t_left, t_right; ///< along the edge, at the source's ends
  ProfilePoint left, right;
  double nearness_left, nearness_right;
  double beside; ///< rounding of X

  bool is_upright() const { return source.x0 == source.x1; }
};

/// A line along an edge, turned or not, that is seen where the edge is.
struct SeenWith {
  static constexpr std::uint32_t kNone = 0xffffffff;
  std::uint32_t line = kNone;
  bool is_turned = false;
};

/// The lines of a sector within a range of X: those of a list, and behind them in number those that
/// were found on the way. REQUIRES that surface, points, sector and list
/// outlive it.
class LinePictures {
public:
  /// `reach_m`: as facts of the terrain have it. `points`: of lines on the ground, in the view's
  /// profile frame. `from_m`: depth from which on
  /// terrain is looked at. `overlays_are_lifted`: draped lines are higher than the ground.
  LinePictures(const Surface& surface, double reach_m, std::span<const ProfilePoint> points,
               const Sector& sector, const std::vector<EdgeLine>& lines, XRange range,
               double from_m, bool overlays_are_lifted = false);

  const EdgeLine& line(std::uint32_t i) const {
    return i < lines_.size() ? lines_[i] : found_[i - lines_.size()];
  }
  std::size_t size() const { return lines_.size() + found_.size(); }
  const Sector& sector() const { return sector_; }
  /// Adds a line and tells its number: that of a line dropped, if there is one.
  std::uint32_t add_found(const EdgeLine& line);
  /// The number that the next line will get.
  std::uint32_t next_found() const {
    return dropped_.empty() ? static_cast<std::uint32_t>(size()) : dropped_.back();
  }
  /// Forgets a line that was found. REQUIRES that its number stands nowhere any more.
  void drop_found(std::uint32_t number) { dropped_.push_back(number); }
  const std::vector<EdgeLine>& found() const { return found_; }
  void set_found(std::vector<EdgeLine> lines) { found_ = std::move(lines); }

  ProfileLine whole(SurfaceEdge edge) const;
  ProfileLine whole(std::uint32_t i) const { return whole(line(i).edge); }
  /// Whether a line is an edge of the surface, and not one on the ground.
  bool is_edge(std::uint32_t i) const { return ends_.is_edge(line(i).edge); }
  /// Whether a line lies between the sectors, so that it was moved ahead of the near plane.
  bool is_moved(SurfaceEdge edge) const;
  /// Have a line brought into the cache, and then its points.
  [[gnu::always_inline]] void fetch(std::uint32_t i) const {
    if (i < lines_.size()) __builtin_prefetch(&lines_[i]);
  }
  [[gnu::always_inline]] void fetch_points(std::uint32_t i) const { ends_.fetch(line(i).edge); }
  /// The point at a place along a line.
  ProfilePoint point(std::uint32_t line, double t) const;

  LinePicture picture(std::uint32_t line, const ProfileLine& whole) const;
  /// The same of a line that has no number yet.
  LinePicture picture(const ProfileLine& whole) const { return picture(0, whole); }
  /// As a line of a slab that holds all of it.
  SurfaceLine surface_line(std::uint32_t line, const LinePicture& picture) const {
    return surface_line(this->line(line), picture);
  }
  SurfaceLine surface_line(const EdgeLine& line, const LinePicture& picture) const;
  /// Leaves what is in the range; tells whether any of it is.
  bool cut_to_range(SurfaceLine& line) const;
  /// By bounds alone: all of it is below all of the horizon's blocks that it reaches.
  bool is_hidden(const LinePicture& picture, const BlockedHorizon& horizon) const;
  /// Adds what the view draws of a part of a line; shares of the way along its picture, left to
  /// right.
  void add_part(std::uint32_t line, const LinePicture& picture, double t_begin, double t_end,
                std::vector<LinePart>& parts) const;
  /// The same, and of the line that is seen with it, if any is.
  void add_seen(std::uint32_t line, const LinePicture& picture, double t_begin, double t_end,
                std::vector<LinePart>& parts) const;
  /// By the edges' numbers. REQUIRES that it outlives this.
  void set_seen_with(std::span<const SeenWith> seen_with) { seen_with_ = seen_with; }
  /// From such a share to one along the edge.
  double along_edge(const LinePicture& picture, double share) const;
  /// The parts of silhouettes and the border, voids' too, that `horizon`, the one behind
  /// everything, is made of, where these lines are drawn; visible or not.
  std::vector<LinePart> skyline(const Horizon& horizon) const;

  /// X that is looked at: the range, and what is beside it by rounding.
  XRange looked_at() const { return beside_range_; }
  double from_m() const { return from_m_; }
  /// Bound on the rounding of u and v.
  double rounding_m() const { return rounding_m_; }
  /// The same of X, up to a distance from the middle and from a depth on.
  double rounding(double x, double from_m) const {
    return rounding_m_ * (view_.is_perspective() ? (1 + x) / from_m : 1 + std::abs(view_.x_per_v));
  }
  /// Whether a width is more than that, which nearly all is by far: that is told without dividing.
  bool is_wider(double width, double x, double from_m) const {
    return (view_.is_perspective() && width * from_m > 2 * rounding_m_ * (1 + x)) ||
           width > rounding(x, from_m);
  }

private:
  EdgeEnds ends_;
  bool overlays_are_lifted_;
  const Sector& sector_;
  const View& view_;
  const std::vector<EdgeLine>& lines_;
  std::vector<EdgeLine> found_;
  std::span<const SeenWith> seen_with_;
  std::vector<std::uint32_t> dropped_; ///< numbers of those found that are free
  XRange range_, beside_range_;        ///< the second with what is beside the first by rounding
  double from_m_;
  double rounding_m_;
};

/// Whether a height is below all blocks of the horizon between two abscissae.
bool is_below_blocks(const BlockedHorizon& horizon, double x_begin, double x_end, double height);

/// The number of the line that a source is of; and the source's id, of a number.
std::uint32_t line_number(const Segment& source);
std::uint64_t source_id(std::uint32_t line);

/// Whether a line hides anything, and as what: it has an extent in X.
inline bool raises(const SurfaceLine& line) {
  return line.hides && line.begin < line.end && !line.upright();
}
inline HorizonPiece occluder_of(const SurfaceLine& line) {
  return {line.begin, line.end, line.source, line.drawn};
}

/// Of coordinates in the profile frame, which are sums of products of lengths; in metres.
double position_rounding_m(double reach_m, const View& view);

/// For each of the ranges the lines that reach into it, by number. `numbers`, where it is given: of
/// those that may, rising.
std::vector<std::vector<LineAtDepth>> lines_by_range(const Surface& surface, double reach_m,
                                                     std::span<const ProfilePoint> points,
                                                     const Sector& sector,
                                                     const std::vector<EdgeLine>& lines,
                                                     const std::vector<std::uint32_t>* numbers,
                                                     std::span<const XRange> ranges, double from_m);

} // namespace orograph
