// SPDX-License-Identifier: GPL-3.0-or-later
// The lines of a strip of X, in the lattice's order.
#pragma once

#include "hidden_lines/lattice_contours.hpp"
#include "hidden_lines/lattice_in_work.hpp"
#include "hidden_lines/line_pictures.hpp"
#include "hidden_lines/place_silhouettes.hpp"
#include "hidden_lines/ridges.hpp"
#include "hidden_lines/shown_of_place.hpp"
#include "hidden_lines/upright_heights.hpp"
#include "horizon/blocked_horizon.hpp"
#include "horizon/surface_line.hpp"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace orograph {

/// Takes lines edge by edge: those of a list, and the silhouettes that it finds where they aren't
/// listed; between them contours, where they aren't listed either. Place by place: `begin_place`,
/// for each of its parts in order `begin_part`, and then as long as there is a `next` edge either
/// `take` or not; `end_place`.
class LatticeLines {
public:
  /// `which`: of the list, by number. Lines found get numbers in `pictures`. REQUIRES that all
  /// outlive it.
  LatticeLines(const LatticeInWork& lattice, XRange range, std::span<const LineAtDepth> which,
               LinePictures& pictures, BlockedHorizon& horizon);
  LatticeLines(const LatticeLines&) = delete;
  LatticeLines& operator=(const LatticeLines&) = delete;

  struct EdgeAtTurn {
    LatticeOrder::Turn turn;
    SurfaceEdge edge;
  };

  void begin_place(std::uint32_t place, const ShownOfPlace& shown);
  void begin_part(PlacePart part);
  /// The next edge with lines that may be seen or hide anything; none if nothing is left in the
  /// part.
  std::optional<EdgeAtTurn> next();
  /// Compares the lines on that edge with the horizon, and then raises it.
  void take();
  /// Leaves out folds that can be told by now.
  void end_place();
  /// Once everything was taken.
  void finish();

  /// What was visible, less what is told apart by `ridges`, and what is marked as a whole.
  const std::vector<LinePart>& visible_parts() const { return parts_; }
  const Ridges* ridges() const { return ridges_ ? &*ridges_ : nullptr; }
  /// What was found of contours, if they are to be found.
  LatticeContours* contours() { return contours_ ? &*contours_ : nullptr; }

private:
  std::optional<EdgeAtTurn> next_edge();
  struct LineAtTurn {
    LatticeOrder::Turn turn;
    std::uint32_t line;
  };
  struct LookedAt {
    SurfaceLine line;
    LinePicture picture;
    std::uint32_t number;
  };
  void order_lines(std::span<const LineAtDepth> which);
  bool look_at_alone(const PlaceSilhouettes::Found& found);
  void look_at(std::uint32_t line, const LinePicture& picture);
  bool is_whole_on_ground(std::uint32_t line, const LinePicture& picture,
                          const SurfaceLine& of_picture) const;
  void take_alone();
  void take_group();
  void add_visible(std::uint32_t number, const LinePicture& picture, XRange shown, bool stands);
  bool is_found(std::uint32_t line) const { return line >= lattice_.work.lines.size(); }

  const LatticeInWork& lattice_;
  XRange inner_range_; ///< what no other strip looks at
  LinePictures& pictures_;
  BlockedHorizon& horizon_;
  UprightHeights uprights_;
  std::vector<LineAtTurn> lines_; ///< of the list, by turn
  std::size_t next_line_ = 0;
  std::optional<PlaceSilhouettes> silhouettes_;
  std::optional<LatticeContours> contours_;
  std::uint32_t place_ = 0;                              ///< the present one
  double taken_to_m_ = 0;                                ///< depth of all that it holds
  PlacePart part_{};                                     ///< of it
  std::span<const PlaceSilhouettes::Found> found_;       ///< of that, left to take
  std::vector<LookedAt> looked_at_;                      ///< the lines on an edge
  const PlaceSilhouettes::Found* found_alone_ = nullptr; ///< or the one that is alone there
  XRange found_shown_{};
  std::vector<VisibleLinePart> visible_;
  std::vector<LinePart> parts_;
  std::optional<Ridges> ridges_;
};

} // namespace orograph
