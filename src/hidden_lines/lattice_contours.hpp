// SPDX-License-Identifier: GPL-3.0-or-later
// The contours of a strip of X, in the lattice's order.
#pragma once

#include "hidden_lines/contour_chains.hpp"
#include "hidden_lines/lattice_in_work.hpp"
#include "hidden_lines/line_pictures.hpp"
#include "hidden_lines/place_contours.hpp"
#include "hidden_lines/shown_of_place.hpp"
#include "hidden_lines/upright_heights.hpp"
#include "horizon/blocked_horizon.hpp"
#include "horizon/surface_line.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace orograph {

/// Compares them with the horizon piece by piece, as they are found, and chains what is visible.
/// Nearly every piece is above all of the horizon where it is, or below all of it, which bounds
/// tell. Place by place, part by part: `take` each turn at which something rises before it does.
class LatticeContours {
public:
  /// `inner_range`: of X, what no other strip looks at. REQUIRES that all outlive this.
  LatticeContours(const LatticeInWork& lattice, std::span<const double> levels_m,
                  XRange inner_range, const LinePictures& pictures, const BlockedHorizon& horizon,
                  UprightHeights& uprights)
      : lattice_(lattice), inner_range_(inner_range), pictures_(pictures), horizon_(horizon),
        uprights_(uprights), place_(lattice, levels_m, pictures) {}

  void begin_place(const LatticeOrder::Place& place, const ShownOfPlace& shown) {
    if (chains_.is_full()) chains_.end_runs();
    place_.find(place, shown, horizon_);
  }
  void begin_part(PlacePart part) { left_ = place_.of(part); }
  /// Those of the part up to a turn and at it.
  void take(LatticeOrder::Turn last) {
    for (; !left_.empty() && left_.front().turn <= last; left_ = left_.subspan(1))
      take(left_.front());
  }

  /// Once everything was taken.
  void finish() { chains_.end_runs(); }
  std::vector<ContourRuns>& runs() { return chains_.runs(); }
  /// What isn't visible from node to node.
  const std::vector<ContourPart>& parts() const { return parts_; }

private:
  using Point = PlaceContours::Point;
  void take(const PlaceContours::Piece& piece);
  void take_exactly(const PlaceContours::Piece& piece);
  void link(const PlaceContours::Piece& piece);

  const LatticeInWork& lattice_;
  XRange inner_range_;
  const LinePictures& pictures_;
  const BlockedHorizon& horizon_;
  UprightHeights& uprights_;
  PlaceContours place_;
  std::span<const PlaceContours::Piece> left_;
  std::size_t block_ = 0; ///< of the horizon: that of the last piece's left end
  ContourChains chains_;
  std::vector<ContourPart> parts_;
  std::vector<VisibleLinePart> visible_; ///< of a piece
  std::vector<LinePart> shares_;         ///< the same, along it
};

} // namespace orograph
